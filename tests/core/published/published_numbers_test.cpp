// Figures and a table that are computed as a whole.
#include "core/base/read_data_file.hpp"
#include "core/data/field_file.hpp"
#include "core/published/published.hpp"
#include "core/tessellate/camera.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace gaspard {
namespace {

TEST(PublishedNumbers, EveryDifferenceOfATableIsNoted) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const Reproduction result = find_recipe("bahari-table9").make(catalogue, [](const std::string&) {}, {});
    std::size_t different = 0;
    for (const PublishedRow& row : result.rows) {
        const bool noted = full_note(row).find("beyond the last digit") != std::string::npos;
        EXPECT_EQ(noted, differs(row));
        if (!differs(row)) continue;
        ++different;
        EXPECT_EQ(row.quantity, "Err");
        if (row.row == "p = 5, n = 128") {
            EXPECT_NEAR(*difference(row) / row.published->value, -0.507, 1e-3);
            EXPECT_NE(full_note(row).find("(-51 %)"), std::string::npos) << full_note(row);
        }
    }
    EXPECT_EQ(different, 5U);
}

TEST(PublishedNumbers, Figure2IsTwoUntangledMeshes) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    int runs = 0;
    const Reproduction result =
        find_recipe("mcrae-fig2").make(catalogue, [&](const std::string&) { ++runs; }, {});
    EXPECT_EQ(runs, 2);
    ASSERT_TRUE(result.figure.has_value());
    ASSERT_EQ(result.figure->panels.size(), 2u);
    for (const auto& panel : result.figure->panels) {
        const auto& snapshot = std::get<std::shared_ptr<const Snapshot>>(panel.content);
        EXPECT_EQ(snapshot->mesh->cell_count(), 900u);
        EXPECT_EQ(snapshot->report.status, RunStatus::converged);
    }
    const auto row = std::find_if(result.rows.begin(), result.rows.end(),
                                  [](const PublishedRow& r) { return r.quantity == "iterations"; });
    ASSERT_NE(row, result.rows.end());
    EXPECT_EQ(row->row, "ring, n = 30");
    EXPECT_EQ(row->ours, 189);
    for (const auto& r : result.rows)
        if (r.quantity == "tangled cells") {
            EXPECT_EQ(r.ours, 0);
        }
}

// The flow is computed from its noise; the shipped data are its end.
TEST(PublishedNumbers, Figure4IsTheFlowThatIsShippedAndItsMesh) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const Reproduction result = find_recipe("mcrae-fig4").make(catalogue, [](const std::string&) {}, {});
    std::map<std::string, double> ours;
    for (const PublishedRow& row : result.rows) {
        ours[row.row + ", " + row.quantity] = row.ours;
        EXPECT_FALSE(differs(row)) << row.quantity;
    }
    EXPECT_NEAR(ours.at("flow, T = 500, least q"), -0.4012, 1e-4);
    EXPECT_NEAR(ours.at("flow, T = 500, largest q"), 0.3790, 1e-4);
    EXPECT_NEAR(ours.at("flow, T = 500, change of the mean"), 0, 1e-16);
    EXPECT_NEAR(ours.at("flow, T = 500, enstrophy / at T = 0"), 0.02211, 1e-5);
    EXPECT_NEAR(1 - ours.at("flow, T = 500, energy / at T = 0"), 1.96e-5, 1e-7);
    EXPECT_NEAR(ours.at("mesh, quasi-newton, iterations"), 30, 1);
    EXPECT_NEAR(ours.at("mesh, quasi-newton, equidistribution"), 0.03174, 1e-5);
    EXPECT_EQ(ours.at("mesh, quasi-newton, tangled cells"), 0);
    EXPECT_EQ(ours.at("mesh, auto, tangled cells"), 0);
    ASSERT_EQ(result.figure->panels.size(), 2u);
    const auto left = std::get<std::shared_ptr<const Snapshot>>(result.figure->panels[0].content);
    const Field* q = left->field("q");
    ASSERT_NE(q, nullptr);
    const FieldData shipped =
        parse_field(read_data_file("gaspard:flow-vortices.nc", {}), "flow-vortices.nc", {.variable = "q"});
    const auto& values = std::get<GridData>(shipped.data).values;
    ASSERT_EQ(values.size(), 10000u);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t node = i / 100 * 101 + i % 100;
        ASSERT_NEAR(q->values[node], values[i], 1e-7) << i; // of 32 bits
        ASSERT_EQ(left->mesh->nodes[node].x, static_cast<double>(i % 100) / 100);
    }
}

