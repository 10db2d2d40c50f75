#include "core/layer/triangle_problem.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/layer/interval_problem.hpp"
#include "core/linear/cell_lu.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gaspard {

namespace {

using Index = std::size_t;

/// Symmetric rule of degree 6 with twelve points (Strang, Fix): barycentric coordinates and weights.
struct RulePoint {
    double a, b, c, weight;
};
constexpr double a1 = 0.501426509658179, b1 = 0.249286745170910, w1 = 0.116786275726379;
constexpr double a2 = 0.873821971016996, b2 = 0.063089014491502, w2 = 0.050844906370207;
constexpr double a3 = 0.053145049844817, b3 = 0.310352451033784, c3 = 0.636502499121399,
                 w3 = 0.082851075618374;
constexpr std::array<RulePoint, 12> rule = {{{a1, b1, b1, w1},
                                             {b1, a1, b1, w1},
                                             {b1, b1, a1, w1},
                                             {a2, b2, b2, w2},
                                             {b2, a2, b2, w2},
                                             {b2, b2, a2, w2},
                                             {a3, b3, c3, w3},
                                             {a3, c3, b3, w3},
                                             {b3, a3, c3, w3},
                                             {b3, c3, a3, w3},
                                             {c3, a3, b3, w3},
                                             {c3, b3, a3, w3}}};

/// A triangle: its corners and, in numbers of the fine grid of (2N + 1)^2 points, its six nodes (corners,
/// then the midpoints opposite to them).
struct Triangle {
    bool lower = true; ///< of the two of its quadrilateral
    std::array<Vec3, 3> corner;
    std::array<Index, 6> node;
    double area = 0;
    std::array<Vec3, 3> slope; ///< gradients of the barycentric coordinates
};

Triangle triangle_at(const Points& x, Index n, Index i, Index j, bool lower) {
    const Index fine = 2 * n + 1;
    const std::array<std::array<Index, 2>, 3> at =
        lower ? std::array<std::array<Index, 2>, 3>{{{i, j}, {i + 1, j}, {i + 1, j + 1}}}
              : std::array<std::array<Index, 2>, 3>{{{i, j}, {i + 1, j + 1}, {i, j + 1}}};
    Triangle t;
    t.lower = lower;
    for (Index k = 0; k < 3; ++k) {
        const auto &p = at[(k + 1) % 3], &q = at[(k + 2) % 3];
        t.corner[k] = x[at[k][1] * (n + 1) + at[k][0]];
        t.node[k] = 2 * at[k][1] * fine + 2 * at[k][0];
        t.node[3 + k] = (p[1] + q[1]) * fine + p[0] + q[0];
    }
    const Vec3 u = t.corner[1] - t.corner[0], v = t.corner[2] - t.corner[0];
    t.area = 0.5 * (u.x * v.y - u.y * v.x);
    for (Index k = 0; k < 3; ++k) {
        const Vec3 edge = t.corner[(k + 2) % 3] - t.corner[(k + 1) % 3];
        t.slope[k] = {-edge.y / (2 * t.area), edge.x / (2 * t.area), 0};
    }
    return t;
}

using RuleCoefficients = std::span<const TriangleCoefficients, rule.size()>;

/// Calls `visit(triangle, coefficients at the points of the rule)`; formulas are evaluated by rows of the
/// grid.
template <class Visit>
void for_each_triangle(const TriangleProblem& problem, const Points& x, int cells,
                       const std::stop_token& stop, const Visit& visit) {
    const auto n = static_cast<Index>(cells);
    std::vector<Triangle> row(2 * n);
    Points points(row.size() * rule.size());
    std::vector<TriangleCoefficients> at(points.size());
    for (Index j = 0; j < n; ++j) {
        if (stop.stop_requested()) throw Interrupted();
        for (Index k = 0; k < row.size(); ++k) {
            const Triangle& t = row[k] = triangle_at(x, n, k / 2, j, k % 2 == 0);
            for (Index p = 0; p < rule.size(); ++p)
                points.set(k * rule.size() + p,
                           rule[p].a * t.corner[0] + rule[p].b * t.corner[1] + rule[p].c * t.corner[2]);
        }
        problem.coefficients(points, at);
        for (Index k = 0; k < row.size(); ++k)
            visit(row[k], RuleCoefficients(at.data() + k * rule.size(), rule.size()));
    }
}

/// Shape functions and gradients of order 1 (three) or 2 (six) at a point of the rule.
struct Shapes {
    std::array<double, 6> value{};
    std::array<Vec3, 6> slope{};
};
Shapes shapes(const Triangle& t, const RulePoint& p, int order) {
    const std::array<double, 3> l = {p.a, p.b, p.c};
    Shapes s;
    for (Index k = 0; k < 3; ++k) {
        const Index a = (k + 1) % 3, b = (k + 2) % 3;
        s.value[k] = order == 1 ? l[k] : l[k] * (2 * l[k] - 1);
        s.slope[k] = (order == 1 ? 1.0 : 4 * l[k] - 1) * t.slope[k];
        s.value[3 + k] = 4 * l[a] * l[b];
        s.slope[3 + k] = 4 * l[a] * t.slope[b] + 4 * l[b] * t.slope[a];
    }
    return s;
}

/// The unknowns of a grid: its nodes, of order 2 all points of the fine grid; held ones are among them.
class GridUnknowns {
  public:
    GridUnknowns(int cells, int order)
        : fine_(2 * static_cast<Index>(cells) + 1), step_(order == 1 ? 2 : 1), along_(order == 1 ? 2 : 3) {}

