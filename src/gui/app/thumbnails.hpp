// The small pictures of the built-in scenarios (assets/thumbnails, made by scripts/thumbnails.sh).
#pragma once

#include "gui/gl/picture_sheet.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace gaspard {

inline constexpr int thumbnail_width = 128, thumbnail_height = 96; // pixels

/// The bytes of the PNG file of a built-in scenario; empty if there is none.
std::string_view thumbnail_file(std::string_view scenario);

/// Decodes pictures when they are first asked for, a few per frame.
class Thumbnails {
  public:
    /// At the beginning of a frame.
    void begin_frame() { decoded_ = 0, waiting_ = false; }
    /// Nothing if there is no picture, or if it comes in one of the next frames.
    std::optional<PicturePlace> find(std::string_view scenario);
    /// Whether pictures that this frame asked for are still to come.
    bool waiting() const { return waiting_; }

  private:
    std::shared_ptr<PictureSheet> sheet_; ///< once it is needed
    std::map<std::string, PicturePlace, std::less<>> places_;
    int decoded_ = 0; ///< in this frame
    bool waiting_ = false;
};

} // namespace gaspard
