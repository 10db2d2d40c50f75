// What a run reports of the mesh, whatever the method: one table of names, labels and values per diagnostic.
#include "core/diagnostics/exact_map.hpp"
#include "core/diagnostics/quality.hpp"

namespace gaspard {

std::vector<SeriesInfo> quality_series() {
    const auto jacobian = [](const char* part) { return SharedPlot{"jacobian", "Jacobian range", part}; };
    return {{.name = "equidistribution",
             .label = "Equidistribution",
             .symbol = "std(M) / mean(M)",
             .scale = ParameterScale::logarithmic,
             .help = "standard deviation / mean of Mᵢ, the integral of m over cell i / its measure at ξ",
             .measured = true,
             .column = false},
            {.name = "max_jacobian",
             .label = "Max. Jacobian",
             .symbol = "det(∂x/∂ξ)",
             .scale = ParameterScale::logarithmic,
             .help = "largest det(∂x/∂ξ) of the map from computational to physical cells",
             .plot = jacobian("max"),
             .measured = true,
             .column = false},
            {.name = "min_jacobian",
             .label = "Min. Jacobian",
             .symbol = "det(∂x/∂ξ)",
             .scale = ParameterScale::logarithmic,
             .help = "smallest det(∂x/∂ξ) of the map from computational to physical cells",
             .plot = jacobian("min"),
             .measured = true,
             .column = false}};
}

SeriesValues values_of(const MeshQuality& quality) {
    return {quality.equidistribution, quality.max_jacobian, quality.min_jacobian};
}

SeriesInfo folded_drawn_cells_series() {
    return {.name = "folded_drawn_cells",
            .label = "Drawn cells that fold",
            .help = "cells of the mesh, which approximate the map, with a Jacobian of 0 or less",
            .measured = true};
}

std::vector<SeriesInfo> exact_series() {
    const auto plot = [](const char* part) {
        return SharedPlot{"exact_rms", "Distance to exact mesh", part};
    };
    return {{.name = "exact_rms",
             .label = "Distance to exact mesh, vertices",
             .scale = ParameterScale::logarithmic,
             .help = "root mean square, on a sphere along it, of the vertices",
             .plot = plot("vertices"),
             .measured = true,
             .column = false},
            {.name = "exact_rms_nodes",
             .label = "Distance to exact mesh, nodes",
             .scale = ParameterScale::logarithmic,
             .help = "root mean square, on a sphere along it, of all nodes",
             .plot = plot("nodes"),
             .measured = true,
             .column = false}};
}

SeriesValues values_of(const ExactDeviation& deviation) { return {deviation.vertices, deviation.nodes}; }

} // namespace gaspard
