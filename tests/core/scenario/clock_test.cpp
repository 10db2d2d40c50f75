// The clock: times, parameters as formulas in t, paths; how the section "time" is read and written.
#include "core/base/error.hpp"
#include "core/scenario/clock.hpp"
#include "core/scenario/time_rows.hpp"
#include "core/scenario/toml.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

class ClockTest : public testing::Test {
  protected:
    Scenario moving(std::vector<std::string> settings, const std::string& name = "plane-ring") {
        Scenario scenario = find_scenario(catalogue, name);
        settings.insert(settings.begin(), {"time.end=1", "time.step=0.25"});
        apply_settings(catalogue, scenario, settings);
        return scenario;
    }
    Clock clock(const std::vector<std::string>& settings, const std::string& name = "plane-ring") {
        return Clock(moving(settings, name));
    }
    std::string complaint(const std::vector<std::string>& settings, const std::string& name = "plane-ring") {
        try {
            clock(settings, name);
        } catch (const InputError& error) {
            return error.what();
        }
        return "none";
    }
    static double value(const Clock& clock, double t, const std::string& key) {
        return clock.at(t).monitor.values.real(key);
    }
    const Catalogue catalogue = builtin_catalogue();
};

TEST_F(ClockTest, StepsEndAtTheEnd) {
    const Clock even = clock({});
    EXPECT_EQ(even.steps(), 4);
    EXPECT_EQ(even.time(1), 0.25);
    EXPECT_EQ(even.time(4), 1.0);
    const Clock shorter_last = clock({"time.start=0.5", "time.step=0.2"});
    EXPECT_EQ(shorter_last.steps(), 3);
    EXPECT_EQ(shorter_last.time(2), 0.9);
    EXPECT_EQ(shorter_last.time(3), 1.0);
    EXPECT_EQ(shorter_last.nearest(0.72), 1);
    const Clock short_last = clock({"time.step=0.45"});
    EXPECT_EQ(short_last.nearest(1), 3) << "0, 0.45, 0.9, 1";
    EXPECT_EQ(short_last.nearest(0.96), 3);
    EXPECT_EQ(short_last.nearest(0.94), 2);
    EXPECT_EQ(format_number(clock({"time.step=0.1"}).time(3)), "0.3");
    EXPECT_EQ(shorter_last.nearest(-3), 0);
    EXPECT_EQ(shorter_last.nearest(7), 3);
    EXPECT_EQ(clock({"time.step=0.1"}).steps(), 10) << "rounding adds no step";
    EXPECT_EQ(make_clock(moving({"time.end=0"})), nullptr);
    EXPECT_NE(complaint({"time.step=1e-9"}).find("more than 10000000 steps"), std::string::npos);
}

TEST_F(ClockTest, ChecksAsManyTimesAsItIsToldTo) {
    const auto allowed = [&](const std::string& radius, int moments) {
        try {
            return Clock(moving({"time.monitor.radius=" + radius}), moments).steps() == 4;
        } catch (const InputError&) {
            return false;
        }
    };
    const std::string never = "-1", not_at_the_end = "0.4 - t/2", not_in_the_middle = "abs(t - 0.5) - 0.1";
    EXPECT_TRUE(allowed(never, 0));
    EXPECT_FALSE(allowed(never, 1));
    EXPECT_TRUE(allowed(not_at_the_end, 1)) << "at the first time";
    EXPECT_FALSE(allowed(not_at_the_end, 2)) << "and at the last";
    EXPECT_TRUE(allowed(not_in_the_middle, 2));
    EXPECT_FALSE(allowed(not_in_the_middle, 3));
    EXPECT_FALSE(allowed(not_in_the_middle, 100)) << "there are only five";
}

