// Newton's method for the fixed point of a mesh PDE on quadrilaterals. The equation of a node p and an axis,
//
//   sum over triangles T at p of m_T (k_T u)_p = 0,
//
// has positive and negative terms, flows in and out, whose sums I and O are compared as ln(I / O): densities
// depend on positions exponentially, their logarithms do not. The iteration solve() amplifies errors of nodes
// at the edge of a layer of width eps by up to 1 / (N eps) and ends in a cycle for small eps.
//
// From the result of Algorithm 3, (37) converges for N = 16 to 128 and eps = 1e-2, 1e-4 in 3 to 13 steps, for
// N = 16 to 64 and eps = 1e-6, 1e-8 in 22 to 108. Numbers that are no powers of two start worse and need
// more, up to 145; N = 12 and eps = 1e-8 takes over 150. (34) converges for eps = 1e-2, 1e-4 in 3 to 46
// steps, and not in 150 for thinner layers: the steps that help have to be too short.
#include "core/layer/square_level.hpp"

#include <Eigen/Sparse>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
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

/// Corners as points: nodes, then centres.
std::array<Index, 3> SquareLevel::triangle_points(Index triangle) const {
    const Index q = triangle / 4, n = static_cast<Index>(n_), i = q % n, j = q / n, p = j * (n + 1) + i;
    const std::array<Index, 5> points = {p, p + 1, p + n + 1, p + n + 2, node_count() + q};
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

/// The Newton step by unknowns.
std::vector<double> SquareLevel::newton_direction(const Residual& r,
                                                  const DensitySampler::Derivatives& derivatives) const {
    const auto size = static_cast<Eigen::Index>(r.in.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * quad_count() * axes().size() * axes().size() * 12);
    const auto add = [&](Index row, Index column, double value) {
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
    };
    for (Index triangle = 0; triangle < 4 * quad_count(); ++triangle) {
        const auto points = triangle_points(triangle);
        const int q = static_cast<int>(triangle / 4);
        const auto k = stiffness(q % n_, q / n_)[triangle % 4];
        for (const Index axis : axes())
            for (Index a = 0; a < 3; ++a) {
                if (is_fixed_point(axis, points[a])) continue;
                double flow = 0;
                for (Index b = 0; b < 3; ++b) flow += k[a][b] * coordinate(axis, points[b]);
                const Index row = unknown(axis, points[a]);
                const double scale = 1 / (flow > 0 ? r.in : r.out)[row];
                for (Index b = 0; b < 3; ++b) {
                    add(row, unknown(axis, points[b]), scale * means_[axis][triangle] * k[a][b]);
                    for (const Index c : axes())
                        add(row, unknown(c, points[b]), scale * flow * derivatives[axis][c][triangle][b]);
                }
            }
    }
    for (const Index axis : axes())
        for (Index point = 0; point < node_count(); ++point)
            if (is_fixed_point(axis, point)) add(unknown(axis, point), unknown(axis, point), 1);
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(matrix);
    if (lu.info() != Eigen::Success) return {};
    const std::vector<double> f = r.values();
    const Eigen::VectorXd step = lu.solve(-Eigen::Map<const Eigen::VectorXd>(f.data(), size));
    return {step.data(), step.data() + size};
}

bool SquareLevel::is_inverted() const {
    for (Index triangle = 0; triangle < 4 * quad_count(); ++triangle) {
        const auto p = triangle_points(triangle);
        const auto at = [&](Index k) { return Vec3{coordinate(0, p[k]), coordinate(1, p[k]), 0}; };
        if (!(cross(at(1) - at(0), at(2) - at(0)).z > 0)) return true;
    }
    return inverted_triangles(nodes_, n_) > 0;
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

SquareMeshNewton SquareLevel::newton(const LayerDensities& densities) {
    constexpr double shortest = 1e-3;
    sampler_.means(densities, nodes_, centres_, means_);
    const Residual r = residual();
    SquareMeshNewton result{.residual = r.norm()};
    const Vec3 middle = 0.25 * (domain_[0] + domain_[1] + domain_[2] + domain_[3]);
    const std::vector<double> step =
        newton_direction(r, sampler_.derivatives(densities, nodes_, centres_, middle));
    const bool usable = !step.empty() && std::all_of(step.begin(), step.end(),
                                                     [](double value) { return std::isfinite(value); });
    const Points nodes = nodes_, centres = centres_;
    for (double factor = 1; usable && factor > shortest; factor *= 0.5) {
        result.update = move(nodes, centres, step, factor);
        if (is_inverted()) continue;
        sampler_.means(densities, nodes_, centres_, means_);
        if (residual().norm() < (1 - 0.1 * factor) * result.residual) {
            result.factor = factor;
            return result;
        }
    }
    nodes_ = nodes, centres_ = centres;
    result.update = solve(densities).update;
    return result;
}

} // namespace gaspard
