// The colours of a drawing of a mesh, and their legend.
#pragma once

#include "core/io/svg_document.hpp"
#include "core/io/svg_scene.hpp"
#include "core/tessellate/colouring.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {

inline constexpr const char *svg_dark_ink = "#14171c", *svg_light_ink = "#d4d2de";

/// The colours of the cells, a limited number of them.
class SvgClasses {
  public:
    /// `scene` must outlive it.
    SvgClasses(const SvgScene& scene, const std::optional<Colouring>& colouring, int classes);

    std::size_t count() const { return colours_.size(); }
    const ColourRange& range() const { return range_; }
    std::string colour(std::size_t k) const { return svg_colour(colours_[k]); }
    std::array<unsigned char, 3> parts(std::size_t k) const { return colours_[k]; }
    std::size_t of(std::size_t face) const {
        if (scene_.values.empty()) return 0;
        const double place = std::clamp(range_.position(scene_.values[face]), 0.0, 1.0);
        return std::min(count() - 1, static_cast<std::size_t>(place * static_cast<double>(count())));
    }
    /// Of a contour line.
    bool level_wants_light_ink(double level) const {
        const std::size_t k = static_cast<std::size_t>(std::clamp(range_.position(level), 0.0, 1.0) *
                                                       static_cast<double>(count()));
        return wants_light_ink(std::min(k, count() - 1), k > 0 ? k - 1 : 0);
    }
    /// Lines on these classes are seen: against either ink the contrast ratio is at least 3.
    bool wants_light_ink(std::size_t a, std::size_t b) const;

  private:
    const SvgScene& scene_;
    ColourRange range_;
    std::vector<std::array<unsigned char, 3>> colours_ = {{255, 255, 255}};
};

/// From 0 to 1, of linear light.
double svg_luminance(std::array<unsigned char, 3> colour);

/// A rectangle.
std::string svg_block(double x, double y, double width, double height, const std::string& attributes);

/// The lines above the bar.
std::vector<std::string> svg_legend_words(const Colouring& colouring);
/// Of the legend with a bar of this height.
double svg_legend_width(const Colouring& colouring, double height);
/// A bar of the classes with ticks and levels, the upper left corner of the words above it at `corner`.
std::string svg_colour_bar(const SvgClasses& classes, const Colouring& colouring, PagePoint corner,
                           double height);

} // namespace gaspard
