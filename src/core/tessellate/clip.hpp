// Convex polygons, and segments, that planes clip.
#pragma once

#include "core/tessellate/cell_lattice.hpp"
#include "core/tessellate/cut_planes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace gaspard {

/// A corner of a polygon, and what it lies on: bit f for the faces of the cell, further ones for the planes.
struct ClipCorner {
    std::uint32_t point = 0;
    std::uint32_t marks = 0;
};

/// With two corners, a segment.
class ClipPolygon {
  public:
    ClipPolygon() = default;
    ClipPolygon(std::initializer_list<ClipCorner> corners) {
        for (const ClipCorner& corner : corners) add(corner);
    }
    /// A point that is the same as the one before is no further corner.
    void add(ClipCorner corner);
    void close(); ///< after the last corner
    void reverse() { std::reverse(corners_.begin(), corners_.begin() + static_cast<std::ptrdiff_t>(size_)); }
    std::span<const ClipCorner> corners() const { return {corners_.data(), size_}; }
    std::size_t size() const { return size_; }
    const ClipCorner& operator[](std::size_t i) const { return corners_[i % size_]; }

  private:
    std::array<ClipCorner, 6 + 2 * most_cut_planes> corners_{}; // every plane adds one or two
    std::size_t size_ = 0;
};

/// The planes of a cut, and the points that they cut edges at.
class Clipper {
  public:
    /// `tolerance`: distance up to which a point lies on a plane.
    Clipper(const std::vector<CutWedge>& cut, double tolerance, LatticePoints& points);

    struct Wedge {
        std::uint32_t begin = 0, end = 0; ///< its planes
    };
    std::span<const CutPlane> planes() const { return planes_; }
    std::span<const Wedge> wedges() const { return wedges_; }
    static std::uint32_t mark(std::uint32_t plane) { return 256U << plane; }

    /// From plane number `plane`; 0 within the tolerance, positive beyond it.
    double distance(std::uint32_t point, std::uint32_t plane) const;
    /// Where an edge from one side of a plane to the other crosses it; b if that lies on it.
    ClipCorner cross(ClipCorner a, ClipCorner b, std::uint32_t plane);
    /// The parts on either side of a plane; empty where there is none. What lies in the plane is beyond.
    void split(const ClipPolygon& polygon, std::uint32_t plane, ClipPolygon& before, ClipPolygon& beyond);

    /// The part of a cap in plane `cap` that lies in its wedge: beyond all other planes of that.
    ClipPolygon within_wedge(ClipPolygon polygon, std::uint32_t wedge, std::uint32_t cap);
    /// Hands over what no wedge hides. Of a cap in a plane of wedge `own`, its own wedge is left out; where
    /// other planes are the same one, the first of them has the cap.
    template <class Use>
    void outside(const ClipPolygon& polygon, const Use& use, std::uint32_t wedge = 0,
                 std::uint32_t own = no_wedge, std::uint32_t cap = 0) {
        if (wedge == wedges_.size()) return use(polygon);
        if (wedge == own) return outside(polygon, use, wedge + 1, own, cap);
        const std::size_t least = std::min<std::size_t>(polygon.size(), 3);
        ClipPolygon rest = polygon, before, beyond;
        for (std::uint32_t plane = wedges_[wedge].begin; plane < wedges_[wedge].end; ++plane) {
            if (own != no_wedge && own < wedge && stays_in(rest, plane, cap))
                return outside(rest, use, wedge + 1, own, cap);
            split(rest, plane, before, beyond);
            if (before.size() >= least) outside(before, use, wedge + 1, own, cap);
            rest = beyond;
            if (rest.size() < least) return;
        }
    }
    static constexpr std::uint32_t no_wedge = 0xffffffff;

  private:
    /// Whether a cap lies in another plane of the same direction.
    bool stays_in(const ClipPolygon& polygon, std::uint32_t plane, std::uint32_t cap) const;

    std::vector<CutPlane> planes_;
    std::vector<Wedge> wedges_;
    double tolerance_;
    LatticePoints& points_;
};

} // namespace gaspard
