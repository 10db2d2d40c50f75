#include "gui/viewport.hpp"

#include "core/tessellate/ticks.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {

// At scale 1.
constexpr float margin = 14, gap = 6, bar_width = 14;

float line_height() { return ImGui::GetFontSize() * 1.35F; }

Colour status_colour(RunStatus status, const Theme& theme) {
    switch (status) {
    case RunStatus::converged:
        return theme.good;
    case RunStatus::iteration_limit:
    case RunStatus::stalled:
    case RunStatus::interrupted:
        return theme.warning;
    case RunStatus::diverged:
    case RunStatus::tangled:
    case RunStatus::failed:
        return theme.bad;
    case RunStatus::preparing:
    case RunStatus::running:
        break;
    }
    return theme.accent;
}

/// Parts of the caption, so many to a line as fit.
std::vector<std::vector<std::string>> caption_lines(const ViewportText& text, float width, float scale) {
    std::vector<std::vector<std::string>> lines;
    float used = width + 1;
    for (auto& part : caption_parts(text)) {
        const float need = ImGui::CalcTextSize(part.c_str()).x + 4 * gap * scale;
        if (used + need > width) {
            lines.emplace_back();
            used = 0;
        }
        used += need;
        lines.back().push_back(std::move(part));
    }
    return lines;
}

struct Legend {
    std::vector<Tick> ticks;
    float width = 0; ///< bar, gap and labels or title, whichever is wider
};

/// Both ends of the range, and round values that keep their distance from them.
std::vector<Tick> legend_ticks(const ColourRange& range) {
    std::vector<Tick> ticks = linear_ticks(range.low, range.high, 6);
    if (ticks.size() < 2) return ticks;
    std::erase_if(ticks, [&](const Tick& tick) {
        return range.position(tick.value) < 0.07 || range.position(tick.value) > 0.93;
    });
    ticks.push_back({range.low, short_number(range.low, 3), true});
    ticks.push_back({range.high, short_number(range.high, 3), true});
    return ticks;
}

Legend make_legend(const MeshPicture& picture, float scale) {
    Legend legend;
    if (picture.scalar == nullptr) return legend;
    legend.ticks = legend_ticks(picture.range);
    float labels = 0;
    for (const Tick& tick : legend.ticks)
        labels = std::max(labels, ImGui::CalcTextSize(tick.label.c_str()).x);
    legend.width =
        std::max((bar_width + gap) * scale + labels, ImGui::CalcTextSize(picture.scalar_name.c_str()).x);
    return legend;
}

void draw_bar(ImDrawList& list, const ColourMap& map, ImVec2 low, ImVec2 high) {
    constexpr int pieces = 64;
    const auto colour = [&](int i) {
        const auto c = colour_at(map, 1 - static_cast<double>(i) / pieces);
        return IM_COL32(c[0], c[1], c[2], 255);
    };
    for (int i = 0; i < pieces; ++i) {
        const auto y = [&](int k) { return low.y + (high.y - low.y) * static_cast<float>(k) / pieces; };
        list.AddRectFilledMultiColor({low.x, y(i)}, {high.x, y(i + 1)}, colour(i), colour(i), colour(i + 1),
                                     colour(i + 1));
    }
}

void draw_legend(ImDrawList& list, const MeshPicture& picture, ScreenRect room, const Theme& theme,
                 float scale) {
    const Legend legend = make_legend(picture, scale);
    if (legend.ticks.empty()) return;
    const float line = line_height(), pad = 8 * scale;
    const float height = std::min(0.62F * room.height(), 420 * scale);
    const float left = std::round(room.max.x - margin * scale - legend.width);
    const float top = std::round((room.min.y + room.max.y - height) / 2 + line / 2);
    const ImVec2 low = {left, top}, high = {left + std::round(bar_width * scale), std::round(top + height)};
    list.AddRectFilled({left - pad, top - line - pad}, {left + legend.width + pad, high.y + pad + line / 2},
                       packed(theme.background, 0.78F), 6 * scale);
    list.AddText({left, top - line - gap * scale / 2}, packed(theme.text), picture.scalar_name.c_str());
    draw_bar(list, colour_map(picture.map), low, high);
    for (const Tick& tick : legend.ticks) {
        const float at = static_cast<float>(picture.range.position(tick.value));
        const float y = std::round(high.y - at * (high.y - low.y));
        list.AddRectFilled({high.x, y}, {high.x + 3 * scale, y + std::max(1.0F, std::round(scale))},
                           packed(theme.faint_text));
        list.AddText({high.x + gap * scale, y - ImGui::GetFontSize() / 2}, packed(theme.faint_text),
                     tick.label.c_str());
    }
}

