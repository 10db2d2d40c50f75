#include "core/spline/patch_file.hpp"

#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/spline/patch_checks.hpp"
#include "core/spline/patch_xml.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>

namespace gaspard {

namespace {

using Json = nlohmann::json;

const Json& member(const Json& json, const char* key, const std::string& origin) {
    if (!json.is_object()) not_a_patch(origin, "it must be an object with degrees, knots and control_points");
    const auto found = json.find(key);
    if (found == json.end() || !found->is_array())
        not_a_patch(origin, "it has no list '" + std::string(key) + "'");
    return *found;
}

std::vector<double> numbers(const Json& json, const std::string& what, const std::string& origin) {
    if (!json.is_array()) not_a_patch(origin, what + " must be a list of numbers");
    std::vector<double> all;
    for (const auto& one : json) {
        if (!one.is_number() || !std::isfinite(one.get<double>()))
            not_a_patch(origin, what + " must be a list of finite numbers");
        all.push_back(one.get<double>());
    }
    return all;
}

} // namespace

SplinePatch parse_patch(std::string_view text, const std::string& origin) {
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::parse_error& error) {
        not_a_patch(origin, "JSON syntax error at character " + std::to_string(error.byte));
    }
    const Json &degrees = member(json, "degrees", origin), &knots = member(json, "knots", origin);
    if (degrees.size() != 2 || knots.size() != 2)
        not_a_patch(origin, "degrees and knots must have two entries, one per direction");
    SplinePatch patch;
    for (std::size_t d = 0; d < 2; ++d) {
        const std::string which = std::to_string(d);
        patch.space.directions.push_back(
            checked_direction(degrees[d].is_number() ? degrees[d].get<double>() : 0,
                              numbers(knots[d], "knots[" + which + "]", origin), which, origin));
    }
    const Json& control = member(json, "control_points", origin);
    patch.control = Points(control.size());
    for (std::size_t i = 0; i < control.size(); ++i) {
        const std::string what = "control_points[" + std::to_string(i) + "]";
        const auto point = numbers(control[i], what, origin);
        if (point.size() != 2 && point.size() != 3)
            not_a_patch(origin, what + " must have two or three coordinates");
        patch.control.set(i, {point[0], point[1], point.size() == 3 ? point[2] : 0});
    }
    patch.weights.assign(control.size(), 1.0);
    if (json.contains("weights")) patch.weights = numbers(json["weights"], "weights", origin);
    check_patch(patch, origin);
    return patch;
}

SplinePatch read_patch(const std::filesystem::path& file) {
    const std::string text = read_file(file);
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return ending == ".xml" ? parse_patch_xml(text, file.string()) : parse_patch(text, file.string());
}

SplinePatch find_patch(const std::string& json_or_file) {
    const auto begin = json_or_file.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) return nurbs_disk();
    return json_or_file[begin] == '{' ? parse_patch(json_or_file, "domain.file") : read_patch(json_or_file);
}

std::string patch_json(const SplinePatch& patch) {
    nlohmann::ordered_json json;
    for (const auto& direction : patch.space.directions) {
        json["degrees"].push_back(direction.degree);
        json["knots"].push_back(direction.knots);
    }
    for (std::size_t i = 0; i < patch.control.size(); ++i) {
        const Vec3 c = patch.control[i];
        json["control_points"].push_back({c.x, c.y, c.z});
    }
    json["weights"] = patch.weights;
    return json.dump(1) + '\n';
}

// Nine control points: corners at 45 degrees, and the intersections of their tangents.
SplinePatch nurbs_disk() {
    const double s = std::sqrt(0.5);
    const KnotVector line{2, {0, 0, 0, 1, 1, 1}};
    SplinePatch patch{{{line, line}}, Points(9), {1, s, 1, s, 1, s, 1, s, 1}};
    const double at[3] = {-s, 0, s}, out[3] = {-2 * s, 0, 2 * s};
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i)
            patch.control.set(3 * j + i, {j == 1 ? out[i] : at[i], i == 1 ? out[j] : at[j], 0});
    return patch;
}

} // namespace gaspard
