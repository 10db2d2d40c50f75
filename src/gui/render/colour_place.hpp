// Where values lie in a range of colours, linearly; the shaders take the logarithm.
#pragma once

#include "core/tessellate/colour_map.hpp"

namespace gaspard {

class ColourPlace {
  public:
    explicit ColourPlace(const ColourRange& range)
        : low_(range.low), scale_(range.high > range.low ? 1 / (range.high - range.low) : 0),
          shift_(range.high > range.low ? 0.0F : 0.5F) {}
    float of(double value) const {
        const float place = static_cast<float>((value - low_) * scale_) + shift_;
        return place - place == 0 ? place : 0.0F; // values that are not finite get the lowest colour
    }

  private:
    double low_, scale_;
    float shift_;
};

} // namespace gaspard
