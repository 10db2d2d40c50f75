#include "core/spline/solid_folds.hpp"

#include "core/base/check.hpp"
#include "core/spline/bernstein.hpp"
#include "core/spline/line_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaspard {

namespace {

constexpr std::size_t most_parts_per_cell = 512;

using Values = std::vector<double>;

/// out(.., i, ..) = sum over k of matrix(i, k) in(.., k, ..) along one direction of an array with `before`
/// faster and `after` slower entries.
void apply_along(std::span<const double> matrix, std::size_t rows, std::size_t columns, std::size_t before,
                 std::size_t after, const double* in, double* out) {
    for (std::size_t a = 0; a < after; ++a)
        for (std::size_t i = 0; i < rows; ++i) {
            double* to = out + (a * rows + i) * before;
            std::fill(to, to + before, 0.0);
            for (std::size_t k = 0; k < columns; ++k) {
                const double factor = matrix[i * columns + k];
                const double* from = in + (a * columns + k) * before;
                for (std::size_t b = 0; b < before; ++b) to[b] += factor * from[b];
            }
        }
}

/// One of the nine derivatives, tabulated at the interpolation points.
class SolidFactor {
  public:
    SolidFactor(SplineFunction of, const BernsteinPoints& at)
        : of_(std::move(of)), size_(at.size), lines_{LineTable(of_.space.directions[0], at.points, 0),
                                                     LineTable(of_.space.directions[1], at.points, 0),
                                                     LineTable(of_.space.directions[2], at.points, 0)} {}

    /// Calls visit(coefficient) for the B-splines that are not zero on a cell, the first direction fastest.
    template <class Visit>
    void visit(const std::array<std::size_t, 3>& cell, const Visit& visit) const {
        const std::size_t columns = lines_[0].functions(), rows = lines_[1].functions();
        const auto first = [&](std::size_t d) { return lines_[d].first(cell[d] * size_); };
        for (std::size_t k = 0; k < lines_[2].width(); ++k)
            for (std::size_t j = 0; j < lines_[1].width(); ++j)
                for (std::size_t i = 0; i < lines_[0].width(); ++i)
                    visit(of_.coefficients[((first(2) + k) * rows + first(1) + j) * columns + first(0) + i]);
    }
    /// Values at the points of a cell.
    void values(const std::array<std::size_t, 3>& cell, Values& out, Values& half, Values& local) const {
        local.clear();
        visit(cell, [&](double value) { local.push_back(value); });
        const auto table = [&](std::size_t d) {
            return std::span<const double>(lines_[d].row(0, cell[d] * size_), size_ * lines_[d].width());
        };
        const std::size_t x = lines_[0].width(), y = lines_[1].width(), z = lines_[2].width(), m = size_;
        half.resize(m * y * z);
        out.resize(m * m * z);
        apply_along(table(0), m, x, 1, y * z, local.data(), half.data());
        apply_along(table(1), m, y, m, z, half.data(), out.data());
        half.resize(m * m * m);
        apply_along(table(2), m, z, m * m, 1, out.data(), half.data());
        out.swap(half);
    }

  private:
    SplineFunction of_;
    std::size_t size_;
    std::array<LineTable, 3> lines_;
};

struct Range {
    double low, high;