/// Where the middle of a panel's picture is on the unit sphere.
Vec3 middle_of(const FigurePanel& panel) {
    EXPECT_TRUE(shows_all(panel.camera)) << panel.camera;
    return towards_viewer(parse_camera(panel.camera, {800, 800}));
}

TEST(PublishedNumbers, Figure5IsTheX2MeshWithItsDeviationFromTheExactOne) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const Reproduction result = find_recipe("mcrae-fig5").make(catalogue, [](const std::string&) {}, {});
    ASSERT_EQ(result.figure->panels.size(), 2u); // front and rear, the fine region in the middle
    const double root = std::sqrt(3.0);
    EXPECT_LT(norm(middle_of(result.figure->panels[0]) - Vec3{root / 2, 0, 0.5}), 1e-12);
    EXPECT_LT(norm(middle_of(result.figure->panels[1]) - Vec3{-root / 2, 0, -0.5}), 1e-12);
    const auto& snapshot = std::get<std::shared_ptr<const Snapshot>>(result.figure->panels.front().content);
    EXPECT_EQ(snapshot->mesh->cell_count(), 1536u);
    EXPECT_EQ(snapshot->report.iteration, 32);
    const auto row = std::find_if(result.rows.begin(), result.rows.end(), [](const PublishedRow& r) {
        return r.quantity == "rms to the exact mesh, vertices";
    });
    ASSERT_NE(row, result.rows.end());
    EXPECT_NEAR(row->ours, 4.42e-4, 1e-6);
}

TEST(PublishedNumbers, Figure7HasTheCrossingInTheMiddle) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const Reproduction result = find_recipe("mcrae-fig7").make(catalogue, [](const std::string&) {}, {});
    ASSERT_EQ(result.figure->panels.size(), 1u);
    const Vec3 middle = middle_of(result.figure->panels[0]);
    const double root = std::sqrt(3.0);
    for (const Vec3 pole :
         {Vec3{root / 2, 0, 0.5}, Vec3{-root / 2, 0, 0.5}}) // the bands are 90 degrees from them
        EXPECT_NEAR(dot(middle, pole), 0, 1e-12);
}

TEST(PublishedNumbers, Figure9IsATangledMesh) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const Reproduction result = find_recipe("mcrae-fig9").make(catalogue, [](const std::string&) {}, {});
    const auto& snapshot = std::get<std::shared_ptr<const Snapshot>>(result.figure->panels.front().content);
    EXPECT_EQ(snapshot->mesh->kind.order, 1);
    EXPECT_GT(*snapshot->report.tangled_cells, 0u);
    EXPECT_LT(snapshot->report.residual, 2); // before divergence
}

double kawecki_row(const Reproduction& result, const std::string& row, const std::string& quantity) {
    for (const PublishedRow& one : result.rows)
        if (one.row == row && one.quantity == quantity) return one.ours;
    ADD_FAILURE() << row << ", " << quantity;
    return NAN;
}

TEST(PublishedNumbers, KaweckisErrorsHaveTheOrdersOfTheText) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const Reproduction result = find_recipe("kawecki-fig1").make(catalogue, [](const std::string&) {}, {});
    int stated = 0;
    for (const PublishedRow& row : result.rows) {
        if (row.published) {
            ++stated;
            EXPECT_NEAR(row.ours, row.published->value, 0.1) << row.row << ' ' << row.quantity;
        }
        if (row.quantity == "Newton steps") {
            EXPECT_LE(row.ours, 7) << row.row;
        }
    }
    EXPECT_EQ(stated, 10);
    ASSERT_EQ(result.figure->panels.size(), 4u);
    for (const FigurePanel& panel : result.figure->panels)
        EXPECT_EQ(std::get<Plot>(panel.content).curves.size(), 8u);
    // By an independent implementation.
    const auto expect = [&](int rings, const std::string& quantity, double value, int digits) {
        const std::string row = "P1, recovery, n = " + std::to_string(rings);
        EXPECT_NEAR(kawecki_row(result, row, quantity), value, printed(value, digits).last_digit) << row;
    };
    expect(32, "L2 error", 3.614e-4, 4), expect(64, "L2 error", 8.896e-5, 4);
    expect(32, "H1 error", .0567, 3), expect(64, "H1 error", .0281, 3);
    expect(32, "recovered gradient", 8.46e-4, 3), expect(64, "recovered gradient", 2.36e-4, 3);
    EXPECT_NEAR(kawecki_row(result, "P1, no recovery, n = 64", "order, Hessian"), 0.5, 0.05);
}

} // namespace
} // namespace gaspard
