#include "core/base/error.hpp"
#include "core/base/parameter.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

Values sample() {
    return Values("monitor", {{.key = "amplitude", .minimum = 0, .maximum = 100, .default_value = 10.0},
                              {.key = "cells",
                               .kind = ParameterKind::integer,
                               .minimum = 4,
                               .maximum = 480,
                               .default_value = std::int64_t{60}},
                              {.key = "boundary",
                               .kind = ParameterKind::choice,
                               .default_value = std::string("periodic"),
                               .choices = {"periodic", "walls"}},
                              {.key = "on", .kind = ParameterKind::boolean, .default_value = true}});
}

std::string refusal_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Values, StartWithTheDefaultsOfTheirRows) {
    const Values values = sample();
    EXPECT_EQ(values.real("amplitude"), 10.0);
    EXPECT_EQ(values.integer("cells"), 60);
    EXPECT_EQ(values.text("boundary"), "periodic");
    EXPECT_TRUE(values.boolean("on"));
}

TEST(Values, ParseEveryKindFromText) {
    Values values = sample();
    values.parse("amplitude", "2.5e1");
    values.parse("cells", "4");
    values.parse("boundary", "walls");
    values.parse("on", "false");
    EXPECT_EQ(values.real("amplitude"), 25.0);
    EXPECT_EQ(values.integer("cells"), 4);
    EXPECT_EQ(values.text("boundary"), "walls");
    EXPECT_FALSE(values.boolean("on"));
}

TEST(Values, TakeFormerChoicesAndGiveThePresentOnes) {
    Values values("view", {{.key = "layout",
                            .kind = ParameterKind::choice,
                            .default_value = std::string("single"),
                            .choices = {"single", "projection"},
                            .former_choices = {{"map", "projection"}}}});
    values.set("layout", std::string("map"));
    EXPECT_EQ(values.text("layout"), "projection");
    values.set("layout", std::string("single"));
    values.parse("layout", "map");
    EXPECT_EQ(values.text("layout"), "projection");
}

TEST(ParameterRows, AreFoundByTheirPresentKeyBeforeAFormerOne) {
    const std::vector<ParameterRow> rows = {
        {.key = "color_map", .former_key = "map"}, {.key = "low"}, {.key = "high", .former_key = "low"}};
    EXPECT_EQ(present_key(rows, "color_map"), "color_map");
    EXPECT_EQ(present_key(rows, "map"), "color_map");
    EXPECT_EQ(present_key(rows, "low"), "low");
    EXPECT_EQ(present_key(rows, "maps"), "");
    EXPECT_EQ(present_key(rows, ""), "") << "most rows have no former key";
}

TEST(Values, TakeANumberOrAuto) {
    Values values("method", {{.key = "step_size",
                              .kind = ParameterKind::real_or_auto,
                              .minimum = 0.01,
                              .maximum = 10,
                              .default_value = std::string("auto")}});
    EXPECT_FALSE(values.real_or_auto("step_size").has_value());
    values.parse("step_size", "0.25");
    EXPECT_EQ(values.real_or_auto("step_size"), 0.25);
    EXPECT_EQ(values.real("step_size"), 0.25);
    values.set("step_size", std::int64_t{2});
    EXPECT_EQ(values.real_or_auto("step_size"), 2.0);
    values.parse("step_size", "auto");
    EXPECT_FALSE(values.real_or_auto("step_size").has_value());
    EXPECT_EQ(format_value(values.at("step_size")), "auto");
    EXPECT_EQ(describe_range(values.rows()[0]), "0.01 to 10, or auto");
    for (const char* text : {"automatic", "Auto", "", "true"})
        EXPECT_NE(refusal_of([&] { values.parse("step_size", text); }).find("a number or \"auto\""),
                  std::string::npos)
            << text;
    EXPECT_NE(refusal_of([&] { values.parse("step_size", "20"); }).find("or auto"), std::string::npos);
    EXPECT_FALSE(values.real_or_auto("step_size").has_value()) << "the old value is kept";
}

TEST(Values, RejectInvalidValuesAndKeepTheOldOnes) {
    Values values = sample();
    EXPECT_NE(refusal_of([&] { values.parse("cells", "0"); }).find("4 to 480"), std::string::npos);
    EXPECT_NE(refusal_of([&] { values.parse("cells", "1000000000"); }).find("4 to 480"), std::string::npos);
    EXPECT_NE(refusal_of([&] { values.parse("amplitude", "nan"); }).find("finite"), std::string::npos);
    EXPECT_NE(refusal_of([&] { values.set("amplitude", INFINITY); }).find("finite"), std::string::npos);
    EXPECT_NE(refusal_of([&] { values.parse("cells", "4.5"); }).find("an integer"), std::string::npos);
    EXPECT_NE(refusal_of([&] { values.parse("on", "yes"); }).find("true or false"), std::string::npos);
    EXPECT_EQ(values, sample());
}

TEST(Values, NameTheNearestKeyAndChoice) {
    Values values = sample();
    EXPECT_NE(refusal_of([&] { values.parse("amplitud", "1"); }).find("'monitor.amplitude'"),
              std::string::npos);
    EXPECT_NE(refusal_of([&] { values.parse("boundary", "wals"); }).find("'walls'"), std::string::npos);
}

TEST(Values, RangesOfIntegersArePrintedAsIntegers) {
    EXPECT_EQ(describe_range({.kind = ParameterKind::integer, .minimum = 0, .maximum = 1e6}), "0 to 1000000");
    EXPECT_EQ(describe_range({.minimum = 0.5, .maximum = 1e-4}), "0.5 to 10⁻⁴");
}

TEST(Values, NumbersReadBackToTheSameDouble) {
    for (const double value : {0.1, 1.0 / 3, 1e-300, 123456789.123456789, -0.0})
        EXPECT_EQ(std::stod(format_number(value)), value);
}

TEST(Nearest, IsEmptyWhenNothingIsClose) {
    EXPECT_EQ(nearest("plane-rng", {"plane-ring", "plane-bell"}), "plane-ring");
    EXPECT_EQ(nearest("xyzzy", {"plane-ring", "plane-bell"}), "");
}

} // namespace
} // namespace gaspard
