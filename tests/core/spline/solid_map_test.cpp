#include "core/base/error.hpp"
#include "core/io/facets.hpp"
#include "core/spline/patch_checks.hpp"
#include "core/spline/patch_file.hpp"
#include "core/spline/patch_xml.hpp"
#include "core/spline/solid_domain.hpp"
#include "core/tessellate/cell_geometry.hpp"
#include "support/messages.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace gaspard {
namespace {

using std::numbers::pi;

/// A NURBS ring segment of quadratic, cubic and linear direction, with weights that are not of a product.
SplinePatch uneven_solid() {
    const TensorSpace space{{KnotVector{2, {0, 0, 0, 0.4, 1, 1, 1}}, KnotVector{3, {0, 0, 0, 0, 1, 1, 1, 1}},
                             KnotVector{1, {0, 0, 0.5, 1, 1}}}};
    SplinePatch patch{space, Points(space.size()), std::vector<double>(space.size(), 1.0)};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shake(-0.05, 0.05);
    for (std::size_t i = 0; i < space.size(); ++i) {
        const Vec3 at{static_cast<double>(i % 4) / 3, static_cast<double>(i / 4 % 4) / 3,
                      static_cast<double>(i / 16) / 2};
        const double angle = 1.5 * at.y, radius = 1 + at.x;
        patch.control.set(i, Vec3{radius * std::cos(angle), radius * std::sin(angle), at.z} +
                                 Vec3{shake(random), shake(random), shake(random)});
        patch.weights[i] = 1 + shake(random);
    }
    return patch;
}

struct NamedSolid {
    std::string name;
    std::shared_ptr<const SolidMap> map;
    double volume; ///< 0: not known
};

class Solids : public testing::TestWithParam<NamedSolid> {
  protected:
    const SolidMap& map = *GetParam().map;
    Points xi{200};

    Solids() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> unit(0.02, 0.98);
        for (std::size_t i = 0; i < xi.size(); ++i) xi.set(i, {unit(random), unit(random), unit(random)});
    }
    /// xi moved by h along each direction, forth and back.
    Points around(std::size_t i, double h) const {
        Points all(6);
        const Vec3 steps[3] = {{h, 0, 0}, {0, h, 0}, {0, 0, h}};
        for (std::size_t d = 0; d < 3; ++d)
            all.set(2 * d, xi[i] + steps[d]), all.set(2 * d + 1, xi[i] - steps[d]);
        return all;
    }
};

INSTANTIATE_TEST_SUITE_P(All, Solids,
                         testing::Values(NamedSolid{"cube", cube_map(), 1},
                                         NamedSolid{"ball", ball_map(), 4 * pi / 3},
                                         NamedSolid{"cylinder", cylinder_map(), 2 * pi},
                                         NamedSolid{"halfTorus", half_torus_map(), 2 * pi* pi},
                                         NamedSolid{"nurbsCylinder", solid_map(nurbs_cylinder()), 2 * pi},
                                         NamedSolid{"uneven", solid_map(uneven_solid()), 0}),
                         [](const auto& solid) { return solid.param.name; });

TEST_P(Solids, TangentsAreThoseOfDifferences) {
    std::array<Points, 3> tangents;
    map.tangents(xi, tangents);
    constexpr double h = 1e-5;
    for (std::size_t i = 0; i < xi.size(); ++i) {
        Points x;
        map.points(around(i, h), x);
        for (std::size_t d = 0; d < 3; ++d)
            EXPECT_LT(norm((1 / (2 * h)) * (x[2 * d] - x[2 * d + 1]) - tangents[d][i]), 1e-7);
    }
}

TEST_P(Solids, VolumeElementsAreDeterminants) {
    std::array<Points, 3> tangents;
    map.tangents(xi, tangents);
    Points x, expected;
    std::vector<double> element(xi.size());
    map.places(xi, x, element);
    map.points(xi, expected);
    for (std::size_t i = 0; i < xi.size(); ++i) {
        EXPECT_LT(norm(x[i] - expected[i]), 1e-15);
        EXPECT_NEAR(element[i], std::abs(dot(cross(tangents[0][i], tangents[1][i]), tangents[2][i])), 1e-13);
    }
}

