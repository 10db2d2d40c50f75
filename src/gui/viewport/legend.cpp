#include "gui/viewport/legend.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace gaspard {

namespace {

// At scale 1.
constexpr float legend_margin = 9, legend_gap = 6, bar_width = 14, histogram_width = 30, pad = 8;
constexpr const char* widest_label = "-1.25×10⁻³"; // the width reserved for labels

float label_width() { return ImGui::CalcTextSize(widest_label).x; }

float legend_line_height() { return ImGui::GetFontSize() * 1.35F; }

std::string title_of(const Colouring& colouring, bool with_symbol) {
    return colouring.label + (with_symbol && !colouring.symbol.empty() ? " " + colouring.symbol : "") +
           (colouring.range.logarithmic ? " (log)" : "");
}

/// "monitor m"; without the symbol where the legend would be wider for it.
std::string fitting_title(const Colouring& colouring, float width) {
    std::string title = title_of(colouring, true);
    return ImGui::CalcTextSize(title.c_str()).x <= width ? title : title_of(colouring, false);
}

constexpr const char* widest_remark = "contours every 2×10⁻¹⁰"; // the width reserved for them

/// Below the title: how values between the nodes are found, if each cell has not one value, and the levels of
/// contour lines.
std::vector<std::string> remarks_of(const Colouring& colouring) {
    std::vector<std::string> remarks;
    if (colouring.place == FieldPlace::node) remarks.emplace_back("interpolated");
    if (!colouring.contours.values.empty()) remarks.push_back("contours " + colouring.contours.text);
    return remarks;
}

struct Frame {
    ScreenRect all;   ///< with its title
    ImVec2 low, high; ///< the bar
};

Frame frame_of(const Colouring& colouring, bool histogram, ScreenRect available, float scale) {
    const float line = legend_line_height();
    const float width = legend_width(colouring, histogram, scale) - 2 * legend_margin * scale;
    const float above = line * static_cast<float>(1 + remarks_of(colouring).size());
    const float free = available.height() - above - line - 2 * (pad + legend_gap) * scale;
    const float height =
        std::round(std::max(std::min(free, std::min(0.66F * available.height(), 420 * scale)), 1.0F));
    const float left = std::round(available.max.x - legend_margin * scale - width);
    const float top = std::round((available.min.y + available.max.y - height + line) / 2);
    const float bar = std::round(left + (histogram ? histogram_width * scale : 0));
    return {{{left - pad * scale, top - above - pad * scale},
             {left + width + pad * scale, top + height + pad * scale + line / 2}},
            {bar, top},
            {bar + std::round(bar_width * scale), top + height}};
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

/// Bars to the left of the colours.
void draw_histogram(ImDrawList& list, const Colouring& colouring, HistogramCounts how, ImVec2 low,
                    ImVec2 high, const Theme& theme, float scale) {
    const auto& counts = colouring.histogram;
    const std::uint32_t most = *std::max_element(counts.begin(), counts.end());
    if (most == 0) return;
    const auto y = [&](std::size_t k) {
        return std::round(high.y -
                          (high.y - low.y) * static_cast<float>(k) / static_cast<float>(counts.size()));
    };
    const float longest = (histogram_width - 4) * scale, right = low.x - 2 * scale;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        if (counts[k] == 0) continue;
        const float length = std::max(longest * histogram_length(counts[k], most, how), 1.5F * scale);
        list.AddRectFilled({right - length, y(k + 1)}, {right, y(k)}, packed(theme.faint_text, 0.85F));
    }
}

/// The levels of contour lines, as strokes across the bar.
void draw_levels(ImDrawList& list, const Colouring& colouring, ImVec2 low, ImVec2 high, const Theme& theme,
                 float scale) {
    for (const double level : colouring.contours.values) {
        const double place = colouring.range.position(level);
        const bool dark = is_dark(colour_at(*colouring.map, place));
        const float y = high.y - static_cast<float>(place) * (high.y - low.y), half = 0.6F * scale;
        list.AddRectFilled({low.x, y - half}, {high.x, y + half},
                           packed(opaque(dark ? theme.line_on_dark : theme.line_on_light)));
    }
}

/// A tip at an end of the bar where values go on beyond it.
void draw_tips(ImDrawList& list, const Colouring& colouring, ImVec2 low, ImVec2 high, float scale) {
    const auto tip = [&](double at, float y, float direction) {
        const auto c = colour_at(*colouring.map, at);
        const ImVec2 a{low.x, y}, b{high.x, y}, top{(low.x + high.x) / 2, y + direction * 7 * scale};
        list.AddTriangleFilled(a, direction < 0 ? top : b, direction < 0 ? b : top,
                               IM_COL32(c[0], c[1], c[2], 255));
    };
    if (colouring.above) tip(1, low.y, -1);
    if (colouring.below) tip(0, high.y, 1);
}

} // namespace

