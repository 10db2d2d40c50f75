#include "core/tessellate/camera.hpp"

#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/scenario/view_directions.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace gaspard {

namespace {

constexpr double half_turn = std::numbers::pi;

/// What is seen of something, along the camera's axes.
struct ScreenExtent {
    double left = std::numeric_limits<double>::infinity(), right = -left, bottom = left, top = -left;
    void add(const Camera& camera, Vec3 p) {
        const double x = dot(camera.right, p), y = dot(camera.up, p);
        if (!std::isfinite(x) || !std::isfinite(y)) return;
        left = std::min(left, x), right = std::max(right, x);
        bottom = std::min(bottom, y), top = std::max(top, y);
    }
};

/// Sets the scale so that the extent fills what the insets leave free, and moves the camera, which looks at
/// the middle of the extent, beside the insets.
void fit_extent(Camera& camera, const ScreenExtent& extent, Size size, Insets insets) {
    constexpr double margin = 0.02; // of the free space, at each side
    const double free_width = std::max(1.0, size.width - insets.left - insets.right) * (1 - 2 * margin);
    const double free_height = std::max(1.0, size.height - insets.top - insets.bottom) * (1 - 2 * margin);
    camera.scale =
        std::max((extent.right - extent.left) / free_width, (extent.top - extent.bottom) / free_height);
    if (!(camera.scale > 0)) camera.scale = 1 / std::min(free_width, free_height);
    pan(camera, {(insets.left - insets.right) / 2, (insets.top - insets.bottom) / 2});
}

void fit(Camera& camera, const Box& box, Size size, Insets insets) {
    ScreenExtent extent;
    for (int corner = 0; corner < 8; ++corner)
        extent.add(camera,
                   {(corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
                    (corner & 4) != 0 ? box.high.z : box.low.z});
    camera.centre = box.centre();
    fit_extent(camera, extent, size, insets);
}

/// `v` turned about the axis `k` (of unit length).
Vec3 turned(Vec3 v, Vec3 k, double angle) {
    return std::cos(angle) * v + std::sin(angle) * cross(k, v) + ((1 - std::cos(angle)) * dot(k, v)) * k;
}

/// Unit length and a right angle; false where there is no such pair near. What is good already stays as it
/// is.
bool make_orthonormal(Vec3& right, Vec3& up) {
    constexpr double tolerance = 1e-9;
    if (std::abs(norm(right) - 1) < tolerance && std::abs(norm(up) - 1) < tolerance &&
        std::abs(dot(right, up)) < tolerance)
        return true;
    if (!(norm(right) > 0) || !(norm(up) > 0)) return false;
    right = (1 / norm(right)) * right;
    up = (1 / norm(up)) * up;
    up = up - dot(right, up) * right;
    if (!(norm(up) > 1e-6)) return false;
    up = (1 / norm(up)) * up;
    return true;
}

std::string three_numbers(Vec3 v) {
    return format_number(v.x) + " " + format_number(v.y) + " " + format_number(v.z);
}

/// Twelve digits: enough to aim with, few enough to survive a division and a multiplication.
std::string twelve_digits(double value) {
    char buffer[40];
    const auto [end, code] =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 12);
    return {buffer, end};
}

[[noreturn]] void refuse_camera(std::string_view text, const std::string& why) {
    throw InputError(
        "the camera '" + std::string(text) + "' " + why +
        "; a camera reads 'centre 0.5 0.5 0 height 1.2', and may go on with 'right 1 0 0 up 0 1 0', which "
        "alone shows all of a mesh");
}

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    constexpr std::string_view blanks = " \t\r\n,;";
    for (std::size_t begin = 0; (begin = text.find_first_not_of(blanks, begin)) != text.npos;) {
        const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
        words.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

std::optional<double> number_of(std::string_view word) {
    double value = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (code != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

} // namespace

Camera planar_home(const Box& box, Size size, Insets insets) {
    Camera camera;
    fit(camera, box, size, insets);
    return camera;
}

Camera spatial_home(const Box& box, Size size, Insets insets, std::string_view direction) {
    Camera camera;
    camera.right = view_direction(direction).right, camera.up = view_direction(direction).up;
    fit(camera, box, size, insets);
    return camera;
}

Camera home(const Box& box, Size size, Insets insets, std::string_view direction) {
    return box.high.z > box.low.z ? spatial_home(box, size, insets, direction)
                                  : planar_home(box, size, insets);
}

void fit_points(Camera& camera, const std::vector<const Points*>& points, Size size, Insets insets) {
    ScreenExtent extent;
    for (const Points* of : points)
        for (std::size_t i = 0; i < of->size(); ++i) extent.add(camera, (*of)[i]);
    if (!(extent.left <= extent.right)) return;
    const double x = (extent.left + extent.right) / 2 - dot(camera.right, camera.centre);
    const double y = (extent.bottom + extent.top) / 2 - dot(camera.up, camera.centre);
    camera.centre = camera.centre + x * camera.right + y * camera.up;
    fit_extent(camera, extent, size, insets);
}

void fit_ball(Camera& camera, Vec3 middle, double radius, Size size, Insets insets) {
    ScreenExtent extent;
    for (const double side : {-radius, radius})
        extent.add(camera, middle + side * camera.right), extent.add(camera, middle + side * camera.up);
    camera.centre = middle;
    fit_extent(camera, extent, size, insets);
}

Pixel to_pixel(const Camera& camera, Size size, Vec3 world) {
    const Vec3 from_centre = world - camera.centre;
    return {size.width / 2 + dot(camera.right, from_centre) / camera.scale,
            size.height / 2 - dot(camera.up, from_centre) / camera.scale};
}

Vec3 to_world(const Camera& camera, Size size, Pixel pixel) {
    const double x = (pixel.x - size.width / 2) * camera.scale,
                 y = (size.height / 2 - pixel.y) * camera.scale;
    return camera.centre + x * camera.right + y * camera.up;
}

void pan(Camera& camera, Pixel by) {
    camera.centre = camera.centre - (by.x * camera.scale) * camera.right + (by.y * camera.scale) * camera.up;
}

void zoom(Camera& camera, Size size, Pixel fixed, double factor, const Box& box) {
    const double extent = std::max(box.size(), norm(box.centre()));
    const double finest = 1e-12 * (extent > 0 ? extent : 1), coarsest = 10 * (extent > 0 ? extent : 1);
    const Vec3 under = to_world(camera, size, fixed);
    camera.scale =
        std::clamp(camera.scale / factor, std::min(finest, camera.scale), std::max(coarsest, camera.scale));
    camera.centre = camera.centre + under - to_world(camera, size, fixed);
}

Vec3 towards_viewer(const Camera& camera) { return cross(camera.right, camera.up); }

/// The world turns about an axis of unit length through `pivot`; the camera goes the other way.
static void turn_world(Camera& camera, Vec3 axis, double angle, Vec3 pivot) {
    const auto turn = [&](Vec3 v) { return turned(v, axis, -angle); };
    camera.centre = pivot + turn(camera.centre - pivot);
    camera.right = turn(camera.right), camera.up = turn(camera.up);
    camera.right = (1 / norm(camera.right)) * camera.right;
    camera.up = camera.up - dot(camera.up, camera.right) * camera.right;
    camera.up = (1 / norm(camera.up)) * camera.up;
}

/// The world turns by the shortest way that takes the direction `from` to the direction `to`.
static void turn_from_to(Camera& camera, Vec3 from, Vec3 to, Vec3 pivot) {
    const Vec3 axis = cross(from, to);
    const double sine = norm(axis);
    if (sine > 0) turn_world(camera, (1 / sine) * axis, std::atan2(sine, dot(from, to)), pivot);
}

/// From the middle of a ball to its point under a pixel, in world axes.
static Vec3 ball_point(const Camera& camera, Size size, Pixel pixel, Vec3 pivot, double radius) {
    const Vec3 from_pivot = to_world(camera, size, pixel) - pivot;
    const double x = dot(camera.right, from_pivot) / radius, y = dot(camera.up, from_pivot) / radius;
    constexpr double steep = 0.9; // of the radius; from here on a curve that goes on with the same slope
    const double away = std::hypot(x, y);
    const double rim = std::sqrt(1 - steep * steep), power = steep * steep / (rim * rim);
    const double depth = away < steep ? std::sqrt(1 - away * away) : rim * std::pow(steep / away, power);
    return x * camera.right + y * camera.up + depth * towards_viewer(camera);
}

void turn_ball(Camera& camera, Size size, Pixel from, Pixel to, Vec3 pivot, double radius) {
    if (from.x == to.x && from.y == to.y) return;
    turn_from_to(camera, ball_point(camera, size, from, pivot, radius),
                 ball_point(camera, size, to, pivot, radius), pivot);
}

void bring_to_front(Camera& camera, Vec3 where, Vec3 pivot) {
    const Vec3 from = where - pivot, to = towards_viewer(camera);
    constexpr double hardly = 1e-6; // from the very back any way is the shortest, but none can be told
    if (dot(from, to) < 0 && norm(cross(from, to)) < hardly * norm(from))
        turn_world(camera, camera.up, half_turn, pivot);
    turn_from_to(camera, from, towards_viewer(camera), pivot);
}

void spin(Camera& camera, double radians, Vec3 pivot) { turn_world(camera, {0, 0, 1}, radians, pivot); }

Camera from_behind(const Camera& camera, Vec3 pivot) {
    const Vec3 away = camera.centre - pivot;
    return {pivot + 2 * dot(camera.up, away) * camera.up - away, camera.scale, -1 * camera.right, camera.up};
}

void rotate(Camera& camera, Size size, Pixel by, Vec3 pivot) {
    const double distance = std::hypot(by.x, by.y);
    if (!(distance > 0)) return;
    const double angle = half_turn * distance / std::min(size.width, size.height);
    const Vec3 axis = (by.y / distance) * camera.right + (by.x / distance) * camera.up;
    turn_world(camera, axis, angle, pivot);
}

std::string format_axes(const Camera& camera) {
    return "right " + three_numbers(camera.right) + " up " + three_numbers(camera.up);
}

std::string format_camera(const Camera& camera, Size size) {
    std::string text =
        "centre " + three_numbers(camera.centre) + " height " + twelve_digits(camera.scale * size.height);
    if (!(camera.right == Vec3{1, 0, 0} && camera.up == Vec3{0, 1, 0}))
        text.append(" ").append(format_axes(camera));
    return text;
}

bool shows_all(std::string_view text) {
    const auto words = words_of(text);
    return !words.empty() && std::none_of(words.begin(), words.end(), [](std::string_view word) {
        return word == "centre" || word == "center" || word == "height";
    });
}

namespace {

/// Far beyond all meshes; what is computed with such numbers stays finite.
constexpr double largest = 1e20, smallest_height = 1e-50, smallest_axis = 1e-20;

bool is_axis(Vec3 v) { return norm(v) >= smallest_axis && norm(v) <= largest; }

void check_ranges(std::string_view text, const Camera& camera, double height) {
    const auto beyond = [](double c) { return !(std::abs(c) <= largest); };
    if (beyond(camera.centre.x) || beyond(camera.centre.y) || beyond(camera.centre.z))
        refuse_camera(text, "wants a centre with coordinates from −10²⁰ to 10²⁰");
    if (!(height >= smallest_height && height <= largest))
        refuse_camera(text, "wants a height from 10⁻⁵⁰ to 10²⁰");
    if (!is_axis(camera.right) || !is_axis(camera.up))
        refuse_camera(text, "wants a right and an up of lengths from 10⁻²⁰ to 10²⁰");
}

} // namespace

Camera parse_camera(std::string_view text, Size size) {
    struct Part {
        std::string_view name;
        std::size_t least, most; ///< numbers
        std::vector<double> numbers;
    };
    Part parts[] = {{"centre", 2, 3, {}}, {"height", 1, 1, {}}, {"right", 3, 3, {}}, {"up", 3, 3, {}}};
    Part* part = nullptr;
    for (const std::string_view word : words_of(text)) {
        if (const auto number = number_of(word); number && part != nullptr) {
            part->numbers.push_back(*number);
            continue;
        }
        const std::string_view name = word == "center" ? "centre" : word;
        part =
            std::find_if(std::begin(parts), std::end(parts), [&](const Part& p) { return p.name == name; });
        if (part == std::end(parts)) refuse_camera(text, "has the word '" + std::string(word) + "'");
        if (!part->numbers.empty()) refuse_camera(text, "says '" + std::string(word) + "' twice");
    }
    const bool axes_alone = parts[0].numbers.empty() && parts[1].numbers.empty() &&
                            !parts[2].numbers.empty() && !parts[3].numbers.empty();
    for (const Part& p : parts) {
        const bool optional = p.numbers.empty() && (&p >= parts + 2 || axes_alone);
        if (!optional && (p.numbers.size() < p.least || p.numbers.size() > p.most))
            refuse_camera(text, "wants " + std::to_string(p.most) + (p.most == 1 ? " number" : " numbers") +
                                    " after '" + std::string(p.name) + "'");
    }
    const auto vector = [](const Part& p, Vec3 otherwise) {
        if (p.numbers.empty()) return otherwise;
        return Vec3{p.numbers[0], p.numbers[1], p.numbers.size() > 2 ? p.numbers[2] : 0};
    };
    const double height = axes_alone ? 1 : parts[1].numbers[0];
    Camera camera{vector(parts[0], {}), height / size.height, vector(parts[2], {1, 0, 0}),
                  vector(parts[3], {0, 1, 0})};
    check_ranges(text, camera, height);
    if (!make_orthonormal(camera.right, camera.up))
        refuse_camera(text, "wants a right and an up that point in different directions");
    return camera;
}

} // namespace gaspard
