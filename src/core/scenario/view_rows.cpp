#include "core/scenario/view_rows.hpp"

namespace gaspard {

std::vector<ParameterRow> view_rows() {
    const auto pixels = [](const char* key, const char* label, std::int64_t value) {
        return ParameterRow{.key = key,
                            .label = label,
                            .unit = "pixels",
                            .kind = ParameterKind::integer,
                            .minimum = 64,
                            .maximum = 8192,
                            .default_value = value,
                            .help = "size of the picture"};
    };
    return {{.key = "color",
             .label = "Colour by",
             .kind = ParameterKind::choice,
             .default_value = std::string("monitor"),
             .choices = {"monitor", "none"},
             .help = "what the cells are filled with"},
            {.key = "blend",
             .label = "Blend",
             .symbol = "t",
             .minimum = 0,
             .maximum = 1,
             .default_value = 1.0,
             .help = "nodes are shown at xi + t (x - xi): 0 is the computational, 1 the physical mesh"},
            pixels("width", "Width", 1200),
            pixels("height", "Height", 900)};
}

} // namespace gaspard
