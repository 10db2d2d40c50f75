#include "gui/app/file_kinds.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/user_path.hpp"
#include "core/io/state_file.hpp"
#include "core/spline/solid_domain.hpp"
#include "core/spline/spline_domain.hpp"
#include "core/transport/convex_shape.hpp"
#include "gui/panels/sections.hpp"

#include <algorithm>

namespace gaspard {

namespace {

bool is_image(std::string_view head) {
    return head.starts_with("\x89PNG\r\n\x1a\n") || head.starts_with("\xff\xd8\xff");
}

bool is_netcdf(std::string_view head) {
    return head.starts_with("CDF\x01") || head.starts_with("CDF\x02") || head.starts_with("CDF\x05") ||
           head.starts_with("\x89HDF\r\n\x1a\n");
}

/// Whether the beginning of a patch's file tells that it has three directions: degrees of our own JSON and of
/// splinepy, the type of G+Smo's first geometry.
bool begins_solid(std::string_view head) {
    const auto degrees = head.find("\"degrees\"");
    if (degrees != std::string_view::npos) {
        const auto open = head.find('[', degrees), close = head.find(']', degrees);
        if (open == std::string_view::npos || close == std::string_view::npos || close < open) return false;
        const std::string_view list = head.substr(open, close - open);
        return std::count(list.begin(), list.end(), ',') == 2;
    }
    const auto solid = std::min(head.find("TensorBSpline3"), head.find("TensorNurbs3"));
    const auto patch = std::min(head.find("TensorBSpline2"), head.find("TensorNurbs2"));
    return solid < patch;
}

/// The section and the type that a use needs.
struct Destination {
    SectionKind section;
    std::string type;
};

Destination destination_of(FileUse use) {
    switch (use) {
    case FileUse::image:
        return {SectionKind::monitor, "image"};
    case FileUse::field:
        return {SectionKind::monitor, "field"};
    case FileUse::patch:
        return {SectionKind::domain, std::string(own_patch_domain)};
    case FileUse::solid:
        return {SectionKind::domain, std::string(own_solid_domain)};
    case FileUse::mesh:
        return {SectionKind::domain, "convex"};
    case FileUse::scenario:
    case FileUse::state:
        break;
    }
    check_failed("a scenario or a state is not a value of a scenario");
}

} // namespace

std::span<const FileKind> file_kinds() {
    static const std::vector<FileKind> kinds = {
        {FileUse::scenario, "a scenario", {".toml"}},
        {FileUse::image, "an image", {".png", ".jpg", ".jpeg"}},
        {FileUse::field, "a field", {".nc", ".csv", ".txt", ".vtk", ".vti", ".vtr", ".vts", ".vtu", ".vtp"}},
        {FileUse::patch, "a spline patch or solid", {".json", ".xml"}},
        {FileUse::mesh, "the mesh of a convex domain", {".obj", ".off", ".ply", ".stl"}},
        {FileUse::state, "the state of an earlier run", {".bin"}},
    };
    return kinds;
}

std::optional<FileUse> use_of(const std::filesystem::path& file, std::string_view head) {
    if (is_image(head)) return FileUse::image;
    if (is_netcdf(head)) return FileUse::field;
    if (is_state(head)) return FileUse::state;
    for (const FileKind& kind : file_kinds())
        for (const std::string_view ending : kind.endings)
            if (has_extension(file, ending))
                return kind.use == FileUse::patch && begins_solid(head) ? FileUse::solid : kind.use;
    return std::nullopt;
}

std::string what_opens() {
    std::string text;
    const auto kinds = file_kinds();
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (i > 0) text += i + 1 < kinds.size() ? ", " : " or ";
        text += std::string(kinds[i].what) + " (" + join(kinds[i].endings, ", ") + ")";
    }
    return text;
}

std::vector<std::string_view> endings_of(std::optional<FileUse> use) {
    std::vector<std::string_view> endings;
    if (use == FileUse::solid) use = FileUse::patch;
    for (const FileKind& kind : file_kinds())
        if (!use || *use == kind.use) endings.insert(endings.end(), kind.endings.begin(), kind.endings.end());
    return endings;
}

Scenario with_file(const Catalogue& catalogue, const Scenario& opened, const Scenario& scenario, FileUse use,
                   const std::filesystem::path& file) {
    const Destination destination = destination_of(use);
    const SectionKind section = destination.section;
    std::optional<Scenario> changed = scenario;
    if (section_of(scenario, section).type != destination.type)
        changed = with_type(catalogue, opened, scenario, section, destination.type);
    if (!changed)
        throw InputError(file.string() + " cannot be used here: this domain and method have no " +
                         std::string(section_key(section)) + " of type " + destination.type);
    if (use == FileUse::mesh) {
        section_of(*changed, section).values.set("shape", shape_of_file);
        update_typed_rows(catalogue, *changed);
    }
    Values& values = section_of(*changed, section).values;
    if (use == FileUse::patch || use == FileUse::solid) // they belong to the file before
        for (const ParameterRow& row : std::vector<ParameterRow>(values.rows()))
            if (row.role == ParameterRole::patch || row.role == ParameterRole::control_points)
                values.set(row.key, row.default_value);
    const ParameterRow* row = find_role(values.rows(), ParameterRole::file);
    GASPARD_CHECK(row != nullptr);
    values.set(row->key, file.string());
    update_typed_rows(catalogue, *changed);
    return *changed;
}

} // namespace gaspard
