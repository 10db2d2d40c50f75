#include "core/monitor/formula.hpp"

namespace gaspard {

std::vector<ParameterRow> center_in_space_rows(Vec3 centre) {
    const auto row = [](const char* axis, const char* symbol, double value) {
        return ParameterRow{.key = std::string("center_") + axis,
                            .label = std::string("Centre ") + axis,
                            .symbol = symbol,
                            .minimum = -10,
                            .maximum = 10,
                            .default_value = value,
                            .help = "where the feature stands"};
    };
    return {row("x", "c1", centre.x), row("y", "c2", centre.y), row("z", "c3", centre.z)};
}

Vec3 center_in_space(const Values& values) {
    return {values.real("center_x"), values.real("center_y"), values.real("center_z")};
}

} // namespace gaspard
