#include "core/spline/patch_inverse.hpp"

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

constexpr std::size_t side = 65; // sample points along each direction
constexpr double beyond = 0.1;   // how far parameters may leave [0, 1]
constexpr double longest_step = 2.0 / (side - 1);
constexpr int most_steps = 80;
constexpr double near_edge = 1e-6;    // of an edge, in parameters
constexpr double near_enough = 1e-14; // of a step, in parameters

double middle_of(std::size_t i) { return static_cast<double>(i) / (side - 1); }

/// What is known of the patch as a whole.
struct Samples {
    NearestPoint nearest;
    std::vector<Vec3> uv; ///< of its points
    std::array<PatchClosure, 2> closure{PatchClosure::open, PatchClosure::open};
    Vec3 low, high;                             ///< the bounds of u and v where F is continued
    std::array<std::array<bool, 2>, 2> point{}; ///< edges that are one point: of u = 0, u = 1; v = 0, v = 1
    double exact = 0;                           ///< distances below are rounding
};

/// F at the side x side points, u fastest.
Points sample(const PatchMap& map) {
    Points uv(side * side), x;
    for (std::size_t i = 0; i < uv.size(); ++i) uv.set(i, {middle_of(i % side), middle_of(i / side), 0});
    map.points(uv, x);
    return x;
}

/// The points of two opposite edges; `first`: those of u = 0 and u = 1.
Vec3 edge_point(const Points& x, bool first, bool far, std::size_t k) {
    const std::size_t end = far ? side - 1 : 0;
    return first ? x[k * side + end] : x[end * side + k];
}

PatchClosure closure_of(const Points& x, bool first, double rounding) {
    double same = 0, opposite = 0;
    for (std::size_t k = 0; k < side; ++k) {
        const Vec3 near = edge_point(x, first, false, k);
        same = std::max(same, norm(near - edge_point(x, first, true, k)));
        opposite = std::max(opposite, norm(near - edge_point(x, first, true, side - 1 - k)));
    }
    return same <= rounding       ? PatchClosure::periodic
           : opposite <= rounding ? PatchClosure::flipped
                                  : PatchClosure::open;
}

bool is_one_point(const Points& x, bool first, bool far, double rounding) {
    for (std::size_t k = 1; k < side; ++k)
        if (norm(edge_point(x, first, far, k) - edge_point(x, first, far, 0)) > rounding) return false;
    return true;
}

Samples make_samples(const PatchMap& map) {
    const Points x = sample(map);
    const double size = bounding_box(x).size(), rounding = 1e-12 * size;
    Samples samples{.nearest = {},
                    .uv = {},
                    .low = {-beyond, -beyond, 0},
                    .high = {1 + beyond, 1 + beyond, 0},
                    .exact = 1e-10 * size};
    auto& point = samples.point;
    for (const bool first : {true, false}) {
        const std::size_t d = first ? 0 : 1;
        samples.closure[d] = closure_of(x, first, rounding);
        for (const bool far : {false, true}) {
            point[d][far ? 1 : 0] = is_one_point(x, first, far, rounding);
            if (!point[d][far ? 1 : 0]) continue;
            double& bound =
                far ? (first ? samples.high.x : samples.high.y) : (first ? samples.low.x : samples.low.y);
            bound = far ? 1 : 0;
        }
        if (point[d][0] && point[d][1]) samples.closure[d] = PatchClosure::open; // two tips, perhaps the same
    }
    // No search starts at an edge that is one point: there F does not tell the directions apart.
    Points kept;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::size_t k = i % side, l = i / side, last = side - 1;
        if ((point[0][0] && k == 0) || (point[0][1] && k == last) || (point[1][0] && l == 0) ||
            (point[1][1] && l == last))
            continue;
        samples.uv.push_back({middle_of(k), middle_of(l), 0});
        kept.resize(kept.size() + 1);
        kept.set(kept.size() - 1, x[i]);
    }
    samples.nearest = NearestPoint(std::move(kept));
    return samples;
}

