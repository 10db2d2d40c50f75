// The nearest of a fixed set of points, by a k-d tree.
#pragma once

#include "core/base/points.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gaspard {

class NearestPoint {
  public:
    NearestPoint() = default;
    /// At least one point.
    explicit NearestPoint(Points points);
    const Points& points() const { return points_; }
    /// The index of the point nearest to x.
    std::size_t operator()(Vec3 x) const;

  private:
    struct Best {
        double squared;
        std::size_t index;
    };
    void sort(std::size_t begin, std::size_t end);
    void search(std::size_t begin, std::size_t end, Vec3 x, Best& best) const;

    // The median of a range along its longest side stands in its middle: a tree without pointers.
    Points points_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint8_t> axis_; ///< of the cut at each median
};

} // namespace gaspard
