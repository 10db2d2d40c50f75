// Meshes of solids: methods against each other, measures, threads, folds.
#include "core/method/patch_form.hpp"
#include "core/method/spline_map.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "core/spline/patch_file.hpp"
#include "core/spline/solid_folds.hpp"
#include "core/tessellate/cell_geometry.hpp"
#include "support/largest_distance.hpp"
#include "support/sanitizers.hpp"
#include "support/solved_run.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

namespace gaspard {
namespace {

/// A run of a solid of degree 3 with a shell as monitor.
std::vector<std::string> shell(const std::string& domain, int cells, std::vector<std::string> further = {}) {
    std::vector<std::string> settings = {
        "domain.type=" + domain, "domain.cells=" + std::to_string(cells), "monitor.type=formula",
        "monitor.expression=1 + 3*exp(-4*(sqrt(x^2 + y^2 + z^2) - 0.6)^2)", "method.interpolation=false"};
    settings.insert(settings.end(), further.begin(), further.end());
    return settings;
}

TEST(SolidRuns, AllMethodsFindTheSameMeshWithBothForms) {
    gaspard::Run picard =
        solved_run("spline-cube", shell("spline-cube", 8, {"method.type=picard", "method.tolerance=1e-11"}));
    EXPECT_EQ(picard.status(), RunStatus::converged);
    for (const std::string method : {"newton", "accelerated", "auto"}) {
        gaspard::Run other = solved_run(
            "spline-cube", shell("spline-cube", 8, {"method.type=" + method, "method.tolerance=1e-11"}));
        EXPECT_EQ(other.status(), RunStatus::converged) << method;
        EXPECT_LT(largest_distance(picard.snapshot()->x, other.snapshot()->x), 1e-8) << method;
        if (method == "newton") {
            EXPECT_LE(other.history().back().iteration, 8);
        }
    }
    gaspard::Run mixed = solved_run("spline-cube", shell("spline-cube", 8, {"method.type=picard-mixed"}));
    EXPECT_LT(largest_distance(picard.snapshot()->x, mixed.snapshot()->x), 0.02)
        << "the forms approach each other";
}

TEST(SolidRuns, TheMultilevelStartLeadsToTheSameMesh) {
    std::vector<Points> found;
    for (const std::string start : {"multilevel", "identity"}) {
        gaspard::Run run = solved_run(
            "spline-ball",
            shell("spline-ball", 16,
                  {"method.type=picard-mixed", "method.tolerance=1e-10", "method.start=" + start}));
        EXPECT_EQ(run.status(), RunStatus::converged);
        found.push_back(run.snapshot()->x);
    }
    EXPECT_LT(largest_distance(found[0], found[1]), 1e-7);
}

TEST(SolidRuns, AConstantMonitorMovesNothing) {
    for (const std::string measure : {"parameter", "physical"})
        for (const std::string domain : {"spline-ball", "spline-half-torus"}) {
            gaspard::Run run =
                solved_run(domain, {"domain.cells=6", "monitor.type=constant", "method.measure=" + measure,
                                    "method.tolerance=1e-11", "method.interpolation=false"});
            EXPECT_EQ(run.status(), RunStatus::converged);
            EXPECT_LT(largest_distance(run.snapshot()->x, run.snapshot()->mesh->nodes), 1e-8)
                << domain << measure;
        }
}

/// A bell as a field on 41^3 points around the ball, in a file of VTK.
std::filesystem::path bell_file(const TemporaryFolder& folder) {
    const std::filesystem::path path = folder / "bell.vtk";
    std::ofstream file(path);
    file.precision(17);
    file << "# vtk DataFile Version 3.0\nbell\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 41 41 41\n"
            "ORIGIN -1 -1 -1\nSPACING 0.05 0.05 0.05\nPOINT_DATA 68921\nSCALARS m double\nLOOKUP_TABLE "
            "default\n";
    const auto at = [](int i) { return -1 + 0.05 * i; };
    for (int k = 0; k < 41; ++k)
        for (int j = 0; j < 41; ++j)
            for (int i = 0; i < 41; ++i) {
                const double x = at(i) - 0.2, y = at(j), z = at(k) + 0.1;
                file << 1 + 3 * std::exp(-4 * (x * x + y * y + z * z)) << '\n';
            }
    return path;
}
const std::string bell_expression = "1 + 3*exp(-4*((x - 0.2)^2 + y^2 + (z + 0.1)^2))";

Points mesh_of(const std::string& domain, int cells, std::vector<std::string> further) {
    further.insert(further.end(), {"domain.type=" + domain, "domain.cells=" + std::to_string(cells),
                                   "method.interpolation=false", "method.tolerance=1e-9"});
    gaspard::Run run = solved_run("spline-ball", further);
    EXPECT_EQ(run.status(), RunStatus::converged);
    EXPECT_GT(largest_distance(run.snapshot()->x, run.snapshot()->mesh->nodes), 0.03) << "nodes move";
    return run.snapshot()->x;
}

// The blur over a cell changes a sampled monitor with order 2 in the size of cells.
TEST(SolidMonitors, AFieldAndItsFormulaLeadToTheSameMesh) {
    const TemporaryFolder folder;
    const std::string file = bell_file(folder).string();
    std::vector<double> distances;
    for (const int cells : {8, 16}) {
        const Points sampled = mesh_of(
            "spline-ball", cells, {"monitor.type=field", "monitor.density=values", "monitor.file=" + file});
        const Points exact =
            mesh_of("spline-ball", cells, {"monitor.type=formula", "monitor.expression=" + bell_expression});
        distances.push_back(largest_distance(sampled, exact));
    }
    EXPECT_LT(distances[1], 0.015) << "an eighth of a cell";
    EXPECT_GT(distances[0] / distances[1], 2.8);
}

// Derived monitors have no blur, so that only the interpolation of u differs; it has second derivatives to
// order 1 where splines are kept between the data.
TEST(SolidMonitors, AMonitorDerivedFromAFieldIsThatOfItsFormula) {
    const TemporaryFolder folder;
    const std::string file = bell_file(folder).string();
    for (const std::string kind : {"arc-length", "curvature", "magnitude"}) {
        if (sanitized && kind == "curvature") continue;
        const std::vector<std::string> common = {"monitor.type=derived", "monitor.kind=" + kind};
        auto of_field = common, of_formula = common;
        of_field.insert(of_field.end(), {"monitor.u.type=field", "monitor.u.file=" + file});
        of_formula.insert(of_formula.end(),
                          {"monitor.u.type=formula", "monitor.u.expression=" + bell_expression});
        if (kind == "magnitude") // as a part of a whole
            for (auto* one : {&of_field, &of_formula}) {
                for (std::string& setting : *one) setting.replace(0, 8, "monitor.a.");
                one->insert(one->begin(), {"monitor.type=combine", "monitor.operation=product"});
                one->insert(one->end(), {"monitor.b.type=bell"});
            }
        EXPECT_LT(
            largest_distance(mesh_of("spline-ball", 8, of_field), mesh_of("spline-ball", 8, of_formula)),
            kind == "curvature" ? 0.03 : 0.001)
            << kind;
    }
}

TEST(SolidRuns, EquidistributeInSpaceWithTheirMeasure) {
    for (const std::string domain : {"spline-ball", "spline-cylinder", "spline-half-torus"}) {
        if (sanitized && domain != "spline-cylinder") continue;
        std::vector<double> physical, parameter;
        for (const int cells : {8, 16})
            for (const std::string measure : {"parameter", "physical"}) {
                gaspard::Run run =
                    solved_run(domain, shell(domain, cells,
                                             {"method.type=picard-mixed", "method.measure=" + measure,
                                              "method.tolerance=1e-8"}));
                EXPECT_EQ(run.status(), RunStatus::converged) << domain << measure;
                (measure == "physical" ? physical : parameter)
                    .push_back(*run.history().back().value("equidistribution"));
                EXPECT_LT(*run.history().back().value("border_error"), 1e-14);
            }
        const double order = std::log2(physical[0] / physical[1]);
        // Below some 1e-3, the corners of the section, where J = 0, limit the order (docs/splines.md).
        EXPECT_TRUE(order > 1.5 || (order > 0.5 && physical[0] < 1e-3)) << domain << ": " << order;
        EXPECT_LT(physical[1], 0.25 * parameter[1]) << domain << ", where the paper's form stays";
    }
}

TEST(SolidRuns, DoNotDependOnTheNumberOfThreads) {
    std::vector<Points> found;
    for (const int threads : {1, 3}) {
        const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
        Scenario scenario = find_scenario(*catalogue, "spline-ball");
        apply_settings(*catalogue, scenario, shell("spline-ball", 8, {"method.measure=physical"}));
        gaspard::Run run(catalogue, scenario, {.threads = threads});
        run.solve();
        found.push_back(run.snapshot()->x);
    }
    EXPECT_EQ(found[0].x, found[1].x);
    EXPECT_EQ(found[0].z, found[1].z);
}

// The derivative of a potential with a bump: Psi_d = xi_d + s b'(xi_d) over one direction, det = 1 + s b''.
TEST(SolidRuns, FoldsAreFoundBetweenSamples) {
    const MappedForm<3> form(std::make_shared<SolidDomain>(3, 6, cube_map()), Formulation::standard, 6);
    const std::size_t n = form.form()->size();
    std::vector<double> phi(n * n * n, 0.0), whole(phi.size());
    const auto folded = [&](double size) {
        for (std::size_t i = 0; i < phi.size(); ++i)
            phi[i] = i % n == 4 ? size : 0; // a function of xi1 alone
        form.add_identity(phi, whole);
        const auto map = form.form()->map(whole);
        return folded_solid_cells(map, 6);
    };
    EXPECT_TRUE(folded(0).empty());
    // phi'' of the B-spline is -2/h^2 times its coefficient at its middle, which is a knot, and up to 1/h^2
    // beside.
    const double h = 1.0 / 6, limit = h * h / 2;
    EXPECT_TRUE(folded(0.99 * limit).empty());
    const auto cells = folded(1.01 * limit);
    EXPECT_EQ(cells.size(), 2U * 36); // on both sides of the knot, all along the other directions
    for (const std::uint32_t cell : cells) EXPECT_TRUE(cell % 6 == 2 || cell % 6 == 3) << cell % 6;
}

/// The smallest det grad Psi at 7^3 points of a cell, its corners among them.
double smallest_in(const std::vector<SplineFunction>& psi, std::size_t cell, std::size_t cells) {
    constexpr std::size_t points = 7;
    std::array<std::array<SplineFunction, 3>, 3> slopes;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t d = 0; d < 3; ++d) slopes[c][d] = derivative(psi[c], d);
    const auto place = [&](std::size_t i, std::size_t k) { // one-sided at the ends
        const double t = std::clamp(static_cast<double>(k) / (points - 1), 1e-9, 1 - 1e-9);
        return (static_cast<double>(i) + t) / static_cast<double>(cells);
    };
    double smallest = HUGE_VAL;
    for (std::size_t k = 0; k < points * points * points; ++k) {
        const Vec3 xi{place(cell % cells, k % points), place(cell / cells % cells, k / points % points),
                      place(cell / cells / cells, k / points / points)};
        std::array<Vec3, 3> rows;
        const auto slope = [&](std::size_t c, std::size_t d) {
            return evaluate(slopes[c][d].space, slopes[c][d].coefficients, xi);
        };
        for (std::size_t c = 0; c < 3; ++c) rows[c] = {slope(c, 0), slope(c, 1), slope(c, 2)};
        smallest = std::min(smallest, dot(rows[0], cross(rows[1], rows[2])));
    }
    return smallest;
}

TEST(SolidRuns, FoldsOfAnyMapAreThoseThatSamplesShow) {
    constexpr std::size_t cells = 4;
    for (const Formulation formulation : {Formulation::standard, Formulation::mixed}) {
        const MappedForm<3> form(std::make_shared<SolidDomain>(3, cells, cube_map()), formulation, cells);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> number(-1, 1);
        std::vector<double> waves(form.form()->unknowns()), phi(waves.size()), whole(waves.size());
        for (double& one : waves) one = number(random);
        std::vector<SplineFunction> psi;
        std::vector<std::uint32_t> folded;
        for (double size = 0.001; folded.size() < 8; size *= 1.1) { // until some cells fold
            for (std::size_t i = 0; i < phi.size(); ++i) phi[i] = size * waves[i];
            form.add_identity(phi, whole);
            const auto map = form.form()->map(whole);
            psi.assign(map.begin(), map.end());
            folded = folded_solid_cells(psi, cells);
        }
        std::size_t shown = 0;
        for (std::size_t cell = 0; cell < cells * cells * cells; ++cell) {
            const double least = smallest_in(psi, cell, cells);
            const bool found = std::find(folded.begin(), folded.end(), cell) != folded.end();
            if (least <= 0) {
                ++shown;
                EXPECT_TRUE(found) << cell << ": " << least;
            }
            if (least > 0.1) {
                EXPECT_FALSE(found) << cell << ": " << least;
            }
        }
        std::vector<SplineFunction> turned{psi[1], psi[0],
                                           psi[2]}; // about the third axis: the same determinant
        for (double& one : turned[0].coefficients) one = -one;
        EXPECT_EQ(folded_solid_cells(turned, cells), folded);
        EXPECT_GT(shown, 3U);
        EXPECT_LT(folded.size(), cells * cells * cells - 3);
    }
}

// det dx/ds of a cell of order 3 has degree 8 in each direction.
TEST(SolidRuns, CellsHaveTheVolumeOfTheCubeTogether) {
    gaspard::Run run = solved_run("spline-cube", {"domain.cells=6", "method.interpolation=false"});
    const auto snapshot = run.snapshot();
    double volume = 0;
    for (const double one : CellGeometry(snapshot->mesh).measures(snapshot->x)) volume += one;
    EXPECT_NEAR(volume, 1, 1e-12);
}

TEST(SolidRuns, StatesOfPatchesAndSolidsAreNotMistaken) {
    const auto layout = parse_spline_layout("solid mixed p=3 n=8");
    ASSERT_TRUE(layout);
    EXPECT_EQ(layout->dimension, 3U);
    EXPECT_EQ(spline_layout(*layout), "solid mixed p=3 n=8");
    EXPECT_EQ(parse_spline_layout("spline mixed p=3 n=8")->dimension, 2U);
    EXPECT_FALSE(parse_spline_layout("cube mixed p=3 n=8"));
    const PatchForm patch(std::make_shared<SplineDomain>(2, 4, square_map()), Formulation::standard, 4);
    EXPECT_TRUE(patch.adopt("solid standard p=2 n=4", std::vector<double>(216)).empty());
}

TEST(SolidRuns, TheAdaptedSolidIsASplineAgain) {
    gaspard::Run run = solved_run("spline-ball", shell("spline-ball", 8, {"method.type=picard-mixed"}));
    const auto adapted = adapted_patch(run.state(), *ball_map());
    ASSERT_TRUE(adapted);
    const auto again = solid_map(parse_patch({patch_json(*adapted), "adapted-patch.json", {}, 3}).patch);
    const auto psi = spline_map(run.state());
    ASSERT_TRUE(psi && psi->size() == 3);
    Points xi(27), there(27), expected, x;
    for (std::size_t i = 0; i < 27; ++i) {
        xi.set(i, {0.1 + 0.37 * static_cast<double>(i % 3), 0.12 + 0.33 * static_cast<double>(i / 3 % 3),
                   0.2 + 0.3 * static_cast<double>(i / 9)});
        const auto at = [&](std::size_t d) {
            return evaluate((*psi)[d].space, (*psi)[d].coefficients, xi[i]);
        };
        there.set(i, {at(0), at(1), at(2)});
    }
    ball_map()->points(there, expected);
    again->points(xi, x);
    EXPECT_LT(largest_distance(x, expected), 1e-3);
}

} // namespace
} // namespace gaspard
