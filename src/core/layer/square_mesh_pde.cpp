#include "core/layer/square_mesh_pde.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/linear/nine_point.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {

using Index = std::size_t;

/// Corners of the four triangles of a quadrilateral: (0,0), (1,0), (0,1), (1,1), centre = 0..4.
constexpr std::array<std::array<Index, 3>, 4> triangles = {{{0, 1, 4}, {1, 3, 4}, {3, 2, 4}, {2, 0, 4}}};

/// Closed Newton-Cotes rule of degree 4 on a triangle: barycentric coordinates (in quarters) and weights.
struct SamplePoint {
    double a, b, c, weight;
};
constexpr std::array<SamplePoint, 12> degree_4_points = {{{3, 1, 0, 4},
                                                          {1, 3, 0, 4},
                                                          {0, 3, 1, 4},
                                                          {0, 1, 3, 4},
                                                          {1, 0, 3, 4},
                                                          {3, 0, 1, 4},
                                                          {2, 2, 0, -1},
                                                          {0, 2, 2, -1},
                                                          {2, 0, 2, -1},
                                                          {2, 1, 1, 8},
                                                          {1, 2, 1, 8},
                                                          {1, 1, 2, 8}}};

/// One resolution: the grid, the geometry of the computational triangles, the iterate.
class Level {
  public:
    Level(int n, const SquareMeshPdeOptions& options)
        : n_(n), options_(options), x_(node_count()), centres_(quad_count()), solvers_{solver(0), solver(1)} {
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) x_.set(node(i, j), computational(i, j));
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) centres_.set(quad(i, j), centre(i, j));
    }

    const Points& nodes() const { return x_; }
    int n() const { return n_; }

    /// The iterate of a mesh of half as many cells, which is linear on its triangles.
    void interpolate(const Level& coarse) {
        for (int j = 0; j <= n_; ++j)
            for (int i = 0; i <= n_; ++i) {
                const int a = i / 2, b = j / 2;
                const auto& from = coarse.x_;
                if (i % 2 == 0 && j % 2 == 0)
                    x_.set(node(i, j), from[coarse.node(a, b)]);
                else if (j % 2 == 0)
                    x_.set(node(i, j), 0.5 * (from[coarse.node(a, b)] + from[coarse.node(a + 1, b)]));
                else if (i % 2 == 0)
                    x_.set(node(i, j), 0.5 * (from[coarse.node(a, b)] + from[coarse.node(a, b + 1)]));
                else
                    x_.set(node(i, j), coarse.centres_[coarse.quad(a, b)]);
            }
        for (int j = 0; j < n_; ++j)
            for (int i = 0; i < n_; ++i) // its place: where sides are not parallel, off the coarse edges
                centres_.set(quad(i, j), coarse.at(i / 2, j / 2, centre(i, j)));
    }

    struct Step {
        double update = 0;
        int inner_iterations = 0;
    };
    Step step(const LayerDensities& densities) {
        sample(densities);
        Step result;
        const bool both = options_.form == MeshPdeForm::componentwise;
        for (const Index axis : {Index{0}, Index{1}}) {
            if (axis == 0 && !both) continue; // x = xi1 already
            std::vector<double>& u = axis == 0 ? x_.x : x_.y;
            std::vector<double>& c = axis == 0 ? centres_.x : centres_.y;
            std::vector<CornerMatrix> matrices = eliminated(axis);
            solvers_[axis].set_matrices(std::move(matrices));
            const std::vector<double> before = u, centres_before = c;
            result.inner_iterations += solvers_[axis].solve(u, 1e-8, 1e-14);
            restore_centres(u, c);
            for (Index i = 0; i < u.size(); ++i)
                result.update = std::max(result.update, std::abs(u[i] - before[i]));
            for (Index i = 0; i < c.size(); ++i)
                result.update = std::max(result.update, std::abs(c[i] - centres_before[i]));
        }
        return result;
    }

  private:
    /// The iterate at a point of the computational quadrilateral (i, j), linear on each triangle.
    Vec3 at(int i, int j, Vec3 xi) const {
        const std::array<Vec3, 5> place = {computational(i, j), computational(i + 1, j),
                                           computational(i, j + 1), computational(i + 1, j + 1),
                                           centre(i, j)};
        const auto value = corners_of(i, j);
        const auto area = [](Vec3 a, Vec3 b, Vec3 c) { return cross(b - a, c - a).z; };
        Vec3 found{};
        double most = -1;
        for (const auto& t : triangles) { // the one whose barycentric coordinates are not negative
            const Vec3 a = place[t[0]], b = place[t[1]], c = place[t[2]];
            const double whole = area(a, b, c), u = area(xi, b, c) / whole, v = area(a, xi, c) / whole;
            const double w = 1 - u - v, least = std::min({u, v, w});
            if (least <= most) continue;
            most = least;
            found = u * value[t[0]] + v * value[t[1]] + w * value[t[2]];
        }
        return found;
    }

    Index node(int i, int j) const {
        return static_cast<Index>(j) * static_cast<Index>(n_ + 1) + static_cast<Index>(i);
    }
    Index quad(int i, int j) const {
        return static_cast<Index>(j) * static_cast<Index>(n_) + static_cast<Index>(i);
    }
    Index node_count() const { return static_cast<Index>(n_ + 1) * static_cast<Index>(n_ + 1); }
    Index quad_count() const { return static_cast<Index>(n_) * static_cast<Index>(n_); }

    Vec3 computational(int i, int j) const {
        const double s = static_cast<double>(i) / n_, t = static_cast<double>(j) / n_;
        const auto& c = options_.corners;
        return (1 - t) * ((1 - s) * c[0] + s * c[1]) + t * ((1 - s) * c[2] + s * c[3]);
    }
    Vec3 centre(int i, int j) const {
        const double s = (i + 0.5) / n_, t = (j + 0.5) / n_;
        const auto& c = options_.corners;
        return (1 - t) * ((1 - s) * c[0] + s * c[1]) + t * ((1 - s) * c[2] + s * c[3]);
    }
    /// x is fixed on the left and right, y below and above.
    NinePointSolver solver(int axis) const {
        std::vector<std::uint8_t> fixed(node_count());
        for (int j = 0; j <= n_; ++j)
            for (int i = 0; i <= n_; ++i) {
                const int along = axis == 0 ? i : j;
                fixed[node(i, j)] = along == 0 || along == n_ ? 1 : 0;
            }
        return {n_, std::move(fixed)};
    }

    std::array<Vec3, 5> corners_of(int i, int j) const {
        return {x_[node(i, j)], x_[node(i + 1, j)], x_[node(i, j + 1)], x_[node(i + 1, j + 1)],
                centres_[quad(i, j)]};
    }

    /// Mean densities of all triangles, by quadrilaterals.
    void sample(const LayerDensities& densities) {
        const bool corners = options_.samples == DensitySamples::corners;
        const Index count = corners ? node_count() + quad_count() : 48 * quad_count();
        if (at_.size() != count) {
            at_.resize(count), m11_.resize(count), m22_.resize(count);
            for (auto& mean : means_) mean.resize(4 * quad_count());
        }
        if (corners) {
            for (Index i = 0; i < node_count(); ++i) at_.set(i, x_[i]);
            for (Index i = 0; i < quad_count(); ++i) at_.set(node_count() + i, centres_[i]);
        } else {
            Index next = 0;
            for (int j = 0; j < n_; ++j)
                for (int i = 0; i < n_; ++i) {
                    const auto corner = corners_of(i, j);
                    for (const auto& t : triangles)
                        for (const SamplePoint& p : degree_4_points)
                            at_.set(next++,
                                    0.25 * (p.a * corner[t[0]] + p.b * corner[t[1]] + p.c * corner[t[2]]));
                }
        }
        densities(at_, m11_, m22_);
        check_values();
        for (const Index axis : {Index{0}, Index{1}}) {
            const auto& m = axis == 0 ? m11_ : m22_;
            for (int j = 0; j < n_; ++j)
                for (int i = 0; i < n_; ++i) {
                    const Index q = quad(i, j);
                    const std::array<Index, 5> at = {node(i, j), node(i + 1, j), node(i, j + 1),
                                                     node(i + 1, j + 1), node_count() + q};
                    for (Index t = 0; t < 4; ++t) {
                        double mean = 0;
                        if (corners)
                            for (const Index c : triangles[t]) mean += m[at[c]] / 3;
                        else
                            for (Index p = 0; p < 12; ++p)
                                mean += m[12 * (4 * q + t) + p] * degree_4_points[p].weight / 45;
                        means_[axis][4 * q + t] = mean;
                    }
                }
        }
    }
    void check_values() const {
        for (const auto* m : {&m11_, &m22_})
            for (Index i = 0; i < m->size(); ++i)
                if (!((*m)[i] > 0) || !std::isfinite((*m)[i]))
                    throw InputError("the density of the mesh must be positive and finite, but is " +
                                     format_number((*m)[i]) + " at (" + format_number(at_.x[i]) + ", " +
                                     format_number(at_.y[i]) + ")");
    }

    /// The matrices of the quadrilaterals without their centres.
    std::vector<CornerMatrix> eliminated(Index axis) {
        std::vector<CornerMatrix> matrices(quad_count());
        centre_weights_.resize(quad_count());
        const bool one = options_.form == MeshPdeForm::one_direction;
        for (int j = 0; j < n_; ++j)
            for (int i = 0; i < n_; ++i) {
                const std::array<Vec3, 5> xi = {computational(i, j), computational(i + 1, j),
                                                computational(i, j + 1), computational(i + 1, j + 1),
                                                centre(i, j)};
                std::array<std::array<double, 5>, 5> k{};
                for (Index t = 0; t < 4; ++t) {
                    const auto& v = triangles[t];
                    const double area = 0.5 * ((xi[v[1]].x - xi[v[0]].x) * (xi[v[2]].y - xi[v[0]].y) -
                                               (xi[v[2]].x - xi[v[0]].x) * (xi[v[1]].y - xi[v[0]].y));
                    const double weight = means_[axis][4 * quad(i, j) + t] / (4 * area);
                    for (Index a = 0; a < 3; ++a)
                        for (Index b = 0; b < 3; ++b) {
                            const auto edge = [&](Index c) {
                                return xi[v[(c + 2) % 3]] - xi[v[(c + 1) % 3]];
                            };
                            const Vec3 ea = edge(a), eb = edge(b); // 2 |T| grad = the opposite edge, turned
                            k[v[a]][v[b]] += weight * (ea.x * eb.x + (one ? 0.0 : ea.y * eb.y));
                        }
                }
                auto& c = centre_weights_[quad(i, j)];
                for (Index a = 0; a < 4; ++a) c[a] = -k[4][a] / k[4][4];
                Index at = 0;
                for (Index a = 0; a < 4; ++a)
                    for (Index b = 0; b <= a; ++b) matrices[quad(i, j)][at++] = k[a][b] + k[a][4] * c[b];
            }
        return matrices;
    }
    void restore_centres(const std::vector<double>& u, std::vector<double>& c) const {
        for (int j = 0; j < n_; ++j)
            for (int i = 0; i < n_; ++i) {
                const auto& w = centre_weights_[quad(i, j)];
                c[quad(i, j)] = w[0] * u[node(i, j)] + w[1] * u[node(i + 1, j)] + w[2] * u[node(i, j + 1)] +
                                w[3] * u[node(i + 1, j + 1)];
            }
    }

    int n_;
    SquareMeshPdeOptions options_;
    Points x_, centres_;
    Points at_;
    std::vector<double> m11_, m22_;
    std::array<std::vector<double>, 2> means_;
    std::vector<std::array<double, 4>> centre_weights_; ///< of the last axis
    std::array<NinePointSolver, 2> solvers_;
};

} // namespace

