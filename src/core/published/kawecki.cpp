#include "core/published/kawecki.hpp"

#include "core/base/check.hpp"
#include "core/published/mcrae_runs.hpp"
#include "core/transport/ring_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace gaspard {

ExactPotential kawecki_potential() {
    return {.value = [](Vec3 x) { return x.x * x.x + 1.5 * x.y * x.y - 0.625; },
            .gradient =
                [](Vec3 x) {
                    return Vec3{2 * x.x, 3 * x.y, 0};
                },
            .hessian =
                [](Vec3) {
                    return Covariance{2, 0, 3};
                }};
}

std::shared_ptr<const TransportDomain> kawecki_domain(const KaweckiMesh& mesh) {
    return std::make_shared<const TransportDomain>(TransportDomain::Setup{.source = ellipse({}, 1, 1),
                                                                          .target = ellipse({}, 2, 3),
                                                                          .rings = mesh.rings,
                                                                          .degree = mesh.degree,
                                                                          .curved = mesh.curved,
                                                                          .source_name = "unit disk"});
}

KaweckiSolve solve_kawecki(const KaweckiMesh& mesh, std::stop_token stop) {
    const auto domain = kawecki_domain(mesh);
    const auto space = std::make_shared<const NonvariationalSpace>(domain->elements(), mesh.recovery, stop);
    TransportForm form(space, domain->setup().source, domain->setup().target);
    RecoveryPreconditioner preconditioner(space);
    form.start(); // sets the scale of b
    std::vector<double> u = form.identity();
    KaweckiSolve result;
    result.h = triangle_quality(ring_mesh(*domain->setup().source, mesh.rings).mesh).longest_edge;
    result.newton = transport_newton(form, preconditioner, {}, u, {}, std::move(stop));
    result.errors = transport_errors(form, kawecki_potential());
    result.convexity = form.convexity();
    return result;
}

namespace {

/// The meshes of a curve.
struct KaweckiCurve {
    std::string label;
    KaweckiMesh mesh;
    std::vector<int> rings;
    std::optional<int> order_of_value{}, order_of_gradient{}; ///< stated in the paper
    std::string note{};
};

const std::string of_straight_edges = "the domain is a polygon", beyond = "isoparametric, not in the paper";

std::vector<KaweckiCurve> kawecki_curves() {
    const std::vector<int> of_p1 = {8, 16, 32, 64}, of_p2 = {4, 8, 16, 32}, of_p3 = {4, 8, 16};
    return {{"P1, recovery", {.degree = 1}, of_p1, 2, 1},
            {"P2, recovery", {.degree = 2}, of_p2, 2, 2, of_straight_edges},
            {"P3, recovery", {.degree = 3}, of_p3, 2, 2, of_straight_edges},
            {"P2, no recovery", {.degree = 2, .recovery = Recovery::none}, of_p2, 2, 2, of_straight_edges},
            {"P3, no recovery", {.degree = 3, .recovery = Recovery::none}, of_p3, 2, 2, of_straight_edges},
            {"P2, recovery, curved", {.degree = 2, .curved = true}, of_p2, {}, {}, beyond},
            {"P3, recovery, curved", {.degree = 3, .curved = true}, of_p3, {}, {}, beyond},
            {"P1, no recovery",
             {.degree = 1, .recovery = Recovery::none},
             of_p1,
             {},
             {},
             "the paper finds no convergence"}};
}

/// A norm and the plot of it.
struct KaweckiNorm {
    std::string quantity, title;
    double TransportErrors::*error;
};
const std::array<KaweckiNorm, 4> kawecki_norms = {
    KaweckiNorm{"L2 error", "Error in L2", &TransportErrors::value},
    {"H1 error", "Error of ∇u", &TransportErrors::gradient},
    {"recovered gradient", "Error of the recovered gradient", &TransportErrors::recovered_gradient},
    {"Hessian", "Error of the Hessian", &TransportErrors::hessian}};

void add_rows(const KaweckiCurve& curve, int rings, const KaweckiSolve& solve,
              std::vector<PublishedRow>& rows) {
    const std::string row = curve.label + ", n = " + std::to_string(rings);
    const auto& inner = solve.newton.inner;
    const auto count = [](auto number) { return static_cast<double>(number); };
    rows.push_back({row, "h", solve.h});
    for (const KaweckiNorm& norm : kawecki_norms)
        rows.push_back({row, norm.quantity, solve.errors.*norm.error});
    rows.push_back({row, "Newton steps", count(inner.size())});
    const int most = *std::max_element(inner.begin(), inner.end());
    rows.push_back({row, "inner iterations", count(std::accumulate(inner.begin(), inner.end(), 0)),
                    std::nullopt, "at most " + std::to_string(most) + " in a step"});
    rows.push_back({row, "convexity", solve.convexity, std::nullopt,
                    solve.convexity > 0 ? "" : "u is not finite element convex"});
}

/// (95), of the last two meshes.
void add_orders(const KaweckiCurve& curve, const KaweckiSolve& coarse, const KaweckiSolve& fine,
                std::vector<PublishedRow>& rows) {
    const std::string row = curve.label + ", n = " + std::to_string(curve.rings.back());
    for (std::size_t i = 0; i < kawecki_norms.size(); ++i) {
        const auto of = kawecki_norms[i].error;
        const auto stated = i == 0 ? curve.order_of_value : i == 1 ? curve.order_of_gradient : std::nullopt;
        rows.push_back({row, "order, " + kawecki_norms[i].quantity,
                        std::log(coarse.errors.*of / fine.errors.*of) / std::log(coarse.h / fine.h),
                        stated ? std::optional(printed(*stated, 1)) : std::nullopt, curve.note});
    }
}

Reproduction ellipse_figure(const Workshop& workshop) {
    std::vector<Plot> plots;
    for (const KaweckiNorm& norm : kawecki_norms)
        plots.push_back({norm.title, {"h", true}, {norm.quantity, true}, {}});
    Reproduction result;
    for (const KaweckiCurve& curve : kawecki_curves()) {
        workshop.announce(curve.label);
        for (Plot& plot : plots) plot.curves.push_back({curve.label, {}, {}, true});
        std::vector<KaweckiSolve> solves;
        for (const int rings : curve.rings) {
            KaweckiMesh mesh = curve.mesh;
            mesh.rings = rings;
            solves.push_back(solve_kawecki(mesh, workshop.stop));
            GASPARD_CHECK(solves.back().newton.converged);
            add_rows(curve, rings, solves.back(), result.rows);
            for (std::size_t i = 0; i < plots.size(); ++i) {
                plots[i].curves.back().x.push_back(solves.back().h);
                plots[i].curves.back().y.push_back(solves.back().errors.*kawecki_norms[i].error);
            }
        }
        add_orders(curve, *(solves.end() - 2), solves.back(), result.rows);
    }
    result.figure = Figure{"From the unit disk to an ellipse", {}};
    for (Plot& plot : plots) result.figure->panels.push_back({plot.title, std::move(plot)});
    return result;
}

/// The weighted correlation of pairs.
class Correlation {
  public:
    void add(double x, double y, double weight) { pairs_.push_back({x, y, weight}); }
    double value() const {
        double sum = 0, mean_x = 0, mean_y = 0, xx = 0, xy = 0, yy = 0;
        for (const auto& [x, y, w] : pairs_) sum += w, mean_x += w * x, mean_y += w * y;
        mean_x /= sum, mean_y /= sum;
        for (const auto& [x, y, w] : pairs_) {
            xx += w * (x - mean_x) * (x - mean_x);
            xy += w * (x - mean_x) * (y - mean_y);
            yy += w * (y - mean_y) * (y - mean_y);
        }
        return xy / std::sqrt(xx * yy);
    }

