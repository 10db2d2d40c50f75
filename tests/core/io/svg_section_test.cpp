// Solids that are cut open, as SVG.
#include "core/io/svg.hpp"
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

} // namespace
} // namespace gaspard
