#include "core/fem/surface_q2.hpp"

#include "core/base/check.hpp"
#include "core/fem/exponential_map.hpp"
#include "core/linear/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gaspard {

namespace {

std::shared_ptr<const Mesh> scaled(Mesh mesh, double factor) {
    for (auto* coordinate : {&mesh.nodes.x, &mesh.nodes.y, &mesh.nodes.z})
        for (double& value : *coordinate) value *= factor;
    return std::make_shared<const Mesh>(std::move(mesh));
}

/// The unknowns of every cell of a mesh, given the unknown of every node.
CellUnknowns cell_unknowns(const Mesh& mesh, const std::vector<std::int32_t>& of_node) {
    CellUnknowns unknowns{
        .count = 0, .per_cell = static_cast<std::size_t>(nodes_per_cell(mesh.kind)), .numbers = mesh.cells};
    for (auto& number : unknowns.numbers) {
        number = of_node[static_cast<std::size_t>(number)];
        unknowns.count = std::max(unknowns.count, static_cast<std::size_t>(number) + 1);
    }
    return unknowns;
}

/// The cells' rows of indices in the order `order`, each index mapped by the permutation `place`.
std::vector<std::int32_t> rearranged(const std::vector<std::int32_t>& numbers, std::size_t per_cell,
                                     const std::vector<std::int32_t>& order,
                                     const std::vector<std::int32_t>& place) {
    std::vector<std::int32_t> result;
    result.reserve(numbers.size());
    for (const auto cell : order)
        for (std::size_t n = 0; n < per_cell; ++n) {
            const auto number =
                static_cast<std::size_t>(numbers[static_cast<std::size_t>(cell) * per_cell + n]);
            result.push_back(place.empty() ? static_cast<std::int32_t>(number) : place[number]);
        }
    return result;
}

} // namespace

SurfaceSetup sphere_setup(const SphereGrid& grid, int geometry_order, double radius,
                          bool monitor_at_vertices) {
    return {.mesh = sphere_mesh(grid),
            .geometry_order = geometry_order,
            .monitor_at_vertices = monitor_at_vertices,
            .radius = radius,
            .grid = grid};
}

SurfaceQ2::SurfaceQ2(SurfaceSetup setup, const Progress& progress, std::stop_token stop)
    : shape_(setup.shape), radius_(setup.radius), monitor_at_vertices_(setup.monitor_at_vertices),
      grid_(setup.grid), curved_(setup.geometry_order == 2) {
    GASPARD_CHECK(setup.geometry_order == 1 || setup.geometry_order == 2);
    number_unknowns(setup);
    if (progress) progress(0, "dissecting the mesh");
    dissection_ = std::make_shared<Dissection>(dissect(phi_cells_, middles()));
    if (!curved_) facet_dissection_ = std::make_shared<Dissection>(dissect(facet_cells_, middles()));
    SurfaceCells cells{.shape = shape_,
                       .quadratic = quadratic_.kind,
                       .geometry = mesh_->kind,
                       .phi = rearranged(phi_cells_.numbers, phi_cells_.per_cell, dissection_->cells,
                                         dissection_->permutation),
                       .gradient = {},
                       .nodes = rearranged(mesh_->cells, facet_cells_.per_cell, dissection_->cells, {}),
                       .places = places_,
                       .monitor_at_corners = setup.monitor_at_vertices};
    if (!curved_)
        cells.gradient = rearranged(facet_cells_.numbers, facet_cells_.per_cell, dissection_->cells,
                                    facet_dissection_->permutation);
    elements_ = make_surface_elements(std::move(cells));
    factorise(progress, stop);
}

void SurfaceQ2::number_unknowns(const SurfaceSetup& setup) {
    quadratic_ = setup.mesh.quadratic;
    Mesh facets = curved_ ? quadratic_ : straightened(setup.mesh);
    places_ = facets.nodes;
    std::vector<std::int32_t> unknowns = setup.unknowns;
    if (unknowns.empty()) {
        unknowns.resize(quadratic_.node_count());
        std::iota(unknowns.begin(), unknowns.end(), 0);
    }
    GASPARD_CHECK(unknowns.size() == quadratic_.node_count());
    phi_cells_ = cell_unknowns(quadratic_, unknowns);
    facet_cells_ = cell_unknowns(facets, unknowns);
    node_unknown_.assign(unknowns.begin(), unknowns.begin() + static_cast<std::ptrdiff_t>(places_.size()));
    mesh_ = scaled(std::move(facets), radius_);
}

