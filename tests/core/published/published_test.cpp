#include "core/base/error.hpp"
#include "core/published/published.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(Published, CsvLeavesUnprintedNumbersEmptyAndQuotes) {
    const std::string csv = published_csv({{"a", "x, y", 0.5, 2.0, "say \"so\""}, {"b", "z", 1e-8}});
    EXPECT_EQ(csv, "row,quantity,ours,published,note\n"
                   "a,\"x, y\",0.5,2,\"say \"\"so\"\"\"\n"
                   "b,z,1e-08,,\n");
}

TEST(Published, AnUnknownIdNamesTheNearest) {
    try {
        find_recipe("mcrae-fig4");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("'mcrae-fig"), std::string::npos);
    }
}

TEST(Published, Figure2IsTwoUntangledMeshes) {
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

TEST(Published, Figure5IsTheX2MeshWithItsDeviationFromTheExactOne) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const Reproduction result = find_recipe("mcrae-fig5").make(catalogue, [](const std::string&) {}, {});
    ASSERT_EQ(result.figure->panels.size(), 1u);
    const auto& snapshot = std::get<std::shared_ptr<const Snapshot>>(result.figure->panels.front().content);
    EXPECT_EQ(snapshot->mesh->cell_count(), 1536u);
    EXPECT_EQ(snapshot->report.iteration, 32);
    const auto row = std::find_if(result.rows.begin(), result.rows.end(), [](const PublishedRow& r) {
        return r.quantity == "rms to the exact mesh, vertices";
    });
    ASSERT_NE(row, result.rows.end());
    EXPECT_NEAR(row->ours, 4.42e-4, 1e-6);
}

TEST(Published, Figure9IsATangledMesh) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const Reproduction result = find_recipe("mcrae-fig9").make(catalogue, [](const std::string&) {}, {});
    const auto& snapshot = std::get<std::shared_ptr<const Snapshot>>(result.figure->panels.front().content);
    EXPECT_EQ(snapshot->mesh->kind.order, 1);
    EXPECT_GT(*snapshot->report.tangled_cells, 0u);
    EXPECT_LT(snapshot->report.residual, 2); // before divergence
}

TEST(Published, TablesOfBahariListPublishedNumbers) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    for (const int table : {1, 3, 4, 5, 6, 7, 9, 10, 11, 12, 13, 14, 15})
        EXPECT_NO_THROW(find_recipe("bahari-table" + std::to_string(table)));
    EXPECT_THROW(find_recipe("bahari-table2"), InputError); // three-dimensional
    std::stop_source source;
    int solved = 0;
    const auto first_row_only = [&](const std::string&) {
        if (++solved == 2) source.request_stop();
    };
    EXPECT_THROW(find_recipe("bahari-table3").make(catalogue, first_row_only, source.get_token()),
                 Interrupted);
    EXPECT_EQ(solved, 2);
}

TEST(Published, StopsOnRequest) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(find_recipe("mcrae-fig3")
                     .make(
                         catalogue, [](const std::string&) {}, source.get_token()),
                 Interrupted);
}

} // namespace
} // namespace gaspard
