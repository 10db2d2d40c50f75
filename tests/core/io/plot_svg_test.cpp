#include "core/io/svg.hpp"
#include "core/io/svg_document.hpp"
#include "support/svg_reader.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace gaspard {
namespace {

TEST(PlotSvg, LabelsOfTheAxesDoNotTouchAtAnySize) {
    for (const double width : {30.0, 45.0, 84.0})
        for (const double height : {18.0, 25.0, 35.0, 60.0})
            for (const double factor : {1.2, 1.3, 2.0, 8.0, 300.0}) {
                SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height) + ", " +
                             std::to_string(factor));
                Plot plot{"", {"x", false}, {"y", true}, {{}}};
                plot.curves[0].x = {0.52, 0.52 * factor};
                plot.curves[0].y = {0.52, 0.52 * factor};
                const SvgReader svg(svg_of_plot(plot, {.width_mm = width, .height_mm = height}));
                double below = 1e9, right = -1e9;
                for (const auto* text : svg.all("text")) {
                    if (text->Attribute("transform")) continue;
                    const std::string label = text->GetText() ? text->GetText() : "";
                    const double x = text->DoubleAttribute("x"), y = text->DoubleAttribute("y");
                    const std::string anchor =
                        text->Attribute("text-anchor") ? text->Attribute("text-anchor") : "";
                    if (label == "x") continue;
                    if (anchor == "end") {
                        EXPECT_GE(below - y, 0.999 * svg_font_size) << label;
                        below = y;
                    } else {
                        const double half = svg_text_width(label) / 2;
                        EXPECT_GE(x - half, right) << label;
                        right = x + half;
                    }
                }
            }
}

TEST(PlotSvg, ALevelIsADashedLineWithItsName) {
    Plot plot{"", {"x", false}, {"y", true}, {{"", {0, 1, 2}, {1, 1e-2, 1e-4}}}};
    plot.levels.push_back({1e-9, "tolerance 10⁻⁹"});
    const SvgReader svg(svg_of_plot(plot));
    std::size_t dashed = 0;
    for (const auto* path : svg.all("path")) dashed += path->Attribute("stroke-dasharray") != nullptr;
    EXPECT_EQ(dashed, 1U) << "the axis reaches down to it";
    const auto texts = svg.texts();
    EXPECT_NE(std::find(texts.begin(), texts.end(), "tolerance 10−9"), texts.end());
}

} // namespace
} // namespace gaspard