    Index side() const { return (fine_ - 1) / step_ + 1; }
    Index count() const { return side() * side(); }
    Index per_cell() const { return along_ * along_; }
    /// Of a point of the fine grid.
    Index number(Index point) const { return point / fine_ / step_ * side() + point % fine_ / step_; }
    /// Of a point of the fine grid, in the quadrilateral with this lower left one.
    Index local(Index point, Index corner) const {
        const Index i = point % fine_ - corner % fine_, j = point / fine_ - corner / fine_;
        return j / step_ * along_ + i / step_;
    }
    bool is_held(Index point, const std::array<bool, 4>& held) const {
        const Index i = point % fine_, j = point / fine_, last = fine_ - 1;
        return (i == 0 && held[0]) || (i == last && held[1]) || (j == 0 && held[2]) || (j == last && held[3]);
    }
    /// Of the quadrilateral with this lower left point of the fine grid.
    Index quad(Index corner) const { return corner / fine_ / 2 * ((fine_ - 1) / 2) + corner % fine_ / 2; }
    CellUnknowns of_cells() const {
        CellUnknowns unknowns{count(), per_cell(), {}};
        const Index n = (fine_ - 1) / 2;
        for (Index q = 0; q < n * n; ++q)
            for (Index k = 0; k < per_cell(); ++k)
                unknowns.numbers.push_back(static_cast<std::int32_t>(number(
                    (2 * (q / n) + step_ * (k / along_)) * fine_ + 2 * (q % n) + step_ * (k % along_))));
        return unknowns;
    }
    Points middles() const {
        const Index n = (fine_ - 1) / 2;
        Points middles(n * n);
        for (Index q = 0; q < n * n; ++q)
            middles.set(q, {static_cast<double>(q % n), static_cast<double>(q / n), 0});
        return middles;
    }

  private:
    Index fine_, step_, along_; ///< points of the fine grid along a side; between unknowns; in a cell
};

/// The equations, by quadrilaterals. That of a value that is held is u = 0.
class GridSystem {
  public:
    GridSystem(const GridUnknowns& unknowns, const std::array<bool, 4>& held, int cells)
        : unknowns_(unknowns), held_(held), matrices_(static_cast<Index>(cells) * static_cast<Index>(cells) *
                                                      unknowns.per_cell() * unknowns.per_cell()),
          load_(unknowns.count()) {}

    void add(const Triangle& t, Index count, const std::array<std::array<double, 6>, 6>& a,
             const std::array<double, 6>& f) {
        const Index size = unknowns_.per_cell();
        double* matrix = matrices_.data() + unknowns_.quad(t.node[0]) * size * size;
        for (Index k = 0; k < count; ++k) {
            const Index row = unknowns_.local(t.node[k], t.node[0]);
            if (unknowns_.is_held(t.node[k], held_)) {
                matrix[row * (size + 1)] = 1;
                continue;
            }
            load_[unknowns_.number(t.node[k])] += f[k];
            for (Index l = 0; l < count; ++l)
                if (!unknowns_.is_held(t.node[l], held_))
                    matrix[row * size + unknowns_.local(t.node[l], t.node[0])] += a[k][l];
        }
    }
    std::vector<double> solved(const std::stop_token& stop) const {
        const CellUnknowns cells = unknowns_.of_cells();
        const Index size = cells.per_cell * cells.per_cell;
        return solve_by_parts(
            cells, dissect(cells, unknowns_.middles()),
            [&](Index cell, std::span<double> matrix) {
                std::copy_n(matrices_.begin() + static_cast<std::ptrdiff_t>(cell * size), size,
                            matrix.begin());
            },
            load_, stop);
    }

  private:
    const GridUnknowns& unknowns_;
    std::array<bool, 4> held_;
    std::vector<double> matrices_, load_;
};

} // namespace

std::function<void(const Points& x, std::span<TriangleCoefficients>)>
pointwise(std::function<TriangleCoefficients(double x, double y)> coefficients) {
    return [f = std::move(coefficients)](const Points& x, std::span<TriangleCoefficients> all) {
        for (Index i = 0; i < all.size(); ++i) all[i] = f(x.x[i], x.y[i]);
    };
}

namespace {

/// A symmetric tensor of diffusion.
struct AddedDiffusion {
    double xx = 0, xy = 0, yy = 0;
};

} // namespace

