#include "core/scenario/view_rows.hpp"

#include "core/scenario/view_directions.hpp"

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

ParameterRow text(const char* key, const char* label, const char* help) {
    return {.key = key,
            .label = label,
            .kind = ParameterKind::text,
            .default_value = std::string(),
            .help = help};
}

ParameterRow pixels(const char* key, const char* label, std::int64_t value) {
    return {.key = key,
            .label = label,
            .unit = "pixels",
            .kind = ParameterKind::integer,
            .minimum = 64,
            .maximum = 8192,
            .default_value = value,
            .help = "size of the picture"};
}

std::vector<std::string> direction_names() {
    std::vector<std::string> names;
    for (const ViewDirection& direction : view_directions()) names.emplace_back(direction.name);
    return names;
}

} // namespace

std::vector<ParameterRow> view_rows() {
    return {
        choice("color", "Colour by",
               {"monitor", "area", "jacobian", "equidistribution", "displacement", "none"},
               "what the cells are filled with; equidistribution is M_i / mean - 1"),
        {.key = "blend",
         .label = "Blend",
         .symbol = "t",
         .minimum = 0,
         .maximum = 1,
         .default_value = 1.0,
         .help = "nodes are shown at xi + t (x - xi): 0 is the computational, 1 the physical mesh"},
        choice("map", "Colour map",
               {"automatic", "viridis", "plasma", "ember", "grey", "blue-yellow", "blue-red"},
               "automatic: viridis, or blue-red around zero; blue-yellow is safe for colour-blind people"),
        boolean("log", "Log scale", false, "colours by the logarithm, where values are not negative"),
        choice("range", "Range", {"automatic", "fixed"},
               "which values the colours span: those of the mesh, or from low to high"),
        real("low", "Low", 0, "the lowest colour's value, where the range is fixed"),
        real("high", "High", 1, "the highest colour's value, where the range is fixed"),
        boolean("histogram", "Histogram", true, "how often each colour occurs, beside the legend"),
        boolean("lines", "Lines", true, "the cells' edges"),
        boolean("arrows", "Arrows", false, "from xi to x, as many as there is room for"),
        choice(
            "layout", "Layout", {"single", "side-by-side", "front-and-rear", "map", "runs"},
            "side-by-side: computational and physical mesh; front-and-rear: a mesh in space from both sides; "
            "map: a sphere on Hammer's equal-area map; runs: in the window, the meshes of all runs"),
        {.key = "map_longitude",
         .label = "Map centre",
         .unit = "degrees",
         .minimum = -180,
         .maximum = 180,
         .default_value = 0.0,
         .help = "the longitude in the middle of the map, east of 0"},
        choice("overlay", "Overlay", {"none", "exact"},
               "exact: the lines of the exact mesh over the computed one, where the exact map is known"),
        choice("direction", "Direction", direction_names(),
               "where a mesh in space is seen from; z points up"),
        text("camera", "Camera",
             "where one looks from, as copied from the window; empty: all of the mesh; axes alone ('right 0 "
             "1 0 up 0 0 "
             "1'): all of it, seen so"),
        text("map_camera", "Map camera", "where one looks at the map from; empty: all of it"),
        {.key = "spin",
         .label = "Spin",
         .unit = "degrees/s",
         .minimum = -90,
         .maximum = 90,
         .default_value = 0.0,
         .help = "how fast a mesh in space turns eastward in the window; pictures in files show the start"},
        text("pick", "Picked", "what the card describes: 'cell 12' or 'node 7'; may be empty"),
        pixels("width", "Width", 1200),
        pixels("height", "Height", 900),
        choice("theme", "Theme", {"dark", "light"}, "light: dark on white, for paper")};
}

} // namespace gaspard
