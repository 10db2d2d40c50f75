#include "gui/base/icons.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaspard {

namespace {

/// Draws in a square from -1 to 1, y downwards.
struct Pen {
    ImDrawList& list;
    ImVec2 center;
    float half, thickness;
    ImU32 colour;

    ImVec2 at(float x, float y) const { return {center.x + half * x, center.y + half * y}; }
    void line(ImVec2 a, ImVec2 b) const { list.AddLine(at(a.x, a.y), at(b.x, b.y), colour, thickness); }
    void triangle(ImVec2 a, ImVec2 b, ImVec2 c) const {
        list.AddTriangleFilled(at(a.x, a.y), at(b.x, b.y), at(c.x, c.y), colour);
    }
    void bar(float left, float top, float right, float bottom) const {
        list.AddRectFilled(at(left, top), at(right, bottom), colour);
    }
};

/// An open circle whose end points back.
void draw_turn(const Pen& pen) {
    constexpr float radius = 0.72F, from = -2.3F, to = 2.6F;
    pen.list.PathArcTo(pen.center, radius * pen.half, from, to, 24);
    pen.list.PathStroke(pen.colour, ImDrawFlags_None, pen.thickness);
    const float x = radius * std::cos(from), y = radius * std::sin(from);
    pen.triangle({x - 0.5F, y - 0.35F}, {x + 0.45F, y - 0.3F}, {x - 0.25F, y + 0.55F});
}

/// Two arrows that follow each other.
void draw_loop(const Pen& pen) {
    for (const float side : {-1.0F, 1.0F}) {
        pen.line({-0.75F * side, 0.1F * side}, {-0.75F * side, -0.5F * side});
        pen.line({-0.75F * side, -0.5F * side}, {0.4F * side, -0.5F * side});
        pen.triangle({0.35F * side, -0.9F * side}, {0.9F * side, -0.5F * side}, {0.35F * side, -0.1F * side});
    }
}

/// A uniform cell that becomes an adapted one.
void draw_blend(const Pen& pen) {
    const std::array<ImVec2, 4> square{{{-0.9F, -0.55F}, {0.1F, -0.55F}, {0.1F, 0.45F}, {-0.9F, 0.45F}}};
    const std::array<ImVec2, 4> moved{{{-0.2F, -0.25F}, {0.95F, -0.6F}, {0.7F, 0.6F}, {-0.35F, 0.85F}}};
    for (const auto& cell : {square, moved})
        for (std::size_t i = 0; i < 4; ++i) pen.line(cell[i], cell[(i + 1) % 4]);
}

/// An arrow back (-1) or forth (1) over an arc.
void draw_arc_arrow(const Pen& pen, float side) {
    constexpr float pi = 3.14159265F;
    pen.list.PathArcTo(pen.at(0, 0.25F), 0.7F * pen.half, side > 0 ? -pi : -0.85F * pi,
                       side > 0 ? -0.15F * pi : 0, 20);
    pen.list.PathStroke(pen.colour, ImDrawFlags_None, pen.thickness);
    pen.triangle({0.95F * side, -0.45F}, {0.85F * side, 0.35F}, {0.2F * side, -0.1F});
}

void draw_house(const Pen& pen) {
    pen.line({-0.95F, 0}, {0, -0.85F});
    pen.line({0, -0.85F}, {0.95F, 0});
    pen.line({-0.65F, -0.2F}, {-0.65F, 0.85F});
    pen.line({0.65F, -0.2F}, {0.65F, 0.85F});
    pen.line({-0.65F, 0.85F}, {0.65F, 0.85F});
}

void draw_camera(const Pen& pen) {
    pen.list.AddRect(pen.at(-0.95F, -0.5F), pen.at(0.95F, 0.8F), pen.colour, 0.2F * pen.half,
                     ImDrawFlags_None, pen.thickness);
    pen.bar(-0.35F, -0.8F, 0.35F, -0.5F);
    pen.list.AddCircle(pen.at(0, 0.15F), 0.36F * pen.half, pen.colour, 20, pen.thickness);
}

/// A strip with holes along both edges.
void draw_film(const Pen& pen) {
    pen.list.AddRect(pen.at(-0.95F, -0.75F), pen.at(0.95F, 0.75F), pen.colour, 0.12F * pen.half,
                     ImDrawFlags_None, pen.thickness);
    for (const float side : {-1.0F, 1.0F}) {
        pen.line({0.5F * side, -0.75F}, {0.5F * side, 0.75F});
        for (const float y : {-0.25F, 0.25F}) pen.line({0.5F * side, y}, {0.95F * side, y});
    }
}

/// An arrow down into a tray.
void draw_tray(const Pen& pen) {
    pen.line({0, -0.9F}, {0, 0.1F});
    pen.triangle({-0.45F, -0.05F}, {0.45F, -0.05F}, {0, 0.5F});
    pen.line({-0.85F, 0.3F}, {-0.85F, 0.85F});
    pen.line({-0.85F, 0.85F}, {0.85F, 0.85F});
    pen.line({0.85F, 0.85F}, {0.85F, 0.3F});
}

} // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 center, float size, ImU32 colour) {
    const Pen pen{list, center, size / 2, std::max(1.0F, 0.11F * size), colour};
    switch (icon) {
    case Icon::none:
        return;
    case Icon::run:
        return pen.triangle({-0.6F, -0.85F}, {0.85F, 0}, {-0.6F, 0.85F});
    case Icon::pause:
        pen.bar(-0.65F, -0.8F, -0.18F, 0.8F);
        return pen.bar(0.18F, -0.8F, 0.65F, 0.8F);
    case Icon::step:
        pen.triangle({-0.75F, -0.8F}, {0.35F, 0}, {-0.75F, 0.8F});
        return pen.bar(0.4F, -0.8F, 0.75F, 0.8F);
    case Icon::back:
        pen.triangle({0.75F, -0.8F}, {-0.35F, 0}, {0.75F, 0.8F});
        return pen.bar(-0.75F, -0.8F, -0.4F, 0.8F);
    case Icon::to_start:
        pen.triangle({0.15F, -0.75F}, {-0.65F, 0}, {0.15F, 0.75F});
        pen.triangle({0.95F, -0.75F}, {0.15F, 0}, {0.95F, 0.75F});
        return pen.bar(-0.95F, -0.8F, -0.7F, 0.8F);
    case Icon::to_end:
        pen.triangle({-0.15F, -0.75F}, {0.65F, 0}, {-0.15F, 0.75F});
        pen.triangle({-0.95F, -0.75F}, {-0.15F, 0}, {-0.95F, 0.75F});
        return pen.bar(0.7F, -0.8F, 0.95F, 0.8F);
    case Icon::loop:
        return draw_loop(pen);
    case Icon::blend:
        return draw_blend(pen);
    case Icon::undo:
        return draw_arc_arrow(pen, -1);
    case Icon::redo:
        return draw_arc_arrow(pen, 1);
    case Icon::reset:
        return draw_turn(pen);
    case Icon::home:
        return draw_house(pen);
    case Icon::image:
        return draw_camera(pen);
    case Icon::film:
        return draw_film(pen);
    case Icon::save:
        return draw_tray(pen);
    }
}

