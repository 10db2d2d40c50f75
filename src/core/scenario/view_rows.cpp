#include "core/scenario/view_rows.hpp"

#include "core/base/check.hpp"
#include "core/scenario/view_directions.hpp"

#include <algorithm>
#include <array>

namespace gaspard {

namespace {

ParameterRow choice(const char* key, const char* label, std::vector<std::string> choices, const char* help) {
    return {.key = key,
            .label = label,
            .kind = ParameterKind::choice,
            .default_value = choices.front(),
            .choices = choices,
            .help = help};
}

ParameterRow boolean(const char* key, const char* label, bool value, const char* help) {
    return {.key = key, .label = label, .kind = ParameterKind::boolean, .default_value = value, .help = help};
}

ParameterRow real(const char* key, const char* label, double value, const char* help) {
    return {.key = key,
            .label = label,
            .minimum = -1e12,
            .maximum = 1e12,
            .scale = ParameterScale::logarithmic,
            .default_value = value,
            .help = help};
}

ParameterRow formerly(const char* key, ParameterRow row) {
    row.former_key = key;
    return row;
}

ParameterRow text(const char* key, const char* label, const char* help) {
    return {.key = key,
            .label = label,
            .kind = ParameterKind::text,
            .default_value = std::string(),
            .help = help};
}

ParameterRow layout_row() {
    ParameterRow row = choice(
        "layout", "Layout",
        {"single", "computational", "side-by-side", "field-and-mesh", "front-and-rear", "projection", "runs"},
        "single: one mesh, by default the physical one; computational: the computational mesh "
        "with the same values; side-by-side: both; field-and-mesh: the colours and the mesh without them, "
        "beside each other; front-and-rear: a mesh in space from both sides; "
        "projection: a sphere in Hammer's equal-area projection; runs: in the window, the meshes of "
        "all runs");
    row.former_choices = {{"map", "projection"}};
    return row;
}

ParameterRow pixels(const char* key, const char* label, std::int64_t value) {
    return {.key = key,
            .label = label,
            .unit = "pixels",
            .kind = ParameterKind::integer,
            .minimum = 64,
            .maximum = 8192,
            .default_value = value,
            .help = "size of the image"};
}

ParameterRow background_row() {
    ParameterRow row =
        text("background", "Background",
             "of images in files: theme, transparent, or a colour as '#rrggbb'; the window keeps "
             "the background of its theme");
    row.default_value = std::string("theme");
    return row;
}

ParameterRow colour_row(std::span<const FieldInfo> further, std::string_view usual) {
    ParameterRow row =
        choice("color", "Colour by", {"monitor"},
               "what the cells are filled with, or for an interval what is plotted (without "
               "it, or with none, the map x(ξ)); equidistribution is Mᵢ / mean − 1, orthogonality the "
               "non-orthogonality angle; intervals have no aspect_ratio, skewness, "
               "orthogonality and alignment");
    row.choices.clear();
    const auto add = [&row](const FieldInfo& field) {
        row.choices.push_back(field.name);
        row.choice_labels.push_back(field.label.empty() ? field.name : field.label);
    };
    for (const FieldInfo& field : mesh_colours()) add(field);
    for (const FieldInfo& field : further) {
        if (std::find(row.choices.begin(), row.choices.end(), field.name) != row.choices.end()) continue;
        add(field);
        if (!field.help.empty()) row.help += "; " + field.name + ": " + field.help;
    }
    row.choices.emplace_back("none");
    row.choice_labels.emplace_back("none");
    row.default_value = std::string(usual);
    return row;
}

std::vector<std::string> direction_names() {
    std::vector<std::string> names;
    for (const ViewDirection& direction : view_directions()) names.emplace_back(direction.name);
    return names;
}

} // namespace

const std::vector<FieldInfo>& mesh_colours() {
    static const std::vector<FieldInfo> table = {
        {.name = "monitor", .label = "monitor", .symbol = "m", .help = "m at the nodes"},
        {.name = "area",
         .label = "cell area",
         .place = FieldPlace::cell,
         .help = "of the physical cell; length of a line, volume of a solid"},
        {.name = "jacobian",
         .label = "Jacobian",
         .symbol = "det(∂x/∂ξ)",
         .place = FieldPlace::cell,
         .centre = 1,
         .help = "smallest sampled in each cell"},
        {.name = "equidistribution",
         .label = "equidistribution",
         .place = FieldPlace::cell,
         .centre = 0,
         .help = "Mᵢ / mean − 1 of each cell: 0 where the monitor is equidistributed"},
        {.name = "displacement",
         .label = "displacement",
         .symbol = "|x − ξ|",
         .help = "|x − ξ| of the nodes"},
        {.name = "mesh_speed",
         .label = "mesh speed",
         .symbol = "|∂x/∂t|",
         .help = "of the nodes of a mesh that follows a time, since the time before"},
        {.name = "mesh_velocity_x",
         .label = "mesh velocity x",
         .symbol = "∂x/∂t",
         .centre = 0,
         .help = "a component of the velocity of these nodes"},
        {.name = "mesh_velocity_y",
         .label = "mesh velocity y",
         .symbol = "∂y/∂t",
         .centre = 0,
         .help = "a component of the velocity of these nodes"},
        {.name = "mesh_velocity_z",
         .label = "mesh velocity z",
         .symbol = "∂z/∂t",
         .centre = 0,
         .help = "a component of the velocity of these nodes"},
        {.name = "aspect_ratio",
         .label = "aspect ratio",
         .place = FieldPlace::cell,
         .help = "of the cell, 1 is ideal"},
        {.name = "skewness",
         .label = "skewness",
         .place = FieldPlace::cell,
         .help = "how far the angles are from ideal ones, 0 to 1"},
        {.name = "orthogonality",
         .label = "non-orthogonality",
         .unit = "°",
         .place = FieldPlace::cell,
         .help = "angle between the line to a neighbour and the normal of the side, the largest"},
        {.name = "alignment",
         .label = "alignment with grad m",
         .place = FieldPlace::cell,
         .centre = 0,
         .help = "1: the cell is thin along grad m, −1: thin across it"},
        {.name = "interpolation_error",
         .label = "interpolation error",
         .place = FieldPlace::cell,
         .help = "L2 error of each cell (method.interpolation), in the colours of both meshes"},
        {.name = "interpolation_error_uniform",
         .label = "interpolation error, uniform mesh",
         .place = FieldPlace::cell,
         .help = "the same on the uniform mesh"},
        {.name = "interpolation_ratio",
         .label = "interpolation error, uniform / adapted",
         .place = FieldPlace::cell,
         .centre = 1,
         .help = "how many times the error of each cell has become smaller"}};
    return table;
}

const FieldInfo& mesh_colour(std::string_view name) {
    for (const FieldInfo& field : mesh_colours())
        if (field.name == name) return field;
    check_failed("the field is one of mesh_colours()");
}

std::vector<ParameterRow> view_rows(std::span<const FieldInfo> further, std::string_view usual_colour) {
    constexpr std::array<std::string_view, 17> details{"axes",
                                                       "histogram_counts",
                                                       "histogram",
                                                       "contours",
                                                       "elevation",
                                                       "peel",
                                                       "layers",
                                                       "only",
                                                       "explode",
                                                       "arrows",
                                                       "cut_cells",
                                                       "projection_longitude",
                                                       "direction",
                                                       "camera",
                                                       "spin",
                                                       "overlay",
                                                       "projection_camera"};
    std::vector<ParameterRow> rows = {
        colour_row(further, usual_colour),
        {.key = "blend",
         .label = "Blend",
         .symbol = "λ",
         .minimum = 0,
         .maximum = 1,
         .default_value = 1.0,
         .help = "nodes are shown at ξ + λ (x − ξ): 0 is the computational, 1 the physical mesh"},
        formerly("map", choice("color_map", "Colour map",
                               {"automatic", "viridis", "plasma", "ember", "grey", "blue-yellow", "blue-red"},
                               "automatic: viridis, or blue-red around zero; blue-yellow is safe for "
                               "colour-blind people")),
        choice("x_axis", "x axis", {"linear", "log-left", "log-right"},
               "for an interval: log-left and log-right show the logarithm of the distance from its left or "
               "right end"),
        boolean("log", "Log scale", false,
                "logarithmic colour scale, or vertical axis of a plot, for values that are not negative"),
        choice(
            "range", "Range", {"automatic", "fixed"},
            "the values that the colours, or the vertical axis of a plot, span: all values of the mesh, or "
            "low to high"),
        real("low", "Low", 0, "the lowest colour's value, where the range is fixed"),
        real("high", "High", 1, "the highest colour's value, where the range is fixed"),
        boolean("histogram", "Histogram", true, "histogram of the values, beside the legend"),
        choice("histogram_counts", "Histogram counts", {"square-root", "linear", "logarithmic"},
               "how long the bars of the histogram are, for the number of values"),
        boolean("lines", "Lines", true, "the cells' edges; of an interval, the nodes below the plot"),
        boolean("axes", "Axes", true,
                "ticks and names of the coordinates, left of a flat mesh in the plane and below it"),
        {.key = "contours",
         .label = "Contour lines",
         .kind = ParameterKind::integer,
         .minimum = 0,
         .maximum = 100,
         .slider = SliderRange{0, 30},
         .default_value = std::int64_t{0},
         .help = "of the field that the colours show, if it has values at the nodes: at most so many, at "
                 "round values in the range of the colours"},
        {.key = "elevation",
         .label = "Height",
         .minimum = 0,
         .maximum = 100,
         .slider = SliderRange{0, 2},
         .default_value = 0.0,
         .help = "a plane mesh as a surface, as high as the field that the colours show, if it has values at "
                 "the nodes: with 1, the range of colours is half as high as the domain is long; 0: flat"},
        text(
            "cut", "Cut",
            "planes that cut a solid open, such as 'x 0.5' (hides x > 0.5), '-z 0' (hides z < 0) or 'normal "
            "1 "
            "1 0 at 0 0 0'; what lies beyond all planes joined by 'and' is hidden, after ';' begins the next "
            "such wedge"),
        choice("cut_cells", "Cut cells", {"clean", "whole"},
               "clean: planes cut through cells; whole: a cell is shown whole if its middle is on the side "
               "that stays"),
        {.key = "peel",
         .label = "Peel",
         .kind = ParameterKind::integer,
         .minimum = 0,
         .maximum = 1000,
         .slider = SliderRange{0, 16},
         .default_value = std::int64_t{0},
         .help = "so many layers of cells of a solid are hidden, from its boundary inward"},
        text("layers", "Layers",
             "the only layers of cells that are shown of a solid whose cells are a lattice, counted from 0: "
             "'i "
             "4 to 11; k 0'"),
        text("only", "Only",
             "the only cells that are shown of a solid: 'jacobian < 0.5', 'monitor > 2 and area < 1e-3'; "
             "names "
             "as for view.color, or value: what the colours show"),
        {.key = "explode",
         .label = "Explode",
         .minimum = 0,
         .maximum = 0.9,
         .default_value = 0.0,
         .help = "by what part of their size the cells of a solid are shrunk towards their middles"},
        text("section", "Section line",
             "a line across a mesh in the plane, as 'x0 y0 x1 y1', along which the values of the colours are "
             "plotted and written to section.csv and section.svg; empty: none"),
        boolean("arrows", "Arrows", false, "from ξ to x, as many as fit"),
        layout_row(),
        {.key = "projection_longitude",
         .label = "Projection centre",
         .unit = "°",
         .minimum = -180,
         .maximum = 180,
         .default_value = 0.0,
         .help = "longitude of the centre of the projection, degrees east",
         .former_key = "map_longitude"},
        choice("overlay", "Overlay", {"none", "exact"},
               "exact: the lines of the exact mesh over the computed one, where the exact map is known"),
        choice("direction", "Direction", direction_names(),
               "where a mesh in space is seen from; z points up"),
        text("camera", "Camera",
             "position of the camera, as copied from the window; empty: the whole mesh; axes alone "
             "('right 0 1 0 up 0 0 1'): the whole mesh from that direction"),
        formerly("map_camera", text("projection_camera", "Projection camera",
                                    "position of the camera over the projection; empty: the whole sphere")),
        text("elevation_camera", "Camera",
             "position of the camera over a plane mesh with heights; empty: the whole mesh"),
        {.key = "spin",
         .label = "Spin",
         .unit = "°/s",
         .minimum = -90,
         .maximum = 90,
         .default_value = 0.0,
         .help = "how fast a mesh in space turns eastward in the window; images in files show the start"},
        text("pick", "Picked", "the cell or node that is described: 'cell 12' or 'node 7'; may be empty"),
        pixels("width", "Width", 1200),
        pixels("height", "Height", 900),
        {.key = "dpi",
         .label = "Resolution",
         .unit = "dpi",
         .minimum = 36,
         .maximum = 2400,
         .default_value = 254.0,
         .help = "pixels per inch of images in files: 1200 pixels are 120 mm with 254"},
        {.key = "text_size",
         .label = "Text size",
         .minimum = 0.25,
         .maximum = 4,
         .scale = ParameterScale::logarithmic,
         .default_value = 1.0,
         .help = "of texts and lines of images in files, relative to the usual size"},
        boolean("legend", "Legend", true, "the legend of the colours, in images in files"),
        boolean("caption", "Caption", true, "what is solved and how far, below the mesh, in images in files"),
        boolean("note", "Note", true,
                "what the colours of tangled cells and of the exact mesh mean, in images in files"),
        choice("theme", "Theme", {"dark", "light"}, "light: dark on white, for paper"),
        background_row()};
    return as_details(std::move(rows), details);
}

} // namespace gaspard