TEST_P(Solids, VolumeElementsHaveTheGradientsOfTheirDifferences) {
    Points gradient, x;
    std::vector<double> element(xi.size()), again(6);
    map.element_gradients(xi, element, gradient);
    constexpr double h = 1e-5;
    for (std::size_t i = 0; i < xi.size(); ++i) {
        map.places(around(i, h), x, again);
        const Vec3 expected{(again[0] - again[1]) / (2 * h), (again[2] - again[3]) / (2 * h),
                            (again[4] - again[5]) / (2 * h)};
        EXPECT_LT(norm(gradient[i] - expected), 2e-6 * (1 + norm(expected)));
    }
}

/// Volume of the mesh.
double volume_of(const SolidDomain& domain) {
    double sum = 0;
    for (const double one : CellGeometry(domain.mesh()).measures(domain.mesh()->nodes)) {
        EXPECT_GT(one, 0);
        sum += one;
    }
    return sum;
}

// Half a torus has the opposite orientation: its cells exchange two directions.
TEST_P(Solids, MeshesHavePositiveVolumesThatConverge) {
    const double coarse = volume_of(SolidDomain(2, 6, GetParam().map)),
                 fine = volume_of(SolidDomain(2, 12, GetParam().map));
    if (GetParam().volume == 0) {
        EXPECT_NEAR(fine, coarse, 1e-3 * fine);
        return;
    }
    const double error = std::abs(coarse - GetParam().volume), finer = std::abs(fine - GetParam().volume);
    EXPECT_LT(finer, 2e-4 * GetParam().volume);
    if (error > 1e-12) {
        EXPECT_GT(std::log2(error / finer), 2.8);
    }
}

TEST_P(Solids, BoundaryFacesPointOutward) {
    const SolidDomain domain(3, 4, GetParam().map);
    const Mesh& mesh = *domain.mesh();
    const Facets faces = border(mesh);
    EXPECT_EQ(faces.size(), 6U * 16);
    EXPECT_EQ(faces.nodes_each, 16);
    // The divergence theorem over straight facets between the nodes of the faces.
    double volume = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto nodes = faces[f];
        const auto corner = [&](std::size_t k) { return mesh.nodes[static_cast<std::size_t>(nodes[k])]; };
        for (const auto& [a, b, c] : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}})
            volume += dot(corner(a), cross(corner(b), corner(c))) / 6;
    }
    const double whole = volume_of(domain);
    EXPECT_GT(volume, 0.85 * whole);
    EXPECT_LT(volume, 1.05 * whole);
}

TEST(SolidDomain, PutsTheBallsBoundaryOnTheSphere) {
    const SolidDomain domain(3, 6, ball_map());
    const Mesh& mesh = *domain.mesh();
    EXPECT_EQ(mesh.kind, (CellKind{CellShape::hexahedron, 3}));
    EXPECT_EQ(mesh.node_count(), 19U * 19 * 19);
    EXPECT_EQ(mesh.lattice, (std::array<std::int32_t, 3>{6, 6, 6}));
    const Facets faces = border(mesh);
    for (const std::int32_t node : faces.nodes)
        EXPECT_NEAR(norm(mesh.nodes[static_cast<std::size_t>(node)]), 1, 1e-14);
}

TEST(SolidDomain, HasFewerNodesPerCellWhereCellsAreMany) {
    EXPECT_EQ(SolidDomain(5, 4, cube_map()).mesh_order(), 5);
    EXPECT_EQ(SolidDomain(5, 32, cube_map()).mesh_order(), 4);
    EXPECT_EQ(SolidDomain(3, 64, cube_map()).mesh_order(), 2);
}

