#include "core/tessellate/cut_planes.hpp"

#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/number_text.hpp"
#include "core/base/parameter.hpp"

#include <array>

namespace gaspard {

namespace {

constexpr std::array axis_names = {"x", "y", "z"};
constexpr std::array<Vec3, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

[[noreturn]] void refuse_cut(std::string_view text, const std::string& why) {
    throw InputError("view.cut = '" + std::string(text) + "' " + why);
}

std::vector<std::string_view> words_in(std::string_view text) {
    std::vector<std::string_view> words;
    for (const std::string_view word : split(text, " "))
        if (!word.empty()) words.push_back(word);
    return words;
}

double coordinate(std::string_view text, std::string_view word) {
    const auto number = parse_number(word);
    if (!number || !(std::abs(*number) <= 1e100))
        refuse_cut(text, "has '" + std::string(word) + "' where a number is expected");
    return *number;
}

CutPlane read_plane(std::string_view text, const std::vector<std::string_view>& words) {
    for (std::size_t axis = 0; axis < 3 && words.size() == 2; ++axis)
        for (const double sign : {1.0, -1.0}) {
            const std::string name = (sign < 0 ? "-" : "") + std::string(axis_names[axis]);
            if (words[0] == name) return {sign * axes[axis], coordinate(text, words[1]) * axes[axis]};
        }
    if (words.size() != 8 || words[0] != "normal" || words[4] != "at")
        refuse_cut(text,
                   "must be planes such as 'x 0.5', '-z 0' or 'normal 1 1 0 at 0 0 0', in a wedge joined "
                   "by 'and', separated by ';'");
    const auto vector = [&](std::size_t i) {
        return Vec3{coordinate(text, words[i]), coordinate(text, words[i + 1]),
                    coordinate(text, words[i + 2])};
    };
    const Vec3 normal = vector(1);
    const double length = norm(normal);
    if (!(length > 1e-100)) refuse_cut(text, "has a normal of length 0");
    return {(1 / length) * normal, vector(5)};
}

std::string three_numbers(Vec3 v) {
    return format_number(v.x) + ' ' + format_number(v.y) + ' ' + format_number(v.z);
}

/// Few digits of a unit vector; parse_cut() makes it one again.
double short_part(double part) { return std::round(part * 1e4) / 1e4 + 0.0; }

std::string plane_text(const CutPlane& plane) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (std::abs(dot(plane.normal, axes[axis])) > 1 - 1e-12)
            return (dot(plane.normal, axes[axis]) < 0 ? "-" : "") + std::string(axis_names[axis]) + ' ' +
                   format_number(dot(plane.at, axes[axis]));
    const Vec3 n = plane.normal;
    return "normal " + three_numbers({short_part(n.x), short_part(n.y), short_part(n.z)}) + " at " +
           three_numbers(plane.at);
}

} // namespace

std::vector<CutWedge> parse_cut(std::string_view text) {
    std::vector<CutWedge> cut;
    std::size_t planes = 0;
    if (words_in(text).empty()) return cut;
    for (const std::string_view part : split(text, ";")) {
        CutWedge wedge;
        std::vector<std::string_view> words;
        const auto end_plane = [&] {
            wedge.push_back(read_plane(text, words));
            words.clear();
            if (++planes > most_cut_planes)
                refuse_cut(text, "has more than " + std::to_string(most_cut_planes) + " planes");
        };
        for (const std::string_view word : words_in(part))
            if (word == "and")
                end_plane();
            else
                words.push_back(word);
        end_plane();
        cut.push_back(std::move(wedge));
    }
    return cut;
}

std::string format_cut(const std::vector<CutWedge>& cut) {
    std::vector<std::string> wedges;
    for (const CutWedge& wedge : cut) {
        std::vector<std::string> planes;
        for (const CutPlane& plane : wedge) planes.push_back(plane_text(plane));
        wedges.push_back(join(planes, " and "));
    }
    return join(wedges, "; ");
}

std::vector<CutWedge> flipped(std::vector<CutWedge> cut) {
    for (CutWedge& wedge : cut)
        for (CutPlane& plane : wedge) plane.normal = -1 * plane.normal;
    return cut;
}

} // namespace gaspard
