#include "gui/app/window_events.hpp"

#include <backends/imgui_impl_glfw.h>
#include <cctype>
#include <string>

namespace gaspard {

namespace {

/// The name of a key in the table of actions: "Space", "Ctrl+Shift+Z". Letters are those printed on the key.
std::string key_name(int key, int scancode, int modifiers) {
    if (modifiers & (GLFW_MOD_ALT | GLFW_MOD_SUPER)) return {}; // reserved for the desktop
    const std::string prefix = (modifiers & GLFW_MOD_CONTROL) ? "Ctrl+" : "";
    if (key == GLFW_KEY_SPACE) return prefix + "Space";
    if (key == GLFW_KEY_RIGHT) return prefix + "Right";
    if (key == GLFW_KEY_LEFT) return prefix + "Left";
    if (key == GLFW_KEY_HOME) return prefix + "Home";
    if (key == GLFW_KEY_END) return prefix + "End";
    if (key == GLFW_KEY_ESCAPE) return prefix + "Escape";
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25)
        return prefix + "F" + std::to_string(key - GLFW_KEY_F1 + 1);
    const char* printed = glfwGetKeyName(key, scancode);
    if (!printed || printed[1] != '\0') return {};
    const bool shifted = !prefix.empty() && (modifiers & GLFW_MOD_SHIFT) != 0;
    return prefix + (shifted ? "Shift+" : "") +
           static_cast<char>(std::toupper(static_cast<unsigned char>(printed[0])));
}

Happenings& happenings_of(GLFWwindow* window) {
    return *static_cast<Happenings*>(glfwGetWindowUserPointer(window));
}

} // namespace

// Callbacks only record events: no exception may pass through C code.
void note_events(GLFWwindow* window, Happenings& happenings) {
    glfwSetWindowUserPointer(window, &happenings);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int event, int modifiers) {
        happenings_of(w).input = true;
        if (event != GLFW_REPEAT) // ImGui repeats by itself
            happenings_of(w).inputs.emplace_back(
                KeyChange{key, scancode, event, modifiers, key_name(key, scancode, modifiers)});
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned letter) {
        happenings_of(w).input = true;
        happenings_of(w).inputs.emplace_back(Letter{letter});
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        happenings_of(w).input = true;
        happenings_of(w).pointer = {static_cast<float>(x), static_cast<float>(y)};
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int event, int) {
        happenings_of(w).input = true;
        if (button >= 0 && button < ImGuiMouseButton_COUNT)
            happenings_of(w).inputs.emplace_back(
                ButtonChange{button, event == GLFW_PRESS, happenings_of(w).pointer});
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        happenings_of(w).input = true;
        ImGui_ImplGlfw_ScrollCallback(w, x, y);
    });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
        happenings_of(w).input = true;
        ImGui_ImplGlfw_WindowFocusCallback(w, focused);
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        happenings_of(w).input = true;
        double x = 0, y = 0;
        glfwGetCursorPos(w, &x, &y);
        bool dragging = false; // continues outside the window
        for (int button = 0; button < ImGuiMouseButton_COUNT; ++button)
            dragging = dragging || glfwGetMouseButton(w, button) == GLFW_PRESS;
        happenings_of(w).pointer = entered != GLFW_FALSE || dragging
                                       ? ImVec2(static_cast<float>(x), static_cast<float>(y))
                                       : ImVec2(-FLT_MAX, -FLT_MAX);
    });
    glfwSetWindowRefreshCallback(
        window, [](GLFWwindow* w) { happenings_of(w).input = happenings_of(w).exposed = true; });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { happenings_of(w).input = true; });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** files) {
        happenings_of(w).input = true;
        happenings_of(w).dropped.assign(files, files + count);
    });
    glfwSetWindowContentScaleCallback(window,
                                      [](GLFWwindow* w, float, float) { happenings_of(w).input = true; });
}

} // namespace gaspard
