// The series that several methods report.
#include "core/method/monge_ampere.hpp"

namespace gaspard {

SeriesInfo normalised_residual() {
    return {.name = "residual",
            .label = "Residual",
            .symbol = "‖r‖ / ‖θ‖",
            .scale = ParameterScale::logarithmic,
            .help = "normalised residual, r = m det(∂x/∂ξ) − θ tested with the finite element functions"};
}

SeriesInfo level_series() {
    return {.name = "level",
            .label = "Mesh level",
            .help = "mesh of the update: 0 is the mesh of the run, 1 the next coarser one, and so on"};
}

SeriesInfo theta_series() {
    return {.name = "theta",
            .label = "Constant θ",
            .symbol = "θ",
            .help = "the constant that m det(∂x/∂ξ) is to equal",
            .column = false,
            .bounded = true};
}

} // namespace gaspard
