// Runs on patches whose edges are single points, and on mirrored patches.
#include "core/base/read_file.hpp"
#include "core/diagnostics/quality.hpp"
#include "core/fem/gauss.hpp"
#include "core/io/facets.hpp"
#include "core/io/formats.hpp"
#include "core/io/run_files.hpp"
#include "core/method/spline_map.hpp"
#include "core/scenario/toml.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/spline/patch_file.hpp"
#include "core/spline/spline_domain.hpp"
#include "core/tessellate/cell_geometry.hpp"
#include "core/tessellate/colouring.hpp"
#include "support/built_in.hpp"
#include "support/largest_distance.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace gaspard {
namespace {

std::shared_ptr<const Catalogue> shipped() {
    static const auto all = std::make_shared<const Catalogue>(builtin_catalogue());
    return all;
}

Scenario on_patch(const std::string& patch, std::vector<std::string> settings) {
    Scenario chosen = find_scenario(*shipped(), "spline-circle");
    settings.insert(settings.begin(),
                    {"domain.type=spline-patch", "domain.file=" + patch, "domain.cells=16"});
    apply_settings(*shipped(), chosen, settings);
    return chosen;
}

// ---- edges that are points

/// A flat triangle in space; its edge xi2 = 1 is the point (0, 1, 1/2).
const std::string cone =
    R"({"degrees":[1,1],"knots":[[0,0,1,1],[0,0,1,1]],
        "control_points":[[0,0,0],[1,0,0],[0,1,0.5],[0,1,0.5]]})";
/// A triangle in the plane; the tip's coordinates are not exact sums of its control points.
const std::string triangle =
    R"({"degrees":[2,1],"knots":[[0,0,0,1,1,1],[0,0,1,1]],
        "control_points":[[0,0],[1,0],[2,0],[0.3,1.1],[0.3,1.1],[0.3,1.1]]})";
/// Like an egg: both edges xi2 = 0 and xi2 = 1 are points.
const std::string egg =
    R"({"degrees":[2,3],"knots":[[0,0,0,1,1,1],[0,0,0,0,1,1,1,1]],
        "control_points":[[0.1,0.1,-1],[0.1,0.1,-1],[0.1,0.1,-1],  [-1,0,-0.8],[0,-1.4,-0.8],[1,0,-0.8],
                          [-1,0,0.9],[0,-1.4,0.9],[1,0,0.9],  [0.1,0.1,1.3],[0.1,0.1,1.3],[0.1,0.1,1.3]]})";
/// Half a sphere as NURBS, with a pole; its nodes lie on a sphere around the origin.
const std::string dome =
    R"({"degrees":[2,2],"knots":[[0,0,0,0.5,0.5,1,1,1],[0,0,0,1,1,1]],
        "control_points":[[1,0,0],[1,1,0],[0,1,0],[-1,1,0],[-1,0,0],
                          [1,0,1],[1,1,1],[0,1,1],[-1,1,1],[-1,0,1],
                          [0,0,1],[0,0,1],[0,0,1],[0,0,1],[0,0,1]],
        "weights":[1,0.7071067811865476,1,0.7071067811865476,1,
                   0.7071067811865476,0.5,0.7071067811865476,0.5,0.7071067811865476,
                   1,0.7071067811865476,1,0.7071067811865476,1]})";
/// Like the lid of a teapot: one edge is the tip, and control points of an inner row coincide, too.
const std::string lid =
    R"({"degrees":[3,3],"knots":[[0,0,0,0,1,1,1,1],[0,0,0,0,1,1,1,1]],
        "control_points":[[0,0,3.2],[0,0,3.2],[0,0,3.2],[0,0,3.2],
                          [0.9,0,3.2],[0.9,-0.5,3.2],[0.5,-0.9,3.2],[0,-0.9,3.2],
                          [0,0,2.8],[0,0,2.8],[0,0,2.8],[0,0,2.8],
                          [0.25,0,2.7],[0.25,-0.14,2.7],[0.14,-0.25,2.7],[0,-0.25,2.7]]})";
/// The egg, far from the origin.
std::string far_egg() {
    SplinePatch patch = parse_patch({egg, "egg", {}}).patch;
    for (std::size_t i = 0; i < patch.control.size(); ++i)
        patch.control.set(i, patch.control[i] + Vec3{5e5, 4e6, 0});
    return patch_json(patch);
}

