// Newton's method for the fixed point of a mesh PDE on quadrilaterals. The equation of a node p and an axis,
//
//   sum over triangles T at p of m_T (k_T u)_p = 0,
//
// has positive and negative terms, flows in and out, whose sums I and O are compared as ln(I / O): densities
// depend on positions exponentially, their logarithms do not. The iteration solve() amplifies errors of nodes
// at the edge of a layer of width eps by up to 1 / (N eps) and ends in a cycle for small eps.
//
// Newton's method alone gets stuck, too: a triangle at the edge of a layer is much larger than eps, and when
// it grows, so that its samples leave the layer, the flow through it falls by orders of magnitude. A step
// that is short enough for the linearisation brings no node across. Steps are therefore those of the
// linearly implicit Euler method for
//
//   l_p dy_p / dt = -ln(I / O),   l_p: the shortest shift of p at which one of its triangles has no area,
//
// whose stable rest points are the solutions. They need not reduce the residual. The time step tau is
// limited by the change of the triangles' areas, and grows until the step is Newton's.
//
// With samples at the corners the flow through a triangle grows with the triangle, whatever the width of the
// layer: h (rho(y) + rho(y + h)) / 2 does for an exponential. The rule of degree 4 has no weight at the
// corners, and the flow does not: the equations have many solutions then, each with another set of nodes in
// the layer, and for (34), whose columns choose one by one, paths between them are long.
#include "core/layer/square_level.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gaspard {

using Index = std::size_t;

struct SquareLevel::Residual {
    std::vector<double> in, out; ///< by unknowns; both 1 where the unknown is fixed
    std::vector<double> values() const {
        std::vector<double> f(in.size());
        for (Index i = 0; i < f.size(); ++i) f[i] = std::log(in[i] / out[i]);
        return f;
    }
    double norm() const {
        double sum = 0;
        for (const double f : values()) sum += f * f;
        return std::sqrt(sum / static_cast<double>(in.size()));
    }
};

Index SquareLevel::unknown(Index axis, Index point) const {
    return (form_ == MeshPdeForm::componentwise ? axis : 0) * (node_count() + quad_count()) + point;
}

/// Its corners and its centre as points: nodes, then centres.
std::array<Index, 5> SquareLevel::quad_points(Index quad) const {
    const auto n = static_cast<Index>(n_);
    const Index p = quad / n * (n + 1) + quad % n;
    return {p, p + 1, p + n + 1, p + n + 2, node_count() + quad};
}

std::array<Index, 3> SquareLevel::triangle_points(Index triangle) const {
    const std::array<Index, 5> points = quad_points(triangle / 4);
    std::array<Index, 3> of{};
    for (Index k = 0; k < 3; ++k) of[k] = points[crossed_triangles[triangle % 4][k]];
    return of;
}

std::vector<Index> SquareLevel::axes() const {
    return form_ == MeshPdeForm::componentwise ? std::vector<Index>{0, 1} : std::vector<Index>{1};
}

double SquareLevel::coordinate(Index axis, Index point) const {
    const Points& of = point < node_count() ? nodes_ : centres_;
    const Index at = point < node_count() ? point : point - node_count();
    return axis == 0 ? of.x[at] : of.y[at];
}

/// How many quadrilaterals have the point.
double SquareLevel::quads_at(Index point) const {
    if (point >= node_count()) return 1;
    const auto n = static_cast<Index>(n_);
    const auto along = [n](Index k) { return k == 0 || k == n ? 1 : 2; };
    return along(point % (n + 1)) * along(point / (n + 1));
}

bool SquareLevel::is_fixed_point(Index axis, Index point) const {
    if (point >= node_count()) return false;
    const auto s = static_cast<Index>(n_ + 1);
    return is_fixed(axis, static_cast<int>(point % s), static_cast<int>(point / s));
}

/// From the means of the densities.
SquareLevel::Residual SquareLevel::residual() const {
    const Index size = axes().size() * (node_count() + quad_count());
    Residual r{std::vector<double>(size, 0.0), std::vector<double>(size, 0.0)};
    for (Index triangle = 0; triangle < 4 * quad_count(); ++triangle) {
        const auto points = triangle_points(triangle);
        const int q = static_cast<int>(triangle / 4);
        const auto k = stiffness(q % n_, q / n_)[triangle % 4];
        for (const Index axis : axes())
            for (Index a = 0; a < 3; ++a) {
                double flow = 0;
                for (Index b = 0; b < 3; ++b) flow += k[a][b] * coordinate(axis, points[b]);
                flow *= means_[axis][triangle];
                const Index row = unknown(axis, points[a]);
                (flow > 0 ? r.in : r.out)[row] += std::abs(flow);
            }
    }
    for (const Index axis : axes())
        for (Index point = 0; point < node_count(); ++point)
            if (is_fixed_point(axis, point)) r.in[unknown(axis, point)] = r.out[unknown(axis, point)] = 1;
    return r;
}

