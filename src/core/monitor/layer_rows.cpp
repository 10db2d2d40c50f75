#include "core/monitor/layer_rows.hpp"

#include <algorithm>

namespace gaspard {

ParameterRow layer_width_row(const std::string& key, const std::string& symbol) {
    return {.key = key,
            .label = "Layer width",
            .symbol = symbol,
            .kind = ParameterKind::real_or_auto,
            .minimum = 1e-12,
            .maximum = 1,
            .scale = ParameterScale::logarithmic,
            .default_value = std::string("auto"),
            .help =
                "the layer decays as exp(-β d/ε); auto: that of the problem, the smallest if it has several"};
}

std::optional<double> layer_width_of(const Values* pde, const std::string& key) {
    if (pde == nullptr) return std::nullopt;
    if (pde->has(key)) return pde->real(key);
    std::optional<double> smallest;
    for (const char* one : {"eps1", "eps2"})
        if (key == "eps" && pde->has(one)) smallest = std::min(pde->real(one), smallest.value_or(1));
    return smallest;
}

double layer_weight_of(const Values& values) {
    const double sigma = values.real("sigma"), q = values.real("q");
    return values.real_or_auto("K").value_or(q / (sigma * (1 - q)));
}

std::vector<ParameterRow> layer_shape_rows() {
    return {{.key = "q",
             .label = "Share in layers",
             .symbol = "q",
             .minimum = 0.01,
             .maximum = 0.99,
             .default_value = 0.5,
             .help = "share of the cells in layers"},
            {.key = "sigma",
             .label = "Order",
             .symbol = "σ",
             .minimum = 0.1,
             .maximum = 20,
             .scale = ParameterScale::logarithmic,
             .default_value = 2.5,
             .help = "the cells grow from the side as the layer to the power 1/σ; usually the order of the "
                     "method or a little more"},
            {.key = "beta",
             .label = "Decay",
             .symbol = "β",
             .minimum = 0.01,
             .maximum = 100,
             .scale = ParameterScale::logarithmic,
             .default_value = 0.99,
             .help = "the layer decays as exp(-β d/ε)"}};
}

} // namespace gaspard