/// Of exponential fitting along the two lines of the grid that bound a triangle: with the edges t_1 and t_2
/// there, c = a_1 t_1 + a_2 t_2 flows with a_i |t_i| along the one of length |t_i|.
static AddedDiffusion fitting_of(const Triangle& t, const TriangleCoefficients& c) {
    const auto& x = t.corner;
    const std::array<Vec3, 2> edges = t.lower ? std::array<Vec3, 2>{x[1] - x[0], x[2] - x[1]}
                                              : std::array<Vec3, 2>{x[1] - x[2], x[2] - x[0]};
    const Vec3 flow{c.c1, c.c2, 0};
    const double across = cross(edges[0], edges[1]).z;
    const std::array<double, 2> share = {cross(flow, edges[1]).z / across, cross(edges[0], flow).z / across};
    AddedDiffusion added;
    for (Index i = 0; i < 2; ++i) {
        const double length = norm(edges[i]);
        const Vec3 along = (1 / length) * edges[i];
        const double e = c.k1 * along.x * along.x + c.k2 * along.y * along.y;
        const double more = fitting_diffusion(e, share[i] * length, length);
        added.xx += more * along.x * along.x;
        added.xy += more * along.x * along.y;
        added.yy += more * along.y * along.y;
    }
    return added;
}

static TriangleSolution solve(const TriangleProblem& problem, const Points& x, int cells, int order,
                              bool fitted, const std::stop_token& stop) {
    GASPARD_CHECK(order == 1 || order == 2);
    const GridUnknowns unknowns(cells, order);
    GridSystem system(unknowns, problem.held, cells);
    const Index count = order == 1 ? 3 : 6;
    bool unique = std::any_of(problem.held.begin(), problem.held.end(), [](bool held) { return held; });
    for_each_triangle(problem, x, cells, stop, [&](const Triangle& t, RuleCoefficients at) {
        if (!(t.area > 0)) throw InputError("the mesh has an inverted triangle");
        std::array<std::array<double, 6>, 6> a{};
        std::array<double, 6> f{};
        for (Index g = 0; g < rule.size(); ++g) {
            const RulePoint& p = rule[g];
            const TriangleCoefficients& c = at[g];
            const AddedDiffusion d = fitted ? fitting_of(t, c) : AddedDiffusion();
            unique = unique || c.r != 0;
            const Shapes s = shapes(t, p, order);
            const double w = p.weight * t.area;
            for (Index k = 0; k < count; ++k) {
                f[k] += w * c.f * s.value[k];
                for (Index l = 0; l < count; ++l)
                    a[k][l] +=
                        w * ((c.k1 + d.xx) * s.slope[k].x * s.slope[l].x +
                             d.xy * (s.slope[k].x * s.slope[l].y + s.slope[k].y * s.slope[l].x) +
                             (c.k2 + d.yy) * s.slope[k].y * s.slope[l].y +
                             s.value[k] * (c.c1 * s.slope[l].x + c.c2 * s.slope[l].y + c.r * s.value[l]));
            }
        }
        system.add(t, count, a, f);
    });
    if (!unique) throw InputError("without a side that is held and without reaction, u is not unique");
    TriangleSolution solution{order, system.solved(stop)};
    for (const double u : solution.values) check_solution_size(std::abs(u));
    return solution;
}

TriangleSolution solve_triangles(const TriangleProblem& problem, const Points& x, int cells, int order,
                                 const std::stop_token& stop) {
    return solve(problem, x, cells, order, false, stop);
}

TriangleSolution solve_fitted(const TriangleProblem& problem, const Points& x, int cells,
                              const std::stop_token& stop) {
    return solve(problem, x, cells, 1, true, stop);
}

double reference_error(const TriangleProblem& problem, const Points& x, int cells, const TriangleSolution& p1,
                       const TriangleSolution& p2, const std::stop_token& stop) {
    GASPARD_CHECK(p1.order == 1 && p2.order == 2);
    const Index n = static_cast<Index>(cells), fine = 2 * n + 1;
    std::vector<double> difference = p2.values;
    const auto coarse = [&](Index i, Index j) { return p1.values[j * (n + 1) + i]; };
    for (Index j = 0; j < fine; ++j)
        for (Index i = 0; i < fine; ++i) // midpoints lie on sides or on the right diagonal
            difference[j * fine + i] -= 0.5 * (coarse(i / 2, j / 2) + coarse((i + 1) / 2, (j + 1) / 2));
    double square = 0;
    for_each_triangle(problem, x, cells, stop, [&](const Triangle& t, RuleCoefficients at) {
        for (Index g = 0; g < rule.size(); ++g) {
            const RulePoint& p = rule[g];
            const TriangleCoefficients& c = at[g];
            const Shapes s = shapes(t, p, 2);
            double e = 0;
            Vec3 d;
            for (Index k = 0; k < 6; ++k) {
                const double value = difference[t.node[k]];
                e += value * s.value[k], d = d + value * s.slope[k];
            }
            square += p.weight * t.area * (c.k1 * d.x * d.x + c.k2 * d.y * d.y + e * e);
        }
    });
    return std::sqrt(square);
}

} // namespace gaspard
