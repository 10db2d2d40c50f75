// An ImGui context with an owner. While it lives it is the current one, then the one before is again; nothing
// is read from or left on disk.
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
        ImGui::DestroyContext(context_);
        ImGui::SetCurrentContext(previous_);
    }
    ImGuiSession(const ImGuiSession&) = delete;
    ImGuiSession& operator=(const ImGuiSession&) = delete;

  private:
    ImGuiContext* previous_;
    ImGuiContext* context_;
};

} // namespace gaspard
