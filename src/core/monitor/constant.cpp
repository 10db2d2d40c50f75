// The constant monitor, for which the uniform mesh is the solution.
#include "core/base/check.hpp"
#include "core/monitor/monitor.hpp"

#include <algorithm>

namespace gaspard {

namespace {

class ConstantMonitor final : public Monitor {
  public:
    explicit ConstantMonitor(double value) : value_(value) {}

    void values(const Points& x, std::span<double> values) const override {
        GASPARD_CHECK(values.size() == x.size());
        std::fill(values.begin(), values.end(), value_);
    }
    void gradients(const Points& x, Points& gradients) const override { gradients = Points(x.size()); }
    void check() const override {} // the range of the row ensures m > 0
    std::optional<Vec3> symmetry_axis() const override { return Vec3{0, 0, 1}; }

  private:
    double value_;
};

} // namespace

MonitorType constant_monitor() {
    return {.name = "constant",
            .label = "Constant",
            .help = "uniform mesh: no node moves",
            .equation = "m(x) = v",
            .rows =
                [](const Space&) {
                    return std::vector<ParameterRow>{{.key = "value",
                                                      .label = "Value",
                                                      .symbol = "v",
                                                      .minimum = 0.001,
                                                      .maximum = 1000,
                                                      .scale = ParameterScale::logarithmic,
                                                      .default_value = 1.0,
                                                      .help = "every positive value gives the same mesh"}};
                },
            .make = [](const Values& v, const MonitorContext&) -> std::shared_ptr<const Monitor> {
                return std::make_shared<ConstantMonitor>(v.real("value"));
            },
            .formula = [](const Space&) { return std::string("value"); }};
}

} // namespace gaspard
