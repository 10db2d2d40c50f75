// SVG read back: paths by SVG's own grammar, text as text, sizes. Their appearance is checked by hand with
// librsvg and Inkscape (docs/formats.md).
#include "core/base/error.hpp"
#include "core/io/facets.hpp"
#include "core/io/svg.hpp"
#include "core/io/svg_document.hpp"
#include "core/io/svg_path.hpp"
#include "core/io/xml.hpp"
#include "core/scenario/view_rows.hpp"
#include "support/comma_locale.hpp"
#include "support/sample_snapshot.hpp"
#include "support/svg_reader.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <sstream>

namespace gaspard {
namespace {

TEST(SvgPath, IsShortAndDoesNotAddUpItsRounding) {
    SvgPath path;
    path.move({10, 20.5});
    for (int i = 1; i <= 1000; ++i) path.line({10 + i / 3.0, 20.5});
    const auto strokes = read_path(path.data());
    ASSERT_EQ(strokes.size(), 1u);
    ASSERT_EQ(strokes[0].corners.size(), 1001u);
    for (int i = 0; i <= 1000; ++i)
        EXPECT_NEAR(strokes[0].corners[static_cast<std::size_t>(i)].x, 10 + i / 3.0, 0.00501);
    EXPECT_LT(path.data().size(), 6100u);
}

TEST(SvgPath, WritesWhatSvgReads) {
    SvgPath path;
    path.move({1, 2});
    path.line({1.5, 1.75});
    path.line({1.5, 1.751}); // too small a step
    path.curve({2, 3}, {3, 1.75});
    path.curve({4, 1.755}, {5, 1.75}); // as good as straight
    path.close();
    path.move({0, 0});
    path.line({-1, 100});
    EXPECT_EQ(path.data(), "M1 2l.5-.25q.5 1.25 1.5 0l2 0zm-1-2l-1 100");
    const auto strokes = read_path(path.data());
    ASSERT_EQ(strokes.size(), 2u);
    EXPECT_EQ(strokes[0].controls.size(), 1u);
    EXPECT_TRUE(strokes[0].closed);
    EXPECT_EQ(strokes[1].corners[1].y, 100);
}

TEST(SvgText, RaisesDigitsAndEscapes) {
    EXPECT_EQ(svg_text({1, 2.25}, Anchor::end, "10⁻⁸"),
              "<text x=\"1\" y=\"2.25\" text-anchor=\"end\">10<tspan dy=\"-3.04\" "
              "font-size=\"5.6\">−8</tspan></text>\n");
    EXPECT_NE(svg_text({0, 0}, Anchor::start, "a<b & x² c").find("a&lt;b &amp; x<tspan"), std::string::npos);
    EXPECT_NE(svg_text({0, 0}, Anchor::start, "x² c").find("<tspan dy=\"3.04\"> c</tspan>"),
              std::string::npos);
}

TEST(Xml, BytesThatAreNoTextAreReplaced) {
    EXPECT_EQ(xml_escape("a\x01z"), "a\uFFFDz");
    EXPECT_EQ(xml_escape("\xff\xc3"), "\uFFFD\uFFFD");
    EXPECT_EQ(xml_escape("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD") << "a surrogate";
    EXPECT_EQ(xml_escape("ξ → x\t<\"&>"), "ξ → x\t&lt;&quot;&amp;&gt;");
    EXPECT_EQ(xml_escape("𝔽"), "𝔽");
}

Plot falling(std::size_t points) {
    Plot plot{"Residual", {"iteration", false}, {"normalised residual", true}, {{}}};
    for (std::size_t i = 0; i < points; ++i) {
        plot.curves[0].x.push_back(static_cast<double>(i));
        plot.curves[0].y.push_back(
            std::pow(10.0, -8.0 * static_cast<double>(i) / static_cast<double>(points - 1)));
    }
    return plot;
}

/// The strokes of the first curve of a plot.
std::vector<SvgStroke> curve_of(const SvgReader& svg) {
    for (const auto* path : svg.all("path"))
        if (path->Attribute("stroke") && std::string(path->Attribute("stroke")) == "#0072b2")
            return read_path(path->Attribute("d"));
    return {};
}

TEST(PlotSvg, HasItsSizeAndItsWords) {
    const SvgReader svg(svg_of_plot(falling(100), {.width_mm = 84, .height_mm = 60}));
    EXPECT_STREQ(svg.root().Name(), "svg");
    EXPECT_STREQ(svg.root().Attribute("xmlns"), "http://www.w3.org/2000/svg");
    EXPECT_STREQ(svg.root().Attribute("width"), "84mm");
    EXPECT_STREQ(svg.root().Attribute("height"), "60mm");
    EXPECT_STREQ(svg.root().Attribute("viewBox"), "0 0 238.11 170.08");
    const auto texts = svg.texts();
    for (const char* text : {"Residual", "iteration", "normalised residual", "80", "10−8"})
        EXPECT_NE(std::find(texts.begin(), texts.end(), text), texts.end()) << text;
}

TEST(PlotSvg, ACurveRunsFromCornerToCorner) {
    const SvgReader svg(svg_of_plot(falling(100)));
    const auto strokes = curve_of(svg);
    ASSERT_EQ(strokes.size(), 1u);
    const auto& corners = strokes[0].corners;
    ASSERT_EQ(corners.size(), 100u);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        EXPECT_LT(corners[i].x, corners[i + 1].x);
        EXPECT_LT(corners[i].y, corners[i + 1].y) << "down the page";
    }
    // Straight, for the axis is logarithmic.
    const SvgPoint a = corners.front(), b = corners.back(), m = corners[50];
    EXPECT_NEAR((m.x - a.x) / (b.x - a.x), (m.y - a.y) / (b.y - a.y), 1e-3);
}

TEST(PlotSvg, WhatTheEyeCannotSeeIsLeftOut) {
    Plot plot = falling(200'000);
    plot.curves[0].y[100'001] = 1e3; // a peak of one point must stay
    const std::string text = svg_of_plot(plot);
    EXPECT_LT(text.size(), 60'000u);
    const auto strokes = curve_of(SvgReader(text));
    ASSERT_EQ(strokes.size(), 1u);
    double top = 1e9, left = 0, highest_at = 0;
    left = strokes[0].corners.front().x;
    for (const auto& p : strokes[0].corners)
        if (p.y < top) top = p.y, highest_at = p.x;
    EXPECT_LT(top, strokes[0].corners.front().y - 10);
    EXPECT_NEAR((highest_at - left) / (strokes[0].corners.back().x - left), 0.5, 1e-3);
}

TEST(PlotSvg, WhatCannotBeShownIsAGap) {
    Plot plot = falling(9);
    plot.curves[0].y[2] = 0;
    plot.curves[0].y[5] = std::numeric_limits<double>::quiet_NaN();
    plot.curves[0].y[7] = std::numeric_limits<double>::infinity();
    const std::string text = svg_of_plot(plot);
    EXPECT_EQ(curve_of(SvgReader(text)).size(), 2u);
    EXPECT_EQ(SvgReader(text).all("circle").size(), 2u) << "points without neighbours";
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf"), std::string::npos);
}

TEST(PlotSvg, AnEmptyPlotIsAFrame) {
    for (const bool logarithmic : {false, true}) {
        const SvgReader svg(svg_of_plot({"", {"x", false}, {"y", logarithmic}, {}}));
        EXPECT_EQ(svg.all("rect").size(), 2u);
        EXPECT_FALSE(svg.texts().empty());
    }
}

TEST(PlotSvg, ALegendNamesSeveralCurves) {
    Plot plot = falling(10);
    plot.curves[0].label = "n = 60";
    EXPECT_EQ(svg_of_plot(plot).find("n = 60"), std::string::npos) << "one curve needs none";
    plot.curves.push_back(plot.curves[0]);
    plot.curves[1].label = "n = 120";
    const SvgReader svg(svg_of_plot(plot));
    const auto texts = svg.texts();
    EXPECT_NE(std::find(texts.begin(), texts.end(), "n = 60"), texts.end());
    EXPECT_NE(std::find(texts.begin(), texts.end(), "n = 120"), texts.end());
    std::set<std::string> colours;
    for (const auto* path : svg.all("path"))
        if (path->Attribute("stroke-width") && std::string(path->Attribute("stroke-width")) == "1.2")
            colours.insert(path->Attribute("stroke"));
    EXPECT_EQ(colours.size(), 2u);
}

TEST(PlotSvg, AnAskedRangeCutsTheCurveOff) {
    Plot plot{"", {"x", false}, {"y", false}, {{.label = "", .x = {0, 1e9}, .y = {0, 1e9}}}};
    plot.x.low = 100, plot.x.high = 200;
    plot.y.low = 0, plot.y.high = 150;
    const SvgReader svg(svg_of_plot(plot));
    const auto strokes = curve_of(svg);
    ASSERT_EQ(strokes.size(), 1u);
    ASSERT_EQ(strokes[0].corners.size(), 2u);
    const auto* frame = svg.all("rect")[1];
    const double x = frame->DoubleAttribute("x"), y = frame->DoubleAttribute("y");
    const double width = frame->DoubleAttribute("width"), height = frame->DoubleAttribute("height");
    EXPECT_NEAR(strokes[0].corners[0].x, x, 0.02);
    EXPECT_NEAR(strokes[0].corners[0].y, y + height / 3, 0.02);
    EXPECT_NEAR(strokes[0].corners[1].x, x + width / 2, 0.02);
    EXPECT_NEAR(strokes[0].corners[1].y, y, 0.02);
}

TEST(PlotSvg, AReversedAxisShowsDistancesFromTheRightEnd) {
    Plot plot{"", {"x", true}, {"y", false}, {{.label = "", .x = {0, 1e-12, 1}, .y = {0, 1, 1}}}};
    plot.x.reversed = true, plot.x.before = "1 − ";
    plot.curves[0].linear = true;
    plot.rows = {{{0, 1e-12, 1}, 0}};
    const SvgReader svg(svg_of_plot(plot));
    const auto strokes = curve_of(svg);
    ASSERT_EQ(strokes.size(), 1u);
    EXPECT_GT(strokes[0].corners.front().x, strokes[0].corners.back().x);
    const auto texts = svg.texts();
    const auto label = [&](const char* text) {
        return std::find(texts.begin(), texts.end(), text) != texts.end();
    };
    EXPECT_TRUE(label("1 − 10−12") && label("1 − 100"));
}

TEST(PlotSvg, TheLegendLeavesACornerThatHasCurves) {
    const auto box_of = [](const Plot& plot) {
        const SvgReader svg(svg_of_plot(plot));
        return svg.all("rect").back()->DoubleAttribute("y");
    };
    Plot falling_ones{"",
                      {"x"},
                      {"y"},
                      {{.label = "a", .x = {0, 1}, .y = {1, 0}}, {.label = "b", .x = {0, 1}, .y = {1, 0.1}}}};
    EXPECT_LT(box_of(falling_ones), 30) << "above, at the right";
    const Plot flat{
        "",
        {"x"},
        {"y"},
        {{.label = "a", .x = {0, 1, 1}, .y = {1, 1, 0}}, {.label = "b", .x = {0, 1}, .y = {0.95, 0.95}}}};
    EXPECT_GT(box_of(flat), 60) << "below, at the left";
}

TEST(PlotSvg, OfAnIntervalAreAllPlots) {
    Snapshot snapshot;
    Mesh mesh{.kind = {CellShape::line, 1}, .space_dimension = 1, .nodes = Points(3), .cells = {0, 1, 1, 2}};
    mesh.nodes.x = {0, 0.5, 1};
    snapshot.x = mesh.nodes;
    snapshot.x.x[1] = 0.1;
    snapshot.mesh = std::make_shared<const Mesh>(std::move(mesh));
    Values view("view", view_rows());
    view.set("layout", std::string("side-by-side"));
    const SvgReader svg(svg_of_plots(interval_plots(snapshot, view), {}));
    const auto texts = svg.texts();
    for (const char* text : {"physical", "computational", "cell width", "ξ", "x"})
        EXPECT_NE(std::find(texts.begin(), texts.end(), text), texts.end()) << text;
}

TEST(PlotSvg, AMarkSaysWhatHappened) {
    Plot plot = falling(10);
    plot.marks = {{4, "amplitude changed"}, {400, "out of sight"}};
    const auto texts = SvgReader(svg_of_plot(plot)).texts();
    EXPECT_NE(std::find(texts.begin(), texts.end(), "amplitude changed"), texts.end());
    EXPECT_EQ(std::find(texts.begin(), texts.end(), "out of sight"), texts.end());
}

TEST(PlotSvg, NumbersHaveAPointUnderACommaLocale) {
    const std::string plain = svg_of_plot(falling(2000));
    const CommaLocale comma;
    EXPECT_EQ(svg_of_plot(falling(2000)), plain);
}

/// The mesh, coloured.
std::string svg_of(const Snapshot& snapshot, const MeshSvgOptions& options = {},
                   const ColourChoice& colours = {}) {
    return svg_of_mesh(snapshot, make_colouring(snapshot, colours), options);
}

/// All strokes of the paths within an element, or of a path itself.
std::vector<SvgStroke> strokes_in(const SvgReader& svg, const std::string& id) {
    const auto* element = svg.with_id(id);
    if (!element) return {};
    if (std::string(element->Name()) == "path") return read_path(element->Attribute("d"));
    std::vector<SvgStroke> strokes;
    for (const auto* path : svg.all("path", element))
        for (const auto& stroke : read_path(path->Attribute("d"))) strokes.push_back(stroke);
    return strokes;
}

double area_of(const std::vector<SvgStroke>& strokes) {
    double twice = 0;
    for (const auto& stroke : strokes)
        for (std::size_t i = 0; i < stroke.corners.size(); ++i) {
            const SvgPoint a = stroke.corners[i], b = stroke.corners[(i + 1) % stroke.corners.size()];
            twice += b.x * a.y - a.x * b.y; // y down
        }
    return twice / 2;
}

TEST(MeshSvg, FillsTheSquareAndDrawsEveryEdgeOnce) {
    Snapshot snapshot = sample_snapshot(unit_square_mesh(12));
    snapshot.x = snapshot.mesh->nodes;
    const SvgReader svg(svg_of(snapshot));
    EXPECT_STREQ(svg.root().Attribute("width"), "120mm");
    const auto edges = strokes_in(svg, "edges");
    std::size_t segments = 0;
    double low = 1e9, high = 0;
    for (const auto& stroke : edges) {
        segments += stroke.corners.size() - 1;
        for (const auto& p : stroke.corners) low = std::min(low, p.x), high = std::max(high, p.x);
    }
    EXPECT_EQ(segments, 2u * 12 * 13);
    EXPECT_NEAR(area_of(strokes_in(svg, "cells")), (high - low) * (high - low), 0.5);
    EXPECT_GT(high - low, 250) << "points";
}

TEST(MeshSvg, StaysInsideThePage) {
    for (const Mesh& mesh : meshes_of_every_kind()) {
        const SvgReader svg(svg_of(sample_snapshot(mesh), {.width_mm = 84}));
        double width = 0, height = 0;
        std::istringstream box(std::string(svg.root().Attribute("viewBox")).substr(4));
        box >> width >> height;
        EXPECT_NEAR(width, 84 * 72 / 25.4, 0.01);
        std::size_t points = 0;
        for (const auto* path : svg.all("path"))
            for (const auto& stroke : read_path(path->Attribute("d")))
                for (const auto& p : stroke.corners) {
                    ++points;
                    EXPECT_TRUE(p.x >= 0 && p.x <= width && p.y >= 0 && p.y <= height)
                        << cell_name(mesh.kind);
                }
        EXPECT_GT(points, 8u) << cell_name(mesh.kind);
    }
}

TEST(MeshSvg, CellsHaveTheColoursOfTheirClasses) {
    const SvgReader svg(svg_of(sample_snapshot(unit_square_mesh(20)), {.classes = 5}));
    std::set<std::string> fills;
    for (const auto* path : svg.all("path", svg.with_id("cells"))) fills.insert(path->Attribute("fill"));
    EXPECT_EQ(fills.size(), 5u);
    std::set<std::string> legend;
    for (const auto* rect : svg.all("rect", svg.with_id("legend"))) legend.insert(rect->Attribute("fill"));
    legend.erase("none");
    EXPECT_EQ(legend, fills);
    const auto texts = svg.texts();
    EXPECT_EQ(texts[0], "monitor");
    EXPECT_GT(texts.size(), 3u) << "ticks";
}

TEST(MeshSvg, ALogarithmicLegendHasDecades) {
    Snapshot snapshot = sample_snapshot(unit_square_mesh(20));
    for (std::size_t i = 0; i < snapshot.x.size(); ++i)
        snapshot.fields[0].values[i] = std::pow(10.0, 3 * snapshot.mesh->nodes.x[i]);
    const SvgReader svg(svg_of(snapshot, {.classes = 3}, {.logarithmic = true}));
    const auto texts = svg.texts();
    EXPECT_EQ(texts, (std::vector<std::string>{"monitor", "100", "101", "102", "103"})); // raised digits
    const auto cells = strokes_in(svg, "cells");
    ASSERT_EQ(cells.size(), 3u);
    for (const auto& part : cells)
        EXPECT_NEAR(area_of({part}) / area_of(cells), 1.0 / 3, 0.08) << "a decade each";
}

TEST(MeshSvg, TheLegendHasRoomForItsWords) {
    Snapshot snapshot = sample_snapshot(unit_square_mesh(4));
    snapshot.fields.push_back(
        {{.name = "mass", .place = FieldPlace::cell}, snapshot.field("jacobian")->values});
    const SvgReader svg(svg_of(snapshot, {.width_mm = 80}, {.colouring = "equidistribution"}));
    const auto* title = svg.all("text")[0];
    EXPECT_STREQ(title->GetText(), "equidistribution");
    EXPECT_LE(title->DoubleAttribute("x") + svg_text_width("equidistribution"), 80 * points_per_mm);
    double right = 0;
    for (const auto& stroke : strokes_in(svg, "edges"))
        for (const auto& p : stroke.corners) right = std::max(right, p.x);
    EXPECT_LT(right, title->DoubleAttribute("x"));
    // An odd number of classes of a diverging map: the middle one for zero.
    EXPECT_EQ(svg.all("rect", svg.with_id("legend")).size(), 17u + 1) << "and the bar's outline";
}

TEST(MeshSvg, ADirectionTurnsAMeshInSpace) {
    Snapshot snapshot = sample_snapshot(two_cubes());
    snapshot.x = snapshot.mesh->nodes;
    const MeshSvgOptions from_above{.camera = "right 1 0 0 up 0 1 0"};
    EXPECT_EQ(strokes_in(SvgReader(svg_of(snapshot, from_above)), "cells").size(), 2u);
}

TEST(MeshSvg, TheBackgroundIsWhiteAColourOrNone) {
    const Snapshot snapshot = sample_snapshot(unit_square_mesh(4));
    const std::string white = svg_of(snapshot);
    const auto rect = white.find("<rect width=");
    ASSERT_NE(rect, std::string::npos);
    EXPECT_LT(rect, white.find("<g id=\"cells\""));
    const auto end = white.find('\n', rect) + 1;
    const std::string none = white.substr(0, rect) + white.substr(end);
    EXPECT_EQ(svg_of(snapshot, {.background = parse_background("transparent")}), none);
    std::string filled = white;
    filled.replace(filled.find("#fff", rect), 4, "#fff1d6");
    EXPECT_EQ(svg_of(snapshot, {.background = parse_background("#FFF1d6")}), filled);
}

TEST(MeshSvg, ACameraOnACornerShowsThatCorner) {
    Snapshot snapshot = sample_snapshot(unit_square_mesh(12));
    snapshot.x = snapshot.mesh->nodes;
    const SvgReader svg(svg_of(snapshot, {.camera = "centre 0.875 0.875 height 0.25", .aspect = 1}));
    const auto clips = svg.all("clipPath");
    ASSERT_EQ(clips.size(), 1u);
    const auto* rect = clips[0]->FirstChildElement("rect");
    const double left = rect->DoubleAttribute("x"), top = rect->DoubleAttribute("y");
    const double width = rect->DoubleAttribute("width"), height = rect->DoubleAttribute("height");
    EXPECT_NEAR(width, height, 0.01);
    EXPECT_GT(width, 250) << "points";
    // The mesh ends at x = y = 1, which is the upper right corner; a cell is a third of the view wide.
    double right_end = 0, upper_end = 1e9;
    std::size_t segments = 0;
    for (const auto& stroke : strokes_in(svg, "edges")) {
        segments += stroke.corners.size() - 1;
        for (const auto& p : stroke.corners) {
            right_end = std::max(right_end, p.x), upper_end = std::min(upper_end, p.y);
            EXPECT_NEAR(std::remainder(p.x - left, width / 3), 0, 0.02);
            EXPECT_NEAR(std::remainder(p.y - top, height / 3), 0, 0.02);
        }
    }
    EXPECT_NEAR(right_end, left + width, 0.02);
    EXPECT_NEAR(upper_end, top, 0.02);
    EXPECT_EQ(segments, 2u * 4 * 5) << "the 3 x 3 visible cells and those that touch them";
}

TEST(MeshSvg, ACameraTurnsAndCropsAMeshInSpace) {
    Snapshot snapshot = sample_snapshot(two_cubes());
    snapshot.x = snapshot.mesh->nodes;
    const std::string axes = " right 1 0 0 up 0 1 0";
    const SvgReader both(svg_of(snapshot, {.camera = "centre 1 0.5 1 height 4" + axes}));
    EXPECT_EQ(strokes_in(both, "cells").size(), 2u);
    const SvgReader one(svg_of(snapshot, {.camera = "centre 0.25 0.5 1 height 0.1" + axes}));
    EXPECT_EQ(strokes_in(one, "cells").size(), 1u) << "the other cube is far outside";
}

TEST(MeshSvg, WithoutACameraTheAspectSaysNothing) {
    const Snapshot snapshot = sample_snapshot(unit_square_mesh(4));
    EXPECT_EQ(svg_of(snapshot, {.aspect = 2}), svg_of(snapshot));
    EXPECT_EQ(svg_of(snapshot).find("clip"), std::string::npos);
}

TEST(MeshSvg, ACameraThatCannotBeReadIsAnInputError) {
    const Snapshot snapshot = sample_snapshot(unit_square_mesh(2));
    EXPECT_THROW(svg_of(snapshot, {.camera = "somewhere"}), InputError);
}

TEST(MeshSvg, FieldsOfCellsFillTooAndWithoutAFieldNothingDoes) {
    const Snapshot snapshot = sample_snapshot(unit_square_mesh(4));
    const SvgReader cells(svg_of(snapshot, {}, {.colouring = "jacobian"}));
    EXPECT_EQ(cells.texts()[0], "Jacobian");
    EXPECT_EQ(cells.all("path", cells.with_id("cells")).size(), 16u) << "one class for each of the 16 values";
    const SvgReader white(svg_of(snapshot, {}, {.colouring = "none"}));
    EXPECT_TRUE(white.texts().empty());
    EXPECT_EQ(strokes_in(white, "cells").size(), 1u);
}

/// u = x on a square of n x n cells that are moved.
Snapshot ramp(int n) {
    Snapshot snapshot = sample_snapshot(unit_square_mesh(n));
    snapshot.fields[0].values = snapshot.x.x;
    return snapshot;
}

TEST(MeshSvg, ContourLinesAreLongAndLieWhereTheFieldHasTheirLevels) {
    const SvgReader plain(svg_of(ramp(10)));
    EXPECT_TRUE(strokes_in(plain, "contours").empty());
    EXPECT_EQ(plain.texts()[1].find("contours"), std::string::npos);
    const Snapshot snapshot = ramp(10);
    const auto [low, high] = std::minmax_element(snapshot.x.x.begin(), snapshot.x.x.end());
    const SvgReader svg(svg_of(snapshot, {}, {.contours = 5}));
    EXPECT_EQ(svg.texts()[1], "contours every 0.2");
    double left = 1e9, right = 0;
    for (const auto& stroke : strokes_in(svg, "cells"))
        for (const auto& p : stroke.corners) left = std::min(left, p.x), right = std::max(right, p.x);
    const auto strokes = strokes_in(svg, "contours");
    const auto levels = make_colouring(snapshot, {.contours = 5})->contours.values;
    EXPECT_EQ(strokes.size(), levels.size()) << "one long line for each";
    std::set<long> seen;
    for (const auto& stroke : strokes)
        for (const auto& p : stroke.corners) {
            const double u = *low + (p.x - left) / (right - left) * (*high - *low);
            EXPECT_NEAR(u * 5, std::round(u * 5), 0.002);
            seen.insert(std::lround(u * 5));
        }
    EXPECT_EQ(seen.size(), levels.size());
}

TEST(MeshSvg, ContourLinesOfASphereAreDrawnWithItsFaces) {
    const Snapshot snapshot = sample_snapshot(round_octahedron());
    const auto lines = [&](int contours) {
        const SvgReader svg(svg_of(snapshot, {}, {.contours = contours}));
        std::size_t count = 0;
        for (const auto* path : svg.all("path", svg.with_id("cells")))
            count += path->Attribute("fill") != nullptr && std::string(path->Attribute("fill")) == "none";
        return count;
    };
    EXPECT_EQ(lines(0), 0u);
    EXPECT_GE(lines(10), 3u) << "faces that are seen";
}

TEST(MeshSvg, HeightsMakeAPlaneMeshASurface) {
    const Snapshot snapshot = ramp(6);
    // Seen from the front, along y, u = x is a rising line: half as high as the domain is long.
    const std::string front = "right 1 0 0 up 0 0 1";
    const SvgReader svg(svg_of(snapshot, {.elevation = 1, .elevation_camera = front}));
    double left = 1e9, right = 0, top = 1e9, bottom = 0;
    for (const auto& stroke : strokes_in(svg, "cells"))
        for (const auto& p : stroke.corners) {
            left = std::min(left, p.x), right = std::max(right, p.x);
            top = std::min(top, p.y), bottom = std::max(bottom, p.y);
        }
    const auto [low, high] = std::minmax_element(snapshot.x.x.begin(), snapshot.x.x.end());
    EXPECT_NEAR((bottom - top) / (right - left), 0.5 / (*high - *low), 1e-3);
    EXPECT_EQ(svg_of(snapshot, {.elevation = 0, .elevation_camera = front}), svg_of(snapshot));
    EXPECT_EQ(svg_of(snapshot, {.camera = "centre 0 0 height 1", .elevation = 1}),
              svg_of(snapshot, {.elevation = 1}))
        << "the camera of the flat mesh is another";
}

TEST(MeshSvg, TangledCellsStandOut) {
    Snapshot snapshot = sample_snapshot(unit_square_mesh(5));
    EXPECT_EQ(SvgReader(svg_of(snapshot)).with_id("tangled"), nullptr);
    snapshot.fields[1].values[7] = -0.25;
    snapshot.fields[1].values[8] = 0;
    const SvgReader svg(svg_of(snapshot));
    EXPECT_EQ(svg.texts().back(), "2 tangled cells");
    const auto* veil = svg.with_id("veil");
    ASSERT_NE(veil, nullptr);
    EXPECT_EQ(strokes_in(svg, "veil").size(), 2u);
    ASSERT_NE(veil->Attribute("opacity"), nullptr) << "as one: twice covered is no darker";
    EXPECT_EQ(std::string(veil->Attribute("opacity")), ".45");
    EXPECT_EQ(strokes_in(svg, "tangled").size(), 2u * 4) << "two rings, the veil, the outline";
    const Snapshot untangled = sample_snapshot(unit_square_mesh(5));
    EXPECT_GE(strokes_in(svg, "cells").size(), strokes_in(SvgReader(svg_of(untangled)), "cells").size())
        << "they have their colours below the veil";
    // Above everything else of the mesh.
    bool edges_seen = false;
    for (auto* e = svg.root().FirstChildElement(); e; e = e->NextSiblingElement()) {
        const char* id = e->Attribute("id");
        if (id && std::string(id) == "edges") edges_seen = true;
        if (id && std::string(id) == "tangled") {
            EXPECT_TRUE(edges_seen);
        }
    }
}

TEST(MeshSvg, ACurvedEdgeIsItsParabola) {
    Mesh mesh = of_order_two(unit_square_mesh(1));
    Snapshot snapshot = sample_snapshot(mesh);
    snapshot.x = mesh.nodes;
    for (std::size_t i = 0; i < mesh.node_count(); ++i)
        if (mesh.nodes[i] == Vec3{0.5, 1, 0}) snapshot.x.y[i] = 1.25;
    const auto strokes = strokes_in(SvgReader(svg_of(snapshot)), "cells");
    ASSERT_EQ(strokes.size(), 1u);
    ASSERT_EQ(strokes[0].controls.size(), 1u);
    // Corners at heights 0 and 1, the middle at 1.25: the control point at 1.5.
    double bottom = 0, top = 1e9;
    for (const auto& p : strokes[0].corners) bottom = std::max(bottom, p.y), top = std::min(top, p.y);
    EXPECT_NEAR((bottom - strokes[0].controls[0].y) / (bottom - top), 1.5, 1e-3);
}

TEST(MeshSvg, OfASolidOnlyTheFrontIsDrawn) {
    Snapshot snapshot = sample_snapshot(two_cubes());
    snapshot.x = snapshot.mesh->nodes;
    const SvgReader svg(svg_of(snapshot));
    EXPECT_EQ(strokes_in(svg, "cells").size(), 5u) << "right, two on top, two at a side";
}

TEST(MeshSvg, AClosedSurfaceMayFaceInwardAsAWhole) {
    const Facets faces = border(two_cubes());
    Mesh box = two_cubes();
    box.kind = faces.kind;
    box.cells = faces.nodes;
    Mesh inward = box;
    for (std::size_t f = 0; f < faces.size(); ++f)
        std::swap(inward.cells[4 * f + 1], inward.cells[4 * f + 3]);
    std::vector<std::set<std::pair<double, double>>> seen;
    for (const Mesh& mesh : {box, inward}) {
        const auto faces_seen = strokes_in(SvgReader(svg_of(sample_snapshot(mesh))), "cells");
        EXPECT_EQ(faces_seen.size(), 5u);
        seen.emplace_back();
        for (const auto& stroke : faces_seen)
            for (const auto& p : stroke.corners)
                seen.back().emplace(std::round(10 * p.x), std::round(10 * p.y));
    }
    EXPECT_EQ(seen[0], seen[1]) << "the same corners: those in front";
}

TEST(MeshSvg, ACurveInThePlaneIsALine) {
    Mesh mesh = three_lines();
    mesh.space_dimension = 2;
    mesh.nodes.y = {0, 0.5, 0.25, 0.125};
    const SvgReader svg(svg_of(sample_snapshot(mesh)));
    EXPECT_EQ(svg.all("circle").size(), 6u);
    EXPECT_EQ(svg.with_id("cells"), nullptr);
}

TEST(MeshSvg, AMeshOf120By120CellsIsSmall) {
    Snapshot snapshot = sample_snapshot(unit_square_mesh(120));
    for (std::size_t i = 0; i < snapshot.x.size(); ++i) // a bell
        snapshot.fields[0].values[i] =
            1 + 50 * std::exp(-30 * (std::pow(snapshot.x.x[i] - .5, 2) + std::pow(snapshot.x.y[i] - .5, 2)));
    const std::string text = svg_of(snapshot);
    EXPECT_LT(text.size(), 500'000u);
    EXPECT_GT(text.size(), 200'000u) << "is the mesh there?";
}

TEST(MeshSvg, NumbersHaveAPointUnderACommaLocale) {
    const Snapshot snapshot = sample_snapshot(unit_square_mesh(40));
    const std::string plain = svg_of(snapshot);
    const CommaLocale comma;
    EXPECT_EQ(svg_of(snapshot), plain);
}

TEST(MeshSvg, WhatIsNotFiniteIsAFault) {
    Snapshot position = sample_snapshot(two_triangles()), field = position;
    position.x.x[0] = std::numeric_limits<double>::quiet_NaN();
    field.fields[0].values[1] = std::numeric_limits<double>::infinity();
    EXPECT_THROW(svg_of(position), InternalError);
    EXPECT_THROW(svg_of(field), InternalError);
}

} // namespace
} // namespace gaspard
