#include "core/monitor/formula.hpp"

namespace gaspard {

std::vector<ParameterRow> center_in_space_rows(Vec3 centre) {
    const auto row = [](const char* axis, const char* symbol, double value, ParameterRole role) {
        return ParameterRow{.key = std::string("center_") + axis,
                            .label = std::string("Centre ") + axis,
                            .symbol = symbol,
                            .minimum = -10,
                            .maximum = 10,
                            .default_value = value,
                            .help = "position of the centre",
                            .role = role,
                            .point = "center"};
    };
    return {row("x", "c₁", centre.x, ParameterRole::x), row("y", "c₂", centre.y, ParameterRole::y),
            row("z", "c₃", centre.z, ParameterRole::z)};
}

Vec3 center_in_space(const Values& values) {
    return {values.real("center_x"), values.real("center_y"), values.real("center_z")};
}

} // namespace gaspard