TEST_F(ClockTest, ParametersAreFormulasOfTheTime) {
    const Clock moves = clock({"time.monitor.amplitude=amplitude*(1 + t) + radius", "monitor.amplitude=3",
                               "time.monitor.center_x=center_x + 0.75*t"});
    EXPECT_DOUBLE_EQ(value(moves, 0.5, "amplitude"), 3 * 1.5 + 0.25);
    EXPECT_DOUBLE_EQ(value(moves, 0.5, "center_x"), 0.875);
    EXPECT_DOUBLE_EQ(value(moves, 1, "center_x"), 0.25) << "periodic";
    EXPECT_DOUBLE_EQ(value(moves, 1, "center_y"), 0.5) << "stays";
    EXPECT_EQ(complaint({"time.monitor.radius=0.25 - t"}),
              "time.monitor.radius is −0.25 at t = 0.5; monitor.radius must be 0 to 0.5");
    EXPECT_NE(complaint({"time.monitor.radius=speed*t"}).find("'speed' is not t"), std::string::npos);
    EXPECT_NE(complaint({"time.monitor.radius=x"}).find("must not depend on x"), std::string::npos);
    EXPECT_NE(complaint({"time.monitor.radius=0.1/(1 - 2*t)"}).find("not a finite number at t = 0.5"),
              std::string::npos);
    EXPECT_NE(complaint({"time.monitor.radius=0.1 +"}).find("time.monitor.radius: the formula ends"),
              std::string::npos);
}

TEST_F(ClockTest, AFormulaMayUseTheTimeItself) {
    const Clock moves =
        clock({"monitor.type=formula", "monitor.expression=1 + A*exp(-20*(x - 0.5 - t/10)^2)"});
    EXPECT_EQ(value(moves, 0.75, "t"), 0.75);
    const Scenario scenario = moving({"monitor.type=formula", "monitor.expression=2 + sin(t)"});
    EXPECT_FALSE(scenario.time.has("monitor.t")) << "the clock sets it";
}

TEST_F(ClockTest, APathGoesThroughItsPlacesAndRestsAtItsEnds) {
    const Clock moves = clock({"time.path=0.2 0.1 0.2; 0.5 0.4 0.9; 0.8 1.2 0.9"});
    EXPECT_DOUBLE_EQ(value(moves, 0, "center_x"), 0.1);
    EXPECT_DOUBLE_EQ(value(moves, 0.5, "center_x"), 0.4);
    EXPECT_DOUBLE_EQ(value(moves, 0.5, "center_y"), 0.9);
    EXPECT_NEAR(value(moves, 1, "center_x"), 0.2, 1e-12) << "across the border";
    const std::string both = complaint({"time.path=0 0.5 0.5; 1 0.6 0.6", "time.monitor.center_x=t"});
    EXPECT_NE(both.find("both move the monitor"), std::string::npos) << both;
    const Clock to_the_wall =
        clock({"domain.boundary=walls", "time.path=0 0.5 0.5; 0.2 0.9 0.5; 0.3 1 0.5; 0.4 1 0.5; 1 0.6 0.5"});
    for (int i = 0; i <= 100; ++i) EXPECT_LE(value(to_the_wall, i / 100.0, "center_x"), 1.0) << i;
    const double h = 1e-5; // the curve has a slope at its places
    const auto slope = [&](double t, double to) {
        return (value(moves, t + to, "center_x") - value(moves, t, "center_x")) / to;
    };
    EXPECT_NEAR(slope(0.5, h), slope(0.5, -h), 1e-3);
    EXPECT_EQ(parse_path(write_path(parse_path("0 1 2; 1 2.5 -3"))), parse_path("0 1 2;1 2.5 -3;"));
    for (const char* wrong : {"0 1 2", "0 1; 1 2", "0 1 2; 0 2 3", "a b c; 1 2 3"})
        EXPECT_EQ(complaint({std::string("time.path=") + wrong}).substr(0, 9), "time.path") << wrong;
    EXPECT_NE(complaint({"monitor.type=constant", "time.path=0 1 2; 1 2 3"}).find("has none"),
              std::string::npos);
    EXPECT_NE(complaint({"domain.boundary=walls", "monitor.type=formula", "monitor.ranges=x0 0 0.8",
                         "time.path=0 0.5 0.5; 1 0.9 0.5"})
                  .find("time.path leads to"),
              std::string::npos);
}

TEST_F(ClockTest, OnASphereThePathIsTheShortWay) {
    const Clock moves = clock({"monitor.type=bell", "time.path=0 10 170; 1 10 -170"}, "sphere-x4");
    EXPECT_NEAR(std::abs(value(moves, 0.5, "center_longitude")), 180, 1e-9) << "across the date line";
    EXPECT_GT(value(moves, 0.5, "center_latitude"), 10) << "a great circle, nearly";
    const Clock over_the_pole = clock({"monitor.type=bell", "time.path=0 80 0; 1 80 180"}, "sphere-x4");
    EXPECT_NEAR(value(over_the_pole, 0.5, "center_latitude"), 90, 1e-6);
}

