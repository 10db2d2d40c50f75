// Keys and the pointer for ImGui, which takes events since 1.87 and had arrays of states before.
#pragma once

#include <imgui.h>

namespace gaspard {

#if IMGUI_VERSION_NUM >= 18900

/// All events of a frame are processed in it: the caller passes them in order.
inline void process_events_at_once(ImGuiIO& io) { io.ConfigInputTrickleEventQueue = false; }
inline void feed_key(ImGuiIO& io, ImGuiKey key, bool down) { io.AddKeyEvent(key, down); }
inline void feed_control(ImGuiIO& io, bool down) { io.AddKeyEvent(ImGuiMod_Ctrl, down); }
inline void feed_shift(ImGuiIO& io, bool down) { io.AddKeyEvent(ImGuiMod_Shift, down); }
inline void feed_pointer(ImGuiIO& io, ImVec2 at) { io.AddMousePosEvent(at.x, at.y); }

#else

inline void process_events_at_once(ImGuiIO&) {}
inline void feed_key(ImGuiIO& io, ImGuiKey key, bool down) {
    io.KeyMap[key] = key;
    io.KeysDown[key] = down;
}
inline void feed_control(ImGuiIO& io, bool down) { io.KeyCtrl = down; }
inline void feed_shift(ImGuiIO& io, bool down) { io.KeyShift = down; }
inline void feed_pointer(ImGuiIO& io, ImVec2 at) { io.MousePos = at; }

#endif

} // namespace gaspard
