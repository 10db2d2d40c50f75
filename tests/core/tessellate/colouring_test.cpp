#include "core/diagnostics/quality.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/tessellate/colouring.hpp"
#include "fixtures/fixture_meshes.hpp"
#include "support/small_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

namespace gaspard {
namespace {

/// A snapshot of a mesh whose nodes have moved a little, with a monitor.
Snapshot snapshot_of(Mesh mesh, double amount = 0.04) {
    Snapshot snapshot;
    snapshot.x = mesh.nodes;
    for (std::size_t i = 0; i < snapshot.x.size(); ++i) {
        const Vec3 p = mesh.nodes[i];
        snapshot.x.x[i] += amount * std::sin(3 * p.x + p.y);
        if (mesh.space_dimension > 1) snapshot.x.y[i] += amount * std::cos(2 * p.y - p.x);
        if (mesh.space_dimension > 2) snapshot.x.z[i] += amount * std::sin(p.x + p.z);
    }
    Field monitor{{.name = "monitor"}, {}};
    for (std::size_t i = 0; i < snapshot.x.size(); ++i) monitor.values.push_back(1 + norm(snapshot.x[i]));
    snapshot.fields.push_back(std::move(monitor));
    snapshot.mesh = std::make_shared<const Mesh>(std::move(mesh));
    snapshot.version = 1;
    return snapshot;
}

void add_field(Snapshot& snapshot, const char* name, std::vector<double> values) {
    snapshot.fields.push_back({{.name = name, .place = FieldPlace::cell}, std::move(values)});
}

Colouring made(const Snapshot& snapshot, const ColourChoice& choice) {
    const auto colouring = make_colouring(snapshot, choice);
    EXPECT_TRUE(colouring) << choice.colouring;
    return colouring.value_or(Colouring{});
}

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(Colouring, EveryChoiceOfTheViewIsKnown) {
    Snapshot snapshot = snapshot_of(unit_square_mesh(4));
    for (const char* name :
         {"mass", "interpolation_error", "interpolation_error_uniform", "interpolation_ratio"})
        add_field(snapshot, name, std::vector<double>(16, 2.0));
    for (const char* name : {"mesh_speed", "mesh_velocity_x", "mesh_velocity_y", "mesh_velocity_z"})
        snapshot.fields.push_back({mesh_colour(name), std::vector<double>(25, 2.0)});
    Values view("view", view_rows());
    for (const ParameterRow& row : view.rows())
        if (row.key == "color")
            for (const std::string& choice : row.choices) {
                view.set("color", choice);
                const auto colouring = make_colouring(snapshot, colour_choice(view));
                EXPECT_EQ(colouring.has_value(), choice != "none") << choice;
                if (colouring) {
                    EXPECT_FALSE(colouring->label.empty()) << choice;
                    EXPECT_EQ(colouring->values.size(), colouring->place == FieldPlace::node ? 25U : 16U);
                }
            }
    view.set("color", std::string("monitor"));
    for (const ParameterRow& row : view.rows())
        if (row.key == "color_map") {
            EXPECT_EQ(row.choices.size(), colour_maps().size() + 1);
            for (const std::string& choice : row.choices) {
                view.set("color_map", choice);
                const auto name = made(snapshot, colour_choice(view)).map->name;
                EXPECT_EQ(name, choice == "automatic" ? "viridis" : choice);
            }
        }
}

TEST(Colouring, AreasAddUpToTheDomain) {
    Snapshot snapshot = snapshot_of(unit_square_mesh(7));
    snapshot.x = snapshot.mesh->nodes;
    for (std::size_t i = 0; i < snapshot.x.size(); ++i) { // bent, but the border stays
        const Vec3 p = snapshot.mesh->nodes[i];
        snapshot.x.x[i] += 0.1 * std::sin(std::numbers::pi * p.x) * p.y;
    }
    const Colouring area = made(snapshot, {.colouring = "area"});
    EXPECT_EQ(area.place, FieldPlace::cell);
    EXPECT_EQ(area.label, "cell area");
    EXPECT_NEAR(sum_of(area.values), 1, 1e-14);
    EXPECT_EQ(area.range, range_of(area.values));
}

TEST(Colouring, MeasuresCellsOfEveryKind) {
    const auto total = [](Mesh mesh) {
        return sum_of(made(snapshot_of(std::move(mesh), 0), {.colouring = "area"}).values);
    };
    EXPECT_NEAR(total(interval_mesh(9)), 1, 1e-14);
    EXPECT_NEAR(total(cube_mesh(3)), 1, 1e-13);
    EXPECT_NEAR(total(disk_mesh(8)), 24 * std::sin(2 * std::numbers::pi / 48), 1e-13);
    EXPECT_NEAR(total(cubed_sphere_mesh(6)), 4 * std::numbers::pi, 1e-3);
    EXPECT_EQ(made(snapshot_of(interval_mesh(4)), {.colouring = "area"}).label, "cell length");
    EXPECT_EQ(made(snapshot_of(cube_mesh(2)), {.colouring = "area"}).label, "cell volume");
}

TEST(Colouring, JacobiansComputedAtTheNodesAreThoseOfTheMeter) {
    // Of these cells the smallest Jacobian is at a node.
    class One final : public Monitor {
      public:
        void values(const Points&, std::span<double> out) const override {
            std::fill(out.begin(), out.end(), 1.0);
        }
        void gradients(const Points&, Points&) const override {}
        void check() const override {}
    };
    for (const auto& mesh : {unit_square_mesh(6), disk_mesh(3), interval_mesh(8)}) {
        const Snapshot snapshot = snapshot_of(mesh);
        QualityMeter meter(snapshot.mesh);
        const auto& measured = meter.measure(snapshot.x, One()).cell_jacobian;
        const auto computed = made(snapshot, {.colouring = "jacobian"}).values;
        ASSERT_EQ(computed.size(), measured.size());
        for (std::size_t i = 0; i < computed.size(); ++i) EXPECT_NEAR(computed[i], measured[i], 1e-12);
    }
}

TEST(Colouring, JacobiansOfCellsInSpaceAreOneWhereNothingMoved) {
    for (const auto& mesh : {cubed_sphere_mesh(2), cube_mesh(2), interval_mesh(3)}) {
        const Colouring jacobian = made(snapshot_of(mesh, 0), {.colouring = "jacobian"});
        for (const double value : jacobian.values) EXPECT_NEAR(value, 1, 1e-12);
    }
}

TEST(Colouring, EquidistributionIsTheDeviationFromTheMean) {
    Snapshot snapshot = snapshot_of(unit_square_mesh(2));
    add_field(snapshot, "mass", {1, 2, 3, 2});
    const Colouring deviation = made(snapshot, {.colouring = "equidistribution"});
    EXPECT_EQ(deviation.values, (std::vector<double>{-0.5, 0, 0.5, 0}));
    EXPECT_TRUE(deviation.map->diverging);
    EXPECT_EQ(deviation.range, (ColourRange{-0.5, 0.5}));
    snapshot.fields.back().values = {1, 1, 1, 5};
    EXPECT_EQ(made(snapshot, {.colouring = "equidistribution"}).range, (ColourRange{-1.5, 1.5}))
        << "zero is in the middle";
    EXPECT_FALSE(made(snapshot, {.colouring = "equidistribution", .logarithmic = true}).range.logarithmic);
    EXPECT_EQ(made(snapshot, {.colouring = "equidistribution", .map = "grey"}).range,
              (ColourRange{-0.5, 1.5}));
}

TEST(Colouring, DisplacementIsHowFarNodesMoved) {
    Snapshot snapshot = snapshot_of(cube_mesh(2), 0);
    snapshot.x.x[3] += 3, snapshot.x.y[3] += 4, snapshot.x.z[3] += 12;
    const Colouring displacement = made(snapshot, {.colouring = "displacement"});
    EXPECT_EQ(displacement.place, FieldPlace::node);
    EXPECT_EQ(displacement.values[3], 13);
    EXPECT_EQ(displacement.values[4], 0);
}

TEST(Colouring, MeasurementsThatAreLeftOutDoNotFlicker) {
    Snapshot first = snapshot_of(unit_square_mesh(3));
    add_field(first, "mass", {1, 2, 3, 4, 5, 6, 7, 8, 9});
    Snapshot second = first;
    second.fields.pop_back();
    second.version = 2;
    ColouringMaker maker;
    EXPECT_FALSE(ColouringMaker().make(second, {.colouring = "equidistribution"}))
        << "nothing was ever measured";
    const auto before = maker.make(first, {.colouring = "equidistribution"});
    const auto after = maker.make(second, {.colouring = "equidistribution"});
    ASSERT_TRUE(before && after);
    EXPECT_EQ(before->values, after->values);

    // Also where another colouring was looked at meanwhile.
    ColouringMaker other;
    other.see(first);
    EXPECT_TRUE(other.make(second, {.colouring = "equidistribution"}));
    Snapshot elsewhere = snapshot_of(unit_square_mesh(3));
    elsewhere.version = 3;
    EXPECT_FALSE(other.make(elsewhere, {.colouring = "equidistribution"})) << "another mesh, another run";
}

TEST(Colouring, TangledCellsAreFoundWithAndWithoutAMeasurement) {
    Snapshot snapshot = snapshot_of(unit_square_mesh(4), 0);
    EXPECT_TRUE(ColouringMaker().tangled(snapshot).empty());
    snapshot.x.x[12] += 0.3; // the middle node, across its neighbour
    snapshot.version = 2;
    const auto computed = ColouringMaker().tangled(snapshot);
    EXPECT_EQ(computed, (std::vector<std::uint32_t>{6, 10}));
    add_field(snapshot, "jacobian", {1, 1, 1, -1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0});
    EXPECT_EQ(ColouringMaker().tangled(snapshot), (std::vector<std::uint32_t>{3, 15}))
        << "the measurement counts";
    snapshot.fields.back().values[5] = std::nan("");
    EXPECT_EQ(ColouringMaker().tangled(snapshot), (std::vector<std::uint32_t>{3, 5, 15}));
}

TEST(Colouring, LogarithmicRangesStartAtTheSmallestPositiveValue) {
    Snapshot snapshot = snapshot_of(unit_square_mesh(1));
    snapshot.fields[0].values = {0, 0.01, 1, 100};
    const ColourChoice log{.colouring = "monitor", .logarithmic = true};
    EXPECT_EQ(made(snapshot, log).range, (ColourRange{0.01, 100, true}));
    snapshot.fields[0].values = {-2, 1e-30, 1, 100};
    EXPECT_DOUBLE_EQ(made(snapshot, log).range.low, 1e-4) << "six decades at most";
    snapshot.fields[0].values = {-2, -1, 0, -3};
    EXPECT_FALSE(made(snapshot, log).range.logarithmic);
    Snapshot jacobian = snapshot_of(unit_square_mesh(2), 0);
    add_field(jacobian, "jacobian", {0.25, 1, 1, 2});
    EXPECT_EQ(made(jacobian, {.colouring = "jacobian", .map = "blue-red", .logarithmic = true}).range,
              (ColourRange{0.25, 4, true}))
        << "the Jacobian 1 is in the middle";
}

TEST(Colouring, RoundingIsNoPattern) {
    Snapshot snapshot = snapshot_of(unit_square_mesh(1));
    snapshot.fields[0].values = {3, 3 + 1e-15, 3 - 1e-15, 3};
    for (const bool log : {false, true}) {
        const Colouring same = made(snapshot, {.logarithmic = log});
        EXPECT_EQ(same.range.low, same.range.high);
        EXPECT_EQ(same.colour(1), same.colour(2));
        EXPECT_FALSE(same.below || same.above);
        EXPECT_EQ(std::accumulate(same.histogram.begin(), same.histogram.end(), 0U), 4U);
    }
    snapshot.fields[0].values[1] = 3 + 1e-9;
    EXPECT_NE(made(snapshot, {}).colour(1), made(snapshot, {}).colour(2));
    add_field(snapshot, "mass", {1});
    EXPECT_EQ(made(snapshot, {.colouring = "equidistribution"}).range, (ColourRange{0, 0}));
}

TEST(Colouring, AFixedRangeStaysAndTellsWhatLiesOutside) {
    Snapshot snapshot = snapshot_of(unit_square_mesh(1));
    snapshot.fields[0].values = {0, 1, 2, 8};
    const Colouring fixed = made(snapshot, {.fixed = true, .low = 1, .high = 4});
    EXPECT_EQ(fixed.range, (ColourRange{1, 4}));
    EXPECT_TRUE(fixed.below);
    EXPECT_TRUE(fixed.above);
    EXPECT_EQ(std::accumulate(fixed.histogram.begin(), fixed.histogram.end(), 0U), 2U);
    EXPECT_EQ(fixed.histogram.front(), 1U);
    const Colouring automatic = made(snapshot, {});
    EXPECT_FALSE(automatic.below || automatic.above);
    EXPECT_EQ(fixed.colour(3), colour_at(*fixed.map, 1));
}

TEST(Colouring, TheHistogramCountsEveryFiniteValueInItsPlace) {
    Snapshot snapshot = snapshot_of(unit_square_mesh(63));
    for (std::size_t i = 0; i < 4096; ++i)
        snapshot.fields[0].values[i] = std::pow(10.0, (static_cast<double>(i) + 0.5) / 4096);
    snapshot.fields[0].values[7] = std::nan("");
    const auto log = made(snapshot, {.logarithmic = true}).histogram;
    ASSERT_EQ(log.size(), 64U);
    EXPECT_EQ(std::accumulate(log.begin(), log.end(), 0U), 4095U);
    for (const auto count : log) EXPECT_NEAR(count, 64, 3);
    const auto linear = made(snapshot, {}).histogram;
    EXPECT_EQ(std::accumulate(linear.begin(), linear.end(), 0U), 4095U);
    EXPECT_GT(linear.front(), 5 * linear.back());
}

} // namespace
} // namespace gaspard
