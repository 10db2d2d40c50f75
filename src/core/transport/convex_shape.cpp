#include "core/transport/convex_shape.hpp"

#include "core/base/box.hpp"
#include "core/base/error.hpp"
#include "core/mesh/control_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gaspard {

namespace {

constexpr const char* choices[] = {"ellipse", "rounded-rectangle", "curve", "polygon"};

ParameterRow length_row(std::string key, std::string label, std::string symbol, double value,
                        std::string help) {
    return {.key = std::move(key),
            .label = std::move(label),
            .symbol = std::move(symbol),
            .unit = "length",
            .minimum = shortest_length,
            .maximum = longest_length,
            .slider = SliderRange{0.1, 4},
            .default_value = value,
            .help = std::move(help)};
}

} // namespace

ParameterRow shape_choice_row(const std::string& prefix, const std::string& whose) {
    ParameterRow row{
        .key = prefix + "shape",
        .label = whose + " shape",
        .kind = ParameterKind::choice,
        .default_value = std::string(choices[0]),
        .choices = {std::begin(choices), std::end(choices)},
        .help =
            "an ellipse or disk, a rectangle with round sides, a smooth curve through points, or a polygon "
            "with round corners",
        .role = ParameterRole::defines_rows};
    if (!prefix.empty()) return row;
    row.choices.push_back(shape_of_file);
    row.help += "; file: the mesh of a convex polygon from a file";
    return row;
}

std::vector<ParameterRow> shape_rows(const Values& values, const std::string& prefix,
                                     const std::string& whose) {
    const std::string& shape = values.text(prefix + "shape");
    std::vector<ParameterRow> rows;
    if (shape == shape_of_file)
        return {{.key = prefix + "file",
                 .label = whose + " mesh",
                 .kind = ParameterKind::text,
                 .default_value = std::string("gaspard:half-disk.obj"),
                 .help = "a mesh of triangles or convex polygons in the plane (OBJ, OFF, PLY, STL), whose "
                         "boundary is a convex polygon",
                 .role = ParameterRole::file}};
    if (shape == choices[0] || shape == choices[1]) {
        rows.push_back(length_row(prefix + "a", whose + " half width", "a", 1,
                                  "half of the longest extent in the direction of the angle"));
        rows.push_back(length_row(prefix + "b", whose + " half height", "b", 1, "half of the extent across"));
        if (shape == choices[1])
            rows.push_back(
                {.key = prefix + "exponent",
                 .label = whose + " exponent",
                 .symbol = "p",
                 .minimum = 2,
                 .maximum = 20,
                 .default_value = 4.0,
                 .help = "|x/a|^p + |y/b|^p = 1: 2 is an ellipse, large values are nearly a rectangle"});
        rows.push_back({.key = prefix + "angle",
                        .label = whose + " angle",
                        .unit = "degrees",
                        .minimum = -180,
                        .maximum = 180,
                        .default_value = 0.0,
                        .help = "between the x axis and the half width",
                        .periodic = true});
        for (const char* axis : {"x", "y"})
            rows.push_back({.key = prefix + axis,
                            .label = whose + " centre " + axis,
                            .unit = "length",
                            .minimum = -longest_length,
                            .maximum = longest_length,
                            .slider = SliderRange{-2, 2},
                            .default_value = 0.0,
                            .help = "coordinate of the centre",
                            .role = axis == std::string("x") ? ParameterRole::x : ParameterRole::y,
                            .point = prefix + "centre"});
        return rows;
    }
    const bool polygon = shape == choices[3];
    rows.push_back(
        {.key = prefix + "points",
         .label = whose + " points",
         .kind = ParameterKind::text,
         .default_value = std::string(polygon ? "-1 -1, 1 -1, 1 1, -1 1"
                                              : "1.1 0, 0.6 0.9, -0.5 0.8, -1 0, -0.4 -0.9, 0.6 -0.8"),
         .help = "\"x y, x y, ...\", 3 to 200 points of a convex curve in their order; drag them in the "
                 "window",
         .role = ParameterRole::control_points});
    if (polygon)
        rows.push_back(length_row(prefix + "corner_radius", whose + " corner radius", "r", 0.2,
                                  "radius of the arcs that replace the corners"));
    return rows;
}

bool is_of_source(const Values& domain, const std::string& key) {
    return domain.has(target_prefix + "shape") && !key.starts_with(target_prefix);
}

Vec3 middle_of_shape(const Values& values, const std::string& prefix) {
    if (values.has(prefix + "x")) return {values.real(prefix + "x"), values.real(prefix + "y"), 0};
    if (!values.has(prefix + "points")) return {};
    try {
        const Points points = parse_points(values.text(prefix + "points"), "points");
        return points.size() == 0 ? Vec3{} : bounding_box(points).centre();
    } catch (const InputError&) { // which make_shape() throws
        return {};
    }
}

std::shared_ptr<const ConvexCurve> make_shape(const Values& values, const std::string& prefix, Vec3 origin) {
    const std::string& shape = values.text(prefix + "shape");
    const auto real = [&](const char* key) { return values.real(prefix + key); };
    try {
        if (shape == choices[0])
            return ellipse(Vec3{real("x"), real("y"), 0} - origin, real("a"), real("b"), real("angle"));
        if (shape == choices[1])
            return rounded_rectangle(Vec3{real("x"), real("y"), 0} - origin, real("a"), real("b"),
                                     real("exponent"), real("angle"));
        Points points = parse_points(values.text(prefix + "points"), "domain." + prefix + "points");
        if (points.size() < 3 || points.size() > 200)
            throw InputError("a curve needs 3 to 200 points, not " + std::to_string(points.size()));
        for (std::size_t i = 0; i < points.size(); ++i)
            if (std::abs(points.x[i]) > longest_length || std::abs(points.y[i]) > longest_length)
                throw InputError("coordinates must be between −10⁶ and 10⁶");
        for (std::size_t i = 0; i < points.size(); ++i) points.set(i, points[i] - origin);
        return shape == choices[2] ? closed_spline(points) : rounded_polygon(points, real("corner_radius"));
    } catch (const InputError& error) {
        if (origin != Vec3{}) make_shape(values, prefix); // says the same with the user's coordinates
        const std::string key =
            "domain." + prefix + (shape == choices[2] || shape == choices[3] ? "points" : "shape");
        const std::string what = error.what();
        throw InputError(what.find("domain.") == std::string::npos ? key + ": " + what : what);
    }
}

} // namespace gaspard
