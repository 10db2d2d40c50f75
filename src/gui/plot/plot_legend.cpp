#include "gui/plot/plot_legend.hpp"

#include "gui/base/plot_text.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace gaspard {

namespace {

struct LegendEntry {
    std::string text, whole;          ///< as it is written, and as it is
    const CurveView* curve = nullptr; ///< null: the entry of several curves
};

/// One entry per label.
std::vector<LegendEntry> names_of(const PlotView& plot) {
    std::vector<LegendEntry> entries;
    const CurveView* before = nullptr;
    for (const CurveView& curve : plot.curves) {
        const bool repeated = before && !curve.part.empty() && before->label == curve.label;
        if (!curve.label.empty() && !repeated) entries.push_back({curve.label, curve.label, &curve});
        before = &curve;
    }
    return entries;
}

/// As many as fit.
std::vector<LegendEntry> entries_of(const PlotView& plot, float width, std::size_t fitting) {
    std::vector<LegendEntry> entries = names_of(plot);
    for (LegendEntry& entry : entries) entry.text = shortened(entry.text, width);
    if (entries.size() <= fitting) return entries;
    const std::size_t left_out = entries.size() - fitting + 1;
    std::string others;
    for (std::size_t i = fitting - 1; i < fitting - 1 + left_out; ++i)
        others += (others.empty() ? "" : "\n") + entries[i].whole;
    entries.resize(fitting);
    entries.back() = {"and " + std::to_string(left_out) + " more", others, nullptr};
    return entries;
}

struct LegendSizes {
    float line, pad, sample;
    explicit LegendSizes(float scale)
        : line(ImGui::GetFontSize() * 1.25F), pad(7 * scale), sample(16 * scale) {}
};

/// An entry with its left end at `corner`.
void draw_entry(ImDrawList& list, const LegendEntry& entry, ImVec2 corner, const LegendSizes& sizes,
                const Theme& theme, float scale) {
    const float middle = corner.y + sizes.line / 2;
    if (const CurveView* curve = entry.curve)
        list.AddLine({corner.x, middle}, {corner.x + sizes.sample, middle},
                     packed(curve_colour(theme, curve->colour)), (curve->behind ? 1.5F : 2.0F) * scale);
    write_text(list, {corner.x + sizes.sample + sizes.pad, middle - ImGui::GetFontSize() / 2}, theme.text,
               entry.text);
}

/// Calls `put(entry, place)` for entries in lines of this width; returns the height.
template <class Put>
float in_lines(const std::vector<LegendEntry>& entries, float width, const LegendSizes& sizes,
               const Put& put) {
    ImVec2 at{0, 0};
    for (const LegendEntry& entry : entries) {
        const float needed = sizes.sample + 3 * sizes.pad + text_size(entry.text).x;
        if (at.x > 0 && at.x + needed - 2 * sizes.pad > width) at = {0, at.y + sizes.line};
        put(entry, at);
        at.x += needed;
    }
    return at.y + sizes.line;
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

ImVec2 legend_strip(const PlotView& plot, ScreenRect area, float scale) {
    constexpr std::size_t few = 4; // are worth a box, whatever it hides
    const std::vector<LegendEntry> entries = names_of(plot);
    if (entries.size() <= few) return {0, 0};
    const LegendSizes sizes(scale);
    float widest = 0;
    for (const LegendEntry& entry : entries) widest = std::max(widest, text_size(entry.text).x);
    const float box =
        (widest + sizes.sample + 3 * sizes.pad) * sizes.line * static_cast<float>(entries.size());
    const float width = 0.85F * area.width(); // beside the labels of the y axis
    if (box < 0.08F * area.width() * area.height() || widest + sizes.sample + sizes.pad > width)
        return {0, 0};
    const float height = in_lines(entries, width, sizes, [](const LegendEntry&, ImVec2) {});
    return height > 0.4F * area.height() ? ImVec2{0, 0} : ImVec2{width, height};
}

std::string draw_legend(ImDrawList& list, const PlotView& plot, const std::vector<PixelPath>& paths,
                        const PlotFrame& frame, const Theme& theme, float scale, ImVec2 pointer) {
    const LegendSizes sizes(scale);
    const auto [line, pad, sample] = sizes;
    if (frame.legend_width > 0) {
        const std::vector<LegendEntry> all = names_of(plot);
        const auto nothing = [](const LegendEntry&, ImVec2) {};
        const float height = in_lines(all, frame.legend_width, sizes, nothing);
        const ImVec2 corner{frame.area.max.x - frame.legend_width,
                            frame.area.min.y - ImGui::GetFontSize() / 2 - height};
        in_lines(all, frame.legend_width, sizes, [&](const LegendEntry& entry, ImVec2 at) {
            draw_entry(list, entry, {corner.x + at.x, corner.y + at.y}, sizes, theme, scale);
        });
        return {};
    }
    const float available = frame.area.width() - sample - 5 * pad;
    const float lines = (0.6F * frame.area.height() - pad) / line;
    if (lines < 2 || available < 3 * line) return {};
    const std::vector<LegendEntry> entries = entries_of(plot, available, static_cast<std::size_t>(lines));
    if (entries.size() < 2) return {};
    float width = 0;
    for (const LegendEntry& entry : entries) width = std::max(width, text_size(entry.text).x);
    const ImVec2 size{width + sample + 3 * pad, line * static_cast<float>(entries.size()) + pad};
    const ScreenRect box = legend_place(paths, frame.area, size, pad);
    list.AddRectFilled(box.min, box.max, packed(theme.panel, 0.88F), 4 * scale);
    std::string whole;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const ImVec2 corner{box.min.x + pad, box.min.y + pad / 2 + line * static_cast<float>(i)};
        draw_entry(list, entries[i], corner, sizes, theme, scale);
        const ScreenRect place{corner, {box.max.x, corner.y + line}};
        if (place.contains(pointer) && entries[i].text != entries[i].whole) whole = entries[i].whole;
    }
    return whole;
}

} // namespace gaspard
