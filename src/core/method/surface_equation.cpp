#include "core/method/surface_equation.hpp"

#include "core/base/check.hpp"
#include "core/base/eigenvalues.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

// Minimum resolution of a coarser sphere: cells per side of a cube face; refinements.
constexpr int coarsest_cubed = 8, coarsest_icosahedral = 2;

std::string layout_of(const SphereGrid& grid, int geometry_order) {
    const bool cubed = grid.cells == SphereCells::cubed;
    return (cubed ? "cubed-sphere Q2 k=" : "icosahedral-sphere P2 r=") + std::to_string(grid.resolution) +
           " facets of order " + std::to_string(geometry_order) +
           (cubed && grid.mid_nodes == MidNodes::equiangular ? " equiangular" : "");
}

std::string layout_of(const SurfaceQ2& surface) {
    if (surface.grid()) return layout_of(*surface.grid(), surface.geometry_order());
    return "surface of " + std::to_string(surface.unknowns()) + " unknowns";
}

/// The sphere to which a state with this layout and number of unknowns belongs; nullopt if there is none.
std::optional<SurfaceSetup> sphere_of(const std::string& layout, std::size_t unknowns) {
    const auto fits = [&](const SphereGrid& grid, int order) { return layout == layout_of(grid, order); };
    for (const int order : {1, 2}) {
        for (int k = 1; 24 * static_cast<std::size_t>(k * k) + 2 <= unknowns; ++k)
            for (const auto mid_nodes : {MidNodes::normalised, MidNodes::equiangular})
                if (const SphereGrid grid{SphereCells::cubed, k, mid_nodes};
                    fits(grid, order) && 24 * static_cast<std::size_t>(k * k) + 2 == unknowns)
                    return sphere_setup(grid, order);
        for (int r = 0; (std::size_t{40} << 2 * r) + 2 <= unknowns; ++r)
            if (const SphereGrid grid{SphereCells::icosahedral, r};
                fits(grid, order) && (std::size_t{40} << 2 * r) + 2 == unknowns)
                return sphere_setup(grid, order);
    }
    return std::nullopt;
}

/// The finite element function f on the mesh `from`, evaluated at the nodes of the mesh `to`.
std::vector<double> interpolated(const SurfaceQ2& from, std::span<const double> f, const SurfaceQ2& to) {
    const Mesh& mesh = from.quadratic();
    const auto count = static_cast<std::size_t>(nodes_per_cell(mesh.kind));
    std::vector<double> shapes(count), values(to.unknowns());
    std::vector<Vec3> gradients(count);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const CellPlace place = locate(*from.grid(), to.quadratic().nodes[i]);
        shape_functions(mesh.kind, place.at, shapes, gradients);
        values[i] = 0;
        for (std::size_t n = 0; n < count; ++n)
            values[i] += shapes[n] * f[static_cast<std::size_t>(mesh.cell(place.cell)[n])];
    }
    return values;
}

using Tensor = std::span<const double>; // 3 x 3, row by row

Vec3 applied(Tensor a, Vec3 v) {
    return {a[0] * v.x + a[1] * v.y + a[2] * v.z, a[3] * v.x + a[4] * v.y + a[5] * v.z,
            a[6] * v.x + a[7] * v.y + a[8] * v.z};
}

/// A unit vector orthogonal to `xi`: g / |g|, or any if g is zero.
Vec3 direction_of(Vec3 g, Vec3 xi) { return norm(g) < 1e-12 ? any_across(xi) : (1 / norm(g)) * g; }

/// Eigenvalues of the symmetric part of adj(A) D, with orthonormal bases of the tangent planes
///
///   at xi   (g/|g|, n),   n = xi x g/|g|
///   at x    (u, n),       u = cos|g| g/|g| - sin|g| xi
///
/// D = diag(1, sin|g| / |g|) is the differential of the exponential map.
Eigenvalues2 cofactor_eigenvalues(Tensor sigma, Vec3 xi, Vec3 g) {
    const double length = norm(g), sinc = length > 1e-8 ? std::sin(length) / length : 1;
    const Vec3 along = direction_of(g, xi), across = cross(xi, along);
    const Vec3 u = std::cos(length) * along - std::sin(length) * xi;
    const Vec3 of_along = applied(sigma, along), of_across = applied(sigma, across);
    const double a = dot(u, of_along), b = dot(u, of_across), c = dot(across, of_along),
                 d = dot(across, of_across);
    return symmetric_eigenvalues(d, -(b * sinc + c) / 2, a * sinc);
}

/// The same on a flat surface: eigenvalues of the symmetric part of cof(I + sigma).
Eigenvalues2 flat_cofactor_eigenvalues(Tensor sigma) {
    return symmetric_eigenvalues(1 + sigma[4], -(sigma[1] + sigma[3]) / 2, 1 + sigma[0]);
}

} // namespace

SurfaceEquation::SurfaceEquation(std::shared_ptr<const SurfaceQ2> surface)
    : MongeAmpereEquation(layout_of(*surface), surface->unknowns()), surface_(std::move(surface)),
      workspace_(surface_->make_workspace()), monitor_(surface_->mesh()->node_count()),
      residual_(surface_->unknowns()) {}

