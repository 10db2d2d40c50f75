// Ranges and values of monitors follow the patch of domain.file.
#include "core/base/error.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <thread>

namespace gaspard {
namespace {

std::shared_ptr<const Catalogue> catalogue() {
    static const auto all = std::make_shared<const Catalogue>(builtin_catalogue());
    return all;
}

/// A square patch with this side and corner, as the text of domain.file.
std::string square(double side, double x = 0, double y = 0, const std::string& z = "") {
    const auto point = [&](double a, double b) {
        return "[" + format_number(x + a * side) + "," + format_number(y + b * side) + z + "]";
    };
    return R"({"degrees":[1,1],"knots":[[0,0,1,1],[0,0,1,1]],"control_points":[)" + point(0, 0) + "," +
           point(1, 0) + "," + point(0, 1) + "," + point(1, 1) + "]}";
}

Scenario scenario(const std::string& name, const std::vector<std::string>& settings) {
    Scenario chosen = find_scenario(*catalogue(), name);
    apply_settings(*catalogue(), chosen, settings);
    return chosen;
}

const ParameterRow& row_of(const Values& values, const std::string& key) {
    return *std::find_if(values.rows().begin(), values.rows().end(),
                         [&](const auto& row) { return row.key == key; });
}

class PatchPlace : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Monitors, PatchPlace, testing::Values("ring", "bell", "circle"),
                         [](const auto& name) { return name.param; });

TEST_P(PatchPlace, TheMeshOfALargePatchIsTheScaledMeshOfTheSquare) {
    const auto solved = [&](const std::string& file) {
        gaspard::Run run(catalogue(),
                         scenario("spline-circle", {"domain.type=spline-patch", "domain.cells=16",
                                                    "monitor.type=" + GetParam(), "monitor.amplitude=4",
                                                    "method.type=newton", "domain.file=" + file}));
        run.solve();
        EXPECT_EQ(run.status(), RunStatus::converged);
        return run.snapshot()->x;
    };
    const Points small = solved(square(1)), large = solved(square(2048, 5e5, 4e6));
    const Points tiny = solved(square(1.0 / 1024, -3, 7));
    double moved = 0;
    for (std::size_t i = 0; i < small.size(); ++i) {
        EXPECT_LT(norm(large[i] - (2048 * small[i] + Vec3{5e5, 4e6, 0})), 2048 * 1e-7);
        EXPECT_LT(norm(tiny[i] - (1.0 / 1024 * small[i] + Vec3{-3, 7, 0})), 1.0 / 1024 * 1e-7);
        moved = std::max(moved, norm(small[i] - Vec3{static_cast<double>(i % 33) / 32,
                                                     static_cast<double>(i / 33) / 32, 0}));
    }
    EXPECT_GT(moved, 0.02) << "the monitor acts";
}

TEST(PatchPlaces, CanBeReachedByCentres) {
    const std::vector<std::string> settings = {"monitor.center_x=1500", "domain.file=" + square(2090),
                                               "monitor.radius=400", "domain.type=spline-patch"};
    const Scenario chosen = scenario("spline-circle", settings);
    EXPECT_EQ(chosen.monitor.values.real("center_x"), 1500);
    EXPECT_EQ(chosen.monitor.values.real("radius"), 400);
    EXPECT_EQ(chosen.monitor.values.real("center_y"), 1045) << "the middle by default";
    EXPECT_THROW(scenario("spline-circle", {"domain.type=spline-patch", "domain.file=" + square(2090),
                                            "monitor.center_x=1e6"}),
                 InputError);
    const Scenario again = parse_scenario(*catalogue(), to_toml(chosen), "spline-circle.toml");
    EXPECT_EQ(again, chosen);
    EXPECT_EQ(row_of(again.monitor.values, "center_x").maximum,
              row_of(chosen.monitor.values, "center_x").maximum);
}

TEST(PatchPlaces, MoveAndScaleWhatTheUserHasSet) {
    Scenario chosen = scenario("spline-circle", {"monitor.radius=0.2", "monitor.center_x=0.75",
                                                 "monitor.amplitude=7", "monitor.sharpness=80"});
    set_value(*catalogue(), chosen, "domain.type", std::string("spline-patch"));
    EXPECT_EQ(chosen.monitor.values.real("radius"), 0.2) << "the unit disk is a built-in patch";
    set_value(*catalogue(), chosen, "domain.file", square(2000, 100, 0));
    EXPECT_EQ(chosen.monitor.values.real("radius"), 400);
    EXPECT_EQ(chosen.monitor.values.real("center_x"), 1600);
    EXPECT_EQ(chosen.monitor.values.real("amplitude"), 7);
    EXPECT_DOUBLE_EQ(chosen.monitor.values.real("sharpness"), 80 / 4e6);
    set_value(*catalogue(), chosen, "domain.file", square(50));
    EXPECT_EQ(chosen.monitor.values.real("radius"), 10);
    set_value(*catalogue(), chosen, "domain.type", std::string("spline-square"));
    EXPECT_EQ(chosen.monitor.values.real("radius"), 0.2);
    EXPECT_EQ(chosen.monitor.values.real("center_x"), 0.75);
    EXPECT_DOUBLE_EQ(chosen.monitor.values.real("sharpness"), 80);
}

TEST(PatchPlaces, AreReadOnceForAFile) {
    Scenario chosen = scenario("spline-circle", {"domain.type=spline-patch", "domain.file=" + square(2090)});
    const auto before = chosen.place.content;
    ASSERT_TRUE(before);
    set_value(*catalogue(), chosen, "monitor.amplitude", 6.0);
    set_value(*catalogue(), chosen, "domain.cells", std::int64_t{16});
    set_value(*catalogue(), chosen, "domain.control_points", std::string("0 0, 2090 0, 0 2090, 2100 2090"));
    EXPECT_EQ(chosen.place.content, before);
    EXPECT_EQ(gaspard::Run(catalogue(), chosen).scenario().place.content, before);
    set_value(*catalogue(), chosen, "domain.file", square(10));
    EXPECT_NE(chosen.place.content, before);
    EXPECT_EQ(chosen.place.space.middle, (Vec3{5, 5, 0}));
}

TEST(PatchPlaces, OfAPipeAreReadOnce) {
    const TemporaryFolder folder;
    const std::string pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const std::jthread writer([&] { std::ofstream(pipe) << square(4); });
    const Scenario chosen = scenario("spline-circle", {"domain.type=spline-patch", "domain.file=" + pipe});
    const gaspard::Run run(catalogue(), chosen);
    EXPECT_EQ(run.space().middle, (Vec3{2, 2, 0}));
}

// The window's thread may update rows, but not read.
TEST(PatchPlaces, AreNotReadWhenRowsAreUpdated) {
    const TemporaryFolder folder;
    const std::string pipe = folder / "pipe"; // nobody writes to it: reading would not end
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    Scenario chosen = scenario(
        "spline-circle", {"domain.type=spline-patch", "domain.file=" + square(50), "monitor.center_x=40"});
    chosen.domain.values.set("file", pipe);
    update_rows(*catalogue(), chosen);
    EXPECT_FALSE(is_located(*catalogue(), chosen));
    EXPECT_EQ(chosen.monitor.values.real("center_x"), 40) << "as before until the file is read";
    EXPECT_EQ(space_of(*catalogue(), chosen).middle, (Vec3{25, 25, 0}));
}

TEST(PatchPlaces, OfAMissingFileAreAnything) {
    Scenario chosen = scenario("spline-circle", {"domain.type=spline-patch", "domain.file=missing.json",
                                                 "monitor.center_x=1500", "monitor.sharpness=1e-5"});
    EXPECT_EQ(chosen.monitor.values.real("center_x"), 1500);
    EXPECT_NE(message_of<InputError>([&] { gaspard::Run run(catalogue(), chosen); }).find("missing.json"),
              std::string::npos);
}

TEST(PatchPlaces, LeaveMonitorsWhereTheyAreWhileControlPointsMove) {
    Scenario chosen = scenario("spline-circle", {"domain.type=spline-patch", "domain.file=" + square(20)});
    const Section before = chosen.monitor;
    set_value(*catalogue(), chosen, "domain.control_points", std::string("0 0, 20 0, 0 20, 23 21"));
    EXPECT_EQ(chosen.monitor, before);
    set_value(*catalogue(), chosen, "domain.control_points", std::string("0 0, 900 0, 0 900, 900 900"));
    EXPECT_EQ(chosen.monitor, before);
    EXPECT_GE(row_of(chosen.monitor.values, "center_x").maximum, 900);
}

TEST(PatchPlaces, OfBuiltInPatchesExtendRangesAndKeepValues) {
    for (const char* domain :
         {"spline-square", "spline-disk", "spline-annulus", "spline-torus", "spline-moebius"}) {
        const Scenario chosen =
            scenario("spline-circle", {std::string("domain.type=") + domain, "monitor.type=ring"});
        const Values& ring = chosen.monitor.values;
        EXPECT_EQ(ring.real("center_x"), 0.5);
        EXPECT_EQ(ring.real("radius"), 0.25);
        EXPECT_EQ(ring.real("sharpness"), 200);
        EXPECT_LE(row_of(ring, "center_x").minimum, 0);
        EXPECT_GE(row_of(ring, "center_x").maximum, 1);
    }
    const Scenario disk = scenario("spline-circle", {"domain.type=spline-disk", "monitor.type=ring",
                                                     "monitor.center_x=-0.6", "monitor.radius=0.7"});
    EXPECT_NO_THROW(gaspard::Run(catalogue(), disk)) << "the left half is within reach";
}

} // namespace
} // namespace gaspard
