// The frame of a modal dialog.
#pragma once

#include "gui/base/item_rectangles.hpp"

#include <string>

namespace gaspard {

/// Border and rounding of a dialog, while it begins.
struct ModalFrame {
    ModalFrame();
    ~ModalFrame();
    ModalFrame(const ModalFrame&) = delete;
    ModalFrame& operator=(const ModalFrame&) = delete;
};

/// Begins a modal popup in the middle of the window, and opens it first if it is closed. If true,
/// ImGui::EndPopup() ends it.
bool begin_modal(const char* title);
/// The same with a size in pixels instead of one that fits its content; at most what the window has.
bool begin_modal(const char* title, float width, float height);

/// The largest width of a line of text in a dialog.
float modal_text_width();

/// The buttons at the end of a dialog: one that accepts, and Cancel. Keys "KEYS.ok" and "KEYS.cancel".
enum class ModalAnswer { none, accept, cancel };
ModalAnswer draw_modal_buttons(const std::string& keys, const char* accept, bool enabled,
                               ItemRectangles& items);

} // namespace gaspard
