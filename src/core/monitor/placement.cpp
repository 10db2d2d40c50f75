#include "core/monitor/placement.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace gaspard {

namespace {

bool is_placed(MonitorFigure figure, const Space& space) {
    return figure != MonitorFigure::none && space.kind == SpaceKind::euclidean && space.box;
}

/// The same space without its place.
Space figure_space(const Space& space) {
    return {.kind = space.kind, .dimension = space.dimension, .solid = space.solid};
}

/// 0, 1 or 2 for the coordinates of a point, else nothing.
std::optional<std::size_t> axis_of(const ParameterRow& row) {
    if (row.role == ParameterRole::x) return 0;
    if (row.role == ParameterRole::y) return 1;
    if (row.role == ParameterRole::z) return 2;
    return std::nullopt;
}

/// The power of the length in the row's unit.
int power_of_length(const ParameterRow& row) {
    constexpr std::pair<const char*, int> units[] = {{"length", 1}, {"1/length", -1}, {"1/length²", -2}};
    for (const auto& [unit, power] : units)
        if (row.unit == unit) return power;
    return 0;
}

double component(Vec3 v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// Without what rounding has left in the last of 17 digits, so that it is short as text.
double without_rounding(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.15g", value);
    return std::strtod(text, nullptr);
}

double place(const ParameterRow& row, double number) {
    return without_rounding(row.origin + row.measure * number);
}

void place_row(ParameterRow& row, const Placement& placement, Vec3 shift) {
    const auto axis = axis_of(row);
    const int power = power_of_length(row);
    if (row.kind != ParameterKind::real || (!axis && power == 0)) return;
    row.origin = axis ? component(placement.origin, *axis) : 0;
    row.measure = axis ? placement.scale : std::pow(placement.scale, power);
    row.minimum = place(row, row.minimum);
    row.maximum = place(row, row.maximum);
    const double value = place(row, std::get<double>(row.default_value));
    const double shifted = axis ? without_rounding(value + component(shift, *axis)) : value;
    row.default_value = std::clamp(shifted, row.minimum, row.maximum);
}

/// Widens the range of a row, so that all of a box is within it.
void widen(ParameterRow& row, const Box& box) {
    if (row.kind != ParameterKind::real) return;
    const auto axis = axis_of(row);
    const int power = power_of_length(row);
    const double side = longest_side(box);
    if (axis) {
        row.minimum = std::min(row.minimum, without_rounding(component(box.low, *axis)));
        row.maximum = std::max(row.maximum, without_rounding(component(box.high, *axis)));
    } else if (power > 0) {
        row.maximum = std::max(row.maximum, std::min(row.maximum, 1.0) * side);
    } else if (power < 0 && side > 0) {
        const double factor = std::pow(side, power);
        row.minimum = std::min(row.minimum, row.minimum * factor);
        row.maximum = std::max(row.maximum, row.maximum * factor);
    }
}

std::vector<ParameterRow> placed(std::vector<ParameterRow> rows, const MonitorType& type,
                                 const Space& space) {
    if (type.figure == MonitorFigure::none || space.kind != SpaceKind::euclidean) return rows;
    if (space.box) {
        const Placement placement = placement_of(type.figure, space);
        for (ParameterRow& row : rows) place_row(row, placement, space.middle - space.box->centre());
    }
    for (const Box& box : space.reach)
        for (ParameterRow& row : rows) widen(row, box);
    return rows;
}

void set_numbers(const Values& values, Values& numbers) {
    for (const ParameterRow& row : numbers.rows()) {
        const auto& rows = values.rows();
        const auto from = std::find_if(rows.begin(), rows.end(),
                                       [&](const ParameterRow& one) { return one.key == row.key; });
        if (from == rows.end()) continue;
        const Value& value = values.at(row.key);
        const auto* real = row.kind == ParameterKind::real ? std::get_if<double>(&value) : nullptr;
        numbers.set(row.key, real ? Value((*real - from->origin) / from->measure) : value);
    }
}

/// The values for the figure, of MonitorType::rows alone.
Values first_figure_values(const MonitorType& type, const Values& values, const Space& space) {
    Values numbers(values.section(), without_ranges(type.rows(space)));
    set_numbers(values, numbers);
    return numbers;
}

Values figure_values(const MonitorType& type, const Values& values, const Space& space) {
    Values numbers = first_figure_values(type, values, space);
    if (!type.further_rows) return numbers;
    std::vector<ParameterRow> rows = numbers.rows();
    for (ParameterRow& row : without_ranges(type.further_rows(numbers, space)))
        rows.push_back(std::move(row));
    numbers = Values(values.section(), std::move(rows));
    set_numbers(values, numbers);
    return numbers;
}

class PlacedMonitor final : public Monitor {
  public:
    PlacedMonitor(std::shared_ptr<const Monitor> figure, Placement placement)
        : figure_(std::move(figure)), placement_(placement) {}

    void values(const Points& x, std::span<double> values) const override {
        figure_->values(in_figure(x), values);
    }
    void gradients(const Points& x, Points& gradients) const override {
        figure_->gradients(in_figure(x), gradients);
        for (std::size_t i = 0; i < gradients.size(); ++i)
            gradients.set(i, (1 / placement_.scale) * gradients[i]);
    }
    void check() const override { figure_->check(); }
    MonitorReport report() const override { return figure_->report(); }
    std::vector<Field> fields(const Points& x) const override { return figure_->fields(in_figure(x)); }

  private:
    Points in_figure(const Points& x) const {
        Points v(x.size());
        const double factor = 1 / placement_.scale;
        for (std::size_t i = 0; i < x.size(); ++i) v.set(i, factor * (x[i] - placement_.origin));
        return v;
    }

    std::shared_ptr<const Monitor> figure_;
    Placement placement_;
};

} // namespace

Placement placement_of(MonitorFigure figure, const Space& space) {
    if (!is_placed(figure, space)) return {};
    const Box& box = *space.box;
    const double side = longest_side(box);
    if (figure == MonitorFigure::unit_disk) return {box.centre(), side / 2};
    return {box.centre() - side * Vec3{0.5, 0.5, space.solid ? 0.5 : 0}, side};
}

std::vector<ParameterRow> rows_on(const MonitorType& type, const Space& space) {
    return placed(type.rows(figure_space(space)), type, space);
}

std::vector<ParameterRow> further_rows_on(const MonitorType& type, const Values& values, const Space& space) {
    if (!type.further_rows) return {};
    if (!is_placed(type.figure, space)) return type.further_rows(values, space);
    const Space bare = figure_space(space);
    return placed(type.further_rows(first_figure_values(type, values, bare), bare), type, space);
}

std::shared_ptr<const Monitor> make_on(const MonitorType& type, const Values& values,
                                       const MonitorContext& context) {
    if (!is_placed(type.figure, context.space)) return type.make(values, context);
    MonitorContext bare = context;
    bare.space = figure_space(context.space);
    bare.within = nullptr;
    return std::make_shared<PlacedMonitor>(type.make(figure_values(type, values, bare.space), bare),
                                           placement_of(type.figure, context.space));
}

double transferred(const ParameterRow& from, const ParameterRow& to, double value) {
    if (from.origin == to.origin && from.measure == to.measure) return value;
    return std::clamp(place(to, (value - from.origin) / from.measure), to.minimum, to.maximum);
}

} // namespace gaspard
