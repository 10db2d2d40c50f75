#include "core/io/formats.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/parameter.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/figure.hpp"
#include "core/io/pdf.hpp"
#include "core/io/svg.hpp"
#include "core/scenario/catalogue.hpp"
#include "core/spline/patch_file.hpp"
#include "core/spline/patch_xml.hpp"
#include "core/tessellate/fine_tessellation.hpp"
#include "core/tessellate/interval_plots.hpp"
#include "core/tessellate/snapshot_section.hpp"
#include "core/tessellate/ticks.hpp"

#include <algorithm>

namespace gaspard {

namespace {

void write_obj_files(const std::filesystem::path& folder, const RunResult& result) {
    const Snapshot& snapshot = result.snapshot;
    write_obj(folder / "computational.obj", *snapshot.mesh, snapshot.mesh->nodes);
    const auto cut = surface_of_cut(snapshot, result.view);
    if (cut)
        write_obj(folder / "adapted.obj", *cut, snapshot.x);
    else
        write_obj(folder / "adapted.obj", *snapshot.mesh, snapshot.x);
}

void write_glb_file(const std::filesystem::path& folder, const RunResult& result) {
    const auto cut = surface_of_cut(result.snapshot, result.view);
    if (cut)
        write_glb(folder / "adapted.glb", result.snapshot, *cut);
    else
        write_glb(folder / "adapted.glb", result.snapshot);
}

Tessellation curved(const RunResult& result) {
    return tessellate_within(*result.snapshot.mesh, result.snapshot.x, result.curve_tolerance);
}

void write_curved_obj_files(const std::filesystem::path& folder, const RunResult& result) {
    const Tessellation shape = curved(result);
    write_obj(folder / "computational-curved.obj", shape, result.snapshot.mesh->nodes);
    const auto cut = surface_of_cut(result.snapshot, result.view);
    write_obj(folder / "adapted-curved.obj", cut ? *cut : shape, result.snapshot.x);
}

void write_curved_glb_file(const std::filesystem::path& folder, const RunResult& result) {
    const auto cut = surface_of_cut(result.snapshot, result.view);
    write_glb(folder / "adapted-curved.glb", result.snapshot, cut ? *cut : curved(result));
}

void write_vtu_file(const std::filesystem::path& folder, const RunResult& result) {
    write_vtu(folder / "adapted.vtu", result.snapshot);
}

void write_msh_file(const std::filesystem::path& folder, const RunResult& result) {
    write_msh(folder / "adapted.msh", result.snapshot, result.space);
}

void write_ply_file(const std::filesystem::path& folder, const RunResult& result) {
    const auto cut = surface_of_cut(result.snapshot, result.view);
    if (cut)
        write_ply(folder / "adapted.ply", result.snapshot, *cut);
    else
        write_ply(folder / "adapted.ply", result.snapshot);
}

void write_csv_file(const std::filesystem::path& folder, const RunResult& result) {
    write_csv(folder / "adapted.csv", result.snapshot);
}

void write_ugrid_files(const std::filesystem::path& folder, const RunResult& result) {
    const Snapshot& snapshot = result.snapshot;
    write_ugrid(folder / "computational.ugrid.nc", snapshot, snapshot.mesh->nodes, "computational mesh");
    write_ugrid(folder / "adapted.ugrid.nc", snapshot, snapshot.x, "adapted mesh");
}

void write_patch_files(const std::filesystem::path& folder, const RunResult& result) {
    GASPARD_CHECK(result.patch != nullptr);
    write_atomically(folder / "adapted-patch.json", patch_json(*result.patch));
    write_atomically(folder / "adapted-patch.xml", patch_xml(*result.patch));
}

Plot against_iteration(std::string title, const std::string& y) {
    return {.title = std::move(title),
            .x = {.label = "iteration", .whole = true},
            .y = {y, true},
            .curves = {{}}};
}

/// Where the series was not measured the curve goes on to the next report that was.
Plot history_plot(const RunResult& result, std::string_view name) {
    const std::vector<StepReport>& history = result.history;
    const SeriesTable& table = history.empty() ? *common_series() : *history.back().series;
    const auto place = table.find(name);
    GASPARD_CHECK(place);
    const SeriesInfo& info = table.all()[*place];
    Plot plot = against_iteration(info.label, info.symbol.empty() ? info.help : info.symbol);
    if (result.tolerance && *place == table.criterion())
        plot.levels.push_back({*result.tolerance, "tolerance " + short_number(*result.tolerance)});
    for (const auto& report : history)
        if (const auto value = report.value(name)) {
            plot.curves[0].x.push_back(report.iteration);
            plot.curves[0].y.push_back(*value);
        }
    return plot;
}

void write_svg_files(const std::filesystem::path& folder, const RunResult& result) {
    const Values& view = result.view;
    if (is_interval(*result.snapshot.mesh)) {
        write_svg(folder / "adapted.svg", interval_plots(result.snapshot, view),
                  parse_background(view.text("background")));
    } else {
        const std::vector<SvgPanel> panels = panels_of(result.snapshot, view);
        constexpr double single = 120, beside = 180; // mm, as of an interval
        MeshSvgOptions options = mesh_svg_options(view);
        options.width_mm = panels.size() > 1 ? beside : single;
        write_svg(folder / "adapted.svg", result.snapshot, panels, options);
    }
    write_svg(folder / "residual.svg", history_plot(result, "residual"));
    write_svg(folder / "equidistribution.svg", history_plot(result, "equidistribution"));
}

void write_pdf_file(const std::filesystem::path& folder, const RunResult& result) {
    write_pdf(folder / "figure.pdf", svg_of_figure(result.snapshot, result.view, result.subject));
}

const Format& find_format(std::string_view name) {
    std::vector<std::string> names;
    for (const auto& format : formats()) {
        if (format.name == name) return format;
        names.push_back(format.name);
    }
    throw InputError("unknown format '" + std::string(name) + "'" + did_you_mean(name, names) +
                     "; allowed: " + join(names, ", "));
}

} // namespace

const std::vector<Format>& formats() {
    static const std::vector<Format> table = {
        {"obj",
         "Wavefront OBJ with straight-edged cells: the computational and the adapted mesh",
         {"computational.obj", "adapted.obj"},
         &write_obj_files},
        {"glb",
         "binary glTF 2.0: the adapted mesh coloured by the monitor, animated from the computational "
         "mesh",
         {"adapted.glb"},
         &write_glb_file},
        {"obj-curved",
         "Wavefront OBJ with curved cells: triangles within output.curve_tolerance, and cell edges as lines",
         {"computational-curved.obj", "adapted-curved.obj"},
         &write_curved_obj_files},
        {"glb-curved",
         "binary glTF 2.0 with curved cells, tessellated within output.curve_tolerance",
         {"adapted-curved.glb"},
         &write_curved_glb_file},
        {"vtu",
         "VTK unstructured grid with curved cells and all fields, for ParaView, VTK and meshio",
         {"adapted.vtu"},
         &write_vtu_file},
        {"msh",
         "Gmsh 2.2 with curved cells, named boundaries and nodal fields, for finite element codes",
         {"adapted.msh"},
         &write_msh_file},
        {"ply",
         "binary PLY with straight-edged cells: vertices with the monitor and its colour",
         {"adapted.ply"},
         &write_ply_file},
        {"csv",
         "text, one line per node: its coordinates on both meshes and all fields of nodes, for tables and "
         "plots",
         {"adapted.csv"},
         &write_csv_file},
        {"ugrid",
         "UGRID 1.0 in NetCDF with straight-edged cells and all fields; longitude and latitude on spheres",
         {"computational.ugrid.nc", "adapted.ugrid.nc"},
         &write_ugrid_files},
        {"patch",
         "spline patches only: control points of the adapted mesh as JSON and G+Smo XML, for "
         "isogeometric codes and domain.file",
         {"adapted-patch.json", "adapted-patch.xml"},
         &write_patch_files,
         true},
        {"svg",
         "vector graphics: the meshes of view.layout (of an interval, its plots), and plots of residual "
         "and equidistribution",
         {"adapted.svg", "residual.svg", "equidistribution.svg"},
         &write_svg_files},
        {"pdf",
         "the meshes of view.layout (of an interval, its plots) as vectors, on a page of view.width and "
         "view.height",
         {"figure.pdf"},
         &write_pdf_file},
    };
    return table;
}

bool exports(const Scenario& scenario, std::string_view format) {
    const auto names = split(scenario.output.text("formats"), ",");
    return std::find(names.begin(), names.end(), format) != names.end();
}

std::vector<const Format*> parse_formats(std::string_view list) {
    std::vector<const Format*> chosen;
    for (const std::string_view name : split(list, ",")) {
        if (name.empty() && !list.empty())
            throw InputError("a list of formats must have a name between commas, as in 'obj,glb'");
        const Format* format = &find_format(name);
        if (std::find(chosen.begin(), chosen.end(), format) == chosen.end()) chosen.push_back(format);
    }
    return chosen;
}

std::vector<const Format*> formats_of(const Catalogue& catalogue, const Scenario& scenario) {
    const bool is_spline = catalogue.domain(scenario.domain.type).spline_patch;
    std::vector<const Format*> chosen;
    try {
        chosen = parse_formats(scenario.output.text("formats"));
    } catch (const InputError& error) {
        throw InputError("output.formats: " + std::string(error.what()));
    }
    for (const Format* format : chosen)
        if (format->splines_only && !is_spline)
            throw InputError("output.formats: format '" + format->name +
                             "' requires a spline patch; domain '" + scenario.domain.type + "' is not one");
    return chosen;
}

} // namespace gaspard
