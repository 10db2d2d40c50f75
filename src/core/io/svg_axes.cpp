#include "core/io/svg_axes.hpp"

#include "core/base/box.hpp"
#include "core/io/svg_document.hpp"
#include "core/tessellate/plane_axes.hpp"

#include <algorithm>

namespace gaspard {

namespace {

constexpr double off_mesh = 3, tick_length = 2.5, label_gap = 2; // points
constexpr double capital = 0.72 * svg_font_size;                 // height of a digit
constexpr const char* axis_text = "fill=\"#444\"";

double width_of(const std::string& text) { return svg_text_width(text); }

} // namespace

SvgAxesRoom svg_room_for_axes(const SvgScene& scene) {
    return {off_mesh + tick_length + label_gap + label_room(bounding_box(scene.x), width_of),
            off_mesh + tick_length + label_gap + capital + 1};
}

std::string svg_axes(const SvgScene& scene, const SvgView& view, const std::string& name,
                     bool computational) {
    const Box box = bounding_box(scene.x);
    const auto x_at = [&](double x) { return view.page({x, 0, 0}).x; };
    const auto y_at = [&](double y) { return view.page({0, y, 0}).y; };
    const auto world_x = [&](double x) { return (x - view.origin.x) / view.scale; };
    const auto world_y = [&](double y) { return (view.origin.y - y) / view.scale; };
    const AxisRange across = seen_range(box.low.x, box.high.x, world_x(view.corner.x),
                                        world_x(view.corner.x + view.width)),
                    up = seen_range(box.low.y, box.high.y, world_y(view.corner.y + view.height),
                                    world_y(view.corner.y));
    if (!(across.low < across.high) || !(up.low < up.high)) return ""; // the mesh is out of sight
    const double bottom = y_at(up.low) + off_mesh, left = x_at(across.low) - off_mesh;
    const PlaneAxis horizontal =
                        plane_axis(coordinate_name(false, computational), across, view.scale * across.span(),
                                   36, [](const std::string&text) { return width_of(text) + 5; }),
                    vertical = plane_axis(coordinate_name(true, computational), up, view.scale * up.span(),
                                          32, [](const std::string&) { return 1.3 * svg_font_size; });
    SvgPath lines;
    std::string text = "<g id=\"" + name + "axes\">\n";
    lines.move({x_at(across.low), bottom});
    lines.line({x_at(across.high), bottom});
    lines.move({left, y_at(up.low)});
    lines.line({left, y_at(up.high)});
    const auto below = [&](double x, const std::string& label) {
        if (!label.empty())
            text += svg_text({x_at(x), bottom + tick_length + label_gap + capital}, Anchor::middle, label,
                             axis_text);
    };
    const auto beside = [&](double y, const std::string& label) {
        if (!label.empty())
            text += svg_text({left - tick_length - label_gap, y_at(y) + capital / 2}, Anchor::end, label,
                             axis_text);
    };
    for (const Tick& tick : horizontal.ticks) {
        lines.move({x_at(tick.value), bottom});
        lines.line({x_at(tick.value), bottom + tick_length});
        below(tick.value, tick.label);
    }
    for (const Tick& tick : vertical.ticks) {
        lines.move({left - tick_length, y_at(tick.value)});
        lines.line({left, y_at(tick.value)});
        beside(tick.value, tick.label);
    }
    below(horizontal.name_at, horizontal.name);
    beside(vertical.name_at, vertical.name);
    return text + path_element(lines, " fill=\"none\" stroke=\"#777\" stroke-width=\".4\"") + "</g>\n";
}

} // namespace gaspard
