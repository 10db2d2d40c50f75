#include "core/diagnostics/feature_width.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace gaspard {
namespace {

/// Of the values f(x) on squares.
template <class F>
double share_of(int n, F f) {
    const Mesh mesh = unit_square_mesh(n);
    std::vector<double> m;
    for (std::size_t i = 0; i < mesh.node_count(); ++i) m.push_back(f(mesh.nodes[i].x));
    return share_within_cell(mesh, m);
}

TEST(FeatureWidth, IsThePartOfTheRangeWithinACell) {
    EXPECT_NEAR(share_of(10, [](double x) { return std::exp(3 * x); }), 0.1, 1e-12) << "evenly spread";
    EXPECT_NEAR(share_of(10, [](double x) { return x > 0.55 ? 7.0 : 1.0; }), 1, 1e-12) << "a jump";
    EXPECT_EQ(share_of(300, [](double x) { return x > 1 - 1e-9 ? 7.0 : 1.0; }), 0) << "one cell in 300";
    EXPECT_EQ(share_of(10, [](double) { return 5.0; }), 0);
    EXPECT_EQ(share_of(10, [](double x) { return 1 + 1e-3 * x; }), 0) << "as good as constant";
    EXPECT_NEAR(share_of(10, [](double x) { return 3e-200 * std::exp(3 * x); }), 0.1, 1e-12) << "in any unit";
}

double share_of_ring(const std::string& sharpness) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "plane-ring");
    apply_settings(*catalogue, scenario, {"method.type=auto", "monitor.sharpness=" + sharpness});
    gaspard::Run run(catalogue, scenario);
    run.solve();
    const auto snapshot = run.snapshot();
    return share_within_cell(*snapshot->mesh, snapshot->field("monitor")->values);
}

TEST(FeatureWidth, TellsARingThatCellsCarryFromOneThatTheyDoNot) {
    EXPECT_LT(share_of_ring("200"), 0.65);
    EXPECT_LT(share_of_ring("500"), 0.85);
    EXPECT_GT(share_of_ring("1570"), 0.9);
}

} // namespace
} // namespace gaspard
