// ImGui frames with synthetic input and no graphics backend.
#pragma once

#include "gui/base/item_rectangles.hpp"
#include "gui/base/theme.hpp"
#include "gui/gl/imgui_context.hpp"
#include "gui/gl/imgui_input.hpp"

#include <functional>
#include <imgui.h>
#include <string>

namespace gaspard {

class HeadlessUi {
  public:
    /// With a theme: in its style and font, as the program looks. Without: ImGui's own.
    explicit HeadlessUi(float width = 1400, float height = 900, const Theme* theme = nullptr) {
        ImGuiIO& io = ImGui::GetIO();
        if (theme) {
            apply_theme(*theme, 1);
            load_font(*io.Fonts, *theme, 1);
        }
        io.DisplaySize = {width, height};
        io.DeltaTime = 1.0F / 60;
        unsigned char* pixels = nullptr;
        int columns = 0, rows = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &columns, &rows);
        move_away();
    }

    /// Everything larger, as on a display of high density.
    void scale(float factor) {
        apply_theme(dark_theme(), factor);
        ImGui::GetIO().FontGlobalScale = factor;
    }
    /// One frame around `draw`.
    void frame(const std::function<void()>& draw) {
        ImGui::NewFrame();
        draw();
        ImGui::Render();
    }

    void move(float x, float y) { ImGui::GetIO().MousePos = {x, y}; }
    void move_away() { ImGui::GetIO().MousePos = {-1e6F, -1e6F}; }
    void button(bool down, int which = 0) { ImGui::GetIO().MouseDown[which] = down; }
    void key(ImGuiKey key, bool down) { feed_key(ImGui::GetIO(), key, down); }
    void control(bool down) { feed_control(ImGui::GetIO(), down); }
    void shift(bool down) { feed_shift(ImGui::GetIO(), down); }
    void wheel(float turns) { ImGui::GetIO().MouseWheel = turns; }

    /// Presses and releases at the middle of an item (a copy: every frame notes the items anew).
    /// Types into a field, instead of what it holds.
    void replace_text(ItemRectangle field, const std::string& text, const std::function<void()>& draw) {
        click(field, draw);
        control(true);
        key(ImGuiKey_A, true);
        frame(draw);
        key(ImGuiKey_A, false);
        control(false);
        frame(draw);
        type(text, draw);
    }
    void click(ItemRectangle item, const std::function<void()>& draw) {
        move(item.center_x(), item.center_y());
        frame(draw);
        button(true);
        frame(draw);
        button(false);
        frame(draw);
    }

    /// Twice at the middle of an item.
    void double_click(ItemRectangle item, const std::function<void()>& draw) {
        click(item, draw);
        click(item, draw);
        for (int i = 0; i < 3; ++i) frame(draw); // until a field has the keyboard
    }

    /// Drags along an item from one fraction of its width to another.
    void drag(ItemRectangle item, float from, float to, const std::function<void()>& draw) {
        move(item.left + from * item.width(), item.center_y());
        frame(draw);
        button(true);
        frame(draw);
        for (int i = 1; i <= 10; ++i) {
            move(item.left + (from + (to - from) * static_cast<float>(i) / 10) * item.width(),
                 item.center_y());
            frame(draw);
        }
        button(false);
        frame(draw);
    }

    /// Letters into whatever has the keyboard, one frame each.
    void type(const std::string& text, const std::function<void()>& draw) {
        for (const char letter : text) {
            ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(letter));
            frame(draw);
        }
    }

  private:
    ImGuiSession session_;
};

} // namespace gaspard