struct Tip {
    std::string name, patch;
};
void PrintTo(const Tip& tip, std::ostream* out) { *out << tip.name; }
class Tips : public testing::TestWithParam<Tip> {};
INSTANTIATE_TEST_SUITE_P(All, Tips,
                         testing::Values(Tip{"cone", cone}, Tip{"triangle", triangle}, Tip{"egg", egg},
                                         Tip{"dome", dome}, Tip{"lid", lid}, Tip{"far_egg", far_egg()}),
                         [](const auto& tip) { return tip.param.name; });

TEST_P(Tips, AreMeshedByEveryMethod) {
    for (const char* method : {"picard", "picard-mixed", "newton", "accelerated", "auto"})
        for (const char* monitor : {"constant", "ring", "bell"}) {
            std::vector<std::string> settings = {std::string("method.type=") + method,
                                                 std::string("monitor.type=") + monitor};
            if (std::string(monitor) != "constant") settings.push_back("monitor.amplitude=3");
            Scenario chosen = on_patch(GetParam().patch, settings);
            if (std::string(monitor) == "ring") // that 16 cells resolve it
                chosen.monitor.values.set("sharpness", chosen.monitor.values.real("sharpness") / 5);
            gaspard::Run run(shipped(), chosen);
            run.solve();
            EXPECT_EQ(run.status(), RunStatus::converged) << method << ' ' << monitor;
            EXPECT_EQ(*run.history().back().tangled_cells, 0u) << method << ' ' << monitor;
            const double least = *run.history().back().value("min_jacobian");
            // At 4e6, 5e-10 is what doubles resolve, and cells at the tip are short.
            const double rounding = GetParam().name == "far_egg" ? 2e-5 : 1e-9;
            if (std::string(monitor) == "constant") {
                EXPECT_NEAR(least, 1, rounding) << method;
            } else {
                EXPECT_TRUE(least > 0 && least < 1) << method << ' ' << monitor << ' ' << least;
            }
        }
}

TEST_P(Tips, GiveNumbersEverywhere) {
    gaspard::Run run(shipped(), on_patch(GetParam().patch, {"monitor.type=bell", "monitor.amplitude=3"}));
    run.solve();
    run.interpolation(); // its fields are among the colours
    const auto snapshot = run.snapshot();
    for (const Field& field : snapshot->fields)
        for (const double value : field.values) ASSERT_TRUE(std::isfinite(value)) << field.name;
    const CellGeometry geometry(snapshot->mesh);
    for (const double value : geometry.jacobians(snapshot->x)) ASSERT_TRUE(value > 0 && std::isfinite(value));
    for (const double value : geometry.measures(snapshot->x)) ASSERT_TRUE(value > 0 && std::isfinite(value));
    EXPECT_TRUE(geometry.tangled(snapshot->x).empty());
    for (const FieldInfo& info : mesh_colours()) {
        if (info.name.starts_with("mesh_")) continue; // no time passes
        const auto colouring = make_colouring(*snapshot, {.colouring = info.name});
        ASSERT_TRUE(colouring) << info.name;
        EXPECT_TRUE(std::isfinite(colouring->range.low) && std::isfinite(colouring->range.high)) << info.name;
        for (const double value : colouring->values) ASSERT_TRUE(std::isfinite(value)) << info.name;
    }
}

/// Whether a text has a word that a number which is not finite leaves.
bool has_strange_number(const std::string& text) {
    for (const std::string word : {"nan", "inf", "NaN", "Infinity"})
        for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
            const auto letter = [&](std::size_t i) {
                return i < text.size() && (std::isalpha(static_cast<unsigned char>(text[i])) != 0);
            };
            if (!letter(at - 1) && !letter(at + word.size())) return true;
        }
    return false;
}

TEST_P(Tips, AreWrittenInAllFormats) {
    gaspard::Run run(shipped(), on_patch(GetParam().patch, {"monitor.type=bell", "monitor.amplitude=3"}));
    run.solve();
    const TemporaryFolder folder;
    std::vector<const Format*> all;
    for (const Format& format : formats()) all.push_back(&format);
    write_run_files(folder.path(), run, all);
    const auto written = folder.content();
    for (const Format* format : all)
        for (const std::string& file : format->files)
            EXPECT_NE(std::find(written.begin(), written.end(), file), written.end()) << file;
    for (const std::string& file : written)
        for (const std::string ending : {".obj", ".msh", ".svg", ".json", ".csv", ".xml"})
            if (file.ends_with(ending)) {
                EXPECT_FALSE(has_strange_number(read_file(folder / file))) << file;
            }
}

/// A point of the cone's triangle by its parameters, and the other way round.
Vec3 on_cone(double u, double v) { return {(1 - v) * u, v, v / 2}; }