std::vector<Tick> legend_ticks(const ColourRange& range) {
    if (!(range.high > range.low)) return {{range.low, short_number(range.low, 4), true}};
    std::vector<Tick> ticks =
        range.logarithmic ? log_ticks(range.low, range.high, 6) : linear_ticks(range.low, range.high, 6);
    std::erase_if(ticks, [&](const Tick& tick) {
        const double at = range.position(tick.value);
        return tick.label.empty() || at < 0.07 || at > 0.93;
    });
    // A zero that rounding has missed is a zero.
    const auto label = [&](double value) {
        return short_number(std::abs(value) < 1e-10 * (range.high - range.low) ? 0 : value, 3);
    };
    ticks.push_back({range.low, range.logarithmic ? short_number(range.low, 3) : label(range.low), true});
    ticks.push_back({range.high, label(range.high), true});
    return ticks;
}

float legend_width(const Colouring& colouring, bool histogram, float scale) {
    const float bar = (bar_width + legend_gap + (histogram ? histogram_width : 0)) * scale + label_width();
    float text = ImGui::CalcTextSize(title_of(colouring, false).c_str()).x;
    if (!colouring.contours.values.empty()) text = std::max(text, ImGui::CalcTextSize(widest_remark).x);
    return std::max(bar, text) + 2 * legend_margin * scale;
}

HistogramCounts histogram_counts(std::string_view choice) {
    if (choice == "linear") return HistogramCounts::linear;
    return choice == "logarithmic" ? HistogramCounts::logarithmic : HistogramCounts::square_root;
}

/// By default the square root: with the counts themselves, a mesh that has one colour nearly everywhere would
/// show one bar and nothing else. A logarithmic bar of one value is as long as log 2 / log (1 + most).
float histogram_length(std::uint32_t count, std::uint32_t most, HistogramCounts counts) {
    if (count == 0 || most == 0) return 0;
    if (counts == HistogramCounts::logarithmic)
        return std::log1p(static_cast<float>(count)) / std::log1p(static_cast<float>(most));
    const float share = static_cast<float>(count) / static_cast<float>(most);
    return counts == HistogramCounts::linear ? share : std::sqrt(share);
}

LegendPlaces legend_places(const Colouring& colouring, bool histogram, ScreenRect available, float scale) {
    const Frame frame = frame_of(colouring, histogram, available, scale);
    const auto number = [&](float y) {
        const float left = frame.high.x + legend_gap * scale, half = legend_line_height() / 2;
        return ScreenRect{{left, y - half}, {left + label_width(), y + half}};
    };
    return {frame.all, {frame.low, frame.high}, number(frame.high.y), number(frame.low.y)};
}

void draw_legend(ImDrawList& list, const Colouring& colouring, bool histogram, HistogramCounts counts,
                 ScreenRect available, const Theme& theme, float scale) {
    const Frame frame = frame_of(colouring, histogram, available, scale);
    const auto [low, high] = std::pair(frame.low, frame.high);
    list.AddRectFilled(frame.all.min, frame.all.max, packed(theme.background, 0.82F), 6 * scale);
    list.AddText({frame.all.min.x + pad * scale, frame.all.min.y + pad * scale / 2}, packed(theme.text),
                 fitting_title(colouring, frame.all.width() - 2 * pad * scale).c_str());
    draw_bar(list, *colouring.map, low, high);
    draw_levels(list, colouring, low, high, theme, scale);
    if (histogram) draw_histogram(list, colouring, counts, low, high, theme, scale);
    draw_tips(list, colouring, low, high, scale);
    float y = frame.all.min.y + pad * scale / 2;
    for (const std::string& remark : remarks_of(colouring))
        list.AddText({frame.all.min.x + pad * scale, y += legend_line_height()}, packed(theme.faint_text),
                     remark.c_str());
    for (const Tick& tick : legend_ticks(colouring.range)) {
        const float at = static_cast<float>(colouring.range.position(tick.value));
        const float mark = std::round(high.y - at * (high.y - low.y));
        const float from_end =
            std::min(high.y - mark, mark - low.y); // on a short bar the ends have their labels
        if (at > 0 && at < 1 && from_end < ImGui::GetFontSize()) continue;
        list.AddRectFilled({high.x, mark}, {high.x + 3 * scale, mark + std::max(1.0F, std::round(scale))},
                           packed(theme.faint_text));
        list.AddText({high.x + legend_gap * scale, mark - ImGui::GetFontSize() / 2},
                     packed(theme.text, 0.85F), tick.label.c_str());
    }
}

} // namespace gaspard