std::optional<State> SurfaceEquation::adopt(const State& other, const Discretisation* of) {
    if (other.arrays.size() != 1 || other.arrays[0].name != "phi") return std::nullopt;
    const auto& phi = other.arrays[0].values;
    if (other.layout == layout() && phi.size() == size()) return other;
    if (!surface_->grid()) return std::nullopt;
    const auto* there = dynamic_cast<const SurfaceQ2*>(of);
    if (there && there->unknowns() == phi.size() && other.layout == layout_of(*there))
        return adopt(*there, phi);
    auto setup = sphere_of(other.layout, phi.size());
    if (!setup) return std::nullopt;
    return adopt(SurfaceQ2(std::move(*setup)), phi);
}

State SurfaceEquation::adopt(NonlinearProblem& other, std::span<const double> phi) {
    return adopt(*dynamic_cast<SurfaceEquation&>(other).surface_, phi);
}

// Transfers the Laplacian of phi and solves for the potential, as on the plane. Interpolating phi itself
// would leave kinks at cell edges, which spoil sigma.
State SurfaceEquation::adopt(const SurfaceQ2& from, std::span<const double> phi) const {
    GASPARD_CHECK(from.grid() && surface_->grid());
    return state_of(surface_->potential(interpolated(from, from.laplacian(phi), *surface_)));
}

std::unique_ptr<NonlinearProblem> SurfaceEquation::coarser(const Progress& progress,
                                                           std::stop_token stop) const {
    if (!surface_->grid()) return nullptr;
    SphereGrid half = *surface_->grid();
    const bool cubed = half.cells == SphereCells::cubed;
    half.resolution = cubed ? (half.resolution + 1) / 2 : half.resolution - 1;
    if (half.resolution < (cubed ? coarsest_cubed : coarsest_icosahedral)) return nullptr;
    return std::make_unique<SurfaceEquation>(std::make_shared<SurfaceQ2>(
        sphere_setup(half, surface_->geometry_order(), surface_->radius(), surface_->monitor_at_vertices()),
        progress, stop));
}

Evaluation SurfaceEquation::evaluate(const ProblemData& data, std::span<const double> phi) {
    move(phi);
    data.monitor->values(positions_, monitor_);
    const auto [theta, normalised] = surface_->residual(monitor_, residual_, workspace_);
    theta_ = theta;
    return {.residual = normalised, .series = {data.unit * theta}, .step_size = 0};
}

void SurfaceEquation::move(std::span<const double> phi) {
    surface_->map(phi, workspace_);
    surface_->positions(workspace_, positions_, gradient_);
}

void SurfaceEquation::linearise(const ProblemData& data, Linearised how) {
    if (!d_workspace_) d_workspace_ = surface_->make_workspace();
    d_monitor_.assign(monitor_.size(), 0.0);
    slope_.resize(0);
    if (how == Linearised::fully) data.monitor->gradients(positions_, slope_);
    scale_ = surface_->at_unknowns(monitor_);
    for (double& value : scale_) value = preconditioner_scale(value);
}

void SurfaceEquation::derivative(std::span<const double> w, std::span<double> out) {
    surface_->map_derivative(workspace_, w, *d_workspace_);
    if (slope_.size() > 0) {
        surface_->positions_derivative(gradient_, *d_workspace_, displacement_);
        for (std::size_t i = 0; i < d_monitor_.size(); ++i) d_monitor_[i] = dot(slope_[i], displacement_[i]);
    }
    surface_->residual_derivative(monitor_, workspace_, d_monitor_, *d_workspace_, out);
    for (double& value : out) value = -value;
}

void SurfaceEquation::precondition(std::span<const double> r, std::span<double> u) {
    double mean = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] = scale_[i] * r[i];
        mean += u[i];
    }
    mean /= surface_->area();
    const auto weights = surface_->weights();
    for (std::size_t i = 0; i < u.size(); ++i) u[i] -= mean * weights[i];
    surface_->poisson(u, u, *d_workspace_);
    for (std::size_t i = 0; i < u.size(); ++i) u[i] *= scale_[i];
}

Ellipticity SurfaceEquation::ellipticity() const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Ellipticity extremes{.convexity = infinity, .slowest = infinity, .fastest = -infinity, .theta = theta_};
    const bool flat = surface_->shape() == SurfaceShape::flat;
    for (std::size_t i = 0; i < monitor_.size(); ++i) {
        const Tensor sigma = surface_->sigma(workspace_, i);
        const auto [low, high] = flat ? flat_cofactor_eigenvalues(sigma)
                                      : cofactor_eigenvalues(sigma, surface_->places()[i], gradient_[i]);
        extremes.convexity = std::min(extremes.convexity, low);
        extremes.slowest = std::min(extremes.slowest, monitor_[i] * low);
        extremes.fastest = std::max(extremes.fastest, monitor_[i] * high);
    }
    return extremes;
}

} // namespace gaspard