/// The search for the parameters of one point.
struct Search {
    std::size_t index; ///< of the point
    Vec3 uv, step;
    Vec3 residual, first, second; ///< x - F, dF/du, dF/dv
    double squared = std::numeric_limits<double>::infinity(), damping = 0;
    int seams = 0;     ///< crossed so far
    bool wide = false; ///< parameters may leave [0, 1]
};

struct Bounds {
    Vec3 low, high;
};

/// Within the square at first: beyond an edge, a map may fold back over the patch, and at an edge that is one
/// point, a search would not know where to go. Seams may be crossed.
Bounds bounds_of(const Search& s, const Samples& samples) {
    if (s.wide) return {samples.low, samples.high};
    const auto [left, right] = samples.point[0];
    const auto [bottom, top] = samples.point[1];
    Bounds bounds{{left ? near_edge : 0, bottom ? near_edge : 0, 0},
                  {1 - (right ? near_edge : 0), 1 - (top ? near_edge : 0), 0}};
    if (samples.closure[0] != PatchClosure::open) bounds.low.x = -beyond, bounds.high.x = 1 + beyond;
    if (samples.closure[1] != PatchClosure::open) bounds.low.y = -beyond, bounds.high.y = 1 + beyond;
    return bounds;
}

/// The step of the damped normal equations; a coordinate at its bound does not move out.
Vec3 damped_step(const Search& s, const Bounds& bounds) {
    const double aa = dot(s.first, s.first), bb = dot(s.second, s.second), ab = dot(s.first, s.second);
    const double ra = dot(s.first, s.residual), rb = dot(s.second, s.residual);
    const bool stuck_u = (s.uv.x <= bounds.low.x && ra < 0) || (s.uv.x >= bounds.high.x && ra > 0);
    const bool stuck_v = (s.uv.y <= bounds.low.y && rb < 0) || (s.uv.y >= bounds.high.y && rb > 0);
    const double da = aa * (1 + s.damping), db = bb * (1 + s.damping);
    if (stuck_u) return {0, !stuck_v && db > 0 ? rb / db : 0, 0};
    if (stuck_v) return {da > 0 ? ra / da : 0, 0, 0};
    const double area = da * db - ab * ab;
    if (!(area > 1e-28 * da * db)) return {da > 0 ? ra / da : 0, db > 0 ? rb / db : 0, 0};
    return {(db * ra - ab * rb) / area, (da * rb - ab * ra) / area, 0};
}

/// Replaces parameters beyond a seam by those of the same point on the other side. Returns whether it did.
bool cross_seam(Vec3& uv, const Samples& samples) {
    constexpr double rounding = 1e-12;
    for (const bool first : {true, false}) {
        const PatchClosure closure = samples.closure[first ? 0 : 1];
        double &mine = first ? uv.x : uv.y, &other = first ? uv.y : uv.x;
        if (closure == PatchClosure::open || (mine >= -rounding && mine <= 1 + rounding)) continue;
        mine -= std::floor(mine);
        if (closure == PatchClosure::flipped) other = 1 - other;
        return true;
    }
    return false;
}

bool at_edge(Vec3 uv) { return std::min(uv.x, uv.y) <= near_edge || std::max(uv.x, uv.y) >= 1 - near_edge; }

class Inverse final : public PatchParameters {
  public:
    explicit Inverse(std::shared_ptr<const PatchMap> map) : map_(std::move(map)) {
        GASPARD_CHECK(map_ != nullptr);
    }

    void find(const Points& x, Points& uv) const override {
        uv.resize(x.size());
        if (map_->is_identity()) {
            for (std::size_t i = 0; i < x.size(); ++i) uv.set(i, {x.x[i], x.y[i], 0});
            return;
        }
        constexpr std::size_t block = 1024; // as many as fit into the cache
        for (std::size_t begin = 0; begin < x.size(); begin += block)
            find_block(x, begin, std::min(x.size(), begin + block), uv);
    }
    void points(const Points& uv, Points& x) const override { map_->points(uv, x); }
    void tangents(const Points& uv, Points& first, Points& second) const override {
        std::array<Points, 2> both;
        map_->tangents(uv, both);
        first = std::move(both[0]), second = std::move(both[1]);
    }
    std::array<PatchClosure, 2> closure() const override { return samples().closure; }

