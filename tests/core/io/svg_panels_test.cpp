// Drawings of a mesh in the layouts of the view: the computational mesh, and both beside each other.
#include "core/io/svg.hpp"
#include "support/sample_snapshot.hpp"
#include "support/svg_reader.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace gaspard {
namespace {

constexpr double bend = 3;

/// The unit square with x = ξ³, y = η and u = x + 2 y.
Snapshot bent_square(int cells) {
    Snapshot snapshot = sample_snapshot(unit_square_mesh(cells));
    snapshot.x = snapshot.mesh->nodes;
    auto& u = snapshot.fields[0].values;
    for (std::size_t i = 0; i < u.size(); ++i) {
        snapshot.x.x[i] = std::pow(snapshot.mesh->nodes.x[i], bend);
        u[i] = snapshot.x.x[i] + 2 * snapshot.x.y[i];
    }
    return snapshot;
}

struct Frame {
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    void add(SvgPoint p) {
        left = std::min(left, p.x), right = std::max(right, p.x);
        top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    }
    double x(SvgPoint p) const { return (p.x - left) / (right - left); }
    double y(SvgPoint p) const { return (bottom - p.y) / (bottom - top); }
};

std::vector<SvgStroke> strokes_of_group(const SvgReader& svg, const std::string& id) {
    std::vector<SvgStroke> all;
    const auto* group = svg.with_id(id);
    EXPECT_NE(group, nullptr) << id;
    if (!group) return all;
    for (const auto* path : svg.all("path", group))
        for (auto& stroke : read_path(path->Attribute("d"))) all.push_back(std::move(stroke));
    return all;
}

Frame frame_of(const SvgReader& svg, const std::string& id) {
    Frame frame;
    for (const SvgStroke& stroke : strokes_of_group(svg, id))
        for (const SvgPoint p : stroke.corners) frame.add(p);
    return frame;
}

class SvgPanels : public testing::Test {
  protected:
    std::string drawn(const std::vector<SvgPanel>& panels, MeshSvgOptions options = {}) {
        options.width_mm = 180;
        return svg_of_meshes(snapshot, panels, options);
    }
    std::optional<Colouring> colours() { return make_colouring(snapshot, {.contours = 5}); }
    std::vector<SvgPanel> both() { return {{"computational", 0, colours()}, {"physical", 1, colours()}}; }

