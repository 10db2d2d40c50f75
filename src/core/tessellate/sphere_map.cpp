#include "core/tessellate/sphere_map.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

/// The axes of the map: through its centre, east, north.
struct Axes {
    double cosine, sine;
    explicit Axes(double longitude) : cosine(std::cos(longitude)), sine(std::sin(longitude)) {}
    /// The direction of p in these axes.
    Vec3 turned(Vec3 p) const {
        const Vec3 q{cosine * p.x + sine * p.y, cosine * p.y - sine * p.x, p.z};
        return (1 / norm(q)) * q;
    }
    Vec3 back(Vec3 q) const { return {cosine * q.x - sine * q.y, sine * q.x + cosine * q.y, q.z}; }
};

/// `q`: unit vector in the map's axes; `east`: 1 or -1, the side on which it is drawn.
Vec3 project(Vec3 q, double east, double radius) {
    const double level = std::sqrt(q.x * q.x + q.y * q.y); // the cosine of the latitude
    // level (1 - cos l) and level (1 + cos l), both without cancellation
    const double far = q.x > 0 ? q.y * q.y / (level + q.x) : level - q.x;
    const double near = q.x > 0 ? level + q.x : level - q.x > 0 ? q.y * q.y / (level - q.x) : 0;
    const double sine = east * std::sqrt(level * far / 2), cosine = std::sqrt(level * near / 2);
    const double scale = radius * std::numbers::sqrt2 / std::sqrt(1 + cosine);
    return {2 * scale * sine, scale * q.z, 0};
}

double side_of(Vec3 q) { return q.y >= 0 ? 1 : -1; }

class MapCutter {
  public:
    MapCutter(const Tessellation& globe, const Points& points, const MapProjection& projection,
              SphereMap& map)
        : globe_(globe), radius_(projection.radius), out_(map) {
        const Axes axes(projection.longitude);
        places_.resize(points.size());
        east_.resize(points.size());
        out_.points.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            places_[i] = axes.turned(points[i]);
            east_[i] = places_[i].y >= 0;
            out_.points.set(i, project(places_[i], side_of(places_[i]), radius_));
        }
    }

    void cut_triangles() {
        const std::size_t count = globe_.triangle_cells.size();
        for (std::size_t i = 0; i < count; ++i) {
            const std::array corners = {globe_.triangles[3 * i], globe_.triangles[3 * i + 1],
                                        globe_.triangles[3 * i + 2]};
            if (east_[corners[0]] == east_[corners[1]] && east_[corners[1]] == east_[corners[2]]) continue;
            cut_triangle(i, corners);
        }
    }

    void cut_segments() {
        const std::size_t count = globe_.segments.size() / 2;
        MapEdits& edits = out_.edits;
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t a = globe_.segments[2 * i], b = globe_.segments[2 * i + 1];
            if (east_[a] == east_[b]) continue;
            const Crossing cross = crossing(a, b);
            if (cross.place.x >= 0) continue;
            edits.replaced_segments.insert(edits.replaced_segments.end(),
                                           {static_cast<std::uint32_t>(i), add(cross, side_of(places_[a]))});
            edits.segments.insert(edits.segments.end(), {add(cross, side_of(places_[b])), b});
            edits.segment_sides.insert(edits.segment_sides.end(),
                                       {globe_.segment_sides[2 * i], globe_.segment_sides[2 * i + 1]});
        }
    }

  private:
    /// Where a segment meets the plane of the cut, which also contains the central meridian.
    struct Crossing {
        std::uint32_t a, b;
        double t;
        Vec3 place;
    };

    Crossing crossing(std::uint32_t a, std::uint32_t b) const {
        const Vec3 p = places_[a], q = places_[b];
        const double t = p.y / (p.y - q.y);
        Vec3 place = p + t * (q - p);
        place.y = 0;
        return {a, b, t, place};
    }

    std::uint32_t add(const Crossing& cross, double east) {
        return add(MapCut{cross.a, cross.b, cross.t},
                   project((1 / norm(cross.place)) * cross.place, east, radius_));
    }
    std::uint32_t add(const MapCut& cut, Vec3 place) {
        out_.cuts.push_back(cut);
        out_.points.x.push_back(place.x), out_.points.y.push_back(place.y), out_.points.z.push_back(0);
        return static_cast<std::uint32_t>(out_.points.size() - 1);
    }

    /// Cuts a triangle with corners on both sides of that plane.
    void cut_triangle(std::size_t i, const std::array<std::uint32_t, 3>& corners) {
        std::size_t lone = 0; // the corner that is alone on its side
        while (east_[corners[lone]] == east_[corners[(lone + 1) % 3]] ||
               east_[corners[lone]] == east_[corners[(lone + 2) % 3]])
            ++lone;
        const std::uint32_t a = corners[lone], b = corners[(lone + 1) % 3], c = corners[(lone + 2) % 3];
        const Crossing first = crossing(a, b), second = crossing(a, c);
        if (first.place.x >= 0 && second.place.x >= 0) return; // crosses the central meridian
        std::vector<std::uint32_t> polygons[2];
        for (const bool alone : {true, false}) {
            const double east = side_of(places_[alone ? a : b]);
            const std::uint32_t p = add(first, east), q = add(second, east);
            std::vector<std::uint32_t> polygon = alone ? std::vector{q, a, p} : std::vector{p, b, c, q};
            // A triangle around a pole: the polygon passes through the pole.
            if ((first.place.x < 0) != (second.place.x < 0)) {
                const double t = first.place.x / (first.place.x - second.place.x);
                const Vec3 pole{0, 0, first.place.z + t * (second.place.z - first.place.z) > 0 ? 1.0 : -1.0};
                polygon.push_back(add(MapCut{p, q, t}, project(pole, east, radius_)));
            }
            polygons[alone ? 0 : 1] = std::move(polygon);
        }
        MapEdits& edits = out_.edits;
        bool replaced = false;
        for (const auto& polygon : polygons)
            for (std::size_t k = 2; k < polygon.size(); ++k) {
                const std::array triangle = {polygon[0], polygon[k - 1], polygon[k]};
                auto& list = replaced ? edits.triangles : edits.replaced_triangles;
                if (replaced)
                    edits.triangle_cells.push_back(globe_.triangle_cells[i]);
                else
                    list.push_back(static_cast<std::uint32_t>(i));
                list.insert(list.end(), triangle.begin(), triangle.end());
                replaced = true;
            }
    }

    const Tessellation& globe_;
    double radius_;
    SphereMap& out_;
    std::vector<Vec3> places_; ///< in the map's axes
    std::vector<char> east_;
};

