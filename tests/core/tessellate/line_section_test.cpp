#include "core/base/error.hpp"
#include "core/tessellate/line_section.hpp"
#include "support/messages.hpp"
#include "support/small_meshes.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

/// m = 1 + x + 2 y at the nodes, which the mesh represents exactly.
Snapshot linear_snapshot(const Mesh& mesh) {
    Snapshot snapshot;
    snapshot.mesh = std::make_shared<const Mesh>(mesh);
    snapshot.x = mesh.nodes;
    Field monitor{{.name = "monitor"}, {}};
    for (std::size_t i = 0; i < mesh.node_count(); ++i)
        monitor.values.push_back(1 + mesh.nodes.x[i] + 2 * mesh.nodes.y[i]);
    snapshot.fields.push_back(monitor);
    snapshot.version = 1;
    return snapshot;
}

TEST(SectionLine, IsFourNumbers) {
    EXPECT_FALSE(parse_section_line(""));
    EXPECT_FALSE(parse_section_line("  "));
    const auto line = parse_section_line("0 0.5  1 -2e-1");
    ASSERT_TRUE(line);
    EXPECT_EQ(line->from, (Vec3{0, 0.5, 0}));
    EXPECT_EQ(line->to, (Vec3{1, -0.2, 0}));
    EXPECT_EQ(parse_section_line(format_section_line(*line)), line);
    for (const char* wrong : {"1", "0 0 1", "0 0 1 1 1", "0 0 x 1", "0.5 0.5 0.5 0.5", "0,0,1,1"}) {
        const std::string message = message_of<InputError>([&] { parse_section_line(wrong); });
        EXPECT_NE(message.find("'x0 y0 x1 y1'"), std::string::npos) << wrong << ": " << message;
    }
}

TEST(SectionLine, HasTheValuesOfALinearFieldAndTheSidesOfTheCells) {
    for (const Mesh& mesh : {unit_square_mesh(4), of_order_two(unit_square_mesh(4)), two_triangles()}) {
        const Snapshot snapshot = linear_snapshot(mesh);
        const auto colouring = make_colouring(snapshot, {});
        const SectionLine line{{0.1, 0.15, 0}, {0.9, 0.75, 0}}; // of length 1
        const ValuesOnLine found = values_on_line(snapshot, *colouring, line);
        ASSERT_GE(found.arc.size(), 2U);
        EXPECT_NEAR(found.arc.front(), 0, 1e-12);
        EXPECT_NEAR(found.arc.back(), 1, 1e-12);
        for (std::size_t i = 0; i < found.arc.size(); ++i) {
            const double s = found.arc[i];
            EXPECT_NEAR(found.values[i], 1 + (0.1 + 0.8 * s) + 2 * (0.15 + 0.6 * s), 1e-9);
            if (i > 0) {
                EXPECT_GE(s, found.arc[i - 1]);
            }
        }
        if (mesh.kind.shape == CellShape::triangle) {
            ASSERT_EQ(found.sides.size(), 1U); // across the diagonal x = y
            EXPECT_NEAR(found.sides[0], 0.25, 1e-9);
        } else { // x = 1/4, 1/2, 3/4 and y = 1/4, 1/2; the end is at y = 3/4
            EXPECT_EQ(found.sides.size(), 5U);
        }
    }
}

TEST(SectionLine, OfCellsIsConstantInEachAndBeginsAtTheMesh) {
    const Snapshot snapshot = linear_snapshot(unit_square_mesh(2));
    const auto colouring = make_colouring(snapshot, {.colouring = "area"});
    const SectionLine line{{-1, 0.25, 0}, {3, 0.25, 0}};
    const ValuesOnLine found = values_on_line(snapshot, *colouring, line);
    EXPECT_NEAR(found.arc.front(), 1, 1e-9);
    EXPECT_NEAR(found.arc.back(), 2, 1e-9);
    for (const double value : found.values) EXPECT_NEAR(value, 0.25, 1e-12);
    ASSERT_EQ(found.sides.size(), 1U);
    EXPECT_NEAR(found.sides[0], 1.5, 1e-9);
    EXPECT_TRUE(values_on_line(snapshot, *colouring, {{2, 2, 0}, {3, 3, 0}}).arc.empty());
}

TEST(SectionLine, AlongASideHasEveryPartOnce) {
    const Snapshot snapshot = linear_snapshot(unit_square_mesh(4));
    const auto colouring = make_colouring(snapshot, {});
    const ValuesOnLine found = values_on_line(snapshot, *colouring, {{0, 0.5, 0}, {1, 0.5, 0}});
    double covered = 0;
    for (std::size_t i = 1; i < found.arc.size(); ++i) {
        EXPECT_TRUE(std::isfinite(found.values[i])) << "no gap";
        covered += found.arc[i] - found.arc[i - 1];
    }
    EXPECT_NEAR(covered, 1, 1e-9);
    EXPECT_EQ(found.sides.size(), 3U);
}

TEST(SectionLine, IsAPlotAndATable) {
    const Snapshot snapshot = linear_snapshot(unit_square_mesh(2));
    const auto colouring = make_colouring(snapshot, {});
    const SectionLine line{{0, 0.25, 0}, {1, 0.25, 0}};
    const ValuesOnLine found = values_on_line(snapshot, *colouring, line);
    const Plot plot = section_line_plot(found, *colouring);
    EXPECT_EQ(plot.x.label, "arc length");
    EXPECT_EQ(plot.y.label, "monitor m");
    ASSERT_EQ(plot.rows.size(), 1U);
    EXPECT_EQ(plot.rows[0].x.size(), 1U);
    const std::string csv = section_line_csv(found, *colouring, line);
    EXPECT_TRUE(csv.starts_with("arc_length,x,y,monitor,cell\n0,0,0.25,1.5,0\n")) << csv;
    EXPECT_TRUE(has_section_line(unit_square_mesh(2)));
    EXPECT_FALSE(has_section_line(two_cubes()));
    EXPECT_FALSE(has_section_line(three_lines()));
}

} // namespace
} // namespace gaspard