/// The equations of one quadrilateral, over the unknowns of its points. A fixed unknown has an equation of
/// its own. A diagonal entry of `shift` is divided among the quadrilaterals of the point.
void SquareLevel::newton_matrix(Index quad, const Residual& r, const DensitySampler::Derivatives& derivatives,
                                const std::vector<double>& shift, std::span<double> matrix) const {
    const std::vector<Index> all = axes();
    const std::array<Index, 5> points = quad_points(quad);
    const Index size = 5 * all.size();
    const auto stiff =
        stiffness(static_cast<int>(quad) % n_, static_cast<int>(quad) / n_); // for a density of 1
    std::fill(matrix.begin(), matrix.end(), 0.0);
    for (Index x = 0; x < all.size(); ++x)
        for (Index p = 0; p < 5; ++p) {
            double& diagonal = matrix[(5 * x + p) * (size + 1)];
            if (is_fixed_point(all[x], points[p]))
                diagonal = 1;
            else if (!shift.empty())
                diagonal = shift[unknown(all[x], points[p])] / quads_at(points[p]);
        }
    for (Index t = 0; t < 4; ++t)
        for (Index x = 0; x < all.size(); ++x)
            for (Index a = 0; a < 3; ++a) {
                const std::array<Index, 3>& corner = crossed_triangles[t];
                const Index point = points[corner[a]], triangle = 4 * quad + t;
                if (is_fixed_point(all[x], point)) continue;
                double flow = 0;
                for (Index b = 0; b < 3; ++b) flow += stiff[t][a][b] * coordinate(all[x], points[corner[b]]);
                const double scale = 1 / (flow > 0 ? r.in : r.out)[unknown(all[x], point)];
                double* row = matrix.data() + (5 * x + corner[a]) * size;
                for (Index b = 0; b < 3; ++b) {
                    row[5 * x + corner[b]] += scale * means_[all[x]][triangle] * stiff[t][a][b];
                    for (Index y = 0; y < all.size(); ++y)
                        row[5 * y + corner[b]] += scale * flow * derivatives[all[x]][all[y]][triangle][b];
                }
            }
}

/// Made once; the unknowns of each quadrilateral, by axes those of its points.
const SquareLevel::Elimination& SquareLevel::elimination() {
    if (!elimination_) {
        CellUnknowns unknowns{axes().size() * (node_count() + quad_count()), 5 * axes().size(), {}};
        Points middles(quad_count());
        for (Index q = 0; q < quad_count(); ++q) {
            const auto n = static_cast<Index>(n_);
            middles.set(q, {static_cast<double>(q % n), static_cast<double>(q / n), 0});
            for (const Index axis : axes())
                for (const Index point : quad_points(q))
                    unknowns.numbers.push_back(static_cast<std::int32_t>(unknown(axis, point)));
        }
        Dissection dissection = dissect(unknowns, middles);
        elimination_ =
            std::make_shared<const Elimination>(Elimination{std::move(unknowns), std::move(dissection)});
    }
    return *elimination_;
}

/// The step by unknowns; `shift` is added to the diagonal.
std::vector<double> SquareLevel::newton_direction(const Residual& r,
                                                  const DensitySampler::Derivatives& derivatives,
                                                  const std::vector<double>& shift,
                                                  const std::stop_token& stop) {
    const auto& [unknowns, dissection] = elimination();
    std::vector<double> f = r.values();
    for (double& value : f) value = -value;
    return solve_by_parts(
        unknowns, dissection,
        [&](Index quad, std::span<double> matrix) { newton_matrix(quad, r, derivatives, shift, matrix); }, f,
        stop);
}

/// Twice the areas of the triangles.
std::vector<double> SquareLevel::areas() const {
    std::vector<double> areas(4 * quad_count());
    for (Index triangle = 0; triangle < areas.size(); ++triangle) {
        const auto p = triangle_points(triangle);
        const auto at = [&](Index k) { return Vec3{coordinate(0, p[k]), coordinate(1, p[k]), 0}; };
        areas[triangle] = cross(at(1) - at(0), at(2) - at(0)).z;
    }
    return areas;
}

