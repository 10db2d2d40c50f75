#include "core/scenario/toml.hpp"
#include "gui/document/value_changes.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

class ValueChangesTest : public testing::Test {
  protected:
    Scenario with(const std::vector<std::string>& settings) const {
        Scenario scenario = ring;
        apply_settings(catalogue, scenario, settings);
        return scenario;
    }
    Catalogue catalogue = builtin_catalogue();
    Scenario ring = find_scenario(catalogue, "plane-ring");
};

TEST_F(ValueChangesTest, NameEveryValueThatDiffersAndNoOther) {
    EXPECT_TRUE(value_changes(ring, ring).empty());
    EXPECT_TRUE(value_changes(ring, with({"view.blend=0.5"})).empty()) << "a view changes no solution";
    const auto changes = value_changes(ring, with({"monitor.amplitude=20", "domain.cells=120"}));
    ASSERT_EQ(changes.size(), 2U);
    EXPECT_EQ(changes[0].label + " " + changes[0].before + " to " + changes[0].after,
              "cells per side 60 to 120");
    EXPECT_EQ(changes[1].key, "monitor.amplitude");
}

TEST_F(ValueChangesTest, OfAnotherTypeNameTheTypeOnly) {
    const auto changes = value_changes(ring, with({"monitor.type=bell"}));
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_EQ(changes[0].key + " " + changes[0].before + " " + changes[0].after, "monitor.type ring bell");
}

TEST_F(ValueChangesTest, MakeTheNameOfARun) {
    EXPECT_EQ(describe_scenario(catalogue, ring, ring), "Ring");
    EXPECT_EQ(describe_scenario(catalogue, ring, with({"monitor.amplitude=20", "method.step_size=1e-3"})),
              "Ring, Amplitude A = 20, Step size Δt = 0.001");
    EXPECT_EQ(describe_scenario(catalogue, ring, with({"monitor.type=bell"})), "Bell");
    EXPECT_EQ(describe_scenario(catalogue, ring, with({"method.type=newton"})), "Ring, Newton");
    EXPECT_EQ(describe_scenario(catalogue, ring, with({"domain.boundary=walls", "method.tolerance=5e-9"})),
              "Ring, Boundary: walls, Tolerance = 5×10⁻⁹");
    EXPECT_EQ(describe_scenario(catalogue, ring, with({"method.step_size=auto"})), "Ring, Step size: auto");
    const Scenario photo = with({"monitor.type=image", "monitor.file=/far/away/photo.jpg"});
    EXPECT_EQ(describe_scenario(catalogue, ring, photo), "Image photo.jpg");
    EXPECT_EQ(describe_scenario(catalogue, photo, photo), "Image");
    const Scenario other = with({"monitor.type=image", "monitor.file=gaspard:relief.png"});
    EXPECT_EQ(describe_scenario(catalogue, photo, other), "Image relief.png");
}

TEST(WhatDiffers, LeavesOutWhatStandsInAll) {
    using Texts = std::vector<std::string>;
    EXPECT_EQ(what_differs({}), Texts{});
    EXPECT_EQ(what_differs({"Ring, amplitude 20"}), (Texts{"Ring, amplitude 20"}));
    EXPECT_EQ(
        what_differs({"Ring, amplitude 20, radius 0.3", "Ring, radius 0.3", "Ring, amplitude 9, radius 0.3"}),
        (Texts{"amplitude 20", "Ring", "amplitude 9"}));
    EXPECT_EQ(what_differs({"Ring", "Bell"}), (Texts{"Ring", "Bell"}));
    EXPECT_EQ(what_differs({"Ring, amplitude 20", "Ring, amplitude 20"}), (Texts{"Ring", "Ring"}));
}

} // namespace
} // namespace gaspard
