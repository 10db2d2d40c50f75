// On a sphere, where cells may move around it, the sign of the Jacobian tells whether they face outward.
#include "core/tessellate/cell_geometry.hpp"
#include "fixtures/fixture_meshes.hpp"
#include "support/small_meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace gaspard {
namespace {

double sum(const std::vector<double>& values) {
    double total = 0;
    for (const double value : values) total += value;
    return total;
}

TEST(CellGeometry, RecognisesSpheresByTheirNodes) {
    Mesh mesh = cubed_sphere_mesh(3);
    EXPECT_NEAR(radius_of_ball(mesh), 1, 1e-15);
    for (auto* x : {&mesh.nodes.x, &mesh.nodes.y, &mesh.nodes.z})
        for (double& value : *x) value *= 6371e3;
    EXPECT_NEAR(radius_of_ball(mesh), 6371e3, 1e-6);
    mesh.nodes.x[5] += 1;
    EXPECT_EQ(radius_of_ball(mesh), 0);
    for (const Mesh& other : meshes_of_every_kind()) EXPECT_EQ(radius_of_ball(other), 0);
}

TEST(CellGeometry, RotatingASphereTanglesNothing) {
    for (const bool straight : {false, true}) {
        const Mesh curved = cubed_sphere_mesh(4);
        const auto mesh = std::make_shared<const Mesh>(straight ? without_middles(curved) : curved);
        const CellGeometry geometry(mesh);
        for (const double angle : {0.4, 1.6, 3.14}) { // beyond a quarter turn, the normals are opposite
            Points x = mesh->nodes;
            for (std::size_t i = 0; i < x.size(); ++i)
                x.set(i, {std::cos(angle) * x.x[i] - std::sin(angle) * x.y[i],
                          std::sin(angle) * x.x[i] + std::cos(angle) * x.y[i], x.z[i]});
            for (const double jacobian : geometry.jacobians(x)) EXPECT_NEAR(jacobian, 1, 1e-12);
            EXPECT_NEAR(sum(geometry.measures(x)), sum(geometry.measures(mesh->nodes)), 1e-12);
        }
    }
}

TEST(CellGeometry, TangledCellsAreThoseWithoutAPositiveJacobian) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    for (const Mesh& mesh : meshes_of_every_kind()) {
        const CellGeometry geometry(std::make_shared<const Mesh>(mesh));
        EXPECT_TRUE(geometry.tangled(mesh.nodes).empty());
        for (const double value : {-3.0, 0.5, nothing})
            for (std::size_t node = 0; node < mesh.node_count(); ++node) {
                Points x = mesh.nodes;
                x.x[node] = value;
                const std::vector<double> jacobians = geometry.jacobians(x);
                EXPECT_EQ(geometry.tangled(x), tangled_cells(jacobians));
                EXPECT_TRUE(!std::isnan(value) || !geometry.tangled(x).empty());
            }
    }
}

TEST(CellGeometry, AClockwiseMeshIsNotTangled) {
    Mesh mesh = unit_square_mesh(3);
    for (double& x : mesh.nodes.x) x = -x;
    const CellGeometry geometry(std::make_shared<const Mesh>(mesh));
    EXPECT_TRUE(geometry.tangled(mesh.nodes).empty());
    for (const double jacobian : geometry.jacobians(mesh.nodes)) EXPECT_NEAR(jacobian, 1, 1e-12);
    Points mirrored = mesh.nodes;
    for (double& x : mirrored.x) x = -x;
    EXPECT_EQ(geometry.tangled(mirrored).size(), mesh.cell_count());
}

TEST(CellGeometry, ASphereTurnedInsideOutIsTangledEverywhere) {
    const auto mesh = std::make_shared<const Mesh>(cubed_sphere_mesh(3));
    Points x = mesh->nodes;
    for (double& value : x.z) value = -value;
    const auto jacobians = CellGeometry(mesh).jacobians(x);
    EXPECT_LT(*std::max_element(jacobians.begin(), jacobians.end()), 0);
    EXPECT_NEAR(sum(CellGeometry(mesh).measures(x)), -4 * std::numbers::pi, 0.02);
}

} // namespace
} // namespace gaspard