  private:
    std::vector<std::array<double, 3>> pairs_;
};

double area_of(const Points& x, std::span<const std::int32_t> cell) {
    const auto corner = [&](std::size_t k) { return x[static_cast<std::size_t>(cell[k])]; };
    return cross(corner(1) - corner(0), corner(2) - corner(0)).z / 2;
}

Reproduction portrait_figure(const Workshop& workshop) {
    Reproduction result;
    result.figure = Figure{"A portrait by transport of a disk", {}};
    for (const int rings : {32, 64, 96, 128}) {
        const std::string row = "n = " + std::to_string(rings);
        gaspard::Run run = begin_run(workshop, "transport-portrait",
                                     {"domain.cells=" + std::to_string(rings)}, "portrait, " + row);
        finish(run, workshop);
        const auto snapshot = run.snapshot();
        const DensityCorrelation found = density_correlation(*snapshot);
        const std::string status =
            run.status() == RunStatus::converged ? "" : "status " + std::string(status_name(run.status()));
        const auto add = [&](const std::string& quantity, double value, const std::string& note = {}) {
            result.rows.push_back({row, quantity, value, std::nullopt, note});
        };
        add("triangles", static_cast<double>(snapshot->mesh->cell_count()));
        add("Newton steps", snapshot->report.iteration, status);
        add("correlation of density", found.of_density, "1/area of cells with the picture");
        add("correlation of compression", found.of_compression, "area before/area with the picture");
        add("folded cells", static_cast<double>(found.folded));
        add("area error", snapshot->report.value("area_error").value());
        result.figure->panels.push_back({row, snapshot});
    }
    return result;
}

} // namespace

DensityCorrelation density_correlation(const Snapshot& snapshot) {
    const Field* mass = snapshot.field("mass");
    GASPARD_CHECK(snapshot.mesh->kind == (CellKind{CellShape::triangle, 1}) && mass != nullptr);
    DensityCorrelation result;
    Correlation density, compression;
    for (std::size_t c = 0; c < snapshot.mesh->cell_count(); ++c) {
        const auto cell = snapshot.mesh->cell(c);
        const double before = area_of(snapshot.mesh->nodes, cell), area = area_of(snapshot.x, cell);
        if (!(area > 0)) {
            ++result.folded;
            continue;
        }
        const double mean = mass->values[c] * before / area;
        density.add(1 / area, mean, area);
        compression.add(before / area, mean, area);
    }
    result.of_density = density.value(), result.of_compression = compression.value();
    return result;
}

std::vector<Recipe> kawecki_recipes() {
    return {make_recipe("kawecki-fig1", "errors of the transport from the unit disk to an ellipse",
                        ellipse_figure),
            make_recipe("kawecki-fig2", "a portrait as the density of a mesh, from a uniform one",
                        portrait_figure)};
}

} // namespace gaspard
