// Solids that are cut open, as SVG.
#include "core/io/svg.hpp"
#include "core/scenario/view_rows.hpp"
#include "support/sample_snapshot.hpp"
#include "support/small_meshes.hpp"
#include "support/svg_reader.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>

namespace gaspard {
namespace {

struct DrawnSection {
    double area = 0, length = 0;   ///< of what is filled; of lines
    double side = 0;               ///< width of the drawn part of the page
    std::set<std::string> fills{}; ///< of groups
};

DrawnSection drawn_section(const InsideChoice& inside, const std::string& camera) {
    Snapshot snapshot = sample_snapshot(two_cubes());
    snapshot.x = snapshot.mesh->nodes;
    const SvgReader svg(svg_of_mesh(snapshot, std::nullopt, {.camera = camera, .inside = inside}));
    DrawnSection drawn;
    double left = 1e300, right = -1e300;
    const auto* cells = svg.with_id("cells");
    for (const auto* path : svg.all("path", cells))
        for (const SvgStroke& stroke : read_path(path->Attribute("d"))) {
            const auto& c = stroke.corners;
            double twice = 0;
            for (std::size_t i = 0; i < c.size(); ++i) {
                const SvgPoint a = c[i], b = c[(i + 1) % c.size()];
                twice += a.x * b.y - b.x * a.y;
                if (!stroke.closed && i + 1 < c.size()) drawn.length += std::hypot(b.x - a.x, b.y - a.y);
                left = std::min(left, a.x), right = std::max(right, a.x);
            }
            if (stroke.closed) drawn.area += std::abs(twice) / 2;
        }
    for (const auto* group : svg.all("g", cells))
        if (group->Attribute("fill")) drawn.fills.emplace(group->Attribute("fill"));
    drawn.side = right - left;
    return drawn;
}

Values view_of_only(const std::string& text) {
    Values view("view", view_rows({}));
    view.set("only", text);
    return view;
}

TEST(SectionSvg, ACapIsFilledAndOutlinedOnce) {
    const DrawnSection cap =
        drawn_section({.cut = parse_cut("x 0.6")}, "right 0 1 0 up 0 0 1"); // onto the cap alone
    EXPECT_NEAR(cap.area / (cap.side * cap.side), 1, 1e-3);
    EXPECT_NEAR(cap.length / cap.side, 4, 1e-2);
    EXPECT_EQ(cap.fills, std::set<std::string>{"#ffffff"});
}

TEST(SectionSvg, TheSkinOfACutSolidIsPaler) {
    const DrawnSection both = drawn_section({.cut = parse_cut("x 0.6")}, "right -0.6 0.8 0 up 0 0 1");
    EXPECT_EQ(both.fills, (std::set<std::string>{"#c7c7c7", "#ffffff"}));
    const DrawnSection apart = drawn_section({.explode = 0.25}, "right 0 1 0 up 0 0 1");
    EXPECT_EQ(apart.fills, std::set<std::string>{"#ffffff"}) << "nothing is cut";
    EXPECT_NEAR(apart.area / (apart.side * apart.side), 2, 1e-3) << "one face behind the other";
}

TEST(SectionSvg, HasNoLinesWhereTheViewHasNone) {
    Snapshot snapshot = sample_snapshot(two_cubes());
    snapshot.x = snapshot.mesh->nodes;
    const auto strokes = [&](bool lines) {
        const std::string text =
            svg_of_mesh(snapshot, std::nullopt, {.lines = lines, .inside = {.cut = parse_cut("x 0.6")}});
        return SvgReader(text).all("path").size();
    };
    EXPECT_GT(strokes(true), strokes(false));
    const std::string bare =
        svg_of_mesh(snapshot, std::nullopt, {.lines = false, .inside = {.cut = parse_cut("x 0.6")}});
    EXPECT_EQ(bare.find("fill=\"none\" stroke=\"#14171c\""), std::string::npos);
}

// Displacements are those of the adapted mesh, wherever the nodes are drawn.
TEST(SectionSvg, HidesTheSameCellsInBothPanels) {
    Snapshot snapshot = sample_snapshot(two_cubes());
    snapshot.x = snapshot.mesh->nodes;
    snapshot.x.x.back() += 0.25; // a node of the second cube alone
    const std::string text =
        svg_of_meshes(snapshot, {{"computational", 0, std::nullopt}, {"physical", 1, std::nullopt}},
                      {.inside = {.only = inside_choice(view_of_only("displacement > 0.01")).only}});
    const SvgReader svg(text);
    std::set<std::string> ids;
    std::size_t groups = 0;
    for (const auto* group : svg.all("g"))
        if (const char* id = group->Attribute("id")) {
            EXPECT_TRUE(ids.insert(id).second) << id << " twice";
            if (std::string(id).ends_with("cells")) {
                ++groups;
                EXPECT_FALSE(svg.all("path", group).empty()) << id;
            }
        }
    EXPECT_EQ(groups, 2U);
}

} // namespace
} // namespace gaspard
