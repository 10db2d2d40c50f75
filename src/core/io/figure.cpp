#include "core/io/figure.hpp"

#include "core/tessellate/blend.hpp"
#include "core/tessellate/caption.hpp"
#include "core/tessellate/colouring.hpp"
#include "core/tessellate/interval_plots.hpp"

namespace gaspard {

std::vector<SvgPanel> panels_of(const Snapshot& snapshot, const Values& view) {
    const ColourChoice choice = colour_choice(view);
    ColourChoice uniform = choice; // there the interpolation error is another
    if (choice.colouring == "interpolation_error" && snapshot.interpolation)
        uniform.colouring = "interpolation_error_uniform";
    const std::string& layout = view.text("layout");
    const double blend = view.real("blend");
    SvgPanel computational{"computational", 0, make_colouring(snapshot, uniform)};
    SvgPanel shown{layout == "side-by-side" ? blend_title(blend) : "", blend,
                   make_colouring(snapshot, choice)};
    std::vector<SvgPanel> panels;
    if (layout == "computational") computational.title.clear();
    if (layout == "computational" || layout == "side-by-side") panels.push_back(std::move(computational));
    if (layout == "field-and-mesh") {
        if (shown.colouring) shown.title = shown.colouring->label;
        panels.push_back({shown.title, blend, shown.colouring});
        shown.title = "mesh", shown.colouring.reset();
    }
    if (layout != "computational") panels.push_back(std::move(shown));
    return panels;
}

MeshSvgOptions mesh_svg_options(const Values& view) {
    const auto pixels = [&](const char* key) { return static_cast<double>(view.integer(key)); };
    return {.text_size = view.real("text_size"),
            .legend = view.boolean("legend"),
            .note = view.boolean("note"),
            .camera = view.text("camera"),
            .aspect = pixels("height") / pixels("width"),
            .background = parse_background(view.text("background")),
            .lines = view.boolean("lines"),
            .axes = view.boolean("axes"),
            .elevation = view.real("elevation"),
            .elevation_camera = view.text("elevation_camera"),
            .inside = inside_choice(view)};
}

double millimetres(const Values& view, double pixels) { return pixels / view.real("dpi") * 25.4; }

std::string svg_of_figure(const Snapshot& snapshot, const Values& view, const std::string& subject,
                          int last_iteration) {
    const double width = millimetres(view, static_cast<double>(view.integer("width"))),
                 height = millimetres(view, static_cast<double>(view.integer("height")));
    if (is_interval(*snapshot.mesh))
        return svg_of_plots(interval_plots(snapshot, view), parse_background(view.text("background")),
                            {width, height, view.real("text_size")});
    MeshSvgOptions options = mesh_svg_options(view);
    options.width_mm = width, options.height_mm = height;
    if (view.boolean("caption")) options.caption = caption_parts(subject, snapshot.report, last_iteration);
    return svg_of_meshes(snapshot, panels_of(snapshot, view), options);
}

} // namespace gaspard
