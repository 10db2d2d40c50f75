// Figures 11 and 14 of Hill, Madden (2021) up to N = 128, beside numbers of an independent implementation
// (FEniCS).
#include "core/published/published.hpp"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

namespace gaspard {
namespace {

Reproduction reproduce_hill(const std::string& id) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    return find_recipe(id).make(catalogue, [](const std::string&) {}, {});
}

const PublishedRow* find_row(const Reproduction& result, const std::string& row,
                             const std::string& quantity) {
    const auto found = std::find_if(result.rows.begin(), result.rows.end(), [&](const PublishedRow& one) {
        return one.row == row && one.quantity == quantity;
    });
    return found == result.rows.end() ? nullptr : &*found;
}

/// Errors on N = 16, 32, 64, 128, in the three digits that are known.
using ExpectedErrors = std::pair<std::string, std::array<double, 4>>;
void expect_errors(const Reproduction& result, const std::vector<ExpectedErrors>& expected) {
    for (const auto& [eps, errors] : expected)
        for (int k = 0, n = 16; k < 4; ++k, n *= 2) {
            const std::string row = "ε = " + eps + ", N = " + std::to_string(n);
            const double wanted = errors[static_cast<std::size_t>(k)];
            const PublishedRow* found = find_row(result, row, "energy error");
            ASSERT_NE(found, nullptr) << row;
            EXPECT_NEAR(found->ours, wanted, printed(wanted, 3).last_digit) << row;
        }
    for (const PublishedRow& row : result.rows)
        if (row.quantity == "inverted triangles") {
            EXPECT_EQ(row.ours, 0) << row.row;
        }
}

TEST(HillFigures, Figure11HasTheErrorsOfTheIrregularDomain) {
    expect_errors(reproduce_hill("hill-fig11"), {{"1e-2", {9.23e-3, 4.73e-3, 2.59e-3, 1.53e-3}},
                                                 {"1e-4", {1.06e-3, 5.17e-4, 2.55e-4, 1.26e-4}},
                                                 {"1e-8", {1.12e-5, 5.19e-6, 2.60e-6, 1.30e-6}}});
}

TEST(HillFigures, Figure14HasTheErrorsOfVaryingDiffusion) {
    const Reproduction result = reproduce_hill("hill-fig14");
    expect_errors(result, {{"1e-2", {3.74e-2, 1.87e-2, 9.38e-3, 4.69e-3}},
                           {"1e-4", {6.95e-3, 3.09e-3, 1.51e-3, 7.49e-4}},
                           {"1e-8", {4.12e-3, 1.04e-3, 2.62e-4, 6.55e-5}}});
    const PublishedRow* as_printed = find_row(result, "ε = 1e-8, N = 128", "energy error, as printed");
    ASSERT_NE(as_printed, nullptr);
    EXPECT_GT(as_printed->ours, 0.05) << "the mesh is not that of these layers";
    EXPECT_NE(as_printed->note.find("lacks the exponent"), std::string::npos);
}

} // namespace
} // namespace gaspard
