#include "core/layer/square_level.hpp"

#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

SquareLevel::SquareLevel(int n, MeshPdeForm form, DensitySamples samples, const std::array<Vec3, 4>& corners)
    : n_(n), form_(form), samples_(samples), domain_(corners), nodes_(node_count()), centres_(quad_count()),
      sampler_(n, samples), solver_(n) {
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            nodes_.set(node(i, j), computational(static_cast<double>(i) / n, static_cast<double>(j) / n));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) centres_.set(quad(i, j), computational((i + 0.5) / n, (j + 0.5) / n));
}

void SquareLevel::set_positions(Points nodes, Points centres) {
    nodes_ = std::move(nodes), centres_ = std::move(centres);
}

bool SquareLevel::is_fixed(Index axis, int i, int j) const {
    if (axis == 0) return form_ == MeshPdeForm::one_direction || i == 0 || i == n_;
    return j == 0 || j == n_;
}

void SquareLevel::restore_fixed(Points& nodes) const {
    for (int j = 0; j <= n_; ++j)
        for (int i = 0; i <= n_; ++i)
            for (const Index axis : {Index{0}, Index{1}}) {
                if (!is_fixed(axis, i, j)) continue;
                const Index p = node(i, j);
                double& value = axis == 0 ? nodes.x[p] : nodes.y[p];
                const double kept = axis == 0 ? nodes_.x[p] : nodes_.y[p];
                if (std::abs(value - kept) > 1e-9)
                    throw InputError("a node is to lie at " + exact_number(value) + ", but its side is at " +
                                     exact_number(kept));
                value = kept;
            }
}

SquareLevel SquareLevel::refined() const {
    SquareLevel fine(2 * n_, form_, samples_, domain_);
    for (int j = 0; j <= fine.n_; ++j)
        for (int i = 0; i <= fine.n_; ++i) {
            const int a = i / 2, b = j / 2;
            if (i % 2 == 0 && j % 2 == 0)
                fine.nodes_.set(fine.node(i, j), nodes_[node(a, b)]);
            else if (j % 2 == 0)
                fine.nodes_.set(fine.node(i, j), 0.5 * (nodes_[node(a, b)] + nodes_[node(a + 1, b)]));
            else if (i % 2 == 0)
                fine.nodes_.set(fine.node(i, j), 0.5 * (nodes_[node(a, b)] + nodes_[node(a, b + 1)]));
            else
                fine.nodes_.set(fine.node(i, j), centres_[quad(a, b)]);
        }
    for (int j = 0; j < fine.n_; ++j)
        for (int i = 0; i < fine.n_; ++i) // their places: where sides are not parallel, off the coarse edges
            fine.centres_.set(fine.quad(i, j), at(i / 2, j / 2, fine.computational_corners(i, j)[4]));
    return fine;
}

Vec3 SquareLevel::at(int i, int j, Vec3 xi) const {
    const auto place = computational_corners(i, j), value = corners_of(i, j);
    const auto area = [](Vec3 a, Vec3 b, Vec3 c) { return cross(b - a, c - a).z; };
    Vec3 found{};
    double most = -1;
    for (const auto& t : crossed_triangles) { // the one whose barycentric coordinates are not negative
        const Vec3 a = place[t[0]], b = place[t[1]], c = place[t[2]];
        const double whole = area(a, b, c), u = area(xi, b, c) / whole, v = area(a, xi, c) / whole;
        const double w = 1 - u - v, least = std::min({u, v, w});
        if (least <= most) continue;
        most = least;
        found = u * value[t[0]] + v * value[t[1]] + w * value[t[2]];
    }
    return found;
}

SquareMeshSolve SquareLevel::solve(const LayerDensities& densities) {
    sampler_.means(densities, nodes_, centres_, means_);
    return solve();
}

SquareMeshSolve SquareLevel::solve(TriangleDensities means) {
    means_ = std::move(means);
    return solve();
}

SquareMeshSolve SquareLevel::solve() {
    SquareMeshSolve result;
    for (const Index axis : axes()) {
        std::vector<double>& u = axis == 0 ? nodes_.x : nodes_.y;
        std::vector<double>& c = axis == 0 ? centres_.x : centres_.y;
        eliminate_centres(axis, solver_.matrices());
        solver_.factorise(fixed_nodes(axis));
        before_ = u;
        result.inner_iterations += solver_.solve(u, 1e-8, 1e-14);
        for (Index i = 0; i < u.size(); ++i)
            result.update = std::max(result.update, std::abs(u[i] - before_[i]));
        result.update = std::max(result.update, restore_centres(u, c));
    }
    return result;
}

