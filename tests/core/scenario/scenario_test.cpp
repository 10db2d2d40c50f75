#include "core/base/error.hpp"
#include "core/scenario/data_files.hpp"
#include "core/scenario/toml.hpp"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

class ScenarioTest : public testing::Test {
  protected:
    std::string message_of(const std::function<void()>& action) {
        try {
            action();
        } catch (const InputError& error) {
            return error.what();
        }
        return "no error";
    }
    std::string parse_message(const std::string& text) {
        return message_of([&] { parse_scenario(catalogue, text, "test.toml"); });
    }
    void expect_in(const std::string& part, const std::string& whole) {
        EXPECT_NE(whole.find(part), std::string::npos) << "'" << part << "' is not in: " << whole;
    }
    const Catalogue catalogue = builtin_catalogue();
};

TEST_F(ScenarioTest, EveryBuiltinScenarioPassesAndPinsMethodAndStep) {
    const auto builtins = builtin_scenarios();
    ASSERT_EQ(builtins.size(), 55u);
    for (const auto& builtin : builtins) {
        const Scenario scenario = find_scenario(catalogue, std::string(builtin.name));
        EXPECT_EQ(scenario.name, builtin.name);
        EXPECT_FALSE(scenario.title.empty());
        EXPECT_FALSE(scenario.description.empty());
        EXPECT_NO_THROW(check(catalogue, scenario));
        EXPECT_NE(std::string(builtin.toml).find("[method]\ntype"), std::string::npos);
        if (scenario.method.values.has("step_size")) {
            EXPECT_NE(std::string(builtin.toml).find("step_size"), std::string::npos);
        }
    }
    EXPECT_EQ(find_scenario(catalogue, "plane-bell").method.values.real("step_size"), 0.04);
    EXPECT_EQ(find_scenario(catalogue, "walls-ring").domain.values.text("boundary"), "walls");
}

TEST_F(ScenarioTest, NamesAreSortedAndNumbersInThemBySize) {
    std::vector<std::string> names;
    for (const auto& builtin : builtin_scenarios()) names.emplace_back(builtin.name);
    const auto place = [&](const char* name) { return std::find(names.begin(), names.end(), name); };
    EXPECT_LT(place("plane-bell"), place("plane-ring"));
    EXPECT_LT(place("plane-ring"), place("sphere-cross"));
    EXPECT_LT(place("sphere-cross"), place("sphere-x2"));
    EXPECT_LT(place("sphere-x2"), place("sphere-x4"));
    EXPECT_LT(place("sphere-x4"), place("sphere-x8"));
    EXPECT_LT(place("sphere-x8"), place("sphere-x16"));
    EXPECT_LT(place("sphere-x16"), place("walls-ring"));
}

TEST_F(ScenarioTest, TomlReadsBackToTheSameScenario) {
    Scenario scenario = find_scenario(catalogue, "plane-bell");
    apply_settings(catalogue, scenario,
                   {"monitor.amplitude=0.1", "monitor.center_x=0.3333333333333333", "domain.cells=17",
                    "view.blend=1", "method.tolerance=1e-10", "output.formats=obj"});
    scenario.title = "a \"quoted\" title\nwith \\ and é";
    const Scenario again = parse_scenario(catalogue, to_toml(scenario), "plane-bell.toml");
    EXPECT_EQ(again, scenario);
}

TEST_F(ScenarioTest, AMonitorsRowsFollowTheDomain) {
    Scenario scenario = find_scenario(catalogue, "plane-ring");
    apply_settings(catalogue, scenario,
                   {"monitor.amplitude=7", "monitor.radius=0.3", "monitor.center_x=0.2"});
    Scenario other = scenario;
    apply_settings(catalogue, other,
                   {"monitor.center_latitude=-10", "domain.type=cubed-sphere", "domain.cells=8"});
    EXPECT_EQ(other.monitor.type, "ring");
    EXPECT_EQ(other.monitor.values.real("amplitude"), 7); // chosen, so it stays
    EXPECT_EQ(other.monitor.values.real("radius"), 0.3);
    EXPECT_EQ(other.monitor.values.real("sharpness"), 10); // the default there
    EXPECT_EQ(other.monitor.values.real("center_latitude"), -10);
    EXPECT_FALSE(other.monitor.values.has("center_x"));
    EXPECT_NO_THROW(check(catalogue, other));
    set_value(catalogue, other, "monitor.radius", 2.0); // more than the plane allows
    set_value(catalogue, other, "domain.type", std::string("plane"));
    EXPECT_EQ(other.monitor.values.real("radius"), 0.25);
    EXPECT_EQ(other.monitor.values.real("amplitude"), 7);
    EXPECT_NO_THROW(check(catalogue, other));
    set_value(catalogue, other, "domain.type", std::string("icosahedral-sphere"));
    set_value(catalogue, other, "monitor.type", std::string("bell"));
    EXPECT_TRUE(other.monitor.values.has("center_longitude"));
    const Scenario before = other; // between two spheres nothing changes
    set_value(catalogue, other, "domain.type", std::string("cubed-sphere"));
    EXPECT_EQ(other.monitor, before.monitor);
}