    friend Range operator*(Range a, Range b) {
        const auto [low, high] =
            std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
        return {low, high};
    }
    friend Range operator-(Range a, Range b) { return {a.low - b.high, a.high - b.low}; }
    friend Range operator+(Range a, Range b) { return {a.low + b.low, a.high + b.high}; }
};

/// The determinant of a matrix by rows.
template <class T>
T determinant_of(const std::array<T, 9>& a) {
    return a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
           a[2] * (a[3] * a[7] - a[4] * a[6]);
}

/// A polynomial by its Bernstein coefficients times C(p, i) C(p, j) C(p, k), of which products are
/// convolutions.
struct Scaled {
    std::size_t size = 0; ///< p + 1
    Values values;        ///< size^3, the first direction fastest
};

std::vector<double> binomials(std::size_t size) {
    std::vector<double> row(size, 1.0);
    for (std::size_t k = 1; k < size; ++k)
        row[k] = row[k - 1] * static_cast<double>(size - k) / static_cast<double>(k);
    return row;
}

/// Each value times factors[i] factors[j] factors[k], or divided by them.
void scale(Values& values, std::size_t size, bool divide) {
    const std::vector<double> factors = binomials(size);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double all = factors[i % size] * factors[i / size % size] * factors[i / size / size];
        values[i] = divide ? values[i] / all : values[i] * all;
    }
}

/// sum += sign a b.
void add_product(double sign, const Scaled& a, const Scaled& b, Scaled& sum) {
    sum.size = a.size + b.size - 1;
    sum.values.resize(sum.size * sum.size * sum.size);
    for (std::size_t z = 0; z < a.size; ++z)
        for (std::size_t y = 0; y < a.size; ++y)
            for (std::size_t x = 0; x < a.size; ++x) {
                const double factor = sign * a.values[(z * a.size + y) * a.size + x];
                for (std::size_t k = 0; k < b.size; ++k)
                    for (std::size_t j = 0; j < b.size; ++j) {
                        const double* from = &b.values[(k * b.size + j) * b.size];
                        double* to = &sum.values[((z + k) * sum.size + y + j) * sum.size + x];
                        for (std::size_t i = 0; i < b.size; ++i) to[i] += factor * from[i];
                    }
            }
}

class FoldFinder {
  public:
    FoldFinder(std::span<const SplineFunction> map, std::size_t cells)
        : cells_(cells), points_(degree(map), cells), size_(3 * (points_.size - 1) + 1) {
        for (const SplineFunction& component : map)
            for (std::size_t d = 0; d < 3; ++d) factors_.emplace_back(derivative(component, d), points_);
    }

    std::vector<std::uint32_t> folded() {
        std::vector<std::uint32_t> found;
        for (std::size_t c = 0; c < cells_ * cells_ * cells_; ++c) {
            const std::array<std::size_t, 3> cell{c % cells_, c / cells_ % cells_, c / cells_ / cells_};
            if (surely_positive(cell)) continue;
            if (folds(cell)) found.push_back(static_cast<std::uint32_t>(c));
        }
        return found;
    }

  private:
    /// Of all derivatives in all directions.
    static std::size_t degree(std::span<const SplineFunction> map) {
        int most = 0;
        for (const SplineFunction& component : map)
            for (const KnotVector& line : component.space.directions) most = std::max(most, line.degree);
        return static_cast<std::size_t>(most);
    }

    bool surely_positive(const std::array<std::size_t, 3>& cell) const {
        std::array<Range, 9> ranges{};
        for (std::size_t f = 0; f < 9; ++f) {
            Range range{HUGE_VAL, -HUGE_VAL};
            factors_[f].visit(cell, [&](double value) {
                range.low = value < range.low || std::isnan(value) ? value : range.low;
                range.high = value > range.high || std::isnan(value) ? value : range.high;
            });
            ranges[f] = range;
        }
        const double low = determinant_of(ranges).low;
        return low > 0 && std::isfinite(low);
    }

