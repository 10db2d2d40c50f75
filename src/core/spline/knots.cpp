#include "core/spline/knots.hpp"

#include "core/base/check.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>

namespace gaspard {

std::vector<double> KnotVector::breaks() const {
    std::vector<double> different = knots;
    different.erase(std::unique(different.begin(), different.end()), different.end());
    return different;
}

KnotVector open_knots(int degree, std::span<const double> breaks, int regularity) {
    GASPARD_CHECK(degree >= 0 && degree <= highest_degree);
    GASPARD_CHECK(regularity >= -1 && regularity <= degree - 1 + (degree == 0));
    GASPARD_CHECK(breaks.size() >= 2);
    KnotVector space{degree, {}};
    for (std::size_t i = 0; i < breaks.size(); ++i) {
        const bool end = i == 0 || i + 1 == breaks.size();
        const int multiplicity = end ? degree + 1 : std::max(1, degree - regularity);
        space.knots.insert(space.knots.end(), static_cast<std::size_t>(multiplicity), breaks[i]);
    }
    GASPARD_CHECK(is_open(space));
    return space;
}

KnotVector uniform_knots(int degree, std::size_t cells) {
    std::vector<double> breaks(cells + 1);
    for (std::size_t i = 0; i <= cells; ++i) breaks[i] = static_cast<double>(i) / static_cast<double>(cells);
    return open_knots(degree, breaks, degree - 1);
}

bool is_open(const KnotVector& space) {
    const auto& t = space.knots;
    const auto p = static_cast<std::size_t>(std::max(space.degree, 0));
    if (space.degree < 0 || space.degree > highest_degree || t.size() < 2 * p + 2) return false;
    if (!std::is_sorted(t.begin(), t.end()) || t[0] != 0 || t.back() != 1) return false;
    for (std::size_t i = 0; i <= p; ++i)
        if (t[i] != 0 || t[t.size() - 1 - i] != 1) return false;
    for (std::size_t i = 0; i + p + 1 < t.size(); ++i)
        if (t[i] == t[i + p + 1]) return false;
    return true;
}

std::size_t find_span(const KnotVector& space, double x) {
    const auto p = static_cast<std::ptrdiff_t>(space.degree);
    const auto first = space.knots.begin() + p, last = space.knots.end() - p - 1;
    const auto after = std::upper_bound(first + 1, last, x); // first knot > x, excluding the last ones
    return static_cast<std::size_t>(after - space.knots.begin()) - 1;
}

// Piegl and Tiller, The NURBS Book, Algorithm A2.3: a triangular table of the functions of all lower degrees;
// derivatives are differences of its entries.
void basis_functions(const KnotVector& space, std::size_t span, double x, int derivatives,
                     std::span<double> out) {
    constexpr std::size_t most = highest_degree + 1;
    const auto p = static_cast<std::size_t>(space.degree);
    const auto orders = static_cast<std::size_t>(derivatives);
    GASPARD_CHECK(out.size() >= (orders + 1) * (p + 1));
    const auto& t = space.knots;
    std::array<std::array<double, most>, most> low{}; // [degree][function]; below: knot differences
    std::array<std::array<double, most>, most> width{};
    low[0][0] = 1;
    for (std::size_t j = 1; j <= p; ++j) {
        double saved = 0;
        for (std::size_t r = 0; r < j; ++r) {
            const double right = t[span + r + 1] - x, left = x - t[span + 1 + r - j];
            width[j][r] = t[span + r + 1] - t[span + 1 + r - j];
            const double part = low[j - 1][r] / width[j][r];
            low[j][r] = saved + right * part;
            saved = left * part;
        }
        low[j][j] = saved;
    }
    for (std::size_t k = 0; k <= p; ++k) out[k] = low[p][k];
    // d/dx B_i^q = q (B_i^q-1 / (t_i+q - t_i) - B_i+1^q-1 / (t_i+q+1 - t_i+1)), once per order.
    for (std::size_t d = 1; d <= orders; ++d) {
        double* row = &out[d * (p + 1)];
        if (d > p) {
            std::fill_n(row, p + 1, 0.0);
            continue;
        }
        std::array<double, most> now = low[p - d];
        for (std::size_t q = p - d + 1; q <= p; ++q) {
            std::array<double, most> next{};
            for (std::size_t r = 0; r < q; ++r) {
                const double part = static_cast<double>(q) * now[r] / width[q][r];
                next[r] -= part;
                next[r + 1] += part;
            }
            now = next;
        }
        std::copy_n(now.begin(), p + 1, row);
    }
}

std::vector<double> greville(const KnotVector& space) {
    std::vector<double> points(space.size());
    const auto p = static_cast<std::size_t>(space.degree);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (p == 0) {
            points[i] = (space.knots[i] + space.knots[i + 1]) / 2;
            continue;
        }
        for (std::size_t k = 1; k <= p; ++k) points[i] += space.knots[i + k];
        points[i] /= static_cast<double>(p);
    }
    return points;
}

