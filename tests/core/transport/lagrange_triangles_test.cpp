// Shape functions on triangles, numbering of their nodes, and curved boundaries.
#include "core/transport/lagrange_triangles.hpp"
#include "core/transport/nonvariational_space.hpp"
#include "support/transport_spaces.hpp"

#include <gtest/gtest.h>
#include <numeric>
#include <set>

namespace gaspard {
namespace {

TEST(LagrangeTriangles, ShapeFunctionsAreOneAtTheirNodesAndHaveTheirSlopes) {
    for (int degree = 1; degree <= highest_triangle_degree; ++degree) {
        const auto lattice = lagrange_lattice(degree);
        for (std::size_t i = 0; i < lattice.size(); ++i) {
            const auto shapes =
                triangle_shapes(degree, lattice[i][1] / double(degree), lattice[i][2] / double(degree));
            for (std::size_t j = 0; j < lattice.size(); ++j)
                EXPECT_NEAR(shapes.values[j], i == j ? 1 : 0, 1e-14) << degree;
        }
        const double s = 0.23, t = 0.41, h = 1e-6;
        const auto at = triangle_shapes(degree, s, t);
        EXPECT_NEAR(std::accumulate(at.values.begin(), at.values.end(), 0.0), 1, 1e-14);
        for (std::size_t j = 0; j < lattice.size(); ++j) {
            const auto difference = [&](double ds, double dt) {
                return (triangle_shapes(degree, s + ds, t + dt).values[j] -
                        triangle_shapes(degree, s - ds, t - dt).values[j]) /
                       (2 * h);
            };
            EXPECT_NEAR(at.slopes[j][0], difference(h, 0), 1e-8);
            EXPECT_NEAR(at.slopes[j][1], difference(0, h), 1e-8);
        }
    }
}

TEST(LagrangeTriangles, NeighboursShareTheNodesOfTheirEdge) {
    for (int degree = 1; degree <= highest_triangle_degree; ++degree) {
        const LagrangeTriangles elements = disk_elements(3, degree, false);
        const std::size_t vertices = 37, triangles = 54, edges = vertices + triangles - 1; // Euler
        const auto k = static_cast<std::size_t>(degree);
        EXPECT_EQ(elements.nodes().size(), vertices + (k - 1) * edges + (degree == 3 ? triangles : 0));
        std::set<std::pair<double, double>> places;
        for (std::size_t i = 0; i < elements.nodes().size(); ++i)
            places.emplace(std::round(1e9 * elements.nodes().x[i]), std::round(1e9 * elements.nodes().y[i]));
        EXPECT_EQ(places.size(), elements.nodes().size()) << "no two at one place";
        for (std::size_t c = 0; c < elements.cell_count(); ++c)
            for (std::size_t i = 0; i < elements.per_cell(); ++i) { // the map of a triangle meets its nodes
                const auto at = lagrange_lattice(degree)[i];
                const auto place = elements.place(
                    c, triangle_shapes(degree, at[1] / double(degree), at[2] / double(degree)));
                const Vec3 node = elements.nodes()[static_cast<std::size_t>(elements.cell(c)[i])];
                const auto corner = [&](std::size_t n) {
                    return elements.nodes()[static_cast<std::size_t>(elements.cell(c)[n])];
                };
                const Vec3 straight =
                    (1 / double(degree)) *
                    (double(at[0]) * corner(0) + double(at[1]) * corner(1) + double(at[2]) * corner(2));
                EXPECT_NEAR(norm(place.x - node), 0, 1e-14);
                EXPECT_NEAR(norm(straight - node), 0, 1e-14) << "degree " << degree << ", node " << i;
            }
    }
}

TEST(LagrangeTriangles, CurvedBoundariesHaveTheAreaOfTheDiskToTheirOrder) {
    const auto error = [](int rings, int degree, bool curved) {
        const NonvariationalSpace space(disk_elements(rings, degree, curved), Recovery::gradient);
        return std::abs(space.area() - std::numbers::pi);
    };
    for (int degree = 1; degree <= highest_triangle_degree; ++degree)
        EXPECT_NEAR(std::log2(error(4, degree, false) / error(8, degree, false)), 2, 0.02);
    EXPECT_GT(std::log2(error(4, 2, true) / error(8, 2, true)), 3.9);
    EXPECT_GT(std::log2(error(4, 3, true) / error(8, 3, true)), 3.9);
    EXPECT_LT(error(8, 3, true), 1e-5);
}

TEST(LagrangeTriangles, NodesOnTheBoundaryAreOnTheCurve) {
    for (int degree = 2; degree <= highest_triangle_degree; ++degree) {
        const LagrangeTriangles elements = disk_elements(4, degree, true);
        EXPECT_TRUE(elements.curved());
        EXPECT_EQ(elements.sides().size(), 24U);
        for (const auto& [cell, edge] : elements.sides())
            for (int i = 0; i <= degree; ++i) {
                const auto [s, t] = LagrangeTriangles::on_edge(edge, double(i) / degree);
                EXPECT_NEAR(norm(elements.place(cell, triangle_shapes(degree, s, t)).x), 1, 1e-14);
            }
    }
    EXPECT_FALSE(disk_elements(4, 1, true).curved());
}

} // namespace
} // namespace gaspard
