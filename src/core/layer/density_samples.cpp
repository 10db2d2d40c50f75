#include "core/layer/density_samples.hpp"

#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

/// A rule on a triangle: barycentric coordinates and weights.
struct Sample {
    std::array<double, 3> at;
    double weight;
};

/// The corners; or the closed Newton-Cotes rule of degree 4, whose corners have weight 0.
std::vector<Sample> rule(DensitySamples samples) {
    if (samples == DensitySamples::corners)
        return {{{1, 0, 0}, 1.0 / 3}, {{0, 1, 0}, 1.0 / 3}, {{0, 0, 1}, 1.0 / 3}};
    constexpr double side = 4.0 / 45, half = -1.0 / 45, inside = 8.0 / 45;
    return {{{0.75, 0.25, 0}, side},     {{0.25, 0.75, 0}, side},     {{0, 0.75, 0.25}, side},
            {{0, 0.25, 0.75}, side},     {{0.25, 0, 0.75}, side},     {{0.75, 0, 0.25}, side},
            {{0.5, 0.5, 0}, half},       {{0, 0.5, 0.5}, half},       {{0.5, 0, 0.5}, half},
            {{0.5, 0.25, 0.25}, inside}, {{0.25, 0.5, 0.25}, inside}, {{0.25, 0.25, 0.5}, inside}};
}

[[noreturn]] void refuse_densities(const Points& at, std::span<const double> m) {
    std::size_t i = 0;
    while (m[i] > 0 && std::isfinite(m[i])) ++i;
    throw InputError("the density of the mesh must be positive and finite, but is " + exact_number(m[i]) +
                     " at (" + exact_number(at.x[i]) + ", " + exact_number(at.y[i]) + ")");
}

} // namespace

DensitySampler::DensitySampler(int n, DensitySamples samples) : n_(static_cast<Index>(n)) {
    struct Found {
        Index triangle, place, shift;
        bool lower;
        std::array<double, 3> weights;
    };
    std::vector<Found> found;
    for (Index t = 0; t < 4; ++t)
        for (const Sample& sample : rule(samples)) {
            std::array<double, 5> of{};
            for (Index k = 0; k < 3; ++k) of[crossed_triangles[t][k]] = sample.at[k];
            // Right sides are left sides of the next quadrilateral, lower ones upper ones of the row below.
            const bool right = of[0] + of[2] + of[4] == 0;
            if (right) of = {of[1], 0, of[3], 0, 0};
            const bool lower = of[2] + of[3] + of[4] == 0;
            if (lower) of = {0, 0, of[0], of[1], 0};
            Found one{t, place(of), right ? Index{1} : Index{0}, lower, {}};
            for (Index k = 0; k < 3; ++k) one.weights[k] = sample.weight * sample.at[k];
            found.push_back(one);
        }
    for (Place& p : places_) {
        p.count = p.of[1] + p.of[3] + p.of[4] == 0 ? n_ + 1 : n_;
        p.first = evaluated_;
        evaluated_ += p.count;
    }
    size_ = evaluated_;
    for (Place& p : places_)
        if (p.of[0] + p.of[1] + p.of[4] == 0) p.below = size_, size_ += p.count;
    for (const Found& one : found) {
        const Place& p = places_[one.place];
        terms_[one.triangle].push_back({(one.lower ? p.below : p.first) + one.shift, one.weights});
    }
}

DensitySampler::Index DensitySampler::place(const std::array<double, 5>& of) {
    const auto same = [&](const Place& p) { return p.of == of; };
    const auto at = std::find_if(places_.begin(), places_.end(), same);
    if (at != places_.end()) return static_cast<Index>(at - places_.begin());
    places_.push_back({.of = of});
    return places_.size() - 1;
}

void DensitySampler::put_points(const Points& nodes, const Points& centres, Rows rows, const Place& place,
                                Index to, Points& at) const {
    const auto& w = place.of;
    const auto put = [&](const std::vector<double>& x, const std::vector<double>& c, double* out) {
        const double *lower = x.data() + rows.lower * (n_ + 1), *upper = x.data() + rows.upper * (n_ + 1);
        const double* centre = c.data() + rows.lower * n_;
        if (place.count > n_)
            for (Index i = 0; i <= n_; ++i) out[i] = w[0] * lower[i] + w[2] * upper[i];
        else
            for (Index i = 0; i < n_; ++i)
                out[i] = w[0] * lower[i] + w[1] * lower[i + 1] + w[2] * upper[i] + w[3] * upper[i + 1] +
                         w[4] * centre[i];
    };
    put(nodes.x, centres.x, at.x.data() + to);
    put(nodes.y, centres.y, at.y.data() + to);
}

