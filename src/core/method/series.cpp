// The series that several methods report.
#include "core/method/monge_ampere.hpp"

namespace gaspard {

SeriesInfo normalised_residual() {
    return {.name = "residual",
            .label = "Residual",
            .scale = ParameterScale::logarithmic,
            .help = "normalised residual"};
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
