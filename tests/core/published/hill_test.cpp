// Tables and figures of Hill, Madden (2021), and numbers of their figures by an independent implementation
// (FEniCS).
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

} // namespace
} // namespace gaspard