// The flat triangle has det grad F = (1 - xi2) sqrt(5)/2. The integral of m / det grad F over every adapted
// cell, by a quadrature of this test, is the same for all: that is what the method equidistributes.
TEST(AdaptedCone, IsEquidistributedByAnIndependentMeasure) {
    gaspard::Run run(shipped(), on_patch(cone, {"domain.cells=32", "monitor.type=bell", "monitor.amplitude=4",
                                                "monitor.sharpness=20", "method.type=newton"}));
    run.solve();
    ASSERT_EQ(run.status(), RunStatus::converged);
    const auto snapshot = run.snapshot();
    const Mesh& mesh = *snapshot->mesh;
    const auto m = [&](Vec3 x) {
        const Vec3 d = x - Vec3{0.25, 0.5, 0.25};
        return 1 + 4 / std::pow(std::cosh(20 * dot(d, d)), 2);
    };
    const LineQuadrature rule = gauss_legendre(8);
    const auto nodes = static_cast<std::size_t>(nodes_per_cell(mesh.kind));
    std::vector<double> values(nodes), in_square, in_space;
    std::vector<Vec3> gradients(nodes);
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        double per_square = 0, per_area = 0;
        for (std::size_t i = 0; i < 64; ++i) {
            shape_functions(mesh.kind, {rule.points[i % 8], rule.points[i / 8], 0}, values, gradients);
            Vec3 x, along, across;
            for (std::size_t k = 0; k < nodes; ++k) {
                const Vec3 node = snapshot->x[static_cast<std::size_t>(mesh.cell(c)[k])];
                x = x + values[k] * node;
                along = along + gradients[k].x * node, across = across + gradients[k].y * node;
            }
            const double area = rule.weights[i % 8] * rule.weights[i / 8] * norm(cross(along, across));
            per_area += area * m(x);
            per_square += area * m(x) / ((1 - x.y) * std::sqrt(1.25));
        }
        in_square.push_back(per_square), in_space.push_back(per_area);
    }
    const double mean = std::accumulate(in_square.begin(), in_square.end(), 0.0) / 1024;
    for (const double mass : in_square) EXPECT_NEAR(mass, mean, 0.01 * mean);
    EXPECT_LT(*std::min_element(in_space.begin(), in_space.end()), 0.1 * mean) << "in space they differ";

    // M_i are these integrals over the areas of the computational cells, which are exact on a triangle.
    const Field& mass = *snapshot->field("mass");
    double whole = 0, expected = 0;
    for (std::size_t c = 0; c < 1024; ++c) {
        const double low = static_cast<double>(c / 32) / 32, high = low + 1.0 / 32;
        const double area = (1 - (low + high) / 2) / 1024 * std::sqrt(1.25);
        EXPECT_NEAR(mass.values[c] * area, in_space[c], 1e-6 * in_space[c]) << c;
        whole += mass.values[c] * area;
    }
    constexpr int fine = 1000; // the midpoint rule in the flattened triangle
    for (int j = 0; j < fine; ++j)
        for (int i = 0; i < fine; ++i) {
            const double u = (i + 0.5) / fine, v = (j + 0.5) / fine;
            expected += m(on_cone(u, v)) * (1 - v) * std::sqrt(1.25) / (fine * fine);
        }
    EXPECT_NEAR(whole, expected, 1e-5 * expected);
}

/// The smallest (dx/ds x dx/dt) . normal at 21 x 21 points of every cell, relative to the mean.
double least_turn(const Mesh& mesh, const Points& x, Vec3 normal) {
    const auto nodes = static_cast<std::size_t>(nodes_per_cell(mesh.kind));
    std::vector<double> values(nodes);
    std::vector<Vec3> gradients(nodes);
    double least = std::numeric_limits<double>::infinity(), sum = 0;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
        for (std::size_t k = 0; k < 441; ++k) {
            const Vec3 at{static_cast<double>(k % 21) / 20, static_cast<double>(k / 21) / 20, 0};
            shape_functions(mesh.kind, at, values, gradients);
            Vec3 along, across;
            for (std::size_t i = 0; i < nodes; ++i) {
                const Vec3 node = x[static_cast<std::size_t>(mesh.cell(c)[i])];
                along = along + gradients[i].x * node, across = across + gradients[i].y * node;
            }
            const double turn = dot(cross(along, across), normal);
            least = std::min(least, turn), sum += turn;
        }
    return least * static_cast<double>(441 * mesh.cell_count()) / sum;
}

