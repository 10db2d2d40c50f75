#include "core/method/bfo.hpp"

#include "core/base/check.hpp"
#include "core/base/cube_root.hpp"
#include "core/linear/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gaspard {

namespace {

template <std::size_t D>
constexpr double delta = D == 2 ? 2 : 27; // the factor in (5.5), see the header

constexpr std::size_t parts_in_space = 8;

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

template <std::size_t D>
double norm_of_divergence(const TensorForm<D>& form) {
    auto workspace = form.make_workspace();
    const std::vector<double> divergence(form.slab(), static_cast<double>(D));
    std::vector<double> load(form.unknowns());
    form.begin_load(workspace);
    for (std::size_t y = 0; y < form.line().points.size(); ++y)
        form.load_row(y, divergence.data(), workspace);
    form.end_load(load, workspace);
    return std::sqrt(dot(load, load));
}

template <std::size_t D>
BfoIteration<D>::BfoIteration(std::shared_ptr<const Form> form, double shift, std::size_t threads)
    : form_(std::move(form)), shift_(shift), workspace_(form_->make_workspace(threads)),
      bands_(workspace_.team->workers()) {
    const SplineLine& line = form_->line();
    // A row of cells of the square, a plane of points in the cube.
    const std::size_t slabs = D == 2 ? line.upper.degree + std::size_t{1} : 1;
    for (Band& band : bands_) {
        band.slabs = slabs;
        for (auto* array : {&band.f, &band.g}) array->resize(slabs * form_->slab());
        for (auto& array : band.h) array.resize(slabs * form_->slab());
    }
    const std::size_t points = line.points.size(), count = D == 2 ? 1 : parts_in_space;
    const LineTable& tests = form_->tests();
    for (std::size_t p = 0; p < count; ++p) {
        Part part{.begin = points * p / count, .end = points * (p + 1) / count};
        if (part.begin == part.end) continue;
        part.first = tests.first(part.begin);
        part.last = tests.first(part.end - 1) + tests.width();
        if (D == 3) part.load.resize((part.last - part.first) * form_->slab());
        parts_.push_back(std::move(part));
    }
    load_.resize(form_->unknowns());
    g_load_.resize(form_->unknowns());
}

template <std::size_t D>
void BfoIteration<D>::read(Band& band) const {
    const std::size_t slab = form_->slab();
    for (std::size_t r = 0; r < band.slabs; ++r) {
        const std::size_t at = r * slab;
        typename Form::Fields out;
        out[0] = &band.psi.x[at], out[1] = &band.psi.y[at];
        if constexpr (D == 3) out[2] = &band.psi.z[at];
        for (std::size_t e = 0; e < entries; ++e) out[D + e] = &band.h[e][at];
        form_->row(form_->quadrature(), band.first + r, Form::fields, out, workspace_);
    }
}

template <std::size_t D>
void BfoIteration<D>::load(const Band& band, Part& part) {
    const SplineLine& line = form_->line();
    const std::size_t slab = form_->slab(), points = line.points.size();
    for (std::size_t r = 0; r < band.slabs; ++r) {
        const double* g = &band.g[r * slab];
        const double weight = line.weights[band.first + r];
        if constexpr (D == 2) {
            part.integral += weight * weighted_sum(line.weights, g);
            form_->load_row(band.first + r, g, workspace_);
        } else {
            for (std::size_t y = 0; y < points; ++y)
                part.integral += weight * line.weights[y] * weighted_sum(line.weights, g + y * points);
            form_->tests().scatter(0, band.first + r, weight, g, slab, part.load.data(), part.first);
        }
    }
}

template <std::size_t D>
template <class Work>
double BfoIteration<D>::integrate(bool at_rest, const Work& work) {
    const std::size_t slab = form_->slab();
    workspace_.team->share(parts_.size(), [&](std::size_t worker, std::size_t begin, std::size_t end) {
        Band& band = bands_[worker];
        const std::size_t most = band.g.size() / slab;
        for (std::size_t p = begin; p < end; ++p) {
            Part& part = parts_[p];
            part.integral = 0;
            std::fill(part.load.begin(), part.load.end(), 0.0);
            for (std::size_t at = part.begin; at < part.end; at += most) {
                band.first = at;
                band.slabs = std::min(most, part.end - at);
                if (at_rest) {
                    band.psi = Points(band.slabs * slab);
                    for (auto& array : band.h) std::fill(array.begin(), array.end(), 0.0);
                } else {
                    band.psi.resize(band.slabs * slab);
                    read(band);
                }
                work(band, part);
                load(band, part);
            }
        }
    });
    double integral = 0;
    for (const Part& part : parts_) {
        integral += part.integral;
        for (std::size_t i = 0; i < part.load.size(); ++i)
            workspace_.load[part.first * slab + i] += part.load[i];
    }
    return integral;
}

template <std::size_t D>
void BfoIteration<D>::fill_g(Band& band) {
    const double* f = band.f.data();
    double* __restrict g = band.g.data();
    const std::size_t count = band.size();
    std::array<const double*, entries> h;
    for (std::size_t e = 0; e < entries; ++e) h[e] = band.h[e].data();
    for (std::size_t i = 0; i < count; ++i) {
        Symmetric<D> at;
        for (std::size_t e = 0; e < entries; ++e) at[e] = h[e][i];
        const double t = trace(at), power = (D == 2 ? t : t * t) * t;
        const double value = power + delta<D> * (f[i] - determinant(at));
        const double positive = value > 0 ? value : 0.0 * value; // cut off at 0; NaN remains NaN
        g[i] = D == 2 ? std::sqrt(positive) : cube_root(positive);
    }
}

template <std::size_t D>
void BfoIteration<D>::iterate(const JacobianSource& source, std::span<const double> phi,
                              std::span<double> next, Shape* shape) {
    if (!phi.empty()) form_->expand(phi, Form::Border::given, form_->quadrature(), Form::fields, workspace_);
    form_->begin_load(workspace_);
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (Part& part : parts_) part.convexity = part.least = infinite, part.most = -infinite;
    const double integral = integrate(phi.empty(), [&](Band& band, Part& part) {
        source.values(band.first, band.psi, std::span(band.f).first(band.size()));
        fill_g(band);
        for (std::size_t i = 0; shape && i < band.size(); ++i) {
            const std::array<double, D> sorted = eigenvalues(band.hessian(i));
            double least = sorted.front(), most = sorted.back(), scale = band.g[i];
            if constexpr (D == 3) { // the eigenvalues of the cofactors are the products of two
                const double t = sorted[0] + sorted[1] + sorted[2];
                const auto [low, high] =
                    std::minmax({sorted[0] * sorted[1], sorted[0] * sorted[2], sorted[1] * sorted[2]});
                least = t * t - delta<D> / 3 * high;
                most = t * t - delta<D> / 3 * low;
                scale *= scale;
            }
            part.convexity = std::min(part.convexity, sorted.front());
            part.least = std::min(part.least, least / scale);
            part.most = std::max(part.most, most / scale);
        }
    });
    form_->end_load(load_, workspace_);
    const double scale = form_->border_flux() / integral;
    const auto border = form_->border_load();
    for (std::size_t i = 0; i < load_.size(); ++i) load_[i] = border[i] - scale * load_[i];
    form_->poisson().solve(load_, next, shift_, workspace_.poisson);
    if (!shape) return;
    double convexity = infinite, least = infinite, most = -infinite;
    for (const Part& part : parts_) {
        convexity = std::min(convexity, part.convexity);
        least = std::min(least, part.least);
        most = std::max(most, part.most);
    }
    *shape = {convexity, 1 - scale * most, 1 - scale * least};
}

template <std::size_t D>
void BfoIteration<D>::residual(std::span<const double> phi, std::span<const double> next,
                               std::span<double> r) {
    for (std::size_t i = 0; i < load_.size(); ++i) load_[i] = next[i] - phi[i];
    form_->poisson().multiply(load_, r, workspace_.poisson);
}

template <std::size_t D>
void BfoIteration<D>::poisson(std::span<const double> r, std::span<double> u) {
    form_->poisson().solve(r, u, shift_, workspace_.poisson);
}

// With t the trace, det the determinant and C the cofactors of grad Psi:
//
//   G^d          = t^d + delta (f - det)
//   d G^(d-1) dG = d t^(d-1) dt + delta (df - C : d grad Psi)
template <std::size_t D>
void BfoIteration<D>::linearise(const JacobianSource& source, std::span<const double> phi, bool moving) {
    const std::size_t slab = form_->slab();
    for (auto& array : coefficients_) array.resize(slab * form_->line().points.size());
    form_->expand(phi, Form::Border::given, form_->quadrature(), Form::fields, workspace_);
    form_->begin_load(workspace_);
    constexpr double part_of_delta = delta<D> / static_cast<double>(D);
    g_integral_ = integrate(false, [&](Band& band, Part&) {
        const auto f = std::span(band.f).first(band.size());
        if (moving)
            source.gradients(band.first, band.psi, f, band.slope);
        else
            source.values(band.first, band.psi, f);
        fill_g(band);
        for (std::size_t i = 0; i < band.size(); ++i) {
            const double g = D == 2 ? band.g[i] : band.g[i] * band.g[i];
            const double inverse = g > 0 ? 1 / g : 0; // G cut off at 0 has derivative 0
            const std::size_t at = band.first * slab + i;
            const double slope = moving ? part_of_delta * inverse : 0;
            coefficients_[0][at] = moving ? slope * band.slope.x[i] : 0;
            coefficients_[1][at] = moving ? slope * band.slope.y[i] : 0;
            if constexpr (D == 3) coefficients_[2][at] = moving ? slope * band.slope.z[i] : 0;
            const Symmetric<D> h = band.hessian(i), c = cofactors(h);
            const double t = trace(h), power = D == 2 ? t : t * t;
            for (std::size_t e = 0; e < entries; ++e)
                coefficients_[D + e][at] = -2 * part_of_delta * c[e] * inverse;
            for (const std::size_t d : diagonal<D>)
                coefficients_[D + d][at] = (power - part_of_delta * c[d]) * inverse;
        }
    });
    form_->end_load(g_load_, workspace_);
}

// d(s G) = s (dG - G (integral of dG) / (integral of G))
template <std::size_t D>
void BfoIteration<D>::derivative(std::span<const double> w, std::span<double> out) {
    const std::size_t slab = form_->slab();
    form_->expand(w, Form::Border::zero, form_->quadrature(), Form::fields, workspace_);
    form_->begin_load(workspace_);
    const double integral = integrate(false, [&](Band& band, Part&) {
        for (std::size_t i = 0; i < band.size(); ++i) {
            const std::size_t at = band.first * slab + i;
            double sum = coefficients_[0][at] * band.psi.x[i] + coefficients_[1][at] * band.psi.y[i];
            if constexpr (D == 3) sum += coefficients_[2][at] * band.psi.z[i];
            for (std::size_t e = 0; e < entries; ++e) sum += coefficients_[D + e][at] * band.h[e][i];
            band.g[i] = sum;
        }
    });
    form_->end_load(load_, workspace_);
    const double scale = form_->border_flux() / g_integral_, part = integral / g_integral_;
    form_->poisson().multiply(w, out, workspace_.poisson);
    for (std::size_t i = 0; i < load_.size(); ++i) out[i] += scale * (load_[i] - part * g_load_[i]);
}

template double norm_of_divergence<2>(const TensorForm<2>&);
template double norm_of_divergence<3>(const TensorForm<3>&);
template class BfoIteration<2>;
template class BfoIteration<3>;

} // namespace gaspard