    Snapshot snapshot = bent_square(20);
};

TEST_F(SvgPanels, BothMeshesStandBesideEachOtherOnOneScaleWithOneLegend) {
    const SvgReader svg(drawn(both()));
    const Frame left = frame_of(svg, "computational-cells"), right = frame_of(svg, "cells");
    EXPECT_LT(left.right, right.left);
    EXPECT_NEAR(left.right - left.left, right.right - right.left, 0.02);
    EXPECT_NEAR(left.top, right.top, 0.02);
    const auto texts = svg.texts();
    EXPECT_EQ(std::count(texts.begin(), texts.end(), "computational"), 1);
    EXPECT_EQ(std::count(texts.begin(), texts.end(), "physical"), 1);
    EXPECT_EQ(std::count(texts.begin(), texts.end(), "contours every 0.5"), 1);
    std::set<std::string> ids;
    for (const char* name : {"g", "clipPath"})
        for (const auto* element : svg.all(name))
            if (const char* id = element->Attribute("id")) {
                EXPECT_TRUE(ids.insert(id).second) << id << " twice";
            }
    EXPECT_EQ(drawn({{.colouring = colours()}}), svg_of_mesh(snapshot, colours(), {.width_mm = 180}));
}

// u = x + 2 y is linear on each triangle of the physical mesh, so that its lines there are straight; on the
// computational mesh they are the images of these, ξ³ + 2 η = c at the edges of cells.
TEST_F(SvgPanels, ContourLinesAreWhereTheFieldHasTheirLevelsOnBothMeshes) {
    const SvgReader svg(drawn(both()));
    for (const bool computational : {false, true}) {
        const std::string before = computational ? "computational-" : "";
        const Frame frame = frame_of(svg, before + "cells");
        const auto lines = strokes_of_group(svg, before + "contours");
        std::map<long, std::size_t> seen;
        for (const SvgStroke& line : lines)
            for (const SvgPoint p : line.corners) {
                // Between the nodes of an edge, ξ³ is what interpolates it linearly.
                const double x = frame.x(p), t = x * 20, cell = std::min(std::floor(t), 19.0);
                const double low = std::pow(cell / 20, bend), high = std::pow((cell + 1) / 20, bend);
                const double u = (computational ? low + (t - cell) * (high - low) : x) + 2 * frame.y(p);
                EXPECT_NEAR(u, std::round(2 * u) / 2, 0.002) << computational;
                ++seen[std::lround(2 * u)];
            }
        EXPECT_EQ(lines.size(), 5U) << "0.5, 1, ..., 2.5, one long line each";
        EXPECT_EQ(seen.size(), 5U);
    }
}

TEST_F(SvgPanels, TheBlendOfThePhysicalMeshIsDrawn) {
    const SvgReader svg(drawn({{.blend = 0.5, .colouring = colours()}}));
    const Frame frame = frame_of(svg, "edges");
    std::vector<double> columns; // of nodes on the lower side
    for (const SvgStroke& line : strokes_of_group(svg, "edges"))
        for (const SvgPoint p : line.corners)
            if (frame.y(p) < 1e-3) columns.push_back(frame.x(p));
    for (const double xi : {0.25, 0.5, 0.75})
        EXPECT_TRUE(std::any_of(columns.begin(), columns.end(), [&](double x) {
            return std::abs(x - (xi + std::pow(xi, bend)) / 2) < 1e-3;
        })) << xi;
}

TEST_F(SvgPanels, EdgesCanBeLeftOut) {
    EXPECT_EQ(SvgReader(drawn(both(), {.lines = false})).with_id("edges"), nullptr);
    EXPECT_FALSE(strokes_of_group(SvgReader(drawn(both(), {.lines = false})), "contours").empty());
    const auto inks = [&](bool lines) {
        const SvgReader svg(drawn(both(), {.lines = lines, .elevation = 1}));
        std::set<std::string> found;
        for (const auto* group : svg.all("g", svg.with_id("cells")))
            if (std::string_view(group->Attribute("stroke")) != group->Attribute("fill"))
                found.insert(group->Attribute("stroke"));
        return found.size();
    };
    EXPECT_EQ(inks(true), 2U) << "dark and light";
    EXPECT_EQ(inks(false), 0U);
}

TEST_F(SvgPanels, APartThatACameraShowsIsThatOfBothMeshes) {
    const SvgReader svg(drawn(both(), {.camera = "centre 0.5 0.5 height 0.5"}));
    std::vector<const tinyxml2::XMLElement*> clips = svg.all("clipPath");
    ASSERT_EQ(clips.size(), 2U);
    EXPECT_STREQ(clips[0]->Attribute("id"), "computational-view");
    EXPECT_STREQ(clips[1]->Attribute("id"), "view");
    const auto *one = clips[0]->FirstChildElement(), *other = clips[1]->FirstChildElement();
    EXPECT_EQ(one->DoubleAttribute("width"), other->DoubleAttribute("width"));
    EXPECT_LT(one->DoubleAttribute("x") + one->DoubleAttribute("width"), other->DoubleAttribute("x"));
}

TEST_F(SvgPanels, HeightsAreTheSameOnBothMeshes) {
    const SvgReader svg(drawn(both(), {.elevation = 1, .elevation_camera = "right 0 1 0 up 0 0 1"}));
    const Frame left = frame_of(svg, "computational-cells"), right = frame_of(svg, "cells");
    EXPECT_NEAR(left.bottom - left.top, right.bottom - right.top, 0.02);
    EXPECT_NEAR((right.bottom - right.top) / (right.right - right.left), 0.5, 1e-3) << "half the domain";
}

TEST_F(SvgPanels, EachMeshHasAxesOfItsOwn) {
    const SvgReader svg(drawn(both(), {.axes = true}));
    for (const std::string& name : {std::string("computational-"), std::string()}) {
        const Frame cells = frame_of(svg, name + "cells"), axes = frame_of(svg, name + "axes");
        EXPECT_LT(axes.left, cells.left - 2) << name;
        EXPECT_GT(axes.bottom, cells.bottom + 2) << name;
        EXPECT_NEAR(axes.right, cells.right, 0.05) << name;
        EXPECT_NEAR(axes.top, cells.top, 0.05) << name;
    }
    const auto texts = svg.texts();
    for (const char* text : {"0", "1.0", "x", "y", "ξ", "η"})
        EXPECT_NE(std::find(texts.begin(), texts.end(), text), texts.end()) << text;
    EXPECT_EQ(SvgReader(drawn(both())).with_id("axes"), nullptr);
    EXPECT_EQ(SvgReader(drawn(both(), {.axes = true, .elevation = 1})).with_id("axes"), nullptr)
        << "a surface in space";
}

} // namespace
} // namespace gaspard
