// Figures of McRae, Cotter, Budd (2018) whose recipes take up to minutes.
#include "core/published/published.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

Reproduction reproduce(const std::string& id) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    return find_recipe(id).make(catalogue, [](const std::string&) {}, {});
}

const PublishedRow& find(const Reproduction& result, const std::string& row, const std::string& quantity) {
    const auto found = std::find_if(result.rows.begin(), result.rows.end(), [&](const PublishedRow& one) {
        return one.row == row && one.quantity == quantity;
    });
    if (found == result.rows.end()) throw std::runtime_error(row + ", " + quantity + " is missing");
    return *found;
}

TEST(McRaeFigures, Figure3HasBothStoppingRules) {
    const Reproduction result = reproduce("mcrae-fig3");
    EXPECT_EQ(find(result, "ring, n = 60", "iterations to 1e-8").ours, 198);
    EXPECT_EQ(find(result, "bell, n = 60", "iterations to 1e-8").ours, 894);
    EXPECT_EQ(find(result, "bell, n = 60, quasi-newton", "iterations to 1e-8").ours, 97);
    EXPECT_EQ(find(result, "bell, n = 60, quasi-newton", "to 1e-8 of the first").ours, 91);
    EXPECT_NEAR(find(result, "bell / ring", "ratio of iterations").ours, 894.0 / 198, 1e-12);
}

TEST(McRaeFigures, Figure11SaysWhereQuasiNewtonConverges) {
    const Reproduction result = reproduce("mcrae-fig11");
    for (const std::string ratio : {"2", "4", "8", "16"}) {
        const std::string row = "X" + ratio + ", biquadratic, quasi-newton";
        EXPECT_LT(find(result, row, "residual").ours, 1e-8) << row;
        EXPECT_EQ(find(result, row, "tangled cells").ours, 0) << row;
        EXPECT_TRUE(find(result, row, "iterations").note.starts_with("converged; the paper: ")) << row;
    }
    EXPECT_EQ(find(result, "X8, biquadratic, quasi-newton", "iterations").ours, 117);
    EXPECT_NEAR(find(result, "X16, biquadratic, quasi-newton", "iterations").ours, 435,
                5); // rounding matters
    EXPECT_LT(find(result, "X2, bilinear, quasi-newton", "residual").ours, 1e-8);
    for (const std::string ratio : {"4", "8", "16"}) {
        const std::string row = "X" + ratio + ", bilinear, quasi-newton";
        EXPECT_GT(find(result, row, "residual").ours, 1e-2) << row;
        EXPECT_GT(find(result, row, "tangled cells").ours, 0) << row;
        EXPECT_NE(find(result, row, "iterations").note.find("the linear solver did not converge"),
                  std::string::npos)
            << "how the method fails in the paper";
    }
    ASSERT_EQ(result.figure->panels.size(), 2U);
    const auto markers = [](const FigurePanel& panel) {
        const auto& curves = std::get<Plot>(panel.content).curves;
        return std::count_if(curves.begin(), curves.end(), [](const Curve& one) { return one.markers; });
    };
    EXPECT_EQ(markers(result.figure->panels[0]), 3) << "failures are marked";
    EXPECT_EQ(markers(result.figure->panels[1]), 0);
}

} // namespace
} // namespace gaspard
