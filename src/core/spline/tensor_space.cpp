#include "core/spline/tensor_space.hpp"

#include "core/base/check.hpp"

namespace gaspard {

namespace {

/// A direction beyond the dimension of the space: one constant function.
const KnotVector constant{0, {0, 1}};

const KnotVector& direction(const TensorSpace& space, std::size_t d) {
    return d < space.directions.size() ? space.directions[d] : constant;
}

struct LineValues {
    std::size_t first;
    std::vector<double> values; ///< of one order of derivative
};

LineValues line_values(const KnotVector& space, double x, int order) {
    const auto width = static_cast<std::size_t>(space.degree) + 1;
    std::vector<double> all(static_cast<std::size_t>(order + 1) * width);
    const std::size_t span = find_span(space, x);
    basis_functions(space, span, x, order, all);
    return {span + 1 - width, {all.end() - static_cast<std::ptrdiff_t>(width), all.end()}};
}

/// Applies a matrix along one direction of a tensor.
std::vector<double> apply(const LineMatrix& matrix, std::span<const double> tensor, std::size_t before) {
    const std::size_t after = tensor.size() / (before * matrix.columns);
    std::vector<double> out(before * matrix.rows * after, 0.0);
    for (std::size_t c = 0; c < after; ++c)
        for (std::size_t i = 0; i < matrix.rows; ++i)
            for (std::size_t j = 0; j < matrix.columns; ++j)
                for (std::size_t a = 0; a < before; ++a)
                    out[(c * matrix.rows + i) * before + a] +=
                        matrix(i, j) * tensor[(c * matrix.columns + j) * before + a];
    return out;
}

} // namespace

std::size_t TensorSpace::size() const {
    std::size_t product = 1;
    for (const auto& one : directions) product *= one.size();
    return product;
}

double evaluate(const TensorSpace& space, std::span<const double> coefficients, Vec3 point,
                std::array<int, 3> orders) {
    GASPARD_CHECK(!space.directions.empty() && space.directions.size() <= 3);
    GASPARD_CHECK(coefficients.size() == space.size());
    const std::array<double, 3> at = {point.x, point.y, point.z};
    std::array<LineValues, 3> lines;
    for (std::size_t d = 0; d < 3; ++d) lines[d] = line_values(direction(space, d), at[d], orders[d]);
    const std::size_t nx = direction(space, 0).size(), ny = direction(space, 1).size();
    double sum = 0;
    for (std::size_t k = 0; k < lines[2].values.size(); ++k)
        for (std::size_t j = 0; j < lines[1].values.size(); ++j) {
            const std::size_t row = (lines[2].first + k) * ny + lines[1].first + j;
            const double weight = lines[2].values[k] * lines[1].values[j];
            for (std::size_t i = 0; i < lines[0].values.size(); ++i)
                sum += weight * lines[0].values[i] * coefficients[row * nx + lines[0].first + i];
        }
    return sum;
}

SplineFunction derivative(const SplineFunction& of, std::size_t d) {
    GASPARD_CHECK(of.coefficients.size() == of.space.size() && d < of.space.directions.size());
    const KnotVector& line = of.space.directions[d];
    SplineFunction result{of.space, {}};
    result.space.directions[d] = derivative_space(line);
    result.coefficients.resize(result.space.size());
    std::size_t step = 1; // from one coefficient along d to the next
    for (std::size_t before = 0; before < d; ++before) step *= of.space.directions[before].size();
    const std::size_t n = line.size();
    std::vector<double> along(n);
    for (std::size_t l = 0; l < of.coefficients.size() / n; ++l) {
        const std::size_t first = l % step + l / step * step * n;
        const std::size_t first_of_result = l % step + l / step * step * (n - 1);
        for (std::size_t i = 0; i < n; ++i) along[i] = of.coefficients[first + i * step];
        const auto slopes = derivative_coefficients(line, along);
        for (std::size_t i = 0; i + 1 < n; ++i) result.coefficients[first_of_result + i * step] = slopes[i];
    }
    return result;
}

std::vector<double> insert_knots(const TensorSpace& coarse, std::span<const double> coefficients,
                                 const TensorSpace& fine) {
    GASPARD_CHECK(coarse.directions.size() == fine.directions.size() && coefficients.size() == coarse.size());
    std::vector<double> now(coefficients.begin(), coefficients.end());
    std::size_t before = 1;
    for (std::size_t d = 0; d < coarse.directions.size(); ++d) {
        now = apply(insertion(coarse.directions[d], fine.directions[d]), now, before);
        before *= fine.directions[d].size();
    }
    return now;
}

DeRham de_rham(const TensorSpace& space) {
    const std::size_t dimension = space.directions.size();
    GASPARD_CHECK(dimension == 2 || dimension == 3);
    const auto lowered = [&](auto which) {
        TensorSpace other = space;
        for (std::size_t d = 0; d < dimension; ++d)
            if (which(d)) other.directions[d] = derivative_space(other.directions[d]);
        return other;
    };
    DeRham spaces{space, {}, {}, lowered([](std::size_t) { return true; })};
    for (std::size_t c = 0; c < dimension; ++c) {
        spaces.divergence.push_back(lowered([c](std::size_t d) { return d != c; }));
        if (dimension == 3) spaces.curl.push_back(lowered([c](std::size_t d) { return d == c; }));
    }
    return spaces;
}

} // namespace gaspard