  private:
    const Samples& samples() const {
        std::call_once(once_, [this] { samples_ = make_samples(*map_); });
        return samples_;
    }

    void find_block(const Points& x, std::size_t begin, std::size_t end, Points& uv) const {
        const Samples& known = samples();
        std::vector<Search> active;
        for (std::size_t i = begin; i < end; ++i) {
            uv.set(i, known.uv[known.nearest(x[i])]);
            active.push_back(
                {.index = i, .uv = uv[i], .step = {}, .residual = {}, .first = {}, .second = {}});
        }
        Points trial, there;
        std::array<Points, 2> tangents;
        for (int k = 0; k < most_steps && !active.empty(); ++k) {
            trial.resize(active.size());
            for (std::size_t j = 0; j < active.size(); ++j) trial.set(j, next(active[j], known));
            map_->points(trial, there);
            map_->tangents(trial, tangents);
            std::size_t left = 0;
            for (std::size_t j = 0; j < active.size(); ++j) {
                Search& s = active[j];
                const bool done =
                    judge(s, trial[j], x[s.index] - there[j], tangents[0][j], tangents[1][j], known);
                uv.set(s.index, s.uv);
                if (!done) active[left++] = s;
            }
            active.resize(left);
        }
        for (std::size_t i = begin; i < end; ++i) {
            if (known.closure[0] != PatchClosure::open) uv.x[i] = std::clamp(uv.x[i], 0.0, 1.0);
            if (known.closure[1] != PatchClosure::open) uv.y[i] = std::clamp(uv.y[i], 0.0, 1.0);
        }
    }

    /// The parameters to be tried next.
    static Vec3 next(Search& s, const Samples& known) {
        if (!std::isfinite(s.squared)) return s.uv; // the first time
        const Bounds bounds = bounds_of(s, known);
        const Vec3 step = damped_step(s, bounds);
        const double length = std::max(std::abs(step.x), std::abs(step.y));
        const Vec3 to = s.uv + (length > longest_step ? longest_step / length : 1.0) * step;
        const Vec3 within{std::clamp(to.x, bounds.low.x, bounds.high.x),
                          std::clamp(to.y, bounds.low.y, bounds.high.y), 0};
        s.step = within - s.uv;
        return within;
    }

    /// Accepts the trial if it is nearer. Returns whether the search has ended.
    static bool judge(Search& s, Vec3 trial, Vec3 residual, Vec3 first, Vec3 second, const Samples& known) {
        const double squared = dot(residual, residual),
                     step = std::max(std::abs(s.step.x), std::abs(s.step.y));
        const bool start = !std::isfinite(s.squared);
        if (!std::isfinite(squared)) return true; // no such point: the start is kept
        const bool nearer = squared <= s.squared;
        if (nearer) {
            s.uv = trial, s.residual = residual, s.first = first, s.second = second, s.squared = squared;
            s.damping = s.damping > 1e-6 ? 0.1 * s.damping : 0;
        } else {
            s.damping = std::max(1e-3, 10 * s.damping);
        }
        if (start) return false;
        if (nearer && s.seams < 3 && cross_seam(s.uv, known)) {
            ++s.seams;
            s.squared = std::numeric_limits<double>::infinity(); // evaluated anew on the other side
            return false;
        }
        if (step > near_enough && s.damping <= 1e12) return false;
        if (s.wide || std::sqrt(s.squared) <= known.exact || !at_edge(s.uv)) return true;
        s.wide = true, s.damping = 0; // a point beside the patch
        return false;
    }

    std::shared_ptr<const PatchMap> map_;
    mutable std::once_flag once_;
    mutable Samples samples_;
};

} // namespace

std::shared_ptr<const PatchParameters> patch_parameters(std::shared_ptr<const PatchMap> map) {
    return std::make_shared<Inverse>(std::move(map));
}

} // namespace gaspard
