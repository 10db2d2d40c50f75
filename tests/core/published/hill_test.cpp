// Tables and figures of Hill, Madden (2021), and numbers of their figures by an independent implementation
// (FEniCS).
#include "core/published/hill_problems.hpp"
#include "core/published/published.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace gaspard {
namespace {

Reproduction reproduce(const std::string& id) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    return find_recipe(id).make(catalogue, [](const std::string&) {}, {});
}

double ours(const Reproduction& result, const std::string& row, const std::string& quantity) {
    const auto found = std::find_if(result.rows.begin(), result.rows.end(), [&](const PublishedRow& one) {
        return one.row == row && one.quantity == quantity;
    });
    if (found == result.rows.end()) throw std::runtime_error(row + ", " + quantity + " is missing");
    return found->ours;
}

TEST(Hill, CountsOfIterationsAreThoseOfThePaper) {
    for (const std::string table : {"1", "2", "4"}) {
        const Reproduction result = reproduce("hill-table" + table);
        EXPECT_EQ(result.rows.size(), 30U);
        for (const PublishedRow& row : result.rows) {
            ASSERT_TRUE(row.published.has_value());
            EXPECT_EQ(row.published->last_digit, 0) << "counts are exact";
            EXPECT_FALSE(differs(row)) << table << ' ' << row.row << ' ' << row.ours;
        }
    }
}

TEST(Hill, ErrorsAreThoseOfThePaper) {
    const Reproduction result = reproduce("hill-table3");
    EXPECT_EQ(result.rows.size(), 60U);
    int different = 0;
    for (const PublishedRow& row : result.rows) {
        if (!row.published) continue;
        EXPECT_NEAR(row.ours, row.published->value, 2e-3 * row.published->value) << row.row;
        if (!differs(row)) continue;
        ++different;
        EXPECT_NE(row.row.find("N = 32"), std::string::npos) << row.row;
        EXPECT_NE(full_note(row).find("is between ours and the part"), std::string::npos);
        EXPECT_LT(row.published->value, row.ours);
        EXPECT_GT(row.published->value, ours(result, row.row, "from the derivative"));
    }
    EXPECT_EQ(different, 4);
}

TEST(Hill, Figure4HasTheExactErrorBesideThatOfTheReference) {
    const Reproduction result = reproduce("hill-fig4");
    ASSERT_EQ(result.figure->panels.size(), 2U);
    for (const std::string eps : {"1", "1e-2", "1e-4", "1e-6", "1e-8"})
        for (const std::string cells : {"32", "1024"}) {
            const std::string row = "ε = " + eps + ", N = " + cells;
            const double error = ours(result, row, "energy error"),
                         exact = ours(result, row, "exact energy error");
            EXPECT_NEAR(exact, error, 0.02 * error) << row;
            if (eps != "1") {
                EXPECT_NEAR(error / ours(result, row, "ε^(1/2) / N"), 1.3, 0.1) << row;
            }
        }
}

TEST(Hill, Figure7HasTheErrorsOfTheSystem) {
    const Reproduction result = reproduce("hill-fig7");
    const std::pair<std::string, std::array<double, 6>> expected[] = {
        {"1e-4", {1.525e-2, 7.265e-3, 3.621e-3, 1.863e-3, 9.427e-4, 4.744e-4}},
        {"1e-8", {1.611e-3, 4.040e-4, 1.025e-4, 2.703e-5, 8.019e-6, 2.953e-6}}};
    for (const auto& [eps2, errors] : expected)
        for (int k = 0, n = 32; k < 6; ++k, n *= 2) {
            const double wanted = errors[static_cast<std::size_t>(k)];
            EXPECT_NEAR(ours(result, "ε2 = " + eps2 + ", N = " + std::to_string(n), "energy error"), wanted,
                        1e-3 * wanted);
        }
}

/// Energy errors on N = 16, 32, 64, in the three digits that are known.
struct SquareErrors {
    double eps;
    std::array<double, 3> errors;
};
void expect_errors(const HillSquare& square, const SquareErrors& expected) {
    for (int k = 0, n = 16; k < 3; ++k, n *= 2) {
        const Points x = mesh_pde_square(square.densities, n, square.options).x;
        const auto p1 = solve_triangles(square.problem, x, n, 1),
                   p2 = solve_triangles(square.problem, x, n, 2);
        const double wanted = expected.errors[static_cast<std::size_t>(k)];
        EXPECT_NEAR(reference_error(square.problem, x, n, p1, p2), wanted, printed(wanted, 3).last_digit)
            << expected.eps << ' ' << n;
        EXPECT_EQ(inverted_triangles(x, n), 0U);
    }
}

TEST(Hill, IrregularDomainHasTheErrorsOfFigure11) {
    for (const SquareErrors& one : {SquareErrors{1e-2, {9.23e-3, 4.73e-3, 2.59e-3}},
                                    {1e-4, {1.06e-3, 5.17e-4, 2.55e-4}},
                                    {1e-8, {1.12e-5, 5.19e-6, 2.60e-6}}})
        expect_errors(hill_irregular(one.eps), one);
}

TEST(Hill, VaryingDiffusionHasTheErrorsOfFigure14) {
    for (const SquareErrors& one : {SquareErrors{1e-2, {3.74e-2, 1.87e-2, 9.38e-3}},
                                    {1e-4, {6.95e-3, 3.09e-3, 1.51e-3}},
                                    {1e-8, {4.12e-3, 1.04e-3, 2.62e-4}}})
        expect_errors(hill_varying(one.eps, Diffusion::squared), one);
}

TEST(Hill, MeshesOfFigures10And13AreTriangles) {
    for (const std::string id : {"hill-fig10", "hill-fig13"}) {
        const Reproduction result = reproduce(id);
        ASSERT_EQ(result.figure->panels.size(), 2U);
        for (const FigurePanel& panel : result.figure->panels) {
            const auto& snapshot = *std::get<std::shared_ptr<const Snapshot>>(panel.content);
            EXPECT_EQ(snapshot.mesh->kind, (CellKind{CellShape::triangle, 1}));
            EXPECT_EQ(snapshot.mesh->cell_count(), 2048U);
            EXPECT_EQ(snapshot.report.tangled_cells, 0U);
            EXPECT_LT(snapshot.x.y[33 * 32] - snapshot.x.y[33 * 31], 0.25 / 32) << "a layer above";
        }
    }
}

} // namespace
} // namespace gaspard
