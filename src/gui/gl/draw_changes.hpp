// What changes from one frame of ImGui to the next.
//
// Without a graphics card it takes some 10 ms to draw all panels; after an input most of them are as before.
#pragma once

#include "gui/gl/pixel_rect.hpp"

#include <cstdint>
#include <imgui.h>
#include <vector>

namespace gaspard {

class DrawChanges {
  public:
    /// The pixels outside of which `data` draws the same as the data before; empty if it is all the same.
    PixelRect follow(const ImDrawData& data);

  private:
    /// Of one list of commands: what it draws, and where.
    struct Print {
        std::uint64_t hash = 0;
        PixelRect area;
    };
    static Print print_of(const ImDrawList& list, const ImDrawData& data);

    std::vector<Print> before_, now_;
};

/// The pixels that a list draws to.
PixelRect area_of(const ImDrawList& list, const ImDrawData& data);

} // namespace gaspard