/// By unknowns, l_p: twice the area of a triangle is linear in a coordinate of its corner, its slope the
/// extent of the opposite edge. Infinite where an unknown is fixed.
std::vector<double> SquareLevel::distances_to_inversion(const std::vector<double>& areas) const {
    constexpr double far = std::numeric_limits<double>::infinity();
    std::vector<double> distances(axes().size() * (node_count() + quad_count()), far);
    for (Index triangle = 0; triangle < areas.size(); ++triangle) {
        const auto p = triangle_points(triangle);
        for (const Index axis : axes())
            for (Index k = 0; k < 3; ++k) {
                if (is_fixed_point(axis, p[k])) continue;
                const Index a = p[(k + 1) % 3], b = p[(k + 2) % 3];
                const double extent = std::abs(coordinate(1 - axis, a) - coordinate(1 - axis, b));
                double& distance = distances[unknown(axis, p[k])];
                if (areas[triangle] < distance * extent) distance = areas[triangle] / extent;
            }
    }
    return distances;
}

/// What a change of positions by half a unit in the last place makes of the residual.
double SquareLevel::rounding(const std::vector<double>& distances) const {
    double sum = 0;
    for (const Index axis : axes())
        for (Index point = 0; point < node_count() + quad_count(); ++point)
            sum += std::pow(coordinate(axis, point) / distances[unknown(axis, point)], 2);
    return 0.5 * std::numeric_limits<double>::epsilon() *
           std::sqrt(sum / static_cast<double>(distances.size()));
}

/// Moves the free unknowns from a position by a part of the step; returns the largest change.
double SquareLevel::move(const Points& nodes, const Points& centres, const std::vector<double>& step,
                         double factor) {
    double update = 0;
    for (const Index axis : axes())
        for (Index point = 0; point < node_count() + quad_count(); ++point) {
            if (is_fixed_point(axis, point)) continue;
            const bool is_node = point < node_count();
            const Index at = is_node ? point : point - node_count();
            const Points& from = is_node ? nodes : centres;
            Points& to = is_node ? nodes_ : centres_;
            const double change = factor * step[unknown(axis, point)];
            (axis == 0 ? to.x : to.y)[at] = (axis == 0 ? from.x : from.y)[at] + change;
            update = std::max(update, std::abs(change));
        }
    return update;
}

/// Whether the areas have changed by a factor of `most` and less, and none is inverted.
static bool is_gentle(const std::vector<double>& before, const std::vector<double>& after, double most) {
    for (Index i = 0; i < before.size(); ++i)
        if (!(after[i] > 0) || after[i] > most * before[i] || before[i] > most * after[i]) return false;
    return true;
}
static double largest_change(const std::vector<double>& before, const std::vector<double>& after) {
    double change = 0;
    for (Index i = 0; i < before.size(); ++i)
        change = std::max(change, std::abs(std::log(after[i] / before[i])));
    return change;
}

SquareMeshNewton SquareLevel::newton(const LayerDensities& densities, const std::stop_token& stop) {
    constexpr double most = 7.4;      ///< factor by which areas may change
    constexpr double shortest = 1e-6; ///< time step
    sampler_.means(densities, nodes_, centres_, means_);
    const Residual r = residual();
    const std::vector<double> before = areas(), distances = distances_to_inversion(before);
    SquareMeshNewton result{.residual = r.norm(), .rounding = rounding(distances)};
    const Vec3 middle = 0.25 * (domain_[0] + domain_[1] + domain_[2] + domain_[3]);
    const auto slopes = sampler_.derivatives(densities, nodes_, centres_, middle);
    const Points nodes = nodes_, centres = centres_;
    const bool inverted = !is_gentle(before, before, most);
    while (!inverted && time_step_ > shortest) {
        const bool is_newton = time_step_ >= newtons_time_step;
        std::vector<double> shift(is_newton ? 0 : distances.size());
        for (Index i = 0; i < shift.size(); ++i) shift[i] = 1 / (time_step_ * distances[i]);
        const std::vector<double> step = newton_direction(r, slopes, shift, stop);
        const bool usable =
            std::all_of(step.begin(), step.end(), [](double value) { return std::isfinite(value); });
        if (usable) {
            result.update = move(nodes, centres, step, 1);
            const std::vector<double> after = areas();
            if (is_gentle(before, after, most) && inverted_triangles(nodes_, n_) == 0 &&
                (!is_newton || falls_below(std::max(result.residual, 4 * result.rounding), densities))) {
                result.factor = is_newton ? 1 : time_step_ / (1 + time_step_);
                const double change = largest_change(before, after) / std::log(most);
                if (change < 0.5) time_step_ *= change < 0.025 ? 1000 : std::min(8.0, 0.7 / change);
                time_step_ = std::min(time_step_, newtons_time_step);
                return result;
            }
        }
        time_step_ = is_newton ? 1 : time_step_ / 4;
    }
    nodes_ = nodes, centres_ = centres;
    if (!inverted) time_step_ = 0.01;
    result.update = solve(densities).update;
    return result;
}

bool SquareLevel::falls_below(double norm, const LayerDensities& densities) {
    sampler_.means(densities, nodes_, centres_, means_);
    return residual().norm() <= norm;
}

} // namespace gaspard
