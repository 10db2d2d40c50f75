#include "core/spline/spline_domain.hpp"

#include "core/base/check.hpp"
#include "core/spline/control_points.hpp"
#include "core/spline/patch_checks.hpp"
#include "core/spline/patch_file.hpp"

namespace gaspard {

namespace {

Mesh patch_mesh(std::size_t cells, const std::vector<double>& line, const PatchMap& map) {
    const std::size_t side = line.size();
    Points xi(side * side);
    for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i) xi.set(j * side + i, {line[i], line[j], 0});
    Mesh mesh{.kind = {CellShape::quadrilateral, 2},
              .space_dimension = map.space_dimension(),
              .nodes = {},
              .cells = {}};
    map.points(xi, mesh.nodes);
    mesh.cells.reserve(9 * cells * cells);
    constexpr std::size_t local[9][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0},
                                         {2, 1}, {1, 2}, {0, 1}, {1, 1}}; // VTK's order
    for (std::size_t row = 0; row < cells; ++row)
        for (std::size_t column = 0; column < cells; ++column)
            for (const auto& [i, j] : local)
                mesh.cells.push_back(static_cast<std::int32_t>((2 * row + j) * side + 2 * column + i));
    return mesh;
}

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

std::vector<ParameterRow> rows() {
    return {{.key = "cells",
             .label = "Cells per side",
             .symbol = "n",
             .kind = ParameterKind::integer,
             .minimum = 4,
             .maximum = 256,
             .scale = ParameterScale::logarithmic,
             .default_value = std::int64_t{32},
             .help = "number of cells per side; the patch has n × n cells"},
            {.key = "degree",
             .label = "Degree",
             .symbol = "p",
             .kind = ParameterKind::integer,
             .minimum = 2,
             .maximum = highest_degree,
             .default_value = std::int64_t{3},
             .help = "spline degree; the splines have p − 1 continuous derivatives"}};
}

DomainType domain_type(const char* name, const char* label, const char* help,
                       std::vector<ParameterRow> rows) {
    return {.name = name,
            .label = label,
            .help = help,
            .rows = std::move(rows),
            .space = [](const Values&) { return Space{SpaceKind::euclidean}; },
            .spline_patch = true};
}

} // namespace

SplineDomain::SplineDomain(int degree, std::size_t cells, std::shared_ptr<const PatchMap> map,
                           std::shared_ptr<const Points> control, std::shared_ptr<const PatchList> patches)
    : degree_(degree), cells_(cells), map_(std::move(map)), control_(std::move(control)),
      patches_(std::move(patches)) {
    GASPARD_CHECK(map_ != nullptr && cells_ >= 1 && degree_ >= 2 && degree_ <= highest_degree);
    mesh_ = std::make_shared<const Mesh>(patch_mesh(cells_, node_lines(), *map_));
}

std::size_t SplineDomain::unknowns() const {
    const std::size_t size = cells_ + static_cast<std::size_t>(degree_);
    return size * size;
}

std::vector<double> SplineDomain::node_lines() const {
    std::vector<double> line(2 * cells_ + 1);
    for (std::size_t i = 0; i < line.size(); ++i)
        line[i] = static_cast<double>(i) / static_cast<double>(2 * cells_);
    return line;
}

std::vector<DomainType> spline_domains() {
    std::vector<DomainType> types;
    for (const auto& one : shipped()) types.push_back(domain_type(one.name, one.label, one.help, rows()));
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
    with_file.push_back(
        {.key = "patch",
         .label = "Patch",
         .kind = ParameterKind::text,
         .default_value = std::string(),
         .help = "which patch of a file that has several: its number, from 1, or id:ID with its id "
                 "in the file; if empty, the first",
         .role = ParameterRole::patch});
    with_file.push_back(
        {.key = "control_points",
         .label = "Control points",
         .kind = ParameterKind::text,
         .default_value = std::string(),
         .help = "control points of a planar patch, \"x y, x y, ...\", instead of the file's; in the window, "
                 "drag them",
         .role = ParameterRole::control_points});
    types.push_back(domain_type(from_file, "Patch from a file",
                                "a spline or NURBS patch with control points, in the plane or in space",
                                with_file));
    return types;
}

std::shared_ptr<const SplineDomain> make_spline_domain(const std::string& type, const Values& values,
                                                       const std::filesystem::path& folder) {
    const auto degree = static_cast<int>(values.integer("degree"));
    const auto cells = static_cast<std::size_t>(values.integer("cells"));
    for (const auto& one : shipped())
        if (type == one.name) return std::make_shared<SplineDomain>(degree, cells, one.map());
    GASPARD_CHECK(type == from_file);
    FoundPatch found = find_patch(values.text("file"), folder, values.text("patch"));
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
    const auto map = patch_map(std::move(patch));
    check_regular(*map, found.origin);
    return std::make_shared<SplineDomain>(degree, cells, map, std::move(control), std::move(found.patches));
}

} // namespace gaspard
