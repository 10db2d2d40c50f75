#include "core/mesh/control_points.hpp"

#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/parameter.hpp"

#include <charconv>
#include <cmath>

namespace gaspard {

namespace {

/// Reads a number from the front of the text and removes it; false if there is none.
bool take_number(std::string_view& text, double& number) {
    const auto begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) return false;
    const auto [end, code] = std::from_chars(text.data() + begin, text.data() + text.size(), number);
    if (code != std::errc() || !std::isfinite(number)) return false;
    if (end != text.data() + text.size() && *end != ' ') return false; // rejects "1-2"
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

} // namespace

Points parse_points(std::string_view text, const std::string& key) {
    Points control;
    for (const std::string_view part : split(text, ",")) {
        std::string_view one = part;
        Vec3 point;
        if (!take_number(one, point.x) || !take_number(one, point.y) ||
            one.find_first_not_of(' ') != std::string_view::npos)
            throw InputError(key + " must be a list of points of two numbers, as in \"0 0, 1 0.5\", not '" +
                             std::string(part) + "'");
        control.resize(control.size() + 1);
        control.set(control.size() - 1, point);
    }
    return control;
}

Points parse_control_points(std::string_view text, std::size_t count, const std::string& key,
                            const std::string& owner) {
    Points control = parse_points(text, key);
    if (control.size() != count)
        throw InputError(key + " lists " + std::to_string(control.size()) + " points, but " + owner +
                         " has " + std::to_string(count));
    return control;
}

std::string format_control_points(const Points& control) {
    std::string text;
    for (std::size_t i = 0; i < control.size(); ++i)
        text += (i == 0 ? "" : ", ") + format_number(control.x[i]) + ' ' + format_number(control.y[i]);
    return text;
}

} // namespace gaspard
