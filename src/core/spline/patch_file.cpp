#include "core/spline/patch_file.hpp"

#include "core/base/error.hpp"
#include "core/base/parameter.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

namespace gaspard {

namespace {

using Json = nlohmann::json;

[[noreturn]] void wrong(const std::string& origin, const std::string& what) {
    throw InputError(origin + " is no patch: " + what);
}

const Json& member(const Json& json, const char* key, const std::string& origin) {
    if (!json.is_object()) wrong(origin, "it has to be an object with degrees, knots and control_points");
    const auto found = json.find(key);
    if (found == json.end() || !found->is_array())
        wrong(origin, "there is no list '" + std::string(key) + "'");
    return *found;
}

std::vector<double> numbers(const Json& json, const std::string& what, const std::string& origin) {
    if (!json.is_array()) wrong(origin, what + " has to be a list of numbers");
    std::vector<double> all;
    for (const auto& one : json) {
        if (!one.is_number() || !std::isfinite(one.get<double>()))
            wrong(origin, what + " has to be a list of finite numbers");
        all.push_back(one.get<double>());
    }
    return all;
}

KnotVector direction(const Json& degree, const Json& knots, const std::string& which,
                     const std::string& origin) {
    if (!degree.is_number_integer() || degree < 1 || degree > highest_degree)
        wrong(origin, "degrees has to be two whole numbers from 1 to " + std::to_string(highest_degree));
    KnotVector space{degree.get<int>(), numbers(knots, "knots[" + which + "]", origin)};
    if (!space.knots.empty()) {
        const double first = space.knots.front(), length = space.knots.back() - first;
        for (double& knot : space.knots)
            knot = knot == space.knots.back() ? (length > 0 ? 1 : 0) : (knot - first) / length;
    }
    if (!is_open(space))
        wrong(origin, "knots[" + which + "] has to ascend and to be open: the first and the last knot " +
                          std::to_string(space.degree + 1) + " times for degree " +
                          std::to_string(space.degree) + ", none more often");
    return space;
}

} // namespace

SplinePatch parse_patch(std::string_view text, const std::string& origin) {
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::exception& error) {
        wrong(origin, error.what());
    }
    const Json &degrees = member(json, "degrees", origin), &knots = member(json, "knots", origin);
    if (degrees.size() != 2 || knots.size() != 2)
        wrong(origin, "degrees and knots need one entry per direction, two in all");
    SplinePatch patch;
    for (std::size_t d = 0; d < 2; ++d)
        patch.space.directions.push_back(direction(degrees[d], knots[d], std::to_string(d), origin));
    const std::size_t n = patch.space.size();
    const Json& control = member(json, "control_points", origin);
    if (control.size() != n)
        wrong(origin, "the knots are for " + std::to_string(n) + " control points, and there are " +
                          std::to_string(control.size()));
    patch.control = Points(n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::string what = "control_points[" + std::to_string(i) + "]";
        const auto point = numbers(control[i], what, origin);
        if (point.size() != 2 && point.size() != 3) wrong(origin, what + " needs two or three coordinates");
        patch.control.set(i, {point[0], point[1], point.size() == 3 ? point[2] : 0});
    }
    patch.weights.assign(n, 1.0);
    if (json.contains("weights")) patch.weights = numbers(json["weights"], "weights", origin);
    if (patch.weights.size() != n) wrong(origin, "there have to be as many weights as control points");
    for (const double w : patch.weights)
        if (!(w > 0)) wrong(origin, "weights have to be positive, and one is " + format_number(w));
    return patch;
}

SplinePatch read_patch(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError("the patch " + file.string() + " cannot be read (domain.file)");
    const std::string text(std::istreambuf_iterator<char>(in), {});
    return parse_patch(text, file.string());
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

// Nine points: corners at 45 degrees, the middles of the sides where the tangents there meet.
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
