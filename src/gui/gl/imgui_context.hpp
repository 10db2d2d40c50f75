// An ImGui context with an owner. It is current during its lifetime, or until it is left; afterwards the
// previous one is current again. It reads and writes no files.
#pragma once

#include "gui/gl/imgui_input.hpp"

#include <imgui.h>

namespace gaspard {

class ImGuiSession {
  public:
    ImGuiSession() : previous_(ImGui::GetCurrentContext()), context_(ImGui::CreateContext()) {
        ImGui::SetCurrentContext(context_);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.LogFilename = nullptr;
        process_events_at_once(io);
        io.ConfigInputTextCursorBlink = false; // a window that sleeps would stop it at "hidden"
    }
    ~ImGuiSession() {
        const bool current = ImGui::GetCurrentContext() == context_;
        ImGui::DestroyContext(context_);
        if (current) ImGui::SetCurrentContext(previous_);
    }
    /// Makes the previous context current; what was drawn in this one can still be read.
    void leave() const { ImGui::SetCurrentContext(previous_); }
    ImGuiSession(const ImGuiSession&) = delete;
    ImGuiSession& operator=(const ImGuiSession&) = delete;

  private:
    ImGuiContext* previous_;
    ImGuiContext* context_;
};

} // namespace gaspard
