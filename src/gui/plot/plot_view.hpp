// A plot as it is drawn: the numbers are owned elsewhere and only referenced, so that a frame of the
// window copies none of them.
#pragma once

#include "core/tessellate/extremes.hpp"
#include "core/tessellate/plot.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct CurveView {
    std::string label;     ///< empty: no entry in the legend
    std::string_view part; ///< "min", where a label has several curves; only the first is in the legend
    std::span<const double> x, y;
    const Extremes* extremes = nullptr; ///< of y, if there are any; then x must never decrease
    std::size_t colour = 0;             ///< which of the theme's
    bool markers = false;               ///< a disc on every point
    bool behind = false;                ///< thinner, and below those that are not
    bool linear = false;                ///< as in Curve
    std::string_view name{};            ///< as in Curve
    float opacity = 1;                  ///< below 1: faded, and not what the axes span
};

struct RowView {
    std::span<const double> x;
    std::size_t colour = 0;
};

struct MarkView {
    double x = 0;
    std::string_view label;
    std::size_t colour = 0;
    bool handle = false; ///< as in PlotMark
};

/// As PlotLevel.
struct LevelView {
    double y = 0;
    std::string label;
};

struct PlotView {
    std::string_view title;
    Axis x, y;
    std::vector<CurveView> curves;
    std::vector<MarkView> marks;
    std::vector<RowView> rows{};
    std::vector<LevelView> levels{};
    float left = 0, right = 0; ///< pixels beside the curves, at least; to align plots with each other
};

/// Valid as long as the plot is.
inline PlotView view_of(const Plot& plot) {
    PlotView view{.title = plot.title, .x = plot.x, .y = plot.y, .curves = {}, .marks = {}};
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const Curve& curve = plot.curves[i];
        view.curves.push_back({.label = curve.label,
                               .part = {},
                               .x = curve.x,
                               .y = curve.y,
                               .colour = curve.colour.value_or(i),
                               .markers = curve.markers,
                               .behind = curve.behind,
                               .linear = curve.linear,
                               .name = curve.name});
    }
    for (const PlotRow& row : plot.rows) view.rows.push_back({row.x, row.colour});
    for (const PlotLevel& level : plot.levels) view.levels.push_back({level.y, level.label});
    for (const PlotMark& mark : plot.marks)
        view.marks.push_back({.x = mark.x, .label = mark.label, .handle = mark.handle});
    return view;
}

} // namespace gaspard
