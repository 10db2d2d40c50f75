#include "gui/viewport/handles.hpp"

#include "core/base/error.hpp"
#include "core/mesh/control_points.hpp"
#include "core/scenario/time_rows.hpp"
#include "core/transport/convex_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

constexpr double degree = std::numbers::pi / 180;

const ParameterRow& row_of(const Values& values, const std::string& key) {
    return *std::find_if(values.rows().begin(), values.rows().end(),
                         [&](const ParameterRow& row) { return row.key == key; });
}

double rounded(double value, double digits) { return std::round(value * digits) / digits; }

/// Within the range of its row; a periodic one is wrapped.
void put(Values& values, const std::string& key, double value) {
    const ParameterRow& row = row_of(values, key);
    const double span = row.maximum - row.minimum;
    if (row.periodic && span > 0) value -= span * std::floor((value - row.minimum) / span);
    values.set(key, std::clamp(value, row.minimum, row.maximum));
}

/// Of the points that pairs of rows are coordinates of.
std::vector<Handle> point_handles(const Values& values) {
    std::vector<Handle> handles;
    // The other coordinate of its point.
    const auto with = [&](const ParameterRow& first, ParameterRole role) {
        const auto row =
            std::find_if(values.rows().begin(), values.rows().end(), [&](const ParameterRow& one) {
                return one.role == role && one.point == first.point;
            });
        return row == values.rows().end() ? std::string() : row->key;
    };
    for (const ParameterRow& row : values.rows()) {
        if (row.role == ParameterRole::x)
            if (const std::string y = with(row, ParameterRole::y); !y.empty())
                handles.push_back({row.key, y, false, {values.real(row.key), values.real(y), 0}});
        if (row.role != ParameterRole::latitude) continue;
        if (const std::string second = with(row, ParameterRole::longitude); !second.empty()) {
            const double p = values.real(row.key) * degree, l = values.real(second) * degree;
            handles.push_back(
                {row.key, second, true, {std::cos(p) * std::cos(l), std::cos(p) * std::sin(l), std::sin(p)}});
        }
    }
    return handles;
}

/// The points that a row lists, of the snapshot where it lists none; null where they cannot be moved.
std::shared_ptr<const Points> points_of(const std::string& text, const Snapshot& snapshot) {
    const auto& control = snapshot.control;
    if (text.empty()) return control;
    try {
        Points points = control ? parse_control_points(text, control->size()) : parse_points(text, "points");
        return std::make_shared<const Points>(std::move(points));
    } catch (const InputError&) { // it is being typed, or of another patch
        return nullptr;
    }
}

} // namespace

double rounded_within(double span, double value) {
    if (!(span > 0)) return value;
    const double decimals = 4 - std::floor(std::log10(span));
    const double factor = std::pow(10.0, std::abs(decimals)); // a whole number, so that texts stay short
    return decimals >= 0 ? rounded(value, factor) : std::round(value / factor) * factor;
}

/// Whether the time moves a coordinate of the monitor.
static bool moves(const Scenario& scenario, const std::string& key, bool first_point) {
    if (!has_time(scenario.time)) return false;
    if (first_point && !scenario.time.text("path").empty()) return true;
    const std::string motion = std::string(moving_prefix) + key;
    return scenario.time.has(motion) && !scenario.time.text(motion).empty();
}

std::vector<Handle> monitor_handles(const Scenario& scenario, bool moving) {
    std::vector<Handle> handles = point_handles(scenario.monitor.values), at_rest;
    if (moving) return handles;
    for (Handle& handle : handles) {
        const bool first = &handle == &handles.front();
        if (!moves(scenario, handle.first, first) && !moves(scenario, handle.second, first))
            at_rest.push_back(std::move(handle));
    }
    return at_rest;
}

std::vector<Handle> domain_handles(const Scenario& scenario, const Snapshot& snapshot) {
    const Values& values = scenario.domain.values;
    std::vector<Handle> handles = point_handles(values);
    for (const ParameterRow& row : values.rows()) {
        if (row.role != ParameterRole::control_points) continue;
        const auto control = points_of(values.text(row.key), snapshot);
        for (std::size_t i = 0; control && i < control->size(); ++i)
            handles.push_back({row.key, {}, false, (*control)[i], control, i, snapshot.control_columns});
    }
    for (Handle& handle : handles) {
        handle.of_domain = true;
        handle.of_source = is_of_source(values, handle.first);
    }
    return handles;
}

