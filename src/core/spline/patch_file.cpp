#include "core/spline/patch_file.hpp"

#include "core/base/read_data_file.hpp"
#include "core/base/user_path.hpp"
#include "core/spline/patch_json.hpp"
#include "core/spline/patch_text.hpp"
#include "core/spline/patch_xml.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace gaspard {

namespace {

constexpr std::string_view utf16_json = "JSON in UTF-16; save it as UTF-8";

/// How the content of a kind of file begins, after blanks.
struct FileKind {
    std::string_view begins;
    FoundPatch (*read)(const PatchText&); ///< null: it is not read
    std::string_view name;                ///< of a kind that is not read
};

using namespace std::string_view_literals;

constexpr std::array<FileKind, 21> kinds = {{
    {"{", &read_json_patch, {}},
    {"[", &read_json_patch, {}},
    {"<", &read_gismo, {}},
    {"\xff\xfe{", nullptr, utf16_json}, // after the byte order mark of UTF-16
    {"\xff\xfe[", nullptr, utf16_json},
    {"\xfe\xff\0{"sv, nullptr, utf16_json},
    {"\xfe\xff\0["sv, nullptr, utf16_json},
    {"\xff\xfe", &read_gismo, {}},
    {"\xfe\xff", &read_gismo, {}},
    {"MFEM NURBS mesh", &read_mfem, {}},
    {"# nurbs mesh v.", &read_geopdes, {}},
    {"\x1f\x8b", nullptr, "a gzip-compressed file; decompress it first (gunzip)"},
    {"PK\x03\x04", nullptr, "a zip archive or a file of numpy (.npz)"},
    {"MFEM", nullptr, "an MFEM file, but not an MFEM NURBS mesh"},
    {"ISO-10303-21", nullptr, "a STEP file"},
    {"3D Geometry File Format", nullptr, "a Rhino file (.3dm)"},
    {"CASCADE Topology", nullptr, "an OpenCASCADE file (.brep)"},
    {"DBRep_DrawableShape", nullptr, "an OpenCASCADE file (.brep)"},
    {"glTF", nullptr, "a glTF file"},
    {"ply", nullptr, "a PLY file, a mesh and not a spline"},
    {"solid", nullptr, "an STL file, a mesh and not a spline"},
}};

std::string_view without_blanks(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    return text;
}

/// Programs on Windows begin files in UTF-8 with a mark; no reader needs it.
std::string_view without_mark(std::string_view text) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    return text;
}

} // namespace

FoundPatch parse_patch(const PatchText& given) {
    PatchText file = given;
    file.text = without_mark(file.text);
    const std::string_view begin = without_blanks(file.text);
    if (begin.empty()) cannot_read(file.origin, "it is empty");
    for (const FileKind& kind : kinds) {
        if (!begin.starts_with(kind.begins)) continue;
        if (kind.read == nullptr) cannot_read(file.origin, "it is " + std::string(kind.name));
        FoundPatch found = kind.read(file);
        if (const auto refusal = refusal_of_directions(found.patch.space.directions.size(), file);
            !refusal.empty())
            cannot_read(found.origin, "it is " + refusal);
        return found;
    }
    cannot_read(file.origin,
                "it is none of the kinds of patch file that are read: JSON of Gaspard, geomdl or "
                "splinepy, XML of G+Smo, NURBS meshes of MFEM, geometries of GeoPDEs");
}

FoundPatch read_patch(const std::filesystem::path& file, const std::string& which, std::size_t directions) {
    const std::string text = read_file(file, largest_patch_file);
    return parse_patch({text, file.string(), which, directions});
}

FoundPatch find_patch(const std::string& json_or_file, const std::filesystem::path& folder,
                      const std::string& which, std::size_t directions) {
    if (is_path(json_or_file)) return read_patch(user_path(json_or_file, folder), which, directions);
    if (is_data_uri(json_or_file)) {
        const std::string text = read_data_file(json_or_file, folder, largest_patch_file);
        return parse_patch({text, data_file_name(json_or_file), which, directions});
    }
    if (!without_blanks(json_or_file).empty())
        return parse_patch({json_or_file, "domain.file", which, directions});
    const std::string built_in = directions == 2 ? "the built-in disk" : "the built-in cylinder";
    choose_patch({{"patch", {}, {}}}, {{}, built_in, which, directions});
    return {directions == 2 ? nurbs_disk() : nurbs_cylinder(), built_in};
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

SplinePatch nurbs_cylinder() {
    SplinePatch disk = nurbs_disk();
    const std::size_t n = disk.control.size();
    disk.space.directions.push_back({1, {0, 0, 1, 1}});
    disk.control.resize(2 * n);
    for (std::size_t i = 0; i < n; ++i) {
        disk.control.set(n + i, disk.control[i] + Vec3{0, 0, 2});
        disk.weights.push_back(disk.weights[i]);
    }
    return disk;
}

} // namespace gaspard
