// The standard form (4.5).
#include "core/base/check.hpp"
#include "core/spline/line_matrices.hpp"

namespace gaspard {

namespace {

class StandardForm final : public SplineForm {
  public:
    StandardForm(const SplineLine& line, const LineMatrices& matrices, const NormalTrace& trace)
        : SplineForm(line, {line_operator(matrices.stiffness), line_operator(matrices.mass)},
                     {{{1, true, 0}, {0, true, 1}, {2, true, 0}, {1, true, 1}, {0, true, 2}}}) {
        const std::size_t n = size();
        integrals_ = integrals(line_, quadrature_.upper);
        border_flux_ = flux(line_, trace);
        border_load_.assign(n * n, 0.0);
        const auto& b = quadrature_.upper;
        const auto left = moments(line_, b, trace.left), right = moments(line_, b, trace.right);
        const auto bottom = moments(line_, b, trace.bottom), top = moments(line_, b, trace.top);
        for (std::size_t k = 0; k < n; ++k) {
            border_load_[k * n] -= left[k];
            border_load_[k * n + n - 1] += right[k];
            border_load_[k] -= bottom[k];
            border_load_[(n - 1) * n + k] += top[k];
        }
    }

    // Sums along x with B, its first and its second derivative.
    void expand(std::span<const double> phi, Border, const SplineGrid& grid, std::size_t fields,
                Workspace& workspace) const override {
        for (int d = 0; d < (fields > 2 ? 3 : 2); ++d)
            sum_along_x(grid.upper, d, phi, size(), workspace.half[static_cast<std::size_t>(d)], workspace);
    }
    std::array<SplineFunction, 2> map(std::span<const double> phi) const override {
        const SplineFunction potential{{{line_.upper, line_.upper}}, {phi.begin(), phi.end()}};
        return {derivative(potential, 0), derivative(potential, 1)};
    }
    // The potential (x^2 + y^2) / 2.
    std::vector<double> identity() const override {
        const auto square = square_coefficients(line_.upper);
        std::vector<double> phi;
        for (const double y : square)
            for (const double x : square) phi.push_back((x + y) / 2);
        const double average = mean(phi);
        for (double& value : phi) value -= average;
        return phi;
    }
    const KnotVector& space() const override { return line_.upper; }
    const LineTable& tests() const override { return quadrature_.upper; }
};

} // namespace

std::unique_ptr<SplineForm> make_standard_form(const SplineLine& line, const NormalTrace& trace) {
    GASPARD_CHECK(line.upper.degree >= 2);
    return std::make_unique<StandardForm>(line, LineMatrices(line), trace);
}

} // namespace gaspard
