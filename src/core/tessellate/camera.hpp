// The camera of a view. It is orthographic: one scale maps world units to pixels at any distance.
//
// Pixels: x to the right, y down, (0, 0) at the upper left corner of the view, whose size in pixels is a
// `Size`. A planar camera looks down the z axis with x to the right and y up; a spatial one has other axes.
#pragma once

#include "core/base/box.hpp"
#include "core/base/points.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct Size {
    double width = 1, height = 1;
    friend bool operator==(const Size&, const Size&) = default;
};
struct Pixel {
    double x = 0, y = 0;
};
/// Margins to leave free at the sides of the view, in pixels.
struct Insets {
    double left = 0, top = 0, right = 0, bottom = 0;
    friend bool operator==(const Insets&, const Insets&) = default;
};

struct Camera {
    Vec3 centre;         ///< the world point in the middle of the view
    double scale = 1;    ///< world units per pixel
    Vec3 right{1, 0, 0}; ///< of unit length, to the right of the image
    Vec3 up{0, 1, 0};    ///< of unit length, orthogonal to `right`
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Looks down the z axis; `box` fills what `insets` leave free, except for a small margin.
Camera planar_home(const Box& box, Size size, Insets insets = {});
/// Shows all of `box` from a direction of view_directions(); z is up.
Camera spatial_home(const Box& box, Size size, Insets insets = {}, std::string_view direction = "home");
/// The first for boxes without depth, the second for others.
Camera home(const Box& box, Size size, Insets insets = {}, std::string_view direction = "home");

/// Moves and scales a camera so that the projection of these points fills what the insets leave free. Does
/// nothing if no point is finite.
void fit_points(Camera& camera, const std::vector<const Points*>& points, Size size, Insets insets);
/// The same for a ball around `middle`.
void fit_ball(Camera& camera, Vec3 middle, double radius, Size size, Insets insets);

/// "centre 0.5 0.5 0 height 1.25", followed by "right 0 1 0 up 0 0 1" for cameras with other axes. It fits
/// images of any size, because `height` is the part of the world that the image's height shows. Parsing gives
/// a camera with the same text.
std::string format_camera(const Camera& camera, Size size);
/// "right 0 1 0 up 0 0 1": the whole mesh from this side, in images of any size.
std::string format_axes(const Camera& camera);
/// Throws InputError with one sentence. Axes that are nearly orthonormal are made orthonormal; z of the
/// centre may be left out. For a text of axes alone the centre is the origin and the height 1.
Camera parse_camera(std::string_view text, Size size);
/// Whether a camera's text consists of axes alone.
bool shows_all(std::string_view text);

Pixel to_pixel(const Camera& camera, Size size, Vec3 world);
/// The point under a pixel, in the plane through the camera's centre that faces the viewer.
Vec3 to_world(const Camera& camera, Size size, Pixel pixel);

/// The world follows a pointer that moved by so many pixels.
void pan(Camera& camera, Pixel by);
/// Magnifies by `factor`; the point under `fixed` stays there. The scale is limited to what double precision
/// can resolve around `box`.
void zoom(Camera& camera, Size size, Pixel fixed, double factor, const Box& box);

/// Rotates the world about `pivot` as a pointer moves by so many pixels; moving across the smaller side of
/// the view is half a turn.
void rotate(Camera& camera, Size size, Pixel by, Vec3 pivot);
/// Rotates a ball of this radius around `pivot` with the pointer: its point under `from` moves to `to`, at
/// any zoom. Outside the ball and near its rim, where a pixel would be half a turn, the rotation continues
/// smoothly.
void turn_ball(Camera& camera, Size size, Pixel from, Pixel to, Vec3 pivot, double radius);
/// Rotates the world by the smallest angle that brings `where` in front of `pivot`.
void bring_to_front(Camera& camera, Vec3 where, Vec3 pivot);
/// Rotates the world eastward about the vertical (z) axis through `pivot`.
void spin(Camera& camera, double radians, Vec3 pivot);
/// The view from the other side: half a turn about `up` through `pivot`. Its own inverse.
Camera from_behind(const Camera& camera, Vec3 pivot);
/// Towards the viewer, of unit length.
Vec3 towards_viewer(const Camera& camera);

} // namespace gaspard
