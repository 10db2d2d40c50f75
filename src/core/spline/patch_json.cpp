#include "core/spline/patch_json.hpp"

#include "core/base/error.hpp"
#include "core/base/number_text.hpp"
#include "core/base/parameter.hpp"
#include "core/spline/json_text.hpp"
#include "core/spline/patch_checks.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {

using Json = nlohmann::json;

const Json& member(const Json& json, const char* key, const std::string& origin) {
    const auto found = json.find(key);
    if (found == json.end()) not_a_patch(origin, "it has no '" + std::string(key) + "'");
    return *found;
}

const Json& list_in(const Json& json, const char* key, const std::string& origin) {
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

std::string text_in(const Json& json, const char* key) {
    const auto found = json.is_object() ? json.find(key) : json.end();
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

double number(const Json& json) { return json.is_number() ? json.get<double>() : 0; }

/// Some files say a number that the data tell, too. Where both are there, they must agree.
void check_said(const Json& json, const char* key, std::size_t actual, const std::string& of,
                const std::string& origin) {
    const auto found = json.find(key);
    if (found == json.end() || (found->is_number() && found->get<double>() == static_cast<double>(actual)))
        return;
    not_a_patch(origin, "'" + std::string(key) + "' is " + found->dump().substr(0, 40) + ", but " + of + " " +
                            std::to_string(actual));
}

/// Coordinates of each point, as points() found them.
std::size_t coordinates(const Json& control) { return control.empty() ? 0 : control.front().size(); }

Points points(const Json& control, const std::string& origin) {
    if (!control.is_array()) not_a_patch(origin, "control_points must be a list of points");
    Points all(control.size());
    for (std::size_t i = 0; i < control.size(); ++i) {
        const std::string what = "control_points[" + std::to_string(i) + "]";
        const auto point = numbers(control[i], what, origin);
        if (point.size() != 2 && point.size() != 3)
            not_a_patch(origin, what + " must have two or three coordinates");
        if (point.size() != control[0].size())
            not_a_patch(origin, what + " must have as many coordinates as control_points[0]");
        all.set(i, {point[0], point[1], point.size() == 3 ? point[2] : 0});
    }
    return all;
}

/// Our own files have no other keys, so that a misspelt one is not ignored.
void check_keys(const Json& json, const std::string& origin) {
    static const std::vector<std::string> known = {"degrees", "knots", "control_points", "weights"};
    for (const auto& [key, value] : json.items())
        if (std::find(known.begin(), known.end(), key) == known.end())
            not_a_patch(origin, "unknown key '" + key + "'" + did_you_mean(key, known) +
                                    "; allowed: degrees, knots, control_points, weights");
}

SplinePatch own_patch(const Json& json, const PatchText& file) {
    const std::string& origin = file.origin;
    if (!json.is_object()) not_a_patch(origin, "it must be an object with degrees, knots and control_points");
    check_keys(json, origin);
    const Json &degrees = list_in(json, "degrees", origin), &knots = list_in(json, "knots", origin);
    const bool other = degrees.size() == knots.size() && (degrees.size() == 2 || degrees.size() == 3);
    if (const auto refusal = refusal_of_directions(degrees.size(), file); other && !refusal.empty())
        cannot_read(origin, "it is " + refusal);
    if (degrees.size() != file.directions || knots.size() != file.directions)
        not_a_patch(origin, std::string("degrees and knots must have ") +
                                (file.directions == 2 ? "two" : "three") + " entries, one per direction");
    PatchParts parts{.directions = file.directions};
    for (std::size_t d = 0; d < parts.directions; ++d) {
        parts.degrees[d] = number(degrees[d]);
        parts.knots[d] = numbers(knots[d], "knots[" + std::to_string(d) + "]", origin);
    }
    parts.control = points(list_in(json, "control_points", origin), origin);
    if (json.contains("weights")) {
        parts.weights = numbers(json["weights"], "weights", origin);
        if (parts.weights.empty()) not_a_patch(origin, "there must be as many weights as control points");
    }
    return make_patch(std::move(parts), origin);
}

/// Control points with the second direction fastest, as geomdl has them.
template <class List>
List first_fastest(const List& list, std::size_t first, std::size_t second, const auto& put) {
    List turned = list;
    for (std::size_t i = 0; i < first; ++i)
        for (std::size_t j = 0; j < second; ++j) put(turned, j * first + i, list, i * second + j);
    return turned;
}

/// geomdl's "rational", where it is given, agrees with the weights.
void check_rational(const Json& json, const std::vector<double>& weights, const std::string& origin) {
    const auto rational = json.find("rational");
    if (rational == json.end()) return;
    if (!rational->is_boolean()) not_a_patch(origin, "'rational' must be true or false");
    if (rational->get<bool>() && weights.empty())
        not_a_patch(origin, "'rational' is true, but there are no weights");
    if (!rational->get<bool>() &&
        std::any_of(weights.begin(), weights.end(), [](double w) { return w != 1; }))
        not_a_patch(origin, "'rational' is false, but there are weights other than 1");
}

SplinePatch geomdl_patch(const Json& json, const std::string& origin) {
    PatchParts parts;
    parts.degrees = {number(member(json, "degree_u", origin)), number(member(json, "degree_v", origin))};
    parts.knots = {numbers(member(json, "knotvector_u", origin), "knotvector_u", origin),
                   numbers(member(json, "knotvector_v", origin), "knotvector_v", origin)};
    const Json& control = member(json, "control_points", origin);
    if (!control.is_object()) not_a_patch(origin, "control_points must be an object");
    const Json& rows = member(control, "points", origin);
    const Points given = points(rows, origin);
    check_said(json, "dimension", coordinates(rows), "the number of coordinates of a point is", origin);
    const double u = number(member(json, "size_u", origin)), v = number(member(json, "size_v", origin));
    const bool whole = u >= 1 && v >= 1 && u == std::floor(u) && v == std::floor(v);
    if (!whole || u * v != static_cast<double>(given.size()))
        not_a_patch(origin, "size_u and size_v do not fit the number of control points");
    const auto first = static_cast<std::size_t>(u), second = static_cast<std::size_t>(v);
    parts.control =
        first_fastest(given, first, second, [](Points& to, std::size_t a, const Points& from, std::size_t b) {
            to.set(a, from[b]);
        });
    if (control.contains("weights")) {
        const auto weights = numbers(control["weights"], "weights", origin);
        if (weights.size() != given.size())
            not_a_patch(origin, "there must be as many weights as control points");
        parts.weights =
            first_fastest(weights, first, second,
                          [](auto& to, std::size_t a, const auto& from, std::size_t b) { to[a] = from[b]; });
    }
    check_rational(json, parts.weights, origin);
    return make_patch(std::move(parts), origin);
}

std::string geomdl_refusal(const Json& shape, const Json& entry, const PatchText& file) {
    const std::string type = text_in(shape, "type");
    if (type != "surface") return "a " + (type.empty() ? "shape without type" : type) + ", not a surface";
    if (file.directions == 3) return refusal_of_directions(2, file);
    if (!entry.is_object()) return "not an object";
    const auto trims = entry.find("trims");
    return trims != entry.end() && !trims->empty() ? "a trimmed surface" : "";
}

FoundPatch geomdl(const Json& shape, const PatchText& file) {
    if (!shape.is_object()) not_a_patch(file.origin, "'shape' must be an object");
    const Json& data = member(shape, "data", file.origin);
    const Json list = data.is_array() ? data : Json::array({data});
    check_said(shape, "count", list.size(), "the number of entries of 'data' is", file.origin);
    std::vector<PatchEntry> entries;
    for (const Json& one : list) entries.push_back({"surface", {}, geomdl_refusal(shape, one, file)});
    ChosenPatch chosen = choose_patch(entries, file);
    SplinePatch patch = geomdl_patch(list[chosen.entry], chosen.origin);
    return {std::move(patch), std::move(chosen.origin), std::move(chosen.patches)};
}

/// Numbers as a list (of numbers, or of lists of one), or as base64 of doubles.
std::vector<double> splinepy_numbers(const Json& json, const std::string& what, const std::string& origin) {
    if (json.is_string()) {
        try {
            return decode_numbers(json.get_ref<const std::string&>(), "float64", what);
        } catch (const InputError& error) {
            not_a_patch(origin, error.what());
        }
    }
    if (!json.is_array()) not_a_patch(origin, what + " must be a list of numbers");
    Json flat = Json::array();
    for (const Json& one : json) flat.push_back(one.is_array() && one.size() == 1 ? one.front() : one);
    return numbers(flat, what, origin);
}

bool has_knots(const std::string& type) { return type == "BSpline" || type == "NURBS"; }
bool has_weights(const std::string& type) { return type == "RationalBezier" || type == "NURBS"; }

SplinePatch splinepy_patch(const Json& json, std::size_t directions, const std::string& origin) {
    const std::string type = text_in(json, "SplineType");
    const Json& degrees = list_in(json, "degrees", origin);
    PatchParts parts{.directions = directions};
    check_said(json, "para_dim", degrees.size(), "the number of degrees is", origin);
    for (std::size_t d = 0; d < directions; ++d) {
        const double degree = parts.degrees[d] = d < degrees.size() ? number(degrees[d]) : 0;
        if (has_knots(type)) {
            const Json& knots = list_in(json, "knot_vectors", origin);
            if (knots.size() != directions)
                not_a_patch(origin, std::string("knot_vectors must have ") +
                                        (directions == 2 ? "two" : "three") + " entries");
            parts.knots[d] = numbers(knots[d], "knot_vectors[" + std::to_string(d) + "]", origin);
        } else if (degree >= 1 && degree <= highest_degree) {
            parts.knots[d].assign(static_cast<std::size_t>(degree) + 1, 0.0);
            parts.knots[d].insert(parts.knots[d].end(), static_cast<std::size_t>(degree) + 1, 1.0);
        }
    }
    const Json& control = member(json, "control_points", origin);
    if (control.is_string()) {
        const double dimension = json.contains("dim") ? number(json["dim"]) : 0;
        if (dimension != 2 && dimension != 3) not_a_patch(origin, "'dim' must be 2 or 3");
        const auto d = static_cast<std::size_t>(dimension);
        const auto values = splinepy_numbers(control, "control_points", origin);
        if (values.size() % d != 0)
            not_a_patch(origin, "the length of control_points is not a multiple of dim");
        parts.control = points_in_rows(values, d);
    } else {
        parts.control = points(control, origin);
        check_said(json, "dim", coordinates(control), "the number of coordinates of a point is", origin);
    }
    if (has_weights(type)) {
        parts.weights = splinepy_numbers(member(json, "weights", origin), "weights", origin);
        if (parts.weights.empty()) not_a_patch(origin, "there must be as many weights as control points");
    }
    return make_patch(std::move(parts), origin);
}

FoundPatch splinepy(const Json& json, const PatchText& file) {
    const Json& list = json["SplineList"];
    if (!list.is_array()) not_a_patch(file.origin, "'SplineList' must be a list");
    check_said(json, "NumberOfSplines", list.size(), "the number of entries of 'SplineList' is", file.origin);
    std::vector<PatchEntry> entries;
    for (const Json& one : list) {
        PatchEntry entry{text_in(one, "SplineType"), {}, {}};
        const bool known = has_knots(entry.kind) || has_weights(entry.kind) || entry.kind == "Bezier";
        if (entry.kind.empty()) entry.kind = "an entry without SplineType";
        const auto degrees = one.is_object() ? one.find("degrees") : one.end();
        const std::size_t directions = degrees != one.end() && degrees->is_array() ? degrees->size() : 0;
        if (!known)
            entry.refusal = "no kind of spline that is known";
        else
            entry.refusal = refusal_of_directions(directions, file);
        entries.push_back(std::move(entry));
    }
    ChosenPatch chosen = choose_patch(entries, file);
    SplinePatch patch = splinepy_patch(list[chosen.entry], file.directions, chosen.origin);
    return {std::move(patch), std::move(chosen.origin), std::move(chosen.patches)};
}

} // namespace

FoundPatch read_json_patch(const PatchText& file) {
    Json json;
    try {
        json = parse_json(file.text);
    } catch (const InputError& error) {
        not_a_patch(file.origin, error.what());
    }
    if (json.is_object() && json.contains("shape")) return geomdl(json["shape"], file);
    if (json.is_object() && json.contains("SplineList")) return splinepy(json, file);
    const ChosenPatch chosen = choose_patch({{"patch", {}, {}}}, file);
    return {own_patch(json, file), chosen.origin, nullptr};
}

} // namespace gaspard
