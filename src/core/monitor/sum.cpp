#include "core/monitor/sum.hpp"

#include "core/base/check.hpp"
#include "core/monitor/radial.hpp"

#include <algorithm>

namespace gaspard {

MonitorType ring_monitor();
MonitorType bell_monitor();

void SumMonitor::values(const Points& x, std::span<double> values) const {
    GASPARD_CHECK(values.size() == x.size());
    std::fill(values.begin(), values.end(), 1.0);
    std::vector<double> part(x.size());
    for (const auto& monitor : parts_) {
        monitor->values(x, part);
        for (std::size_t i = 0; i < part.size(); ++i) values[i] += part[i] - 1;
    }
}

void SumMonitor::gradients(const Points& x, Points& gradients) const {
    gradients = Points(x.size());
    Points part;
    for (const auto& monitor : parts_) {
        monitor->gradients(x, part);
        for (std::size_t i = 0; i < part.size(); ++i) gradients.set(i, gradients[i] + part[i]);
    }
}

void SumMonitor::check() const {
    for (const auto& monitor : parts_) monitor->check();
}

namespace {

/// Appends the rows of a type, with its name as prefix of the keys and its label as prefix of the labels.
void add_rows(std::vector<ParameterRow>& rows, const MonitorType& type, const Space& space) {
    for (auto row : type.rows(space)) {
        if (row.key == "amplitude") row.minimum = 0; // the parts of a SumMonitor must be at least 1
        row.key = type.name + "_" + row.key;
        row.label = type.label + ": " + row.label;
        if (!row.point.empty()) row.point = type.name + "_" + row.point;
        rows.push_back(std::move(row));
    }
}

std::shared_ptr<const Monitor> make_part(const MonitorType& type, const Values& values,
                                         const MonitorContext& context) {
    Values own("monitor", without_ranges(type.rows(context.space)));
    for (const auto& row : own.rows()) own.set(row.key, values.at(type.name + "_" + row.key));
    return type.make(own, context);
}

} // namespace

MonitorType ring_and_bell_monitor() {
    return {.name = "ring-and-bell",
            .label = "Ring and bell",
            .help = "the sum of a ring and a bell, each with its own parameters",
            .equation = "m(x) = ring(x) + bell(x) - 1",
            .figure = MonitorFigure::unit_square,
            .rows =
                [](const Space& space) {
                    std::vector<ParameterRow> rows;
                    add_rows(rows, ring_monitor(), space);
                    add_rows(rows, bell_monitor(), space);
                    return rows;
                },
            .make = [](const Values& values,
                       const MonitorContext& context) -> std::shared_ptr<const Monitor> {
                return std::make_shared<SumMonitor>(std::vector{make_part(ring_monitor(), values, context),
                                                                make_part(bell_monitor(), values, context)});
            },
            .formula =
                [](const Space& space) {
                    const auto part = [&](const std::string& type, const std::string& inner) {
                        return " + " + type + "_amplitude*sech(" + type + "_sharpness*(" +
                               distance_formula(space, type + "_center") + "^2" + inner + "))^2";
                    };
                    return "1" + part("ring", " - ring_radius^2") + part("bell", "");
                }};
}

} // namespace gaspard