TEST_F(ScenarioTest, AKeyOfAnotherDomainIsRefusedWithASentence) {
    Scenario sphere = find_scenario(catalogue, "sphere-x2"), plane = find_scenario(catalogue, "plane-ring");
    apply_settings(catalogue, sphere, {"monitor.type=ring"});
    const auto complaint = [&](Scenario& scenario, const std::string& setting) {
        return message_of([&] { apply_settings(catalogue, scenario, {setting}); });
    };
    expect_in(
        "monitor.center_x is not a key for domain 'cubed-sphere'; available: amplitude, sharpness, radius, "
        "center_latitude, center_longitude",
        complaint(sphere, "monitor.center_x=0.5"));
    expect_in("monitor.center_latitude is not a key for domain 'plane'",
              complaint(plane, "monitor.center_latitude=3"));
    expect_in("domain.refinements is not a key for domain 'plane', but for 'icosahedral-sphere'",
              complaint(plane, "domain.refinements=3"));
    expect_in("unknown key monitor.centre_x (did you mean 'monitor.center_x'?)",
              complaint(plane, "monitor.centre_x=3"));
}

TEST_F(ScenarioTest, XnAndCrossAreForSpheresOnly) {
    for (const std::string monitor : {"x-n", "cross"}) {
        Scenario scenario = find_scenario(catalogue, "plane-ring");
        apply_settings(catalogue, scenario, {"monitor.type=" + monitor});
        expect_in("cannot be combined", message_of([&] { check(catalogue, scenario); }));
        for (const std::string domain : {"cubed-sphere", "icosahedral-sphere"}) {
            apply_settings(catalogue, scenario, {"domain.type=" + domain});
            EXPECT_NO_THROW(check(catalogue, scenario));
        }
    }
}

TEST_F(ScenarioTest, SettingsDoNotDependOnTheirOrder) {
    Scenario first = find_scenario(catalogue, "plane-ring"), second = first;
    apply_settings(catalogue, first, {"monitor.type=bell", "monitor.amplitude=7"});
    apply_settings(catalogue, second, {"monitor.amplitude=7", "monitor.type=bell"});
    EXPECT_EQ(first, second);
    EXPECT_EQ(first.monitor.values.real("amplitude"), 7);
    EXPECT_EQ(first.monitor.values.real("sharpness"), 100) << "a new type brings its own defaults";
}

TEST_F(ScenarioTest, ErrorsNameFileLineAndNearestKey) {
    expect_in("test.toml:3: unknown key monitor.amplitud (did you mean 'monitor.amplitude'?)",
              parse_message("[monitor]\ntype = \"ring\"\namplitud = 3\n"));
    expect_in("test.toml:2: domain.cells = 0 is out of range: 4 to 480",
              parse_message("[domain]\ncells = 0\n"));
    expect_in("test.toml:2: domain.cells must be an integer", parse_message("[domain]\ncells = \"many\"\n"));
    expect_in("test.toml:2: monitor.amplitude must be a finite number",
              parse_message("[monitor]\namplitude = nan\n"));
    expect_in("test.toml:2: TOML syntax error: ", parse_message("[monitor]\namplitude = = 3\n"));
    expect_in("test.toml:1: unknown section or key 'monitr' (did you mean 'monitor'?)",
              parse_message("[monitr]\n"));
    expect_in("test.toml:2: unknown monitor.type 'rong' (did you mean 'ring'?)",
              parse_message("[monitor]\ntype = 'rong'\n"));
    expect_in("must be a single value", parse_message("[monitor]\namplitude = [1, 2]\n"));
    expect_in("test.toml:1: monitor is a section", parse_message("monitor = 3\n"));
}

