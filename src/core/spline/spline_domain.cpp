#include "core/spline/spline_domain.hpp"

#include "core/base/box.hpp"
#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/mesh/control_points.hpp"
#include "core/spline/patch_checks.hpp"
#include "core/spline/patch_content.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <limits>
#include <optional>

namespace gaspard {

namespace {

/// A built-in patch.
struct Shipped {
    const char* name;
    const char* label;
    const char* help;
    std::shared_ptr<const PatchMap> (*map)();
};

constexpr const char* from_file = "spline-patch";

const std::vector<Shipped>& shipped() {
    static const std::vector<Shipped> all = {
        {"spline-square", "Spline square", "the unit square", square_map},
        {"spline-disk", "Spline disk", "the unit disk, mapped from a square", disk_map},
        {"spline-annulus", "Spline annulus", "a quarter annulus with radii 1/2 and 1", quarter_annulus_map},
        {"spline-torus", "Spline torus", "part of a torus with radii 3 and 1, a surface in space",
         torus_part_map},
        {"spline-moebius", "Möbius strip", "a Möbius strip of width 1, cut open", moebius_map}};
    return all;
}

/// Around points of the patch, its edges included.
Box box_around(const PatchMap& map) {
    constexpr std::size_t side = 65;
    Points xi(side * side), x;
    for (std::size_t i = 0; i < xi.size(); ++i)
        xi.set(i,
               {static_cast<double>(i % side) / (side - 1), static_cast<double>(i / side) / (side - 1), 0});
    map.points(xi, x);
    return bounding_box(x);
}

Vec3 middle_of(const PatchMap& map) {
    Points xi(1), x;
    xi.set(0, {0.5, 0.5, 0});
    map.points(xi, x);
    return x[0];
}

/// The space of a patch whose file is invalid: monitors may have any size and place.
Space anywhere() {
    constexpr double large = 1e12, small = 1e-12;
    const auto cube = [](double half) { return Box{{-half, -half, -half}, {half, half, half}}; };
    return {.dimension = 3, .reach = {cube(large), cube(small)}, .patch = true};
}

std::vector<ParameterRow> rows() { return cells_and_degree_rows(256, 32, "the patch has n × n cells"); }

DomainType domain_type(const Shipped& one, std::vector<ParameterRow> rows) {
    const auto map = one.map();
    const Space space{.dimension = map->space_dimension(), .reach = {box_around(*map)}, .patch = true};
    return {.name = one.name,
            .label = one.label,
            .help = one.help,
            .rows = std::move(rows),
            .space = [space](const Values&, const DomainContent&) { return space; },
            .spline_patch = true};
}

/// A patch from a file has its box. The unit disk without a file is a built-in patch like the others. Moved
/// control points extend the ranges only, so that a monitor stays where it is while they are dragged.
Space space_of_patch(const Values& values, const DomainContent& content) {
    const auto* read = static_cast<const PatchContent*>(content.get());
    if (!read || !read->found) return anywhere();
    try {
        const std::string &file = values.text("file"), &points = values.text("control_points");
        SplinePatch patch = read->found->patch;
        const auto map = patch_map(patch);
        Space space{.dimension = map->space_dimension(), .patch = true};
        const Box box = box_around(*map);
        if (!(longest_side(box) > 0)) return anywhere();
        if (file.find_first_not_of(" \t\r\n") == std::string::npos) {
            space.reach = {box};
        } else {
            space.box = box;
            space.middle = space.dimension == 3 ? middle_of(*map) : box.centre();
        }
        if (points.empty()) return space;
        patch.control = parse_control_points(points, patch.control.size());
        space.reach.push_back(box_around(*patch_map(patch)));
        return space;
    } catch (const InputError&) { // control points of another patch
    }
    return anywhere();
}

} // namespace

std::vector<DomainType> spline_domains() {
    std::vector<DomainType> types;
    for (const auto& one : shipped()) types.push_back(domain_type(one, rows()));
    std::vector<ParameterRow> with_file = rows();
    with_file.push_back(
        {.key = "file",
         .label = "File",
         .kind = ParameterKind::text,
         .default_value = std::string(),
         .help =
             "patch file, such as JSON or G+Smo's XML (docs/splines.md), or the JSON text itself; if empty, "
             "the unit disk as a NURBS patch",
         .role = ParameterRole::file});
    with_file.push_back(patch_row());
    with_file.push_back(
        {.key = "control_points",
         .label = "Control points",
         .kind = ParameterKind::text,
         .default_value = std::string(),
         .help = "control points of a planar patch, \"x y, x y, ...\", instead of the file's; in the window, "
                 "drag them",
         .role = ParameterRole::control_points});
    types.push_back(
        {.name = from_file,
         .label = "Patch from a file",
         .help = "a spline or NURBS patch with control points, in the plane or in space",
         .rows = std::move(with_file),
         .space = space_of_patch,
         .read = [](const Values& values,
                    const std::filesystem::path& folder) { return read_patch_content(values, folder, 2); },
         .spline_patch = true});
    return types;
}

std::shared_ptr<const SplineDomain> make_spline_domain(const std::string& type, const Values& values,
                                                       const std::filesystem::path& folder,
                                                       const DomainContent& content) {
    const auto degree = static_cast<int>(values.integer("degree"));
    const auto cells = static_cast<std::size_t>(values.integer("cells"));
    for (const auto& one : shipped())
        if (type == one.name) return std::make_shared<SplineDomain>(degree, cells, one.map());
    GASPARD_CHECK(type == from_file);
    FoundPatch found = patch_of_content(values, folder, content, 2);
    SplinePatch& patch = found.patch;
    const bool flat = patch_map(patch)->space_dimension() == 2;
    if (const std::string& points = values.text("control_points"); !points.empty()) {
        if (!flat)
            throw InputError("domain.control_points requires a planar patch, but that of " + found.origin +
                             " is in space");
        patch.control = parse_control_points(points, patch.control.size());
        found.origin = "domain.control_points";
    }
    auto control = flat ? std::make_shared<const Points>(patch.control) : nullptr;
    const std::size_t columns = flat ? patch.space.directions[0].size() : 0;
    const auto map = patch_map(std::move(patch));
    check_regular(*map, found.origin);
    return std::make_shared<SplineDomain>(degree, cells, map, std::move(control), std::move(found.patches),
                                          columns);
}

} // namespace gaspard