Points SurfaceQ2::middles() const {
    const auto corners = static_cast<std::size_t>(corners_per_cell(quadratic_.kind));
    Points middles(quadratic_.cell_count());
    for (std::size_t c = 0; c < middles.size(); ++c) {
        Vec3 sum;
        for (std::size_t n = 0; n < corners; ++n)
            sum = sum + quadratic_.nodes[static_cast<std::size_t>(quadratic_.cell(c)[n])];
        middles.set(c, (1.0 / static_cast<double>(corners)) * sum);
    }
    return middles;
}

void SurfaceQ2::factorise(const Progress& progress, std::stop_token stop) {
    // The elements number the cells in the order of the dissection.
    std::vector<std::size_t> position(dissection_->cells.size());
    for (std::size_t i = 0; i < position.size(); ++i)
        position[static_cast<std::size_t>(dissection_->cells[i])] = i;

    weights_.assign(unknowns(), 0.0);
    std::vector<double> cell_weights(phi_cells_.per_cell);
    for (std::size_t i = 0; i < position.size(); ++i) {
        elements_->weights(i, cell_weights);
        const auto numbers = phi_cells_.of(static_cast<std::size_t>(dissection_->cells[i]));
        for (std::size_t n = 0; n < numbers.size(); ++n)
            weights_[static_cast<std::size_t>(numbers[n])] += cell_weights[n];
    }
    area_ = sum(weights_);

    const auto advance = [&](double from, const char* what) -> CellCholesky::Advance {
        if (!progress) return {};
        return [&progress, from, what](double part) { progress(from + 0.45 * part, what); };
    };
    mass_ = std::make_unique<CellCholesky>(
        phi_cells_, dissection_,
        [&](std::size_t cell, std::span<double> matrix) { elements_->mass(position[cell], matrix); },
        advance(0.1, "factorising the mass matrix"), stop);
    // The kernel of the stiffness matrix consists of the constants. Adding a positive number to one diagonal
    // entry makes the matrix definite; for a load of sum 0 the solution then vanishes at that unknown.
    stiffness_ = std::make_unique<CellCholesky>(
        phi_cells_, dissection_,
        [&](std::size_t cell, std::span<double> matrix) {
            elements_->stiffness(position[cell], matrix);
            if (cell == 0) matrix[0] += 1;
        },
        advance(0.55, "factorising the Laplacian"), stop);
    if (!curved_)
        facet_mass_ = std::make_unique<CellCholesky>(
            facet_cells_, facet_dissection_,
            [&](std::size_t cell, std::span<double> matrix) {
                elements_->facet_mass(position[cell], matrix);
            },
            CellCholesky::Advance{}, stop);
}

SurfaceQ2::Workspace SurfaceQ2::make_workspace() const {
    return {.phi = std::vector<double>(unknowns()),
            .r = std::vector<double>(unknowns()),
            .rows = std::vector<double>(12 * unknowns()),
            .gradient = std::vector<double>(curved_ ? 0 : 4 * facet_cells_.count)};
}

void SurfaceQ2::map(std::span<const double> phi, Workspace& workspace) const {
    GASPARD_CHECK(phi.size() == unknowns());
    for (std::size_t i = 0; i < phi.size(); ++i)
        workspace.phi[static_cast<std::size_t>(dissection_->permutation[i])] = phi[i];
    std::fill(workspace.rows.begin(), workspace.rows.end(), 0.0);
    std::fill(workspace.gradient.begin(), workspace.gradient.end(), 0.0);
    elements_->add_map_loads(0, elements_->batches(), workspace.phi.data(), workspace.rows.data(),
                             workspace.gradient.data());
    mass_->solve<12>(workspace.rows);
    if (!curved_) facet_mass_->solve<4>(workspace.gradient);
}