TEST_F(ScenarioTest, FormerNamesAreReadAndPresentOnesWritten) {
    const auto expect_present = [this](const Scenario& scenario) {
        EXPECT_EQ(scenario.view.text("color_map"), "grey");
        EXPECT_EQ(scenario.view.real("projection_longitude"), 90);
        EXPECT_EQ(scenario.view.text("projection_camera"), "centre 1 0.5 height 2");
        EXPECT_EQ(scenario.view.text("layout"), "projection");
        const std::string written = to_toml(scenario);
        for (const char* line :
             {"\ncolor_map = 'grey'\n", "\nprojection_longitude = 90.0\n",
              "\nprojection_camera = 'centre 1 0.5 height 2'\n", "\nlayout = 'projection'\n"})
            expect_in(line, written);
        for (const char* former : {"\nmap", "'map'"})
            EXPECT_EQ(written.find(former), std::string::npos) << former;
    };
    expect_present(parse_scenario(catalogue,
                                  "[view]\nmap = 'grey'\nmap_longitude = 90\n"
                                  "map_camera = 'centre 1 0.5 height 2'\nlayout = 'map'\n",
                                  "test.toml"));
    Scenario scenario = default_scenario(catalogue);
    apply_settings(catalogue, scenario,
                   {"view.map=grey", "view.map_longitude=90", "view.map_camera=centre 1 0.5 height 2",
                    "view.layout=map"});
    expect_present(scenario);
    expect_in("test.toml:2: view.color_map = 'gray' is unknown (did you mean 'grey'?)",
              parse_message("[view]\nmap = 'gray'\n"));
    expect_in(
        "allowed: single, computational, side-by-side, field-and-mesh, front-and-rear, projection, runs",
        parse_message("[view]\nlayout = 'maps'\n"));
}

TEST_F(ScenarioTest, ReservedNamesAreErrorsOfTheirOwn) {
    for (const std::string text :
         {"[pde]\nepsilon = 1\n", "[domain.target]\ntype = 'disk'\n", "[monitor.source]\ntype = 'ring'\n"})
        expect_in("is reserved", parse_message(text));
    Scenario scenario = default_scenario(catalogue);
    expect_in("is reserved", message_of([&] { apply_settings(catalogue, scenario, {"pde.epsilon=1"}); }));
    expect_in("is reserved",
              message_of([&] { apply_settings(catalogue, scenario, {"domain.target.type=disk"}); }));
}

TEST_F(ScenarioTest, FlowsNeedThePeriodicPlane) {
    Scenario scenario = find_scenario(catalogue, "flow-live");
    EXPECT_NO_THROW(check(catalogue, scenario));
    apply_settings(catalogue, scenario, {"domain.boundary=walls"});
    const std::string message = message_of([&] { check(catalogue, scenario); });
    expect_in(
        "monitor 'flow' and method 'newton' cannot be combined on domain 'plane' with boundary 'walls'; "
        "possible: monitors ring",
        message);
    EXPECT_EQ(message.find("flow with"), std::string::npos) << message;
}

TEST_F(ScenarioTest, SettingsAreChecked) {
    Scenario scenario = default_scenario(catalogue);
    const Scenario before = scenario;
    expect_in("key=value", message_of([&] { apply_settings(catalogue, scenario, {"monitor.amplitude"}); }));
    expect_in("'domain.cells'", message_of([&] { apply_settings(catalogue, scenario, {"domain.cell=9"}); }));
    expect_in("out of range",
              message_of([&] { apply_settings(catalogue, scenario, {"monitor.amplitude=-3"}); }));
    EXPECT_EQ(scenario, before);
}

TEST_F(ScenarioTest, WhatDoesNotGoTogetherIsRefusedWithWhatDoes) {
    Catalogue smaller = catalogue;
    smaller.capabilities.front().monitors = {"constant"};
    expect_in("possible: monitors constant with methods relaxation",
              message_of([&] { check(smaller, default_scenario(smaller)); }));
    EXPECT_EQ(find_capability(smaller, default_scenario(smaller)), nullptr);
    EXPECT_NE(find_capability(catalogue, default_scenario(catalogue)), nullptr);
}

TEST_F(ScenarioTest, UnknownScenariosAndFilesAreNamed) {
    expect_in("'plane-ring'", message_of([&] { find_scenario(catalogue, "plane-rng"); }));
    expect_in("cannot read", message_of([&] { find_scenario(catalogue, "/nowhere/x.toml"); }));
    expect_in("cannot read", message_of([&] { load_scenario(catalogue, "/tmp"); }));
}

