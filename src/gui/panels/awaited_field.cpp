#include "gui/panels/awaited_field.hpp"

#include <imgui.h>
#include <utility>

namespace gaspard {

void AwaitedField::want(std::string key) {
    key_ = std::move(key);
    asked_ = 0;
    since_ = ImGui::GetFrameCount();
}

bool AwaitedField::wanted(std::string_view key) const {
    constexpr int patience = 4; // frames
    if (key_.empty() || key_ != key) return false;
    return asked_ == 0 || (pending() && ImGui::GetFrameCount() - asked_ >= patience);
}

void AwaitedField::ask() {
    ImGui::SetWindowFocus(); // ImGui 1.90 looks for the field in the window that has the focus alone
    ImGui::SetKeyboardFocusHere();
    if (asked_ == 0) since_ = ImGui::GetFrameCount();
    asked_ = ImGui::GetFrameCount();
}

void AwaitedField::note(std::string_view key, bool active) {
    if (asked_ != 0 && active && key_ == key) key_.clear();
}

bool AwaitedField::pending() const { return !key_.empty() && ImGui::GetFrameCount() - since_ < longest_wait; }

} // namespace gaspard