// The blossom of x^2 at the p inner knots of each function: the mean of the products of two distinct knots.
std::vector<double> square_coefficients(const KnotVector& space) {
    const auto p = static_cast<std::size_t>(space.degree);
    GASPARD_CHECK(p >= 2);
    std::vector<double> coefficients(space.size(), 0.0);
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        for (std::size_t k = 1; k <= p; ++k)
            for (std::size_t l = k + 1; l <= p; ++l)
                coefficients[i] += space.knots[i + k] * space.knots[i + l];
        coefficients[i] *= 2.0 / static_cast<double>(p * (p - 1));
    }
    return coefficients;
}

KnotVector derivative_space(const KnotVector& space) {
    GASPARD_CHECK(space.degree >= 1);
    return {space.degree - 1, {space.knots.begin() + 1, space.knots.end() - 1}};
}

std::vector<double> derivative_coefficients(const KnotVector& space, std::span<const double> coefficients) {
    GASPARD_CHECK(coefficients.size() == space.size());
    const auto p = static_cast<std::size_t>(space.degree);
    std::vector<double> result(space.size() - 1);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double width = space.knots[i + p + 1] - space.knots[i + 1];
        GASPARD_CHECK(width > 0); // else the splines may be discontinuous
        result[i] = space.degree * (coefficients[i + 1] - coefficients[i]) / width;
    }
    return result;
}

bool refines(const KnotVector& fine, const KnotVector& coarse) {
    return fine.degree == coarse.degree &&
           std::includes(fine.knots.begin(), fine.knots.end(), coarse.knots.begin(), coarse.knots.end());
}

namespace {

/// Inserts one knot: row i of the result is a convex combination of rows i - 1 and i of `old`.
LineMatrix insert_one(const KnotVector& space, double knot, const LineMatrix& old) {
    const auto p = static_cast<std::size_t>(space.degree);
    const std::size_t span = find_span(space, knot);
    LineMatrix next{old.rows + 1, old.columns, std::vector<double>((old.rows + 1) * old.columns)};
    for (std::size_t i = 0; i < next.rows; ++i) {
        double part = 0; // weight of row i; 1 - part is that of row i - 1
        if (i + p <= span)
            part = 1;
        else if (i <= span)
            part = (knot - space.knots[i]) / (space.knots[i + p] - space.knots[i]);
        for (std::size_t j = 0; j < old.columns; ++j)
            next(i, j) = (part == 0 ? 0 : part * old(i, j)) + (part == 1 ? 0 : (1 - part) * old(i - 1, j));
    }
    return next;
}

Eigen::MatrixXd collocation(const KnotVector& space, std::span<const double> points) {
    const auto p = static_cast<std::size_t>(space.degree);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(points.size()),
                                                   static_cast<Eigen::Index>(space.size()));
    std::vector<double> values(p + 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t span = find_span(space, points[i]);
        basis_functions(space, span, points[i], 0, values);
        for (std::size_t k = 0; k <= p; ++k)
            matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(span - p + k)) = values[k];
    }
    return matrix;
}

} // namespace

LineMatrix insertion(const KnotVector& coarse, const KnotVector& fine) {
    GASPARD_CHECK(refines(fine, coarse));
    LineMatrix matrix{coarse.size(), coarse.size(), std::vector<double>(coarse.size() * coarse.size(), 0.0)};
    for (std::size_t i = 0; i < coarse.size(); ++i) matrix(i, i) = 1;
    KnotVector now = coarse;
    std::vector<double> missing;
    std::set_difference(fine.knots.begin(), fine.knots.end(), coarse.knots.begin(), coarse.knots.end(),
                        std::back_inserter(missing));
    for (const double knot : missing) {
        matrix = insert_one(now, knot, matrix);
        now.knots.insert(std::upper_bound(now.knots.begin(), now.knots.end(), knot), knot);
    }
    return matrix;
}

LineMatrix transfer(const KnotVector& from, const KnotVector& to) {
    if (refines(to, from)) return insertion(from, to);
    const auto points = greville(to);
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> solved =
        collocation(to, points).partialPivLu().solve(collocation(from, points));
    return {to.size(), from.size(), {solved.data(), solved.data() + solved.size()}};
}

LineMatrix interpolation(const KnotVector& space) {
    const auto n = static_cast<Eigen::Index>(space.size());
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> solved =
        collocation(space, greville(space)).partialPivLu().solve(Eigen::MatrixXd::Identity(n, n));
    return {space.size(), space.size(), {solved.data(), solved.data() + solved.size()}};
}

} // namespace gaspard
