#include "core/io/svg_legend.hpp"

#include "core/base/check.hpp"
#include "core/tessellate/ticks.hpp"

#include <cmath>

namespace gaspard {

namespace {

constexpr double bar_width = 10; // points

std::vector<Tick> ticks_of(const ColourRange& range, double height) {
    const int count = static_cast<int>(height / 20);
    return range.logarithmic ? log_ticks(range.low, range.high, count)
                             : linear_ticks(range.low, range.high, count);
}

} // namespace

double svg_luminance(std::array<unsigned char, 3> colour) {
    constexpr std::array weights = {0.2126, 0.7152, 0.0722};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double s = colour[i] / 255.0;
        sum += weights[i] * (s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
    }
    return sum;
}

SvgClasses::SvgClasses(const SvgScene& scene, const std::optional<Colouring>& colouring, int classes)
    : scene_(scene) {
    GASPARD_CHECK(classes >= 1);
    if (!colouring) return;
    range_ = colouring->range;
    int count = range_.low < range_.high ? classes : 1;
    if (colouring->map->diverging && count % 2 == 0) ++count; // one for the middle
    colours_.clear();
    for (int k = 0; k < count; ++k) colours_.push_back(colour_at(*colouring->map, (k + 0.5) / count));
}

/// Lines on these classes are seen: against either ink the contrast ratio is at least 3.
bool SvgClasses::wants_light_ink(std::size_t a, std::size_t b) const {
    return (svg_luminance(colours_[a]) + svg_luminance(colours_[b])) / 2 < 0.13;
}

std::string svg_block(double x, double y, double width, double height, const std::string& attributes) {
    return "<rect x=\"" + svg_number(x) + "\" y=\"" + svg_number(y) + "\" width=\"" + svg_number(width) +
           "\" height=\"" + svg_number(height) + "\" " + attributes + "/>\n";
}

std::vector<std::string> svg_legend_words(const Colouring& colouring) {
    if (colouring.contours.values.empty()) return {colouring.label};
    return {colouring.label, "contours " + colouring.contours.text};
}

double svg_legend_width(const Colouring& colouring, double height) {
    double width = 0;
    for (const std::string& words : svg_legend_words(colouring))
        width = std::max(width, svg_text_width(words));
    for (const Tick& tick : ticks_of(colouring.range, height))
        width = std::max(width, bar_width + 5 + svg_text_width(tick.label));
    return width;
}

std::string svg_colour_bar(const SvgClasses& classes, const Colouring& colouring, PagePoint corner,
                           double height) {
    const double block = height / static_cast<double>(classes.count());
    std::string text = "<g id=\"legend\" fill=\"#222\">\n";
    double top = corner.y;
    for (const std::string& words : svg_legend_words(colouring)) {
        text += svg_text({corner.x, top + 0.75 * svg_font_size}, Anchor::start, words);
        top += 1.5 * svg_font_size;
    }
    for (std::size_t k = 0; k < classes.count(); ++k)
        // Each up to the bar's top, the next one over it: no gap shines through between them.
        text += svg_block(corner.x, top, bar_width, height - static_cast<double>(k) * block,
                          "fill=\"" + classes.colour(k) + '"');
    text += svg_block(corner.x, top, bar_width, height, "fill=\"none\" stroke=\"#444\" stroke-width=\".35\"");
    for (const double level : colouring.contours.values)
        text +=
            svg_block(corner.x, top + height * (1 - classes.range().position(level)) - 0.3, bar_width, 0.6,
                      std::string("fill=\"") +
                          (classes.level_wants_light_ink(level) ? svg_light_ink : svg_dark_ink) + '"');
    SvgPath marks;
    for (const Tick& tick : ticks_of(classes.range(), height)) {
        const double y = top + height * (1 - classes.range().position(tick.value));
        if (y < top - 0.01 || y > top + height + 0.01) continue;
        marks.move({corner.x + bar_width, y});
        marks.line({corner.x + bar_width + (tick.major ? 2.5 : 1.5), y});
        if (tick.label.empty()) continue;
        text += svg_text({corner.x + bar_width + 5, y + 0.36 * svg_font_size}, Anchor::start, tick.label);
    }
    return text + path_element(marks, " stroke=\"#444\" stroke-width=\".35\"") + "</g>\n";
}

} // namespace gaspard