void draw_caption(ImDrawList& list, const ViewportText& text, ScreenRect rect, const Theme& theme,
                  float scale) {
    const auto lines = caption_lines(text, rect.width() - 2 * margin * scale, scale);
    const float height = line_height() * static_cast<float>(lines.size()) + gap * scale;
    float y = rect.max.y - height;
    list.AddRectFilled({rect.min.x, y}, rect.max, packed(theme.panel, 0.9F));
    y += gap * scale / 2;
    const Colour status = status_colour(text.report.status, theme);
    for (const auto& line : lines) {
        float x = rect.min.x + margin * scale;
        for (const std::string& part : line) {
            const bool is_status = &line == &lines.back() && &part == &line.back();
            const float top = y + (line_height() - ImGui::GetFontSize()) / 2;
            list.AddText({x, top}, packed(is_status ? status : theme.text), part.c_str());
            x += ImGui::CalcTextSize(part.c_str()).x + 4 * gap * scale;
        }
        y += line_height();
    }
}

} // namespace

std::vector<std::string> caption_parts(const ViewportText& text) {
    std::vector<std::string> parts;
    const StepReport& report = text.report;
    if (!text.subject.empty()) parts.push_back(text.subject);
    parts.push_back("iteration " + std::to_string(report.iteration));
    parts.push_back("residual " + short_number(report.residual, 3));
    if (report.equidistribution)
        parts.push_back("equidistribution " + short_number(*report.equidistribution, 4));
    if (report.tangled_cells.value_or(0) > 0)
        parts.push_back(std::to_string(*report.tangled_cells) +
                        (*report.tangled_cells == 1 ? " tangled cell" : " tangled cells"));
    parts.emplace_back(status_name(report.status));
    return parts;
}

Insets viewport_insets(const MeshPicture& picture, const ViewportText& text, Size area, float scale) {
    Insets insets;
    if (!text.title.empty()) insets.top = static_cast<double>(line_height() + margin * scale);
    const float legend = make_legend(picture, scale).width;
    if (legend > 0) insets.right = static_cast<double>(legend + 2 * margin * scale);
    if (text.caption) {
        const auto lines = caption_lines(text, static_cast<float>(area.width) - 2 * margin * scale, scale);
        insets.bottom = static_cast<double>(line_height() * static_cast<float>(lines.size()) + gap * scale);
    }
    // Where the legend's strip is free anyway beside a centred mesh, the mesh stays centred.
    const double free_side = (area.width - (area.height - insets.top - insets.bottom)) / 2;
    if (free_side > insets.right) insets.left = insets.right;
    return insets;
}

void draw_viewport_overlay(ImDrawList& list, const MeshPicture& picture, const ViewportText& text,
                           ScreenRect rect, const Theme& theme, float scale) {
    list.PushClipRect(rect.min, rect.max, true);
    const Size size{static_cast<double>(rect.width()), static_cast<double>(rect.height())};
    const Insets insets = viewport_insets(picture, text, size, scale);
    ScreenRect room = rect;
    room.min.y += static_cast<float>(insets.top);
    room.max.y -= static_cast<float>(insets.bottom);
    draw_legend(list, picture, room, theme, scale);
    if (text.caption) draw_caption(list, text, rect, theme, scale);
    if (!text.title.empty()) {
        const float width = ImGui::CalcTextSize(text.title.c_str()).x;
        list.AddText({(rect.min.x + rect.max.x - width) / 2, rect.min.y + margin * scale / 2},
                     packed(theme.text), text.title.c_str());
    }
    list.PopClipRect();
}

} // namespace gaspard
