#include "core/scenario/catalogue.hpp"
#include "core/scenario/toml.hpp"
#include "gui/document/values_in_time.hpp"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace gaspard {
namespace {

TEST(ValuesInTime, AreThoseOfTheClock) {
    const Catalogue catalogue = builtin_catalogue();
    Scenario scenario = find_scenario(catalogue, "plane-ring");
    const auto set = [&](const std::vector<std::string>& settings) {
        apply_settings(catalogue, scenario, settings);
    };
    ValuesInTime values;
    EXPECT_EQ(values.at(scenario, 0.5), nullptr) << "it has no time";
    set({"time.end=2", "time.monitor.center_x=center_x + t/10"});
    EXPECT_EQ(values.at(scenario, {}), nullptr);
    const Values* now = values.at(scenario, 1.0);
    ASSERT_NE(now, nullptr);
    EXPECT_NEAR(now->real("center_x"), scenario.monitor.values.real("center_x") + 0.1, 1e-12);
    EXPECT_EQ(now->real("radius"), scenario.monitor.values.real("radius"));
    EXPECT_NEAR(values.at(scenario, 2.0)->real("center_x"), scenario.monitor.values.real("center_x") + 0.2,
                1e-12);
    set({"monitor.radius=0.3"});
    EXPECT_EQ(values.at(scenario, 2.0)->real("radius"), 0.3);
    set({"time.monitor.center_x=center_x + t/5"});
    EXPECT_NEAR(values.at(scenario, 1.0)->real("center_x"), scenario.monitor.values.real("center_x") + 0.2,
                1e-12);
    set({"time.monitor.center_x=center_x", "time.monitor.radius=0.5 - 0.2*t"});
    ASSERT_NE(values.at(scenario, 1.0), nullptr);
    EXPECT_NEAR(values.at(scenario, 1.0)->real("radius"), 0.3, 1e-12);
    set({"time.monitor.radius=0.5 - 0.4*t"});
    EXPECT_EQ(values.at(scenario, 2.0), nullptr) << "it is negative there";
    ASSERT_NE(values.at(scenario, 1.0), nullptr) << "it is at this time";
    EXPECT_NEAR(values.at(scenario, 1.0)->real("radius"), 0.1, 1e-12);
    set({"time.monitor.center_x=center_x +"});
    EXPECT_EQ(values.at(scenario, 1.0), nullptr) << "a wrong formula moves nothing";
}

} // namespace
} // namespace gaspard
