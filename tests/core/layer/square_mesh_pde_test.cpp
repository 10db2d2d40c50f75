// Meshes of quadrilaterals beside what Hill, Madden (2021) promise of theirs.
#include "core/base/error.hpp"
#include "core/layer/square_mesh_pde.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

/// (37).
LayerDensities varying_diffusion(double eps) {
    return [eps](const Points& x, std::span<double> m11, std::span<double> m22) {
        const auto layer = [](double width, double away) {
            return std::max(1.0, 0.4 * 0.99 / width * std::exp(-0.99 * away / (2.5 * width)));
        };
        for (std::size_t i = 0; i < m11.size(); ++i) {
            m11[i] = layer(eps * std::pow(1 + 2 * x.y[i], 2), 1 - x.x[i]);
            m22[i] = layer(eps * std::pow(3 - 2 * x.x[i], 2), 1 - x.y[i]);
        }
    };
}

TEST(MeshPdeSquare, InvertsNoTriangle) {
    for (const double eps : {1.0, 1e-2, 1e-4, 1e-6, 1e-8})
        for (const int cells : {16, 32, 64}) {
            const auto mesh = mesh_pde_square(varying_diffusion(eps), cells, {});
            EXPECT_EQ(inverted_triangles(mesh.x, cells), 0U) << eps << ' ' << cells;
            EXPECT_LE(mesh.updates.size(), 5U);
        }
}

TEST(MeshPdeSquare, DoesNotMoveForAConstantDensity) {
    const LayerDensities constant = [](const Points&, std::span<double> m11, std::span<double> m22) {
        std::fill(m11.begin(), m11.end(), 3.0), std::fill(m22.begin(), m22.end(), 5.0);
    };
    const auto mesh = mesh_pde_square(constant, 16, {});
    for (std::size_t i = 0; i < mesh.x.size(); ++i) {
        EXPECT_NEAR(mesh.x.x[i], static_cast<double>(i % 17) / 16, 1e-13);
        EXPECT_NEAR(mesh.x.y[i], static_cast<double>(i / 17) / 16, 1e-13);
    }
}

TEST(MeshPdeSquare, KeepsNodesOnStraightSides) {
    SquareMeshPdeOptions options{.form = MeshPdeForm::one_direction,
                                 .corners = {Vec3{0, 0}, {1, 0.5}, {0, 1}, {1, 1}}};
    const LayerDensities layers = [](const Points& x, std::span<double> m11, std::span<double> m22) {
        constexpr double eps = 1e-4, b = 0.99 / (2.5 * eps);
        for (std::size_t i = 0; i < m11.size(); ++i) {
            m11[i] = 1;
            m22[i] = std::max(1.0, 0.28 * 0.99 / eps *
                                       (std::exp(-b * (x.y[i] - x.x[i] / 2)) + std::exp(-b * (1 - x.y[i]))));
        }
    };
    const int n = 32;
    const auto mesh = mesh_pde_square(layers, n, options);
    EXPECT_EQ(inverted_triangles(mesh.x, n), 0U);
    for (std::size_t i = 0; i <= 32; ++i) {
        EXPECT_NEAR(mesh.x.y[i], mesh.x.x[i] / 2, 1e-15);
        EXPECT_EQ(mesh.x.y[33 * 32 + i], 1);
        EXPECT_EQ(mesh.x.x[33 * i], 0);
        EXPECT_EQ(mesh.x.x[33 * i + 32], 1);
    }
    EXPECT_LT(mesh.x.y[33] - mesh.x.y[0], 1e-4) << "cells of the layer";
}

TEST(MeshPdeSquare, SaysWhereADensityIsWrong) {
    const LayerDensities wrong = [](const Points& x, std::span<double> m11, std::span<double> m22) {
        for (std::size_t i = 0; i < m11.size(); ++i) m11[i] = x.x[i] - 0.5, m22[i] = 1;
    };
    EXPECT_THROW(mesh_pde_square(wrong, 8, {}), InputError);
}

TEST(MeshPdeSquare, StartsWithTheCoarsestMeshOfItsSequence) {
    EXPECT_EQ(coarsest_cells(64, 4), 4);
    EXPECT_EQ(coarsest_cells(48, 4), 6);
    EXPECT_EQ(coarsest_cells(33, 4), 33);
    EXPECT_EQ(coarsest_cells(12, 12), 12);
    EXPECT_EQ(coarsest_cells(12, 7), 12);
    EXPECT_THROW(coarsest_cells(3, 4), InputError);
    EXPECT_THROW(coarsest_cells(8, 0), InputError);
    EXPECT_THROW(mesh_pde_square(varying_diffusion(0.1), 3, {}), InputError);
}

TEST(SquareMeshPde, StepsAsAlgorithm3) {
    const SquareMeshPdeOptions options;
    for (const int cells : {33, 48}) {
        const LayerDensities densities = varying_diffusion(1e-4);
        SquareMeshPde pde(options.form, options.samples, options.corners, coarsest_cells(cells, 4));
        while (pde.cells() < cells) {
            for (int i = 0; i < options.inner; ++i) pde.solve(densities);
            pde.refine();
        }
        const auto mesh = mesh_pde_square(densities, cells, options);
        ASSERT_EQ(mesh.updates.size(), 5U);
        for (const double update : mesh.updates) EXPECT_EQ(pde.solve(densities).update, update);
        EXPECT_EQ(pde.nodes(), mesh.x);
        EXPECT_EQ(inverted_triangles(mesh.x, cells), 0U);
    }
}

TEST(SquareMeshPde, StartsFromPositions) {
    const SquareMeshPdeOptions options;
    const LayerDensities densities = varying_diffusion(1e-2);
    SquareMeshPde pde(options.form, options.samples, options.corners, 9);
    const Points uniform = pde.nodes(), uniform_centres = pde.centres();
    const double update = pde.solve(densities).update;
    const Points nodes = pde.nodes(), centres = pde.centres();
    const double second = pde.solve(densities).update;
    pde.set_positions(nodes, centres);
    EXPECT_EQ(pde.solve(densities).update, second);
    pde.set_positions(uniform); // the centres of a uniform mesh are in the middle
    for (std::size_t i = 0; i < uniform_centres.size(); ++i)
        EXPECT_NEAR(norm(pde.centres()[i] - uniform_centres[i]), 0, 1e-15);
    EXPECT_NEAR(pde.solve(densities).update, update, 1e-12);

    EXPECT_THROW(pde.set_positions(Points(99)), InputError);
    EXPECT_THROW(pde.set_positions(nodes, nodes), InputError);
    Points wrong = nodes;
    wrong.y[3] = std::nan("");
    EXPECT_THROW(pde.set_positions(wrong), InputError);
    wrong = nodes;
    wrong.x[10] = 0.01;
    EXPECT_THROW(pde.set_positions(wrong), InputError);
    EXPECT_THROW(SquareMeshPde(options.form, options.samples, options.corners, 0), InputError);
}

} // namespace
} // namespace gaspard
