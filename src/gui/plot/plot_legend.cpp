#include "gui/plot/plot_legend.hpp"

#include "gui/base/plot_text.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace gaspard {

namespace {

struct LegendEntry {
    std::string text;
    const CurveView* curve = nullptr; ///< null: the entry of several curves
};

/// One entry per label, as many as fit.
std::vector<LegendEntry> entries_of(const PlotView& plot, float width, std::size_t fitting) {
    std::vector<LegendEntry> entries;
    const CurveView* before = nullptr;
    for (const CurveView& curve : plot.curves) {
        const bool repeated = before && !curve.part.empty() && before->label == curve.label;
        if (!curve.label.empty() && !repeated) entries.push_back({shortened(curve.label, width), &curve});
        before = &curve;
    }
    if (entries.size() <= fitting) return entries;
    const std::size_t left_out = entries.size() - fitting + 1;
    entries.resize(fitting);
    entries.back() = {"and " + std::to_string(left_out) + " more", nullptr};
    return entries;
}

} // namespace

ScreenRect legend_place(const std::vector<PixelPath>& paths, ScreenRect area, ImVec2 size, float margin) {
    const float left = area.min.x + margin, right = area.max.x - margin - size.x;
    const float top = area.min.y + margin, bottom = area.max.y - margin - size.y;
    ScreenRect best;
    double least = std::numeric_limits<double>::infinity();
    const float middle = (left + right) / 2;
    for (const ImVec2 corner : {ImVec2{right, top}, ImVec2{left, bottom}, ImVec2{left, top},
                                ImVec2{right, bottom}, ImVec2{middle, bottom}, ImVec2{middle, top}}) {
        const ScreenRect place{corner, {corner.x + size.x, corner.y + size.y}};
        double hidden = 0;
        for (const PixelPath& path : paths) hidden += length_within(path, place);
        // Only clearly better ones count, so that the legend does not jump while curves grow.
        if (hidden < 0.7 * least) best = place, least = hidden;
        if (least < static_cast<double>(margin)) break;
    }
    return best;
}

void draw_legend(ImDrawList& list, const PlotView& plot, const std::vector<PixelPath>& paths,
                 const PlotFrame& frame, const Theme& theme, float scale) {
    const float line = ImGui::GetFontSize() * 1.25F, pad = 7 * scale, sample = 16 * scale;
    const float available = 0.7F * frame.area.width() - sample - 3 * pad;
    const float lines = (0.6F * frame.area.height() - pad) / line;
    if (lines < 2 || available < 3 * line) return;
    const std::vector<LegendEntry> entries = entries_of(plot, available, static_cast<std::size_t>(lines));
    if (entries.size() < 2) return;
    float width = 0;
    for (const LegendEntry& entry : entries) width = std::max(width, text_size(entry.text).x);
    const ImVec2 size{width + sample + 3 * pad, line * static_cast<float>(entries.size()) + pad};
    const ScreenRect box = legend_place(paths, frame.area, size, pad);
    list.AddRectFilled(box.min, box.max, packed(theme.panel, 0.88F), 4 * scale);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const float top = box.min.y + pad / 2 + line * static_cast<float>(i), middle = top + line / 2;
        const float left = box.min.x + pad;
        if (const CurveView* curve = entries[i].curve)
            list.AddLine({left, middle}, {left + sample, middle}, packed(curve_colour(theme, curve->colour)),
                         (curve->behind ? 1.5F : 2.0F) * scale);
        write_text(list, {left + sample + pad, middle - ImGui::GetFontSize() / 2}, theme.text,
                   entries[i].text);
    }
}

} // namespace gaspard
