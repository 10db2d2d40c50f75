// Short texts in plots.
#pragma once

#include "gui/base/theme.hpp"

#include <imgui.h>
#include <string>
#include <string_view>

namespace gaspard {

inline ImVec2 text_size(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size());
}

inline void write_text(ImDrawList& list, ImVec2 at, Colour colour, std::string_view text) {
    list.AddText(at, packed(colour), text.data(), text.data() + text.size());
}

/// `text`, or its beginning and its end where it is wider than `width`.
std::string shortened(std::string_view text, float width);

} // namespace gaspard
