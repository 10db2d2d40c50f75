#include "core/method/bfo.hpp"

#include "core/base/check.hpp"
#include "core/base/eigenvalues.hpp"
#include "core/linear/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gaspard {

namespace {

constexpr double delta = 2; // the factor in (5.5): d! for d = 2

// Dot product with eight independent partial sums, which the compiler can vectorise.
double weighted_sum(std::span<const double> weights, const double* values) {
    std::array<double, 8> sums{};
    std::size_t i = 0;
    for (; i + 8 <= weights.size(); i += 8)
        for (std::size_t k = 0; k < 8; ++k) sums[k] += weights[i + k] * values[i + k];
    for (; i < weights.size(); ++i) sums[0] += weights[i] * values[i];
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

} // namespace

double norm_of_divergence(const SplineForm& form) {
    auto workspace = form.make_workspace();
    const std::size_t points = form.line().points.size();
    const std::vector<double> two(points, 2.0);
    std::vector<double> load(form.unknowns());
    form.begin_load(workspace);
    for (std::size_t y = 0; y < points; ++y) form.load_row(y, two.data(), workspace);
    form.end_load(load, workspace);
    return std::sqrt(dot(load, load));
}

Bfo::Bfo(std::shared_ptr<const SplineForm> form, double shift)
    : form_(std::move(form)), shift_(shift), workspace_(form_->make_workspace()) {
    const std::size_t most = band() * form_->line().points.size();
    psi_.resize(most);
    slope_.resize(most);
    for (auto* array : {&xx_, &xy_, &yy_, &f_, &g_}) array->resize(most);
    load_.resize(form_->unknowns());
    g_load_.resize(form_->unknowns());
}

void Bfo::read_rows(std::size_t y, std::size_t rows, const SplineForm::Workspace& workspace) {
    const std::size_t points = form_->line().points.size();
    psi_.resize(rows * points);
    for (std::size_t r = 0; r < rows; ++r) {
        const std::size_t at = r * points;
        form_->row(form_->quadrature(), y + r, map_fields,
                   {&psi_.x[at], &psi_.y[at], &xx_[at], &xy_[at], &yy_[at]}, workspace);
    }
}

void Bfo::clear_rows(std::size_t count) {
    psi_ = Points(count);
    for (auto* array : {&xx_, &xy_, &yy_}) std::fill(array->begin(), array->end(), 0.0);
}

void Bfo::fill_g(std::size_t count) {
    const double *xx = xx_.data(), *xy = xy_.data(), *yy = yy_.data(), *f = f_.data();
    double* __restrict g = g_.data();
    for (std::size_t i = 0; i < count; ++i) {
        const double trace = xx[i] + yy[i], determinant = xx[i] * yy[i] - xy[i] * xy[i];
        const double square = trace * trace + delta * (f[i] - determinant);
        g[i] = std::sqrt(square > 0 ? square : 0.0 * square); // cut off at 0; NaN remains NaN
    }
}

void Bfo::iterate(const JacobianSource& source, std::span<const double> phi, std::span<double> next,
                  Shape* shape) {
    const SplineLine& line = form_->line();
    const std::size_t points = line.points.size();
    if (!phi.empty())
        form_->expand(phi, SplineForm::Border::given, form_->quadrature(), map_fields, workspace_);
    form_->begin_load(workspace_);
    double integral = 0;
    // Smallest eigenvalue of grad Psi; extremes of eigenvalue / G.
    double convexity = std::numeric_limits<double>::infinity(), least = convexity, most = -convexity;
    for (std::size_t y = 0; y < points; y += band()) {
        const std::size_t rows = std::min(band(), points - y), count = rows * points;
        if (phi.empty())
            clear_rows(count);
        else
            read_rows(y, rows, workspace_);
        source.values(y, psi_, std::span(f_).first(count));
        fill_g(count);
        for (std::size_t i = 0; shape && i < count; ++i) {
            const auto [smallest, largest] = symmetric_eigenvalues(xx_[i], xy_[i], yy_[i]);
            convexity = std::min(convexity, smallest);
            least = std::min(least, smallest / g_[i]);
            most = std::max(most, largest / g_[i]);
        }
        for (std::size_t r = 0; r < rows; ++r) {
            integral += line.weights[y + r] * weighted_sum(line.weights, &g_[r * points]);
            form_->load_row(y + r, &g_[r * points], workspace_);
        }
    }
    form_->end_load(load_, workspace_);
    const double scale = form_->border_flux() / integral;
    const auto border = form_->border_load();
    for (std::size_t i = 0; i < load_.size(); ++i) load_[i] = border[i] - scale * load_[i];
    form_->poisson().solve(load_, next, shift_, workspace_.poisson);
    if (shape) *shape = {convexity, 1 - scale * most, 1 - scale * least};
}

void Bfo::residual(std::span<const double> phi, std::span<const double> next, std::span<double> r) {
    for (std::size_t i = 0; i < load_.size(); ++i) load_[i] = next[i] - phi[i];
    form_->poisson().multiply(load_, r, workspace_.poisson);
}

void Bfo::poisson(std::span<const double> r, std::span<double> u) {
    form_->poisson().solve(r, u, shift_, workspace_.poisson);
}

// With t = xx + yy the trace and det = xx yy - xy^2 the determinant of grad Psi:
//
//   G^2    = t^2 + delta (f - det)
//   2 G dG = 2 t dt + delta (df - ddet),   ddet = xx dyy + yy dxx - 2 xy dxy
void Bfo::linearise(const JacobianSource& source, std::span<const double> phi, bool moving) {
    const SplineLine& line = form_->line();
    const std::size_t points = line.points.size();
    for (auto& part : parts_) part.resize(points * points);
    form_->expand(phi, SplineForm::Border::given, form_->quadrature(), map_fields, workspace_);
    form_->begin_load(workspace_);
    g_integral_ = 0;
    for (std::size_t y = 0; y < points; y += band()) {
        const std::size_t rows = std::min(band(), points - y), count = rows * points;
        read_rows(y, rows, workspace_);
        if (moving)
            source.gradients(y, psi_, std::span(f_).first(count), slope_);
        else
            source.values(y, psi_, std::span(f_).first(count));
        fill_g(count);
        for (std::size_t i = 0; i < count; ++i) {
            const double xx = xx_[i], xy = xy_[i], yy = yy_[i], trace = xx + yy;
            const double inverse = g_[i] > 0 ? 1 / g_[i] : 0; // G cut off at 0 has derivative 0
            const std::size_t at = y * points + i;
            parts_[0][at] = moving ? delta / 2 * slope_.x[i] * inverse : 0;
            parts_[1][at] = moving ? delta / 2 * slope_.y[i] * inverse : 0;
            parts_[2][at] = (trace - delta / 2 * yy) * inverse;
            parts_[3][at] = delta * xy * inverse;
            parts_[4][at] = (trace - delta / 2 * xx) * inverse;
        }
        for (std::size_t r = 0; r < rows; ++r) {
            g_integral_ += line.weights[y + r] * weighted_sum(line.weights, &g_[r * points]);
            form_->load_row(y + r, &g_[r * points], workspace_);
        }
    }
    form_->end_load(g_load_, workspace_);
}

// d(s G) = s (dG - G (integral of dG) / (integral of G))
void Bfo::derivative(std::span<const double> w, std::span<double> out) {
    const SplineLine& line = form_->line();
    const std::size_t points = line.points.size();
    form_->expand(w, SplineForm::Border::zero, form_->quadrature(), map_fields, workspace_);
    form_->begin_load(workspace_);
    double integral = 0;
    for (std::size_t y = 0; y < points; y += band()) {
        const std::size_t rows = std::min(band(), points - y);
        read_rows(y, rows, workspace_);
        for (std::size_t i = 0; i < rows * points; ++i) {
            const std::size_t at = y * points + i;
            g_[i] = parts_[0][at] * psi_.x[i] + parts_[1][at] * psi_.y[i] + parts_[2][at] * xx_[i] +
                    parts_[3][at] * xy_[i] + parts_[4][at] * yy_[i];
        }
        for (std::size_t r = 0; r < rows; ++r) {
            integral += line.weights[y + r] * weighted_sum(line.weights, &g_[r * points]);
            form_->load_row(y + r, &g_[r * points], workspace_);
        }
    }
    form_->end_load(load_, workspace_);
    const double scale = form_->border_flux() / g_integral_, part = integral / g_integral_;
    form_->poisson().multiply(w, out, workspace_.poisson);
    for (std::size_t i = 0; i < load_.size(); ++i) out[i] += scale * (load_[i] - part * g_load_[i]);
}

} // namespace gaspard