float icon_button_width(const char* label) {
    const float em = ImGui::GetFontSize(), sign = 0.8F * em, gap = *label ? 0.45F * em : 0;
    return sign + gap + ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

bool icon_button(const char* id, Icon icon, const char* label, float width) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float em = ImGui::GetFontSize(), sign = 0.8F * em, gap = *label ? 0.45F * em : 0;
    const float content = sign + gap + ImGui::CalcTextSize(label).x;
    const float full = width > 0 ? width : icon_button_width(label);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::Button(id, {full, 0});
    const float x = at.x + (full - content) / 2, height = ImGui::GetFrameHeight();
    const ImU32 colour = ImGui::GetColorU32(ImGuiCol_Text);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_icon(list, icon, {x + sign / 2, at.y + height / 2}, sign, colour);
    list.AddText({x + sign + gap, at.y + style.FramePadding.y}, colour, label);
    return pressed;
}

bool eye_button(const char* id, bool crossed, ImU32 colour, ImU32 hovered) {
    const float em = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(id, {1.6F * em, height});
    if (ImGui::IsItemHovered()) colour = hovered;
    const ImVec2 middle{at.x + 0.8F * em, at.y + height / 2};
    const float half = 0.55F * em, thickness = std::max(1.0F, 0.09F * em);
    // Two arcs that meet in the corners: their centres lie below and above.
    constexpr float pi = 3.14159265F, opening = 0.9F;
    const float radius = half / std::sin(opening), depth = radius * std::cos(opening);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PathArcTo({middle.x, middle.y + depth}, radius, -pi / 2 - opening, -pi / 2 + opening, 12);
    list.PathStroke(colour, 0, thickness);
    list.PathArcTo({middle.x, middle.y - depth}, radius, pi / 2 - opening, pi / 2 + opening, 12);
    list.PathStroke(colour, 0, thickness);
    list.AddCircleFilled(middle, 0.18F * em, colour, 12);
    if (crossed)
        list.AddLine({middle.x - 0.45F * em, middle.y + 0.4F * em},
                     {middle.x + 0.45F * em, middle.y - 0.4F * em}, colour, thickness);
    return pressed;
}

} // namespace gaspard
