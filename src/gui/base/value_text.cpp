#include "gui/base/value_text.hpp"

#include "core/tessellate/ticks.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

namespace gaspard {

std::string number_text(const ParameterRow& row, double number) {
    const bool whole = row.kind == ParameterKind::integer && std::abs(number) < 1e15;
    return short_number(number, whole ? 15 : 6);
}

std::string unit_text(const ParameterRow& row) {
    constexpr std::pair<const char*, const char*> short_forms[] = {
        {"degrees", "°"}, {"radians", " rad"}, {"1/radian", " rad⁻¹"}, {"1/radian²", " rad⁻²"}};
    for (const auto& [unit, form] : short_forms)
        if (row.unit == unit) return form;
    if (row.unit.empty() || row.unit.find("length") != std::string::npos) return {};
    return (row.unit.starts_with("°") ? "" : " ") + row.unit;
}

std::string value_text(const ParameterRow& row, const Value& value) {
    if (const auto* real = std::get_if<double>(&value)) return number_text(row, *real) + unit_text(row);
    if (const auto* integer = std::get_if<std::int64_t>(&value))
        return number_text(row, static_cast<double>(*integer)) + unit_text(row);
    if (const auto* boolean = std::get_if<bool>(&value)) return *boolean ? "on" : "off";
    return std::get<std::string>(value);
}

std::string range_text(const ParameterRow& row) {
    const bool number = row.kind == ParameterKind::real || row.kind == ParameterKind::integer ||
                        row.kind == ParameterKind::real_or_auto;
    if (row.kind == ParameterKind::boolean) return "on, off";
    if (!number) return describe_range(row);
    const std::string unit = unit_text(row), first = unit.starts_with("°") ? unit : std::string();
    return number_text(row, row.minimum) + first + " to " + number_text(row, row.maximum) + unit +
           (row.kind == ParameterKind::real_or_auto ? ", or auto" : "");
}

} // namespace gaspard