    bool folds(const std::array<std::size_t, 3>& cell) {
        const std::size_t m = points_.size;
        for (std::size_t f = 0; f < 9; ++f) factors_[f].values(cell, values_[f], half_, local_);
        for (std::size_t i = 0; i < values_[0].size(); ++i) {
            std::array<double, 9> at{};
            for (std::size_t f = 0; f < 9; ++f) at[f] = values_[f][i];
            const double j = determinant_of(at);
            if (!std::isfinite(j) || j <= 0) return true;
        }
        std::array<Scaled, 9> a;
        const std::span<const double> matrix(points_.to_bernstein);
        for (std::size_t f = 0; f < 9; ++f) {
            a[f] = {m, Values(values_[f].size())};
            apply_along(matrix, m, m, 1, m * m, values_[f].data(), a[f].values.data());
            apply_along(matrix, m, m, m, m, a[f].values.data(), values_[f].data());
            apply_along(matrix, m, m, m * m, 1, values_[f].data(), a[f].values.data());
            scale(a[f].values, m, false);
        }
        Scaled determinant;
        for (std::size_t d = 0; d < 3; ++d) { // along the first row
            const std::size_t e = (d + 1) % 3, g = (d + 2) % 3;
            Scaled minor;
            add_product(1, a[3 + e], a[6 + g], minor);
            add_product(-1, a[3 + g], a[6 + e], minor);
            add_product(1, a[d], minor, determinant);
        }
        scale(determinant.values, size_, true);
        return not_positive(std::move(determinant.values));
    }

    /// Whether the polynomial with these Bernstein coefficients is not certain to be positive.
    bool not_positive(Values coefficients) const {
        std::vector<Values> parts;
        parts.push_back(std::move(coefficients));
        for (std::size_t made = 0; !parts.empty();) {
            Values part = std::move(parts.back());
            parts.pop_back();
            if (*std::min_element(part.begin(), part.end()) > 0) continue;
            if (corner(part) <= 0 || ++made > most_parts_per_cell) return true;
            auto [first, second] = halves(std::move(part));
            parts.push_back(std::move(first));
            parts.push_back(std::move(second));
        }
        return false;
    }

    /// The smallest value at a corner.
    double corner(const Values& part) const {
        const std::size_t last = size_ - 1, m = size_;
        double smallest = HUGE_VAL;
        for (const std::size_t k : {std::size_t{0}, last})
            for (const std::size_t j : {std::size_t{0}, last})
                for (const std::size_t i : {std::size_t{0}, last})
                    smallest = std::min(smallest, part[(k * m + j) * m + i]);
        return smallest;
    }

    /// In the direction in which the coefficients vary most, by de Casteljau's algorithm.
    std::pair<Values, Values> halves(Values part) const {
        const std::size_t m = size_, steps[3] = {1, m, m * m};
        std::size_t along = 0;
        double most = -1;
        for (std::size_t d = 0; d < 3; ++d)
            for (std::size_t i = 0; i < part.size(); ++i) {
                if (i / steps[d] % m + 1 == m) continue;
                const double change = std::abs(part[i + steps[d]] - part[i]);
                if (change > most) most = change, along = d;
            }
        const std::size_t step = steps[along];
        Values first = part, second = std::move(part);
        for (std::size_t start = 0; start < first.size(); ++start) {
            if (start / step % m != 0) continue;
            for (std::size_t k = 1; k < m; ++k) { // in second, those below m - k are of step k
                for (std::size_t i = 0; i + k < m; ++i)
                    second[start + i * step] =
                        0.5 * (second[start + i * step] + second[start + (i + 1) * step]);
                first[start + k * step] = second[start];
            }
        }
        return {std::move(first), std::move(second)};
    }

    std::size_t cells_;
    BernsteinPoints points_;           ///< of the factors
    std::size_t size_;                 ///< coefficients of J per direction
    std::vector<SolidFactor> factors_; ///< psi1,1 psi1,2 psi1,3 psi2,1 ...
    std::array<Values, 9> values_;
    Values half_, local_;
};

} // namespace

std::vector<std::uint32_t> folded_solid_cells(std::span<const SplineFunction> map, std::size_t cells) {
    GASPARD_CHECK(cells >= 1 && map.size() == 3);
    for (const SplineFunction& component : map)
        GASPARD_CHECK(component.space.directions.size() == 3 &&
                      component.coefficients.size() == component.space.size());
    return FoldFinder(map, cells).folded();
}

} // namespace gaspard
