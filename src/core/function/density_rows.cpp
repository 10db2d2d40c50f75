#include "core/function/density_rows.hpp"

#include "core/base/short_number.hpp"
#include "core/function/image_options.hpp"

namespace gaspard {

ParameterRow contrast_row(const std::string& help) {
    return {.key = "contrast",
            .label = "Contrast",
            .symbol = "C",
            .minimum = 1,
            .maximum = 1000,
            .scale = ParameterScale::logarithmic,
            .default_value = 20.0,
            .help = help};
}

ParameterRow invert_row(const std::string& help) {
    return {.key = "invert",
            .label = "Invert",
            .kind = ParameterKind::boolean,
            .default_value = false,
            .help = help};
}

ParameterRow gamma_row(const std::string& help) {
    return {.key = "gamma",
            .label = "Gamma",
            .symbol = "γ",
            .minimum = 0.1,
            .maximum = 10,
            .scale = ParameterScale::logarithmic,
            .default_value = 1.0,
            .help = help};
}

ParameterRow blur_row() {
    return {.key = "blur",
            .label = "Blur",
            .symbol = "σ",
            .minimum = 0,
            .maximum = 1000,
            .slider = SliderRange{0, 20},
            .default_value = least_blur,
            .help = "standard deviation of the Gaussian blur; at least " + exact_number(least_blur) +
                    " cells, so that the mesh can follow"};
}

} // namespace gaspard