/// w (4.10) at a node.
Vec3 SurfaceQ2::projected_gradient(const Workspace& workspace, std::size_t node) const {
    const auto unknown = static_cast<std::size_t>(node_unknown_[node]);
    const double* w =
        curved_ ? &workspace.rows[12 * static_cast<std::size_t>(dissection_->permutation[unknown]) + 9]
                : &workspace.gradient[4 * static_cast<std::size_t>(facet_dissection_->permutation[unknown])];
    return {w[0], w[1], w[2]};
}

void SurfaceQ2::positions(const Workspace& workspace, Points& x, Points& gradient) const {
    x.resize(places_.size());
    gradient.resize(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Vec3 xi = places_[i];
        Vec3 g = projected_gradient(workspace, i);
        if (shape_ == SurfaceShape::flat) {
            x.set(i, radius_ * (xi + g));
        } else {
            g = g - dot(g, xi) * xi;
            const auto [cosine, sinc] = cosine_and_sinc(dot(g, g));
            x.set(i, radius_ * (cosine * xi + sinc * g));
        }
        gradient.set(i, g);
    }
}

void SurfaceQ2::map_derivative(const Workspace& workspace, std::span<const double> w,
                               Workspace& d_workspace) const {
    GASPARD_CHECK(w.size() == unknowns());
    for (std::size_t i = 0; i < w.size(); ++i)
        d_workspace.phi[static_cast<std::size_t>(dissection_->permutation[i])] = w[i];
    std::fill(d_workspace.rows.begin(), d_workspace.rows.end(), 0.0);
    std::fill(d_workspace.gradient.begin(), d_workspace.gradient.end(), 0.0);
    elements_->add_map_derivative(0, elements_->batches(), workspace.phi.data(), d_workspace.phi.data(),
                                  d_workspace.rows.data(), d_workspace.gradient.data());
    mass_->solve<12>(d_workspace.rows);
    if (!curved_) facet_mass_->solve<4>(d_workspace.gradient);
}

void SurfaceQ2::positions_derivative(const Points& gradient, const Workspace& d_workspace, Points& dx) const {
    dx.resize(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i) {
        Vec3 d = projected_gradient(d_workspace, i);
        if (shape_ == SurfaceShape::unit_sphere) {
            const Vec3 xi = places_[i], g = gradient[i];
            d = d - dot(d, xi) * xi;
            const double squared = dot(g, g), change = 2 * dot(g, d);
            const auto [cosine, sinc] = cosine_and_sinc(squared);
            d = (-0.5 * sinc * change) * xi + (sinc_slope(squared) * change) * g + sinc * d;
        }
        dx.set(i, radius_ * d);
    }
}

std::span<const double> SurfaceQ2::sigma(const Workspace& workspace, std::size_t node) const {
    const auto unknown = static_cast<std::size_t>(node_unknown_[node]);
    return {&workspace.rows[12 * static_cast<std::size_t>(dissection_->permutation[unknown])], 9};
}

SurfaceQ2::Residual SurfaceQ2::residual(std::span<const double> monitor, std::span<double> r,
                                        Workspace& workspace) const {
    GASPARD_CHECK(monitor.size() == mesh_->node_count() && r.size() == unknowns());
    std::fill(workspace.r.begin(), workspace.r.end(), 0.0);
    elements_->add_residual(0, elements_->batches(), workspace.phi.data(), workspace.rows.data(),
                            monitor.data(), workspace.r.data());
    const double theta = take_mean(workspace, r);
    return {theta, std::sqrt(dot(r, r) / dot(weights_, weights_)) / std::abs(theta)};
}

/// Turns r_v = <v, f> into <v, f - theta> with theta the mean of f; returns theta.
double SurfaceQ2::take_mean(const Workspace& workspace, std::span<double> r) const {
    for (std::size_t i = 0; i < r.size(); ++i)
        r[i] = workspace.r[static_cast<std::size_t>(dissection_->permutation[i])];
    const double theta = sum(r) / area_; // the functions v sum to 1
    for (std::size_t i = 0; i < r.size(); ++i) r[i] -= theta * weights_[i];
    return theta;
}

