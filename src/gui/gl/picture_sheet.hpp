// Small pictures for ImGui, side by side in one image. ImGuiRenderer makes a texture of it when it is first
// drawn, and again after more have been added. Plain data: no OpenGL is needed to fill it.
#pragma once

#include "core/io/image.hpp"

#include <cstdint>
#include <imgui.h>
#include <memory>

namespace gaspard {

/// Where a picture is in the texture of its sheet.
struct PicturePlace {
    const void* sheet = nullptr;
    ImVec2 low, high; ///< texture coordinates of its corners

    ImTextureID texture() const { return const_cast<void*>(sheet); } // as ImGui wants it
};

/// Is shared, so that a renderer notices when it is gone.
class PictureSheet : public std::enable_shared_from_this<PictureSheet> {
  public:
    /// For `count` pictures of this size in pixels, none of which is there yet.
    PictureSheet(int width, int height, int count);

    /// The next picture; it must be of the size, and there must be room for it.
    PicturePlace add(const Image& picture);
    const Image& image() const { return image_; }
    /// Another one after each picture.
    std::uint64_t version() const { return static_cast<std::uint64_t>(added_); }

  private:
    int width_, height_, columns_, count_;
    int added_ = 0;
    Image image_;
};

} // namespace gaspard
