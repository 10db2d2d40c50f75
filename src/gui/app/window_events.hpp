// What happens to a window of GLFW, noted in its order.
#pragma once

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <atomic>
#include <cfloat>
#include <deque>
#include <imgui.h>
#include <string>
#include <variant>
#include <vector>

namespace gaspard {

/// A button of the mouse that went down or up.
struct ButtonChange {
    int button = 0;
    bool down = false;
    ImVec2 at;
};

/// A key that went down or up, in GLFW's terms. `name` is empty if the table of actions cannot contain the
/// key.
struct KeyChange {
    int key = 0, scancode = 0, event = 0, modifiers = 0;
    std::string name;

    bool down() const { return event == GLFW_PRESS; }
    /// The key only types a letter. That arrives as a Letter, so ImGui does not need the key.
    bool only_types() const { return key < GLFW_KEY_ESCAPE && (modifiers & GLFW_MOD_CONTROL) == 0; }
    bool modifies() const { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }
};

struct Letter {
    unsigned code = 0;
};

/// What has happened since the last iteration of the loop.
struct Happenings {
    std::atomic<bool> news = false;  ///< set on any thread
    std::atomic<bool> image = false; ///< of meshes, that is new; set on the painter's thread
    bool input = false;
    bool exposed = true;                                              ///< the window's content is gone
    ImVec2 pointer{-FLT_MAX, -FLT_MAX};                               ///< nowhere, as ImGui writes it
    std::deque<std::variant<KeyChange, Letter, ButtonChange>> inputs; ///< in their order
    std::vector<std::string> dropped;                                 ///< files
};

/// From now on they are noted there; it must outlive the window.
void note_events(GLFWwindow* window, Happenings& happenings);

} // namespace gaspard