Scenario with_handle_at(const Scenario& scenario, const Handle& handle, Vec3 place) {
    Scenario moved = scenario;
    const Values& own = handle.of_domain ? scenario.domain.values : scenario.monitor.values;
    if (!own.has(handle.first)) return moved; // the shape was changed meanwhile
    if (handle.control) {
        Points control = *handle.control;
        const double side = longest_side(bounding_box(control));
        control.set(handle.number, {rounded_within(side, place.x), rounded_within(side, place.y), 0});
        moved.domain.values.set(handle.first, format_control_points(control));
        return moved;
    }
    Values& values = handle.of_domain ? moved.domain.values : moved.monitor.values;
    if (handle.on_sphere) {
        const double latitude = std::atan2(place.z, std::hypot(place.x, place.y)) / degree;
        put(values, handle.first, rounded(latitude, 100));
        put(values, handle.second, rounded(std::atan2(place.y, place.x) / degree, 100));
        return moved;
    }
    const double side =
        row_of(values, handle.first).measure; // of the square for which the monitor is written
    put(values, handle.first, rounded_within(side, place.x));
    put(values, handle.second, rounded_within(side, place.y));
    return moved;
}

std::optional<Pixel> pixel_of(const Handle& handle, const PlannedView& shown) {
    const MeshScene& scene = shown.scene;
    if (handle.of_source != (scene.blend <= 0)) return std::nullopt;
    if (scene.projection && handle.on_sphere)
        return to_pixel(shown.camera, shown.size(), to_map(*scene.projection, handle.place));
    if (handle.on_sphere != (scene.ball > 0)) return std::nullopt;
    if (!handle.on_sphere && !scene.planar()) return std::nullopt; // a surface in space
    if (!handle.on_sphere) return to_pixel(shown.camera, shown.size(), handle.place);
    if (dot(handle.place, towards_viewer(shown.camera)) <= 0) return std::nullopt;
    return to_pixel(shown.camera, shown.size(), scene.ball * handle.place);
}

std::optional<Vec3> place_under(const Handle& handle, const PlannedView& shown, Pixel pixel) {
    const MeshScene& scene = shown.scene;
    const Vec3 there = to_world(shown.camera, shown.size(), pixel);
    if (scene.projection) return from_map(*scene.projection, there);
    if (!handle.on_sphere) return there;
    const Vec3 viewer = towards_viewer(shown.camera);
    const Vec3 on_scene = (1 / scene.ball) * (there - dot(there, viewer) * viewer);
    const double away = norm(on_scene);
    if (away >= 1) return (1 / away) * on_scene;
    return on_scene + std::sqrt(1 - away * away) * viewer;
}

std::string item_name(const Handle& handle) {
    std::string name = "handle." + handle.first;
    if (handle.control) name += '.' + std::to_string(handle.number);
    return name;
}

void draw_control_net(const std::vector<Handle>& handles, ImDrawList& list, const PlannedView& shown,
                      const Theme& theme, float scale) {
    const auto line = [&](const Handle& from, std::size_t number) {
        Handle to = from;
        to.place = (*from.control)[number];
        const auto a = pixel_of(from, shown), b = pixel_of(to, shown);
        if (!a || !b) return;
        const auto at = [&](Pixel p) {
            return ImVec2{shown.rect.min.x + static_cast<float>(p.x),
                          shown.rect.min.y + static_cast<float>(p.y)};
        };
        // Seen on every colour.
        list.AddLine(at(*a), at(*b), packed(theme.background, 0.55F), 3 * scale);
        list.AddLine(at(*a), at(*b), packed(theme.text, 0.6F), scale);
    };
    for (const Handle& handle : handles) {
        if (!handle.control || handle.columns == 0) continue;
        if ((handle.number + 1) % handle.columns != 0) line(handle, handle.number + 1);
        if (handle.number + handle.columns < handle.control->size())
            line(handle, handle.number + handle.columns);
    }
}

/// A monitor's place is a circle with a cross, a control point a square.
void draw_handle(const Handle& handle, ImDrawList& list, ImVec2 at, bool lit, const Theme& theme,
                 float scale) {
    const float radius = (lit ? 9.0F : 7.0F) * scale, arm = 4 * scale;
    const std::pair<float, ImU32> strokes[] = {{4.5F, packed(theme.background, lit ? 1.0F : 0.75F)},
                                               {lit ? 2.2F : 1.6F, packed(theme.text, lit ? 1.0F : 0.8F)}};
    for (const auto& [width, ink] : strokes) {
        if (handle.control) {
            const float half = (lit ? 5.5F : 4.0F) * scale;
            list.AddRect({at.x - half, at.y - half}, {at.x + half, at.y + half}, ink, 0, 0, width * scale);
            continue;
        }
        list.AddCircle(at, radius, ink, 32, width * scale);
        list.AddLine({at.x - arm, at.y}, {at.x + arm, at.y}, ink, width * scale);
        list.AddLine({at.x, at.y - arm}, {at.x, at.y + arm}, ink, width * scale);
    }
}

} // namespace gaspard