Vec3 SquareLevel::computational(double s, double t) const {
    const auto& c = domain_;
    return (1 - t) * ((1 - s) * c[0] + s * c[1]) + t * ((1 - s) * c[2] + s * c[3]);
}

std::array<Vec3, 5> SquareLevel::computational_corners(int i, int j) const {
    const auto at = [&](int a, int b) {
        return computational(static_cast<double>(a) / n_, static_cast<double>(b) / n_);
    };
    return {at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1),
            computational((i + 0.5) / n_, (j + 0.5) / n_)};
}

std::array<Vec3, 5> SquareLevel::corners_of(int i, int j) const {
    return {nodes_[node(i, j)], nodes_[node(i + 1, j)], nodes_[node(i, j + 1)], nodes_[node(i + 1, j + 1)],
            centres_[quad(i, j)]};
}

/// x is fixed on the left and right, y below and above.
std::vector<std::uint8_t> SquareLevel::fixed_nodes(Index axis) const {
    std::vector<std::uint8_t> fixed(node_count());
    for (int j = 0; j <= n_; ++j)
        for (int i = 0; i <= n_; ++i) fixed[node(i, j)] = is_fixed(axis, i, j) ? 1 : 0;
    return fixed;
}

SquareLevel::QuadStiffness SquareLevel::stiffness(int i, int j) const {
    const std::array<Vec3, 5> xi = computational_corners(i, j);
    QuadStiffness k{};
    for (Index t = 0; t < 4; ++t) {
        const auto& v = crossed_triangles[t];
        const double area = 0.5 * cross(xi[v[1]] - xi[v[0]], xi[v[2]] - xi[v[0]]).z;
        for (Index a = 0; a < 3; ++a)
            for (Index b = 0; b < 3; ++b) {
                const auto edge = [&](Index c) { return xi[v[(c + 2) % 3]] - xi[v[(c + 1) % 3]]; };
                const Vec3 ea = edge(a), eb = edge(b); // 2 |T| grad = the opposite edge, turned
                const double across = form_ == MeshPdeForm::one_direction ? 0.0 : ea.y * eb.y;
                k[t][a][b] = (ea.x * eb.x + across) / (4 * area);
            }
    }
    return k;
}

/// The matrix of a quadrilateral with its centre.
std::array<std::array<double, 5>, 5> SquareLevel::matrix(const QuadStiffness& stiffness,
                                                         const double* means) {
    std::array<std::array<double, 5>, 5> k{};
    for (Index t = 0; t < 4; ++t)
        for (Index a = 0; a < 3; ++a)
            for (Index b = 0; b < 3; ++b)
                k[crossed_triangles[t][a]][crossed_triangles[t][b]] += means[t] * stiffness[t][a][b];
    return k;
}

/// The matrices of the quadrilaterals without their centres.
void SquareLevel::eliminate_centres(Index axis, std::span<CornerMatrix> matrices) {
    const bool parallelogram = norm(domain_[0] + domain_[3] - (domain_[1] + domain_[2])) == 0;
    const QuadStiffness common = stiffness(0, 0);
    centre_weights_.resize(quad_count());
    for (int j = 0; j < n_; ++j)
        for (int i = 0; i < n_; ++i) {
            const double* const means = means_[axis].data() + 4 * quad(i, j);
            const auto k = matrix(parallelogram ? common : stiffness(i, j), means);
            auto& c = centre_weights_[quad(i, j)];
            for (Index a = 0; a < 4; ++a) c[a] = -k[4][a] / k[4][4];
            Index at = 0;
            for (Index a = 0; a < 4; ++a)
                for (Index b = 0; b <= a; ++b) matrices[quad(i, j)][at++] = k[a][b] + k[a][4] * c[b];
        }
}

double SquareLevel::restore_centres(const std::vector<double>& u, std::vector<double>& c) const {
    double update = 0;
    for (int j = 0; j < n_; ++j)
        for (int i = 0; i < n_; ++i) {
            const auto& w = centre_weights_[quad(i, j)];
            const double value = w[0] * u[node(i, j)] + w[1] * u[node(i + 1, j)] + w[2] * u[node(i, j + 1)] +
                                 w[3] * u[node(i + 1, j + 1)];
            update = std::max(update, std::abs(value - c[quad(i, j)]));
            c[quad(i, j)] = value;
        }
    return update;
}

} // namespace gaspard