std::shared_ptr<const Tessellation> edited(const std::shared_ptr<const Tessellation>& globe,
                                           const MapEdits& edits, std::size_t points) {
    auto shape = std::make_shared<Tessellation>();
    shape->base = globe;
    shape->cuts = globe->cuts;
    const auto joined = [](const std::vector<std::uint32_t>& first,
                           const std::vector<std::uint32_t>& second) {
        std::vector<std::uint32_t> all;
        all.reserve(first.size() + second.size());
        all.insert(all.end(), first.begin(), first.end());
        all.insert(all.end(), second.begin(), second.end());
        return all;
    };
    shape->triangles = joined(globe->triangles, edits.triangles);
    shape->triangle_cells = joined(globe->triangle_cells, edits.triangle_cells);
    shape->segments = joined(globe->segments, edits.segments);
    shape->segment_sides = joined(globe->segment_sides, edits.segment_sides);
    const auto& triangles = edits.replaced_triangles;
    for (std::size_t i = 0; i < triangles.size(); i += 4)
        std::copy_n(&triangles[i + 1], 3, &shape->triangles[std::size_t{3} * triangles[i]]);
    const auto& segments = edits.replaced_segments;
    for (std::size_t i = 0; i < segments.size(); i += 2)
        shape->segments[std::size_t{2} * segments[i] + 1] = segments[i + 1];
    shape->point_count = points;
    return shape;
}

/// The unit vector of a longitude (relative to the centre) and latitude, in radians.
Vec3 place_at(double longitude, double latitude) {
    return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
            std::sin(latitude)};
}

} // namespace

Vec3 to_map(const MapProjection& projection, Vec3 point) {
    const Vec3 q = Axes(projection.longitude).turned(point);
    return project(q, side_of(q), projection.radius);
}

std::optional<Vec3> from_map(const MapProjection& projection, Vec3 place) {
    const double x = place.x / (4 * projection.radius), y = place.y / (2 * projection.radius);
    if (!(x * x + y * y <= 0.5)) return std::nullopt;
    const double w = std::sqrt(1 - x * x - y * y);
    // With the half longitude l/2: cos p sin(l/2) = 2 w x, cos p cos(l/2) = 2 w^2 - 1, sin p = 2 w y.
    const double half = std::atan2(2 * w * x, 2 * w * w - 1);
    const double north = std::min(1.0, std::max(-1.0, 2 * w * y));
    return projection.radius * Axes(projection.longitude).back(place_at(2 * half, std::asin(north)));
}

std::vector<Vec3> map_outline(const MapProjection& projection) {
    constexpr int points = 240;
    std::vector<Vec3> line;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points;
        line.push_back(projection.radius * std::numbers::sqrt2 *
                       Vec3{2 * std::cos(angle), std::sin(angle), 0});
    }
    return line;
}

SphereMap map_sphere(const std::shared_ptr<const Tessellation>& globe, const Points& points,
                     const MapProjection& projection, const SphereMap* last) {
    GASPARD_CHECK(points.size() == globe->point_count);
    SphereMap map;
    MapCutter cutter(*globe, points, projection, map);
    cutter.cut_triangles();
    cutter.cut_segments();
    const bool as_before = last && last->tessellation && last->tessellation->base == globe &&
                           last->edits == map.edits && last->points.size() == map.points.size();
    map.tessellation = as_before ? last->tessellation : edited(globe, map.edits, map.points.size());
    return map;
}

std::vector<double> map_values(const SphereMap& map, std::span<const double> globe) {
    std::vector<double> values(globe.begin(), globe.end());
    values.reserve(map.points.size());
    for (const MapCut& cut : map.cuts) values.push_back((1 - cut.t) * values[cut.a] + cut.t * values[cut.b]);
    GASPARD_CHECK(values.size() == map.points.size());
    return values;
}

} // namespace gaspard
