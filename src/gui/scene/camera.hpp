// Where one looks from. Orthographic: world units map to pixels by one scale, whatever their distance.
//
// Pixels: x to the right, y down, (0, 0) at the upper left corner of the area that shows the mesh (`Size`).
// A planar camera looks down the z axis with x to the right and y up; a spatial one has other axes. Pure
// mathematics.
#pragma once

#include "core/base/points.hpp"

#include <glm/mat4x4.hpp>
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
/// Room to leave free at the sides of the area, in pixels.
struct Insets {
    double left = 0, top = 0, right = 0, bottom = 0;
    friend bool operator==(const Insets&, const Insets&) = default;
};

struct Box {
    Vec3 low, high;
    Vec3 centre() const { return 0.5 * (low + high); }
    /// Length of the diagonal.
    double size() const { return norm(high - low); }
    friend bool operator==(const Box&, const Box&) = default;
};
/// The smallest box around all finite points; around the origin where there is none.
Box bounding_box(const Points& points);
Box merge(const Box& a, const Box& b);

struct Camera {
    Vec3 centre;         ///< the world point in the middle of the area
    double scale = 1;    ///< world units per pixel
    Vec3 right{1, 0, 0}; ///< of unit length, to the right of the picture
    Vec3 up{0, 1, 0};    ///< of unit length, orthogonal to `right`
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Looks down the z axis; `box` fills what `insets` leave free, but for a small margin.
Camera planar_home(const Box& box, Size size, Insets insets = {});
/// Looks at all of `box` from a direction, as view.direction names it; z is up. "home" is somewhat from
/// above, "front" along y from its lower end, "right" along x from its upper end, "top" down the z axis.
Camera spatial_home(const Box& box, Size size, Insets insets = {}, std::string_view direction = "home");
/// The first for boxes without depth, the second for others.
Camera home(const Box& box, Size size, Insets insets = {}, std::string_view direction = "home");

/// Moves and scales a camera so that what it sees of all these points, which need not fill their box, fills
/// what the insets leave. Leaves it as it is where no point is finite.
void fit_points(Camera& camera, const std::vector<const Points*>& points, Size size, Insets insets);
/// The same for a ball around `middle`, however it is turned.
void fit_ball(Camera& camera, Vec3 middle, double radius, Size size, Insets insets);

/// "centre 0.5 0.5 0 height 1.25", for cameras with other axes also "right 0 1 0 up 0 0 1": one line that
/// fits a picture of any size, for it says how much of the world the picture's height shows. Reads back to
/// the same text.
std::string format_camera(const Camera& camera, Size size);
/// "right 0 1 0 up 0 0 1": all of the mesh from this side, however large the picture is.
std::string format_axes(const Camera& camera);
/// Throws InputError with one sentence. Axes that are not quite orthonormal are made so; z may be left out. A
/// text of axes alone says nothing of centre and scale, which are then the origin and a height of 1.
Camera parse_camera(std::string_view text, Size size);
/// Whether a camera's text consists of axes alone.
bool shows_all(std::string_view text);

Pixel to_pixel(const Camera& camera, Size size, Vec3 world);
/// The point under a pixel, in the plane through the camera's centre that faces the viewer.
Vec3 to_world(const Camera& camera, Size size, Pixel pixel);

/// The world follows a pointer that has moved by so many pixels.
void pan(Camera& camera, Pixel by);
/// Enlarges by `factor` (> 1 comes closer); the point under `fixed` stays there. The scale stays within what
/// double precision carries around `box`.
void zoom(Camera& camera, Size size, Pixel fixed, double factor, const Box& box);

/// Turns the world about `pivot` as if it were a ball under the pointer, which moves by so many pixels; a
/// drag across the smaller side of the area is half a turn.
void rotate(Camera& camera, Size size, Pixel by, Vec3 pivot);
/// Turns a ball of this radius around `pivot` under the pointer: the point of it that was under `from` comes
/// to be under `to`, at any zoom. Beside the ball, and near its rim, where a pixel would be half a turn, the
/// turn goes on evenly.
void turn_ball(Camera& camera, Size size, Pixel from, Pixel to, Vec3 pivot, double radius);
/// Turns the world by the shortest way until `where` lies before `pivot` as the viewer sees it.
void bring_to_front(Camera& camera, Vec3 where, Vec3 pivot);
/// The world turns about the vertical (z) axis through `pivot`, eastward.
void spin(Camera& camera, double radians, Vec3 pivot);
/// The same picture from the other side: half a turn about `up` through `pivot`. Twice is nothing.
Camera from_behind(const Camera& camera, Vec3 pivot);
/// Towards the viewer, of unit length.
Vec3 towards_viewer(const Camera& camera);

/// From world positions minus `origin` to OpenGL's clip coordinates; `depth` is half the depth of the view in
/// world units: what is farther from the centre is cut off.
glm::mat4 clip_matrix(const Camera& camera, Size size, Vec3 origin, double depth);

} // namespace gaspard