void DensitySampler::sweep(const Points& nodes, const Points& centres, Index count, const Evaluate& evaluate,
                           const std::function<void(Index row, const Fields&)>& use) const {
    Fields fields(count), first(count);
    Points lowest(size_ - evaluated_), at(evaluated_);
    for (const Place& p : places_)
        if (p.below > 0) put_points(nodes, centres, {0, 0}, p, p.below - evaluated_, lowest);
    for (auto& values : first) values.resize(lowest.size());
    evaluate(lowest, first);
    for (Index f = 0; f < count; ++f) {
        fields[f].resize(size_);
        std::copy(first[f].begin(), first[f].end(),
                  fields[f].begin() + static_cast<std::ptrdiff_t>(evaluated_));
    }
    for (Index row = 0; row < n_; ++row) {
        for (const Place& p : places_) put_points(nodes, centres, {row, row + 1}, p, p.first, at);
        evaluate(at, fields);
        use(row, fields);
        for (auto& values : fields)
            for (const Place& p : places_)
                if (p.below > 0)
                    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(p.first), p.count,
                                values.begin() + static_cast<std::ptrdiff_t>(p.below));
    }
}

/// Both densities at points, checked.
void DensitySampler::evaluate(const LayerDensities& densities, const Points& at, Fields& fields) {
    const std::span<double> m11(fields[0].data(), at.size()), m22(fields[1].data(), at.size());
    densities(at, m11, m22);
    for (const auto m : {m11, m22}) {
        bool good = true;
        for (const double value : m) good &= value > 0 && value <= std::numeric_limits<double>::max();
        if (!good) refuse_densities(at, m);
    }
}

void DensitySampler::means(const LayerDensities& densities, const Points& nodes, const Points& centres,
                           TriangleDensities& means) const {
    for (auto& mean : means) mean.resize(4 * n_ * n_);
    std::vector<double> sums(n_);
    sweep(
        nodes, centres, 2, [&](const Points& at, Fields& fields) { evaluate(densities, at, fields); },
        [&](Index row, const Fields& fields) {
            for (const Index axis : {Index{0}, Index{1}})
                for (Index t = 0; t < 4; ++t) {
                    std::fill(sums.begin(), sums.end(), 0.0);
                    for (const Term& term : terms_[t]) {
                        const double weight = term.weights[0] + term.weights[1] + term.weights[2];
                        const double* const m = fields[axis].data() + term.at;
                        for (Index i = 0; i < n_; ++i) sums[i] += weight * m[i];
                    }
                    double* const mean = means[axis].data() + 4 * row * n_ + t;
                    for (Index i = 0; i < n_; ++i) mean[4 * i] = sums[i];
                }
        });
}

DensitySampler::Derivatives DensitySampler::derivatives(const LayerDensities& densities, const Points& nodes,
                                                        const Points& centres, Vec3 middle) const {
    constexpr double shift = 1e-11;
    Derivatives derivatives;
    for (auto& of_axis : derivatives)
        for (auto& of : of_axis) of.resize(4 * n_ * n_);
    const auto slopes = [&](const Points& at, Fields& fields) { // [2 axis + coordinate]
        Fields here(2, std::vector<double>(at.size())), there = here;
        evaluate(densities, at, here);
        for (const Index coordinate : {Index{0}, Index{1}}) {
            Points moved = at;
            std::vector<double>& x = coordinate == 0 ? moved.x : moved.y;
            const std::vector<double>& from = coordinate == 0 ? at.x : at.y;
            for (double& value : x) value += value < (coordinate == 0 ? middle.x : middle.y) ? shift : -shift;
            evaluate(densities, moved, there);
            for (const Index axis : {Index{0}, Index{1}})
                for (Index i = 0; i < at.size(); ++i)
                    fields[2 * axis + coordinate][i] = (there[axis][i] - here[axis][i]) / (x[i] - from[i]);
        }
    };
    sweep(nodes, centres, 4, slopes, [&](Index row, const Fields& fields) {
        for (Index f = 0; f < 4; ++f)
            for (Index t = 0; t < 4; ++t)
                for (const Term& term : terms_[t])
                    for (Index i = 0; i < n_; ++i)
                        for (Index k = 0; k < 3; ++k)
                            derivatives[f / 2][f % 2][4 * (row * n_ + i) + t][k] +=
                                term.weights[k] * fields[f][term.at + i];
    });
    return derivatives;
}

} // namespace gaspard