// The standard form keeps the boundary up to an error; behind the tip, the cone turns its other side.
TEST(AdaptedCone, HasNoCellThroughItsTip) {
    for (const char* method : {"picard", "picard-mixed", "newton", "auto"}) {
        gaspard::Run run(shipped(),
                         on_patch(cone, {"domain.cells=24", "monitor.type=bell", "monitor.amplitude=10",
                                         std::string("method.type=") + method}));
        run.solve();
        ASSERT_EQ(run.status(), RunStatus::converged);
        const auto snapshot = run.snapshot();
        const double height = *std::max_element(snapshot->x.z.begin(), snapshot->x.z.end());
        EXPECT_DOUBLE_EQ(height, 0.5) << method;
        const Vec3 normal = (1 / std::sqrt(1.25)) * Vec3{0, -0.5, 1};
        EXPECT_GT(least_turn(*snapshot->mesh, snapshot->x, normal), -1e-9) << method;
    }
}

TEST(CollapsedEdges, AreNoSides) {
    const Tip tip{"cone", cone};
    const SplineDomain domain(3, 8, patch_map(parse_patch({tip.patch, tip.name, {}}).patch));
    EXPECT_EQ(border(*domain.mesh()).size(), 3 * 8);
}

TEST(CollapsedEdges, AreOnePointToTheLastBit) {
    for (const Tip& tip : {Tip{"triangle", triangle}, Tip{"dome", dome}, Tip{"far_egg", far_egg()}}) {
        const SplineDomain domain(3, 8, patch_map(parse_patch({tip.patch, tip.name, {}}).patch));
        const Points& nodes = domain.mesh()->nodes;
        const std::size_t side = 3 * 8 + 1, last = (side - 1) * side, before = (side - 2) * side;
        ASSERT_EQ(nodes.size(), side * side);
        for (std::size_t i = 0; i < side; ++i) EXPECT_EQ(nodes[last + i], nodes[last]) << tip.name;
        EXPECT_NE(nodes[before], nodes[before + 1]);
    }
}

// ---- orientation

/// A curved planar patch, and its mirror image.
const std::string plain =
    R"({"degrees":[2,1],"knots":[[0,0,0,1,1,1],[0,0,1,1]],
        "control_points":[[0,0],[0.5,0.2],[1,0],[0,1],[0.6,1.1],[1.2,1]]})";
const std::string mirrored =
    R"({"degrees":[2,1],"knots":[[0,0,0,1,1,1],[0,0,1,1]],
        "control_points":[[0,0],[-0.5,0.2],[-1,0],[0,1],[-0.6,1.1],[-1.2,1]]})";

gaspard::Run solved(const std::string& patch, double centre, const std::string& method = "newton") {
    const std::string text = format_number(centre);
    gaspard::Run run(shipped(), on_patch(patch, {"monitor.type=circle", "monitor.radius=0.3",
                                                 "monitor.sharpness=20", "monitor.center_x=" + text,
                                                 "monitor.center_y=0.5", "method.type=" + method}));
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    return run;
}

TEST(MirroredPatches, HaveTheMirroredMesh) {
    for (const char* method : {"picard", "picard-mixed", "newton", "accelerated", "auto"}) {
        gaspard::Run a = solved(plain, 0.5, method), b = solved(mirrored, -0.5, method);
        const auto left = a.snapshot(), right = b.snapshot();
        Points image = right->x;
        for (double& x : image.x) x = -x;
        EXPECT_LT(largest_distance(left->x, image), 1e-12) << "the parameters are the file's";
        EXPECT_EQ(a.history().back().iteration, b.history().back().iteration);
        const auto areas = CellGeometry(left->mesh).measures(left->x);
        const auto others = CellGeometry(right->mesh).measures(right->x);
        for (std::size_t c = 0; c < areas.size(); ++c) {
            EXPECT_GT(others[c], 0);
            EXPECT_NEAR(areas[c], others[c], 1e-13);
        }
        EXPECT_NEAR(*a.history().back().value("equidistribution"),
                    *b.history().back().value("equidistribution"), 1e-12);
    }
}

