#include "core/spline/solid_domain.hpp"

#include "core/base/box.hpp"
#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/spline/patch_checks.hpp"
#include "core/spline/patch_content.hpp"

namespace gaspard {

namespace {

struct ShippedSolid {
    const char* name;
    const char* label;
    const char* help;
    std::shared_ptr<const SolidMap> (*map)();
};

const std::vector<ShippedSolid>& shipped_solids() {
    static const std::vector<ShippedSolid> all = {
        {"spline-cube", "Spline cube", "the unit cube", cube_map},
        {"spline-ball", "Spline ball", "the unit ball, mapped from a cube", ball_map},
        {"spline-cylinder", "Spline cylinder", "a cylinder of radius 1 and height 2", cylinder_map},
        {"spline-half-torus", "Half torus", "half of a solid torus with radii 2 and 1", half_torus_map}};
    return all;
}

Box box_around(const SolidMap& map) {
    constexpr std::size_t side = 17;
    Points xi(side * side * side), x;
    const auto place = [](std::size_t i) { return static_cast<double>(i) / (side - 1); };
    for (std::size_t i = 0; i < xi.size(); ++i)
        xi.set(i, {place(i % side), place(i / side % side), place(i / side / side)});
    map.points(xi, x);
    return bounding_box(x);
}

std::vector<ParameterRow> solid_rows() {
    return cells_and_degree_rows(64, 16, "the solid has n × n × n cells");
}

/// Of a solid from a file. If the file is invalid, monitors may have any size and place.
Space space_of_solid(const Values&, const DomainContent& content) {
    const auto* read = static_cast<const PatchContent*>(content.get());
    if (read && read->found) {
        const Box box = box_around(*solid_map(read->found->patch));
        if (longest_side(box) > 0) return {.dimension = 3, .solid = true, .box = box, .middle = box.centre()};
    }
    const auto cube = [](double half) { return Box{{-half, -half, -half}, {half, half, half}}; };
    return {.dimension = 3, .solid = true, .reach = {cube(1e12), cube(1e-12)}};
}

/// Newton's method keeps nine numbers for each of the (n (p + 1))^3 quadrature points.
void check_size(int degree, std::size_t cells) {
    constexpr std::size_t most_points = 400; // per direction: 4.6 GB
    const std::size_t most = most_points / (static_cast<std::size_t>(degree) + 1);
    if (cells > most)
        throw InputError("a solid of degree " + std::to_string(degree) + " may have at most " +
                         std::to_string(most) +
                         " cells per side, but domain.cells = " + std::to_string(cells));
}

DomainType from_file() {
    std::vector<ParameterRow> rows = solid_rows();
    rows.push_back({.key = "file",
                    .label = "File",
                    .kind = ParameterKind::text,
                    .default_value = std::string(),
                    .help =
                        "file of a solid, such as JSON or G+Smo's XML (docs/splines.md), or the JSON text "
                        "itself; if empty, a cylinder as a NURBS solid",
                    .role = ParameterRole::file});
    rows.push_back(patch_row());
    return {.name = std::string(own_solid_domain),
            .label = "Solid from a file",
            .help = "a spline or NURBS solid with control points",
            .rows = std::move(rows),
            .space = space_of_solid,
            .read = [](const Values& values,
                       const std::filesystem::path& folder) { return read_patch_content(values, folder, 3); },
            .spline_patch = true};
}

} // namespace

std::vector<DomainType> solid_domains() {
    std::vector<DomainType> types;
    for (const ShippedSolid& one : shipped_solids()) {
        const Space space{.dimension = 3, .solid = true, .reach = {box_around(*one.map())}};
        types.push_back({.name = one.name,
                         .label = one.label,
                         .help = one.help,
                         .rows = solid_rows(),
                         .space = [space](const Values&, const DomainContent&) { return space; },
                         .spline_patch = true});
    }
    types.push_back(from_file());
    return types;
}

std::shared_ptr<const SolidDomain> make_solid_domain(const std::string& type, const Values& values,
                                                     const std::filesystem::path& folder,
                                                     const DomainContent& content) {
    const auto degree = static_cast<int>(values.integer("degree"));
    const auto cells = static_cast<std::size_t>(values.integer("cells"));
    check_size(degree, cells);
    for (const ShippedSolid& one : shipped_solids())
        if (type == one.name) return std::make_shared<SolidDomain>(degree, cells, one.map());
    GASPARD_CHECK(type == own_solid_domain);
    FoundPatch found = patch_of_content(values, folder, content, 3);
    const auto map = solid_map(std::move(found.patch));
    check_regular(*map, found.origin);
    return std::make_shared<SolidDomain>(degree, cells, map, nullptr, std::move(found.patches));
}

} // namespace gaspard