TEST_F(ClockTest, PlacesFarApartOnASphereNeedOthersBetween) {
    const auto complaint_of_path = [&](const std::string& path) {
        return complaint({"monitor.type=bell", "time.path=" + path}, "sphere-x4");
    };
    EXPECT_NE(complaint_of_path("0 0 0; 1 0 180").find("far apart"), std::string::npos);
    EXPECT_NE(complaint_of_path("0 90 0; 1 -90 0").find("far apart"), std::string::npos);
    EXPECT_NE(complaint_of_path("0 300 0; 1 0 0").find("latitude 300"), std::string::npos);
    EXPECT_EQ(complaint_of_path("0 0 0; 1 0 90; 2 0 180"), "none");
}

TEST_F(ClockTest, StepsMustBeSeenBesideTheTimes) {
    EXPECT_NE(
        complaint({"time.start=999999999", "time.end=999999999.000001", "time.step=1e-9"}).find("too small"),
        std::string::npos);
    EXPECT_EQ(complaint({"time.start=1e6", "time.end=1000000.1", "time.step=0.01"}), "none");
}

TEST_F(ClockTest, AMonitorAsFormulaMovesOn) {
    const auto formula = with_formula(catalogue, moving({"time.monitor.center_x=center_x + 0.1*t"}));
    ASSERT_TRUE(formula);
    EXPECT_EQ(formula->time.text("monitor.center_x"), "center_x + 0.1*t");
    EXPECT_DOUBLE_EQ(value(*make_clock(*formula), 1, "center_x"), 0.6);
}

TEST_F(ClockTest, WhatAComputationBeginsWithDoesNotMove) {
    const Scenario flow = find_scenario(catalogue, "flow-live"),
                   front = find_scenario(catalogue, "burgers-1d");
    for (const char* key : {"strength", "froude", "radius", "t"})
        EXPECT_FALSE(flow.time.has("monitor." + std::string(key))) << key;
    EXPECT_TRUE(flow.time.has("monitor.contrast")) << "of the density, not of the flow";
    EXPECT_FALSE(front.time.has("monitor.nu"));
    EXPECT_FALSE(front.time.has("monitor.x0"));
    EXPECT_TRUE(front.time.has("monitor.alpha"));
}

TEST_F(ClockTest, TimeIsReadAndWritten) {
    const Scenario still = find_scenario(catalogue, "plane-ring");
    EXPECT_EQ(to_toml(still).find("[time]"), std::string::npos);
    const Scenario scenario = moving({"time.monitor.center_x=center_x + t", "time.rule=relaxation"});
    const std::string text = to_toml(scenario);
    EXPECT_NE(text.find("monitor.center_x = 'center_x + t'"), std::string::npos) << text;
    EXPECT_EQ(text.find("monitor.radius ="), std::string::npos) << "what stays is not written";
    const Scenario read = parse_scenario(catalogue, text, "a.toml");
    EXPECT_EQ(read.time, scenario.time);
    const Scenario table =
        parse_scenario(catalogue, "[time]\nend = 2.0\n[time.monitor]\nradius = \"0.1 + t/10\"\n", "b.toml");
    EXPECT_EQ(table.time.text("monitor.radius"), "0.1 + t/10");
    EXPECT_EQ(modified_keys(still, scenario),
              (std::vector<std::string>{"time.end", "time.step", "time.monitor.center_x", "time.rule"}));
    Scenario other = scenario;
    set_value(catalogue, other, "monitor.type", std::string("bell"));
    EXPECT_EQ(other.time.text("monitor.center_x"), "center_x + t") << "the bell has a centre, too";
    EXPECT_FALSE(other.time.has("monitor.radius"));
    EXPECT_EQ(modified_keys(scenario, other), std::vector<std::string>{"monitor.type"});
}

TEST_F(ClockTest, TheSpeedInTheWindowIsNoOtherTime) {
    const Scenario one = moving({"time.monitor.center_x=t"});
    EXPECT_TRUE(same_time(one.time, moving({"time.monitor.center_x=t", "time.speed=2"}).time));
    EXPECT_FALSE(same_time(one.time, moving({"time.monitor.center_x=2*t"}).time));
    EXPECT_FALSE(same_time(one.time, moving({"time.monitor.center_x=t", "time.end=3"}).time));
}

} // namespace
} // namespace gaspard