void SurfaceQ2::residual_derivative(std::span<const double> monitor, const Workspace& workspace,
                                    std::span<const double> d_monitor, Workspace& d_workspace,
                                    std::span<double> dr) const {
    GASPARD_CHECK(monitor.size() == mesh_->node_count() && d_monitor.size() == monitor.size());
    GASPARD_CHECK(dr.size() == unknowns());
    std::fill(d_workspace.r.begin(), d_workspace.r.end(), 0.0);
    elements_->add_residual_derivative(
        0, elements_->batches(), {workspace.phi.data(), workspace.rows.data(), monitor.data()},
        {d_workspace.phi.data(), d_workspace.rows.data(), d_monitor.data()}, d_workspace.r.data());
    take_mean(d_workspace, dr);
}

std::vector<double> SurfaceQ2::at_unknowns(std::span<const double> nodal) const {
    GASPARD_CHECK(nodal.size() == mesh_->node_count());
    std::vector<double> values(unknowns());
    for (std::size_t c = 0; !curved_ && c < mesh_->cell_count(); ++c) {
        const auto nodes = mesh_->cell(c);
        double mean = 0;
        for (const auto node : nodes) mean += nodal[static_cast<std::size_t>(node)];
        mean /= static_cast<double>(nodes.size());
        for (const auto unknown : phi_cells_.of(c)) values[static_cast<std::size_t>(unknown)] = mean;
    }
    for (std::size_t i = 0; i < nodal.size(); ++i)
        values[static_cast<std::size_t>(node_unknown_[i])] = nodal[i];
    return values;
}

void SurfaceQ2::poisson(std::span<const double> r, std::span<double> u, Workspace& workspace) const {
    GASPARD_CHECK(r.size() == unknowns() && u.size() == unknowns());
    for (std::size_t i = 0; i < r.size(); ++i)
        workspace.r[static_cast<std::size_t>(dissection_->permutation[i])] = r[i];
    stiffness_->solve<1>(workspace.r);
    for (std::size_t i = 0; i < u.size(); ++i)
        u[i] = workspace.r[static_cast<std::size_t>(dissection_->permutation[i])];
    const double mean = dot(weights_, u) / area_;
    for (double& value : u) value -= mean;
}

std::vector<double> SurfaceQ2::apply(CellMatrix matrix, std::span<const double> f) const {
    std::vector<double> result(unknowns(), 0.0), small(phi_cells_.per_cell * phi_cells_.per_cell);
    for (std::size_t i = 0; i < dissection_->cells.size(); ++i) {
        (*elements_.*matrix)(i, small);
        const auto numbers = phi_cells_.of(static_cast<std::size_t>(dissection_->cells[i]));
        for (std::size_t a = 0; a < numbers.size(); ++a)
            for (std::size_t b = 0; b < numbers.size(); ++b)
                result[static_cast<std::size_t>(numbers[a])] +=
                    small[a * numbers.size() + b] * f[static_cast<std::size_t>(numbers[b])];
    }
    return result;
}

std::vector<double> SurfaceQ2::laplacian(std::span<const double> phi) const {
    const std::vector<double> load = apply(&SurfaceElements::stiffness, phi);
    std::vector<double> result(load.size());
    for (std::size_t i = 0; i < load.size(); ++i)
        result[static_cast<std::size_t>(dissection_->permutation[i])] = -load[i];
    mass_->solve<1>(result);
    std::vector<double> numbered(result.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        numbered[i] = result[static_cast<std::size_t>(dissection_->permutation[i])];
    return numbered;
}

std::vector<double> SurfaceQ2::potential(std::span<const double> l) const {
    std::vector<double> load = apply(&SurfaceElements::mass, l);
    const double mean = sum(load) / area_;
    for (std::size_t i = 0; i < load.size(); ++i) load[i] = mean * weights_[i] - load[i];
    Workspace workspace = make_workspace();
    poisson(load, load, workspace);
    return load;
}

} // namespace gaspard
