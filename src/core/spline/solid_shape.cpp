#include "core/spline/solid_shape.hpp"

#include "core/base/box.hpp"
#include "core/base/check.hpp"
#include "core/spline/nearest_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

namespace gaspard {

namespace {

constexpr std::size_t cube_side = 33; // sample points along each direction
constexpr double longest_cube_step = 2.0 / (cube_side - 1);
constexpr int most_cube_steps = 60;
constexpr double last_cube_step = 1e-9; // in parameters

double parameter_of(std::size_t i) { return static_cast<double>(i) / (cube_side - 1); }

struct SolidSamples {
    NearestPoint nearest;
    Points xi;
    /// A ball of this radius around the sample lies in the solid; 0 at the boundary.
    std::vector<double> inner;
    double exact = 0; ///< distances below are rounding
    double volume = 0;
    std::array<bool, 3> closed{}; ///< the two sides of a direction are the same, as those of a full pipe
};

/// Sample i of a side of the direction, as a number of a sample on its low and its high side.
std::array<std::size_t, 2> opposite_samples(std::size_t direction, std::size_t i) {
    constexpr std::size_t n = cube_side;
    const std::size_t step = direction == 0 ? 1 : direction == 1 ? n : n * n;
    const std::size_t fast = i % step, slow = i / step;
    const std::size_t low = slow * step * n + fast;
    return {low, low + step * (n - 1)};
}

bool is_closed(const Points& x, std::size_t direction, double rounding) {
    for (std::size_t i = 0; i < cube_side * cube_side; ++i) {
        const auto [low, high] = opposite_samples(direction, i);
        if (norm(x[high] - x[low]) > rounding) return false;
    }
    return true;
}

/// The farthest that neighbours on the boundary are apart: between them it may come nearer than they are.
double widest_gap(const Points& x) {
    constexpr std::size_t n = cube_side, plane = n * n;
    double gap = 0;
    for (const std::size_t across : {std::size_t{1}, n, plane}) {
        const std::size_t first = across == 1 ? n : 1, second = across == plane ? n : plane;
        for (const std::size_t at : {std::size_t{0}, across * (n - 1)})
            for (std::size_t i = 0; i + 1 < n; ++i)
                for (std::size_t j = 0; j + 1 < n; ++j) {
                    const std::size_t corner = at + i * first + j * second;
                    gap = std::max(gap, norm(x[corner + first + second] - x[corner]));
                    gap = std::max(gap, norm(x[corner + first] - x[corner + second]));
                }
    }
    return gap;
}

double volume_of(const SolidMap& map) {
    const Points xi = cube_middles(24);
    Points x;
    std::vector<double> element(xi.size());
    map.places(xi, x, element);
    double sum = 0;
    for (const double one : element) sum += one;
    return sum / static_cast<double>(xi.size());
}

SolidSamples sample_solid(const SolidMap& map) {
    constexpr std::size_t n = cube_side;
    SolidSamples samples{.nearest = {}, .xi = Points(n * n * n), .inner = {}};
    Points x, boundary;
    std::vector<bool> outer(samples.xi.size());
    for (std::size_t i = 0; i < samples.xi.size(); ++i) {
        const std::array<std::size_t, 3> at{i % n, i / n % n, i / n / n};
        samples.xi.set(i, {parameter_of(at[0]), parameter_of(at[1]), parameter_of(at[2])});
    }
    map.points(samples.xi, x);
    const double size = bounding_box(x).size();
    for (std::size_t d = 0; d < 3; ++d) {
        samples.closed[d] = is_closed(x, d, 1e-12 * size);
        for (std::size_t i = 0; !samples.closed[d] && i < n * n; ++i)
            for (const std::size_t end : opposite_samples(d, i)) outer[end] = true;
    }
    for (std::size_t i = 0; i < x.size(); ++i)
        if (outer[i]) boundary.resize(boundary.size() + 1), boundary.set(boundary.size() - 1, x[i]);
    const double gap = widest_gap(x);
    const NearestPoint nearest_outer(std::move(boundary));
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double distance = outer[i] ? 0 : norm(nearest_outer.points()[nearest_outer(x[i])] - x[i]);
        samples.inner.push_back(std::max(0.0, distance - gap));
    }
    samples.exact = 1e-10 * size;
    samples.volume = volume_of(map);
    samples.nearest = NearestPoint(std::move(x));
    return samples;
}

using Three = std::array<double, 3>;

/// The search for the parameters of one point.
struct SolidSearch {
    std::size_t index; ///< of the point
    Three xi{}, step{};
    Vec3 residual{}; ///< x - F
    std::array<Vec3, 3> tangents{};
    double squared = std::numeric_limits<double>::infinity(), damping = 0;
    bool crossed = false; ///< a seam
};

/// Solves the damped normal equations (A + damping diag A) s = b of the free directions, in place of b.
void solve_free(std::array<Three, 3>& a, Three& b, const std::array<bool, 3>& free, double damping) {
    for (std::size_t j = 0; j < 3; ++j) {
        if (!free[j]) {
            for (std::size_t k = 0; k < 3; ++k) a[j][k] = a[k][j] = 0;
            a[j][j] = 1, b[j] = 0;
        } else {
            a[j][j] *= 1 + damping + 1e-12;
        }
    }
    for (std::size_t j = 0; j < 3; ++j) { // Cholesky
        for (std::size_t k = 0; k < j; ++k) a[j][j] -= a[j][k] * a[j][k];
        a[j][j] = std::sqrt(std::max(a[j][j], std::numeric_limits<double>::min()));
        for (std::size_t i = j + 1; i < 3; ++i) {
            for (std::size_t k = 0; k < j; ++k) a[i][j] -= a[i][k] * a[j][k];
            a[i][j] /= a[j][j];
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
        b[i] /= a[i][i];
    }
    for (std::size_t i = 3; i-- > 0;) {
        for (std::size_t k = i + 1; k < 3; ++k) b[i] -= a[k][i] * b[k];
        b[i] /= a[i][i];
    }
}

Three damped_cube_step(const SolidSearch& s) {
    std::array<Three, 3> a{};
    Three b{};
    std::array<bool, 3> free{};
    for (std::size_t j = 0; j < 3; ++j) {
        b[j] = dot(s.tangents[j], s.residual);
        for (std::size_t k = 0; k < 3; ++k) a[j][k] = dot(s.tangents[j], s.tangents[k]);
        // A coordinate at its bound does not move out; one along which F does not move stays.
        free[j] = a[j][j] > 0 && !(s.xi[j] <= 0 && b[j] < 0) && !(s.xi[j] >= 1 && b[j] > 0);
    }
    solve_free(a, b, free, s.damping);
    return b;
}

/// The parameters to be tried next.
Three next_in_cube(SolidSearch& s) {
    if (!std::isfinite(s.squared)) return s.xi; // the first time
    const Three step = damped_cube_step(s);
    double length = 0;
    for (const double one : step) length = std::max(length, std::abs(one));
    const double factor = length > longest_cube_step ? longest_cube_step / length : 1;
    Three to{};
    for (std::size_t d = 0; d < 3; ++d) {
        to[d] = std::clamp(s.xi[d] + factor * step[d], 0.0, 1.0);
        s.step[d] = to[d] - s.xi[d];
    }
    return to;
}

/// Goes on from the other side of the seams at which a search has ended; once. Returns whether it does.
bool cross_seams(SolidSearch& s, const std::array<bool, 3>& closed) {
    bool at_seam = false;
    for (std::size_t d = 0; !s.crossed && d < 3; ++d)
        if (closed[d] && (s.xi[d] <= 0 || s.xi[d] >= 1)) s.xi[d] = 1 - s.xi[d], at_seam = true;
    if (!at_seam) return false;
    s.crossed = true, s.damping = 0;
    s.squared = std::numeric_limits<double>::infinity(); // evaluated anew
    return true;
}

/// Accepts the trial if it is nearer. Returns whether the search has ended.
bool judge_in_cube(SolidSearch& s, const Three& trial, Vec3 residual, const std::array<Vec3, 3>& tangents,
                   const SolidSamples& known) {
    const double squared = dot(residual, residual);
    double step = 0;
    for (const double one : s.step) step = std::max(step, std::abs(one));
    const bool start = !std::isfinite(s.squared);
    if (!std::isfinite(squared)) return true; // no such point: the start is kept
    if (squared <= s.squared) {
        s.xi = trial, s.residual = residual, s.tangents = tangents, s.squared = squared;
        s.damping = s.damping > 1e-6 ? 0.1 * s.damping : 0;
    } else {
        s.damping = std::max(1e-3, 10 * s.damping);
    }
    if (std::sqrt(s.squared) <= known.exact) return true;
    return !start && (step <= last_cube_step || s.damping > 1e12) && !cross_seams(s, known.closed);
}

class Shape final : public SolidShape {
  public:
    explicit Shape(std::shared_ptr<const SolidMap> map) : map_(std::move(map)) {
        GASPARD_CHECK(map_ != nullptr);
    }

    void nearest(const Points& x, Points& nearest) const override {
        nearest = x;
        if (is_box()) {
            for (auto* all : {&nearest.x, &nearest.y, &nearest.z})
                for (double& one : *all) one = std::clamp(one, 0.0, 1.0);
            return;
        }
        constexpr std::size_t block = 1024; // as many as fit into the cache
        for (std::size_t begin = 0; begin < x.size(); begin += block)
            find_block(x, begin, std::min(x.size(), begin + block), nearest);
    }
    double volume() const override { return is_box() ? 1 : samples().volume; }
    bool is_box() const override { return map_->is_identity(); }

  private:
    const SolidSamples& samples() const {
        std::call_once(once_, [this] { samples_ = sample_solid(*map_); });
        return samples_;
    }

    void find_block(const Points& x, std::size_t begin, std::size_t end, Points& nearest) const {
        const SolidSamples& known = samples();
        std::vector<SolidSearch> active;
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t start = known.nearest(x[i]);
            if (norm(known.nearest.points()[start] - x[i]) < known.inner[start]) continue;
            const Vec3 xi = known.xi[start];
            active.push_back({.index = i, .xi = {xi.x, xi.y, xi.z}});
        }
        Points trial, there;
        std::array<Points, 3> tangents;
        std::vector<Three> tried;
        for (int k = 0; k < most_cube_steps && !active.empty(); ++k) {
            trial.resize(active.size()), tried.resize(active.size());
            for (std::size_t j = 0; j < active.size(); ++j) {
                tried[j] = next_in_cube(active[j]);
                trial.set(j, {tried[j][0], tried[j][1], tried[j][2]});
            }
            map_->points(trial, there);
            map_->tangents(trial, tangents);
            std::size_t left = 0;
            for (std::size_t j = 0; j < active.size(); ++j) {
                SolidSearch& s = active[j];
                const bool done = judge_in_cube(s, tried[j], x[s.index] - there[j],
                                                {tangents[0][j], tangents[1][j], tangents[2][j]}, known);
                nearest.set(s.index, x[s.index] - s.residual);
                if (!done) active[left++] = s;
            }
            active.resize(left);
        }
    }

    std::shared_ptr<const SolidMap> map_;
    mutable std::once_flag once_;
    mutable SolidSamples samples_;
};

} // namespace

std::shared_ptr<const SolidShape> solid_shape(std::shared_ptr<const SolidMap> map) {
    return std::make_shared<Shape>(std::move(map));
}

} // namespace gaspard