SquareMeshPdeResult mesh_pde_square(const LayerDensities& densities, int cells,
                                    const SquareMeshPdeOptions& options) {
    int doubled = options.start_cells;
    while (doubled > 0 && doubled < cells) doubled *= 2;
    if (doubled != cells)
        throw InputError("the number of cells, " + std::to_string(cells) + ", must be " +
                         std::to_string(options.start_cells) + " (the coarsest mesh) times a power of two");
    SquareMeshPdeResult result;
    Level level(options.start_cells, options);
    while (level.n() < cells) {
        for (int i = 0; i < options.inner; ++i)
            result.inner_iterations += level.step(densities).inner_iterations;
        Level fine(2 * level.n(), options);
        fine.interpolate(level);
        level = std::move(fine);
    }
    for (int i = 0; i < options.final; ++i) {
        const auto step = level.step(densities);
        result.updates.push_back(step.update);
        result.inner_iterations += step.inner_iterations;
        if (step.update <= options.tolerance) break;
    }
    result.x = level.nodes();
    return result;
}

std::size_t inverted_triangles(const Points& x, int cells) {
    const auto s = static_cast<Index>(cells + 1);
    std::size_t count = 0;
    const auto inverted = [&](Index a, Index b, Index c) {
        return !((x.x[b] - x.x[a]) * (x.y[c] - x.y[a]) - (x.x[c] - x.x[a]) * (x.y[b] - x.y[a]) > 0);
    };
    for (Index j = 0; j + 1 < s; ++j)
        for (Index i = 0; i + 1 < s; ++i) {
            const Index p = j * s + i;
            count += (inverted(p, p + 1, p + s + 1) ? 1U : 0U) + (inverted(p, p + s + 1, p + s) ? 1U : 0U);
        }
    return count;
}

} // namespace gaspard
