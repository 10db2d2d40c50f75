#include "core/monitor/solution.hpp"

#include "core/base/check.hpp"

#include <utility>

namespace gaspard {

namespace {

class MonitorFunction final : public ScalarFunction {
  public:
    MonitorFunction(std::shared_ptr<const Monitor> monitor, double unit)
        : monitor_(std::move(monitor)), unit_(unit) {}

    void values(const Points& x, std::span<double> values) const override {
        monitor_->values(x, values);
        if (unit_ != 1)
            for (double& value : values) value *= unit_;
    }
    void gradients(const Points& x, Points& gradients) const override {
        monitor_->gradients(x, gradients);
        if (unit_ != 1)
            for (auto* axis : {&gradients.x, &gradients.y, &gradients.z})
                for (double& value : *axis) value *= unit_;
    }

  private:
    std::shared_ptr<const Monitor> monitor_;
    double unit_;
};

} // namespace

std::shared_ptr<const ScalarFunction> solution_of(const ProblemData& data) {
    GASPARD_CHECK(data.monitor != nullptr);
    if (auto u = data.monitor->solution()) return u;
    return std::make_shared<MonitorFunction>(data.monitor, data.unit);
}

} // namespace gaspard
