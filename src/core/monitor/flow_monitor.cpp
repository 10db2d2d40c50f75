// Monitors made of the potential vorticity q of a flow at time t, as those of a field of a file are.
#include "core/function/field_function.hpp"
#include "core/function/flow_source.hpp"
#include "core/monitor/field_density.hpp"

#include <utility>

namespace gaspard {

namespace {

FieldInfo vorticity_field() {
    return {.name = "q",
            .label = "vorticity",
            .symbol = "q",
            .centre = 0,
            .help = "potential vorticity of the flow"};
}

class FlowMonitor final : public Monitor {
  public:
    FlowMonitor(std::shared_ptr<const Monitor> density, std::shared_ptr<const ScalarFunction> q)
        : density_(std::move(density)), q_(std::move(q)) {}

    void values(const Points& x, std::span<double> values) const override { density_->values(x, values); }
    void gradients(const Points& x, Points& gradients) const override { density_->gradients(x, gradients); }
    std::optional<SpaceKind> made_for() const override { return density_->made_for(); }
    MonitorReport report() const override { return density_->report(); }
    std::shared_ptr<const ScalarFunction> solution() const override { return q_; }
    std::vector<Field> fields(const Points& x) const override {
        Field q{vorticity_field(), std::vector<double>(x.size())};
        q_->values(x, q.values);
        return {std::move(q)};
    }

  private:
    std::shared_ptr<const Monitor> density_;
    std::shared_ptr<const ScalarFunction> q_;
};

std::vector<ParameterRow> flow_monitor_rows(const Space& space) {
    std::vector<ParameterRow> rows = flow_rows(space);
    rows.push_back(field_transform_row());
    rows.back().default_value = std::string("absolute");
    for (ParameterRow& row : field_density_rows()) rows.push_back(std::move(row));
    return rows;
}

} // namespace

MonitorType flow_monitor_type() {
    return {
        .name = "flow",
        .label = "Flow",
        .help = "small cells in the vortices of a flow that is computed; it moves with the clock",
        .equation = "m(x, t) = 1 + (C - 1) (|q| / max(|q|))^γ, blurred, q_t + div(q u) = 0",
        .spaces = {SpaceKind::periodic_square},
        .solids = false,
        .rows = flow_monitor_rows,
        .make = [](const Values& values, const MonitorContext& context) -> std::shared_ptr<const Monitor> {
            const FieldData q = flow_field(values, context);
            const auto options = field_density_options(values, {.transform = field_transform(values)});
            return std::make_shared<FlowMonitor>(field_density(q, options, context, values.section()),
                                                 field_function(q, {}, context).function);
        },
        .further_rows = further_flow_rows,
        .fields = {vorticity_field()}};
}

} // namespace gaspard
