// Whole tables of Bahari, Habbal, Ratnani, Sonnendruecker (2024), in the digits that they agree in.
#include "core/published/published.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

/// Of the numbers printed, how many ours differ from by more than a thousandth.
int differences(const std::string& id, const std::string& beyond_cells = {}) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const Reproduction result = find_recipe(id).make(catalogue, [](const std::string&) {}, {});
    int count = 0;
    for (const PublishedRow& row : result.rows)
        if (row.published && std::abs(*difference(row)) > 1.05e-3 * std::abs(row.published->value) &&
            (beyond_cells.empty() || row.row.find("n = " + beyond_cells) == std::string::npos)) {
            ++count;
            std::printf("%s %s %s: %g, printed %g\n", id.c_str(), row.row.c_str(), row.quantity.c_str(),
                        row.ours, row.published->value);
        }
    return count;
}

TEST(BahariTables, WholeTablesAgree) {
    EXPECT_EQ(differences("bahari-table1", "128"), 0); // there rounding begins
    EXPECT_EQ(differences("bahari-table4"), 2);        // one of them where the paper's digits are not certain
    EXPECT_EQ(differences("bahari-table5"), 1);
    EXPECT_EQ(differences("bahari-table10"), 0);
    EXPECT_LE(differences("bahari-table15"), 2);
}

/// Ours of a table, against numbers that an independent prototype found (or the paper prints), in their
/// digits.
struct ExpectedRow {
    const char *row, *quantity;
    double value;
};
void expect_numbers(const std::string& id, const std::vector<ExpectedRow>& expected) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const Reproduction result = find_recipe(id).make(catalogue, [](const std::string&) {}, {});
    for (const ExpectedRow& one : expected) {
        bool found = false;
        for (const PublishedRow& row : result.rows)
            if (row.row == one.row && row.quantity == one.quantity) {
                found = true;
                EXPECT_NEAR(row.ours, one.value, 1.1e-3 * one.value)
                    << id << ' ' << one.row << ' ' << one.quantity;
            }
        EXPECT_TRUE(found) << one.row << ' ' << one.quantity;
    }
}

TEST(BahariTables, Table4ClaimsNoMisprint) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const Reproduction result = find_recipe("bahari-table4").make(catalogue, [](const std::string&) {}, {});
    int found = 0;
    for (const PublishedRow& row : result.rows)
        if (row.row == "p = 4, n = 128" && row.quantity == "Err") {
            ++found;
            EXPECT_NEAR(row.ours, 4.82e-3, 5e-6);
            EXPECT_NE(full_note(row).find("no misprint is established"), std::string::npos) << full_note(row);
        }
    EXPECT_EQ(found, 1);
}

TEST(BahariTables, HaveThePrototypesNumbersOnFineMeshes) {
    expect_numbers("bahari-table6", {{"p = 3, n = 64", "Err", 3.468e-3},
                                     {"p = 3, n = 64", "Qual", 9.620e-2},
                                     {"p = 3, n = 64", "min Jac", 0.1699},
                                     {"p = 3, n = 64", "max Jac", 1.869},
                                     {"p = 3, n = 64", "border error", 4.823e-5}});
    expect_numbers("bahari-table9", {{"p = 3, n = 64", "Err", 5.005e-4}});
    expect_numbers("bahari-table11", {{"p = 3, n = 16", "Err", 0.3259},
                                      {"p = 3, n = 32", "Err", 0.08835},
                                      {"p = 3, n = 64", "Err", 0.02677},
                                      {"p = 3, n = 128", "Err", 0.004897}});
    expect_numbers("bahari-table12", {{"p = 3, n = 128", "Err", 1.106e-4}});
    expect_numbers("bahari-table13", {{"p = 3, n = 64", "Err", 4.754e-3},
                                      {"p = 3, n = 64", "Qual", 7.754e-2},
                                      {"p = 3, n = 64", "min Jac", 0.2740},
                                      {"p = 3, n = 64", "max Jac", 1.614}});
    expect_numbers("bahari-table14", {{"p = 3, n = 128", "Err", 8.173e-3},
                                      {"p = 3, n = 128", "Qual", 6.952e-3},
                                      {"p = 3, n = 128", "min Jac", 0.5763},
                                      {"p = 3, n = 128", "max Jac", 1.759}});
}

} // namespace
} // namespace gaspard