TEST_F(ScenarioTest, PathsAreMadeAbsolute) {
    Scenario scenario =
        parse_scenario(catalogue, "[domain]\ntype = 'spline-patch'\nfile = 'p.json'\n", "a.toml");
    const auto file_of = [](const Scenario& one) { return one.domain.values.text("file"); };
    EXPECT_EQ(file_of(with_absolute_paths(scenario)), (std::filesystem::current_path() / "p.json").string());
    scenario.folder = "/there";
    EXPECT_EQ(file_of(with_absolute_paths(scenario)), "/there/p.json");
    apply_settings(catalogue, scenario, {"domain.file=q.json"});
    EXPECT_EQ(file_of(scenario), (std::filesystem::current_path() / "q.json").string())
        << "a setting is relative to the working directory";
    for (const char* text : {"", "{\"degrees\": []}", "/absolute.json"}) {
        set_value(catalogue, scenario, "domain.file", std::string(text));
        EXPECT_EQ(file_of(with_absolute_paths(scenario)), text);
    }
}

TEST_F(ScenarioTest, APlaceIsNamedForTheKeysOfAFile) {
    ScenarioSource source;
    parse_scenario(catalogue, "[view]\n\ncamera = 'from afar'\n", "a.toml", &source);
    EXPECT_EQ(with_place(source, "view.camera: no"), "a.toml:3: view.camera: no");
    EXPECT_EQ(with_place(source, "view.camera_height: no"), "view.camera_height: no");
    EXPECT_EQ(with_place(source, "view.layout: no"), "view.layout: no");
}

TEST_F(ScenarioTest, APatchMayBeAnInteger) {
    const Scenario scenario =
        parse_scenario(catalogue, "[domain]\ntype = 'spline-patch'\npatch = 3\n", "a.toml");
    EXPECT_EQ(scenario.domain.values.text("patch"), "3");
    expect_in("must be a string", parse_message("[view]\ncamera = 3\n"));
}

TEST_F(ScenarioTest, EveryRowIsFitForASliderAndATooltip) {
    const auto examine = [&](const Values& values) {
        std::vector<std::string> keys;
        for (const auto& row : values.rows()) {
            const std::string name = values.section() + "." + row.key;
            EXPECT_FALSE(row.label.empty()) << name;
            EXPECT_FALSE(row.help.empty()) << name;
            if (row.kind == ParameterKind::real || row.kind == ParameterKind::integer) {
                EXPECT_TRUE(std::isfinite(row.minimum) && std::isfinite(row.maximum)) << name;
                EXPECT_LT(row.minimum, row.maximum) << name;
            }
            keys.push_back(row.key);
        }
        std::sort(keys.begin(), keys.end());
        EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end()) << values.section();
    };
    for (const auto& type : catalogue.domains) examine(domain_section(catalogue, type.name).values);
    for (const auto& type : catalogue.monitors) examine(monitor_section(catalogue, type.name).values);
    for (const auto& type : catalogue.methods) examine(method_section(catalogue, type.name).values);
    examine(default_scenario(catalogue).view);
    examine(default_scenario(catalogue).output);
}

TEST_F(ScenarioTest, NumbersThatNoDoubleHoldsAreNamedAsTheyAreTyped) {
    const auto set = [&](const std::string& setting) {
        Scenario scenario = default_scenario(catalogue);
        apply_settings(catalogue, scenario, {setting});
        return scenario;
    };
    for (const char* number : {"1e400", "-1e400", "99999999999999999999e300"})
        expect_in(std::string("monitor.amplitude = ") + number + " is out of range",
                  message_of([&] { set(std::string("monitor.amplitude=") + number); }));
    expect_in("domain.cells = 99999999999999999999 is out of range",
              message_of([&] { set("domain.cells=99999999999999999999"); }));
    for (const char* number : {"1e-400", "-1e-400", "0."})
        EXPECT_EQ(set(std::string("monitor.amplitude=") + number).monitor.values.real("amplitude"), 0);
    expect_in("'1e400' could not be interpreted", parse_message("[monitor]\namplitude = 1e400\n"));
}

TEST(ScenarioText, RefusesTextThatIsNotUtf8) {
    const Catalogue catalogue = builtin_catalogue();
    Scenario scenario = default_scenario(catalogue);
    scenario.output.set("formats", std::string("\x8a,svg"));
    EXPECT_THROW(to_toml(scenario), InputError);
    scenario.output.set("formats", std::string("\u00e4,svg"));
    EXPECT_NE(to_toml(scenario).find("\u00e4"), std::string::npos);
}

} // namespace
} // namespace gaspard
