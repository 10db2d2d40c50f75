#include "gui/viewport/axes.hpp"

#include "core/tessellate/blend.hpp"
#include "core/tessellate/plane_axes.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {

// At scale 1.
constexpr float off_mesh = 5, tick_length = 4, label_gap = 3, least_side = 60;

float text_width(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

float strip_left(const MeshScene& scene, float scale) {
    const double label = label_room(
        scene.home_box, [](const std::string& text) { return static_cast<double>(text_width(text)); });
    return static_cast<float>(label) + (off_mesh + tick_length + 2 * label_gap) * scale;
}

float strip_below(float scale) {
    return ImGui::GetFontSize() + (off_mesh + tick_length + 2 * label_gap) * scale;
}

/// The axes of one view. Pixels are those of the window.
class AxisDrawer {
  public:
    AxisDrawer(ImDrawList& list, const PlannedView& shown, ScreenRect pane,
               const std::optional<ScreenRect>& legend, const Theme& theme, float scale)
        : list_(list), shown_(shown), box_(*shown.axes), pane_(pane), legend_(legend), theme_(theme),
          scale_(scale) {}

    void draw() {
        const ImVec2 low = on_screen(box_.low), high = on_screen(box_.high); // high.y < low.y
        if (low.x > pane_.max.x || high.x < pane_.min.x || low.y < pane_.min.y || high.y > pane_.max.y)
            return; // the mesh is out of sight
        const float off = off_mesh * scale_;
        // Where an edge of the mesh leaves too little room, its axis is at the edge of the pane.
        const float lowest = pane_.max.y - strip_below(scale_) + off;
        const bool at_bottom = low.y + off > lowest + 1;
        bottom_ = at_bottom ? lowest : low.y + off;
        y_end_ = at_bottom ? bottom_ : low.y;
        top_ = std::max(high.y, pane_.min.y);
        const PlaneAxis vertical = vertical_axis();
        const float leftmost = pane_.min.x + strip_of(vertical) - off;
        const bool at_left = low.x - off < leftmost - 1;
        left_ = at_left ? leftmost : low.x - off;
        x_begin_ = at_left ? left_ : low.x;
        right_ = std::min(high.x, pane_.max.x);
        list_.PushClipRect(pane_.min, pane_.max, true);
        const ImU32 ground = packed(theme_.background, 0.92F);
        if (at_left) list_.AddRectFilled(pane_.min, {left_, pane_.max.y}, ground);
        if (at_bottom) list_.AddRectFilled({at_left ? left_ : pane_.min.x, bottom_}, pane_.max, ground);
        draw_horizontal(horizontal_axis());
        draw_vertical(vertical);
        list_.PopClipRect();
    }

  private:
    ImVec2 on_screen(Vec3 place) const {
        const Pixel p = to_pixel(shown_.camera, shown_.size(), place);
        return {shown_.rect.min.x + static_cast<float>(p.x), shown_.rect.min.y + static_cast<float>(p.y)};
    }
    Vec3 under(float x, float y) const {
        return to_world(
            shown_.camera, shown_.size(),
            {static_cast<double>(x - shown_.rect.min.x), static_cast<double>(y - shown_.rect.min.y)});
    }
    bool computational() const { return shown_.scene.blend == 0; }
    float strip_of(const PlaneAxis& vertical) const {
        float widest = 0;
        for (const Tick& tick : vertical.ticks) widest = std::max(widest, text_width(tick.label));
        return std::max(strip_left(shown_.scene, scale_),
                        widest + (off_mesh + tick_length + 2 * label_gap) * scale_);
    }

    PlaneAxis horizontal_axis() const {
        const float length = right_ - x_begin_;
        if (length < least_side * scale_) return {};
        const double scale = static_cast<double>(scale_);
        return plane_axis(coordinate_name(false, computational()),
                          seen_range(box_.low.x, box_.high.x, under(x_begin_, 0).x, under(right_, 0).x),
                          static_cast<double>(length), 70 * scale, [&](const std::string& text) {
                              return static_cast<double>(text_width(text)) + 12 * scale;
                          });
    }
    PlaneAxis vertical_axis() const {
        const float length = y_end_ - top_;
        if (length < least_side * scale_) return {};
        const double high = static_cast<double>(ImGui::GetFontSize());
        return plane_axis(coordinate_name(true, computational()),
                          seen_range(box_.low.y, box_.high.y, under(0, y_end_).y, under(0, top_).y),
                          static_cast<double>(length), 4 * high,
                          [&](const std::string&) { return 1.3 * high; });
    }

    void label(ImVec2 at, const std::string& text, const Colour& ink) const {
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        const ImVec2 end{at.x + size.x, at.y + size.y};
        const bool inside = at.x >= pane_.min.x && at.y >= pane_.min.y - size.y / 2 && end.x <= pane_.max.x &&
                            end.y <= pane_.max.y + 1;
        const bool covered = legend_ && at.x < legend_->max.x && end.x > legend_->min.x &&
                             at.y < legend_->max.y && end.y > legend_->min.y;
        if (!inside || covered) return;
        const float around = scale_;
        list_.AddRectFilled({at.x - around, at.y}, {end.x + around, end.y},
                            packed(theme_.background, 0.8F)); // over control nets
        list_.AddText({std::round(at.x), std::round(at.y)}, packed(ink), text.c_str());
    }

    void draw_horizontal(const PlaneAxis& axis) const {
        if (axis.ticks.empty()) return;
        const ImU32 line = packed(theme_.faint_text, 0.7F);
        const float y = std::round(bottom_), end = y + tick_length * scale_, top = end + label_gap * scale_;
        list_.AddRectFilled({x_begin_, y}, {right_, y + thick()}, line);
        const auto centred = [&](double value, const std::string& text, const Colour& ink) {
            label({on_screen({value, 0, 0}).x - text_width(text) / 2, top}, text, ink);
        };
        for (const Tick& tick : axis.ticks) {
            const float x = std::round(on_screen({tick.value, 0, 0}).x - thick() / 2);
            list_.AddRectFilled({x, y}, {x + thick(), end}, line);
            centred(tick.value, tick.label, theme_.faint_text);
        }
        if (!axis.name.empty()) centred(axis.name_at, axis.name, theme_.text);
    }

    void draw_vertical(const PlaneAxis& axis) const {
        if (axis.ticks.empty()) return;
        const ImU32 line = packed(theme_.faint_text, 0.7F);
        const float x = std::round(left_), end = x - tick_length * scale_, right = end - label_gap * scale_;
        list_.AddRectFilled({x - thick(), top_}, {x, y_end_}, line);
        const auto beside = [&](double value, const std::string& text, const Colour& ink) {
            label({right - text_width(text), on_screen({0, value, 0}).y - ImGui::GetFontSize() / 2}, text,
                  ink);
        };
        for (const Tick& tick : axis.ticks) {
            const float y = std::round(on_screen({0, tick.value, 0}).y - thick() / 2);
            list_.AddRectFilled({end, y}, {x, y + thick()}, line);
            beside(tick.value, tick.label, theme_.faint_text);
        }
        if (!axis.name.empty()) beside(axis.name_at, axis.name, theme_.text);
    }

    float thick() const { return std::max(1.0F, std::round(scale_)); }

    ImDrawList& list_;
    const PlannedView& shown_;
    const Box& box_;
    ScreenRect pane_;
    const std::optional<ScreenRect>& legend_;
    const Theme& theme_;
    float scale_;
    // The lines of both axes.
    float left_ = 0, top_ = 0, y_end_ = 0;
    float bottom_ = 0, x_begin_ = 0, right_ = 0;
};

} // namespace

bool has_axes(const MeshScene& scene) {
    return has_plane_axes(*scene.mesh) && scene.elevation == 0 && !scene.projection;
}

Insets room_for_axes(const MeshScene& scene, float scale) {
    if (!has_axes(scene)) return {};
    return {.left = static_cast<double>(strip_left(scene, scale)),
            .right = static_cast<double>(text_width("0.00") / 2), // of the last label
            .bottom = static_cast<double>(strip_below(scale))};
}

Box shown_box(const MeshScene& scene) {
    if (scene.blend == 1) return bounding_box(*scene.physical);
    if (scene.blend == 0) return bounding_box(*scene.computational);
    Points between = *scene.computational;
    const Points& x = *scene.physical;
    for (auto of : {&Points::x, &Points::y})
        for (std::size_t i = 0; i < (x.*of).size(); ++i)
            (between.*of)[i] = blended((between.*of)[i], (x.*of)[i], scene.blend);
    return bounding_box(between);
}

void draw_axes(ImDrawList& list, const PlannedView& shown, ScreenRect pane,
               const std::optional<ScreenRect>& legend, const Theme& theme, float scale) {
    if (shown.axes) AxisDrawer(list, shown, pane, legend, theme, scale).draw();
}

} // namespace gaspard