TEST(SolidDomain, RefusesMoreCellsThanFitIntoMemory) {
    Values values("domain", solid_domains().front().rows);
    values.set("degree", std::int64_t{7});
    values.set("cells", std::int64_t{64});
    EXPECT_EQ(message_of<InputError>([&] { make_solid_domain("spline-cube", values); }),
              "a solid of degree 7 may have at most 50 cells per side, but domain.cells = 64");
}

/// A square pyramid: the upper face is a point.
const char* pyramid = R"({"degrees": [1, 1, 1], "knots": [[0, 0, 1, 1], [0, 0, 1, 1], [0, 0, 1, 1]],
    "control_points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0],
                       [0.5, 0.5, 1], [0.5, 0.5, 1], [0.5, 0.5, 1], [0.5, 0.5, 1]]})";

TEST(SolidDomain, KnowsFacesThatAreAPointOrACurve) {
    const SolidDomain tip(3, 4, solid_map(parse_patch({pyramid, "pyramid", {}, 3}).patch));
    EXPECT_EQ(tip.collapsed().high, (std::array<bool, 3>{false, false, true}));
    EXPECT_EQ(tip.collapsed().low, (std::array<bool, 3>{}));
    EXPECT_NEAR(volume_of(tip), 1.0 / 3, 1e-12);
    SplinePatch wedge = parse_patch({pyramid, "wedge", {}, 3}).patch;
    wedge.control.set(4, {0.5, 0, 1}), wedge.control.set(5, {0.5, 0, 1});
    wedge.control.set(6, {0.5, 1, 1}), wedge.control.set(7, {0.5, 1, 1});
    const SolidDomain ridge(3, 4, solid_map(wedge));
    EXPECT_EQ(ridge.collapsed().high, (std::array<bool, 3>{false, false, true}));
    EXPECT_NEAR(volume_of(ridge), 0.5, 1e-12);
    EXPECT_EQ(SolidDomain(3, 4, ball_map()).collapsed().high, (std::array<bool, 3>{}));
}

TEST(SolidFile, IsReadBackAsItWasWritten) {
    const SplinePatch solid = uneven_solid();
    EXPECT_EQ(parse_patch({patch_json(solid), "a.json", {}, 3}).patch, solid);
    EXPECT_EQ(parse_patch({patch_xml(solid), "a.xml", {}, 3}).patch, solid);
    EXPECT_NE(patch_xml(solid).find("TensorNurbs3"), std::string::npos);
}

TEST(SolidFile, IsNotTakenForASurfaceNorTheReverse) {
    const auto message = [](const std::string& text, std::size_t directions) {
        return message_of<InputError>([&] { parse_patch({text, "f", {}, directions}); });
    };
    const SplinePatch solid = uneven_solid(), disk = nurbs_disk();
    for (const std::string& text : {patch_json(solid), patch_xml(solid)})
        EXPECT_NE(message(text, 2).find("a solid, not a surface (domain.type = spline-solid reads it)"),
                  std::string::npos)
            << message(text, 2);
    for (const std::string& text : {patch_json(disk), patch_xml(disk)})
        EXPECT_NE(message(text, 3).find("a surface, not a solid (domain.type = spline-patch reads it)"),
                  std::string::npos)
            << message(text, 3);
}

TEST(SolidFile, ThatFoldsIsRefused) {
    SplinePatch folded = parse_patch({pyramid, "pyramid", {}, 3}).patch;
    folded.control.set(0, {2, 2, 0.2});
    EXPECT_NE(message_of<InputError>([&] {
                  check_regular(*solid_map(folded), "f.json");
              }).find("f.json is not a valid patch: the map folds or has no volume"),
              std::string::npos);
    SplinePatch flat = parse_patch({pyramid, "pyramid", {}, 3}).patch;
    for (double& z : flat.control.z) z = 0;
    EXPECT_NE(message_of<InputError>([&] { check_regular(*solid_map(flat), "f.json"); }).find("no volume"),
              std::string::npos);
}

} // namespace
} // namespace gaspard