TEST(MirroredPatches, HaveAnticlockwiseCellsAndBorders) {
    gaspard::Run run = solved(mirrored, -0.5);
    const auto snapshot = run.snapshot();
    const Mesh& mesh = *snapshot->mesh;
    EXPECT_EQ(mesh.space_dimension, 2);
    for (const Points* x : {&mesh.nodes, &snapshot->x})
        for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
            double area = 0;
            for (std::size_t k = 0; k < 4; ++k)
                area += cross((*x)[static_cast<std::size_t>(mesh.cell(c)[k])],
                              (*x)[static_cast<std::size_t>(mesh.cell(c)[(k + 1) % 4])])
                            .z;
            ASSERT_GT(area, 0);
            for (const auto& edge : cell_edges(mesh.kind)) {
                const auto node = [&](std::size_t k) {
                    return mesh
                        .nodes[static_cast<std::size_t>(mesh.cell(c)[static_cast<std::size_t>(edge[k])])];
                };
                for (std::size_t k = 2; k < edge.size(); ++k) {
                    const double t = static_cast<double>(k - 1) / static_cast<double>(edge.size() - 1);
                    ASSERT_LT(norm(node(k) - ((1 - t) * node(0) + t * node(1))), 0.002);
                }
            }
        }
    // Around the domain, with the domain on the left.
    const Facets sides = border(mesh);
    double area = 0, whole = 0;
    for (std::size_t f = 0; f < sides.size(); ++f)
        area += cross(mesh.nodes[static_cast<std::size_t>(sides[f][0])],
                      mesh.nodes[static_cast<std::size_t>(sides[f][1])])
                    .z /
                2;
    for (const double one : CellGeometry(snapshot->mesh).measures(mesh.nodes)) whole += one;
    EXPECT_NEAR(area, whole, 1e-3);
    EXPECT_GT(whole, 1);
}

TEST(MirroredPatches, AreTurnedInThePlaneOnly) {
    const auto first_turn = [](const std::string& patch) {
        const SplineDomain domain(2, 4, patch_map(parse_patch({patch, "patch", {}}).patch));
        const Mesh& mesh = *domain.mesh();
        const auto node = [&](std::size_t k) {
            return mesh.nodes[static_cast<std::size_t>(mesh.cell(0)[k])];
        };
        return std::pair(mesh.space_dimension, cross(node(1) - node(0), node(3) - node(0)).z);
    };
    const auto with_z = [](const std::string& z) {
        return R"({"degrees":[1,1],"knots":[[0,0,1,1],[0,0,1,1]],"control_points":[[0,0)" + z + "],[-1,0" +
               z + "],[0,1" + z + "],[-1,1" + z + "]]}";
    };
    EXPECT_EQ(first_turn(with_z("")).first, 2);
    EXPECT_GT(first_turn(with_z("")).second, 0);
    EXPECT_EQ(first_turn(with_z(",0")).first, 2) << "z = 0 is the plane";
    EXPECT_GT(first_turn(with_z(",0")).second, 0);
    EXPECT_EQ(first_turn(with_z(",3")).first, 3);
    EXPECT_LT(first_turn(with_z(",3")).second, 0) << "a surface in space keeps the orientation of its file";
}

TEST(MirroredPatches, AreWrittenInTheParametersOfTheirFile) {
    gaspard::Run run = solved(mirrored, -0.5);
    const auto map = patch_map(parse_patch({mirrored, "mirrored", {}}).patch);
    const auto psi = spline_map(run.state());
    ASSERT_TRUE(psi);
    const auto snapshot = run.snapshot();
    const auto adapted = adapted_patch(run.state(), *map);
    ASSERT_TRUE(adapted);
    const auto again = patch_map(parse_patch({patch_json(*adapted), "adapted-patch.json", {}}).patch);
    Points xi(1), x, y;
    const auto last = static_cast<std::size_t>(std::lround(std::sqrt(snapshot->x.size()))) - 1;
    for (std::size_t j = 0; j <= last; j += 4)
        for (std::size_t i = 0; i <= last; i += 4) {
            const Vec3 at{static_cast<double>(i) / static_cast<double>(last),
                          static_cast<double>(j) / static_cast<double>(last), 0};
            xi.set(0, {evaluate((*psi)[0].space, (*psi)[0].coefficients, at),
                       evaluate((*psi)[1].space, (*psi)[1].coefficients, at), 0});
            map->points(xi, x);
            EXPECT_LT(norm(x[0] - snapshot->x[j * (last + 1) + i]), 1e-12);
            xi.set(0, at);
            again->points(xi, y);
            EXPECT_LT(norm(x[0] - y[0]), 2e-3) << "F is not affine, so this approximates";
        }
    // Read as domain.file, it is a mirrored patch again.
    EXPECT_GT(CellGeometry(SplineDomain(3, 8, again).mesh())
                  .measures(SplineDomain(3, 8, again).mesh()->nodes)
                  .front(),
              0);
}

} // namespace
} // namespace gaspard
