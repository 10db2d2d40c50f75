#include "core/monitor/tensor.hpp"

#include "core/base/check.hpp"
#include "core/monitor/problem_data.hpp"

#include <cmath>
#include <utility>

namespace gaspard {

double determinant(const SymmetricTensor& m) {
    return m.xx * (m.yy * m.zz - m.yz * m.yz) - m.xy * (m.xy * m.zz - m.yz * m.xz) +
           m.xz * (m.xy * m.yz - m.yy * m.xz);
}

bool positive_definite(const SymmetricTensor& m) {
    const double all = determinant(m);
    return m.xx > 0 && m.xx * m.yy - m.xy * m.xy > 0 && all > 0 && std::isfinite(all);
}

namespace {

class TensorDensity final : public Monitor {
  public:
    explicit TensorDensity(std::shared_ptr<const TensorMonitor> tensor) : tensor_(std::move(tensor)) {}

    void values(const Points& x, std::span<double> values) const override {
        GASPARD_CHECK(values.size() == x.size());
        std::vector<SymmetricTensor> m(x.size());
        tensor_->values(x, m);
        for (std::size_t i = 0; i < m.size(); ++i) values[i] = std::sqrt(determinant(m[i]));
    }
    void gradients(const Points& x, Points& gradients) const override {
        gradients.resize(x.size());
        const auto along = [&](std::vector<double>& axis, double Vec3::*component) {
            constexpr double step = 1e-5; // truncation and rounding error are of similar size, about 1e-10
            Points before = x, after = x;
            for (std::size_t i = 0; i < x.size(); ++i) {
                Vec3 shift;
                shift.*component = step;
                before.set(i, x[i] - shift), after.set(i, x[i] + shift);
            }
            std::vector<double> low(x.size()), high(x.size());
            values(before, low), values(after, high);
            for (std::size_t i = 0; i < x.size(); ++i) axis[i] = (high[i] - low[i]) / (2 * step);
        };
        along(gradients.x, &Vec3::x), along(gradients.y, &Vec3::y), along(gradients.z, &Vec3::z);
    }
    void check() const override { tensor_->check(); }

  private:
    std::shared_ptr<const TensorMonitor> tensor_;
};

} // namespace

std::shared_ptr<const Monitor> density_of(std::shared_ptr<const TensorMonitor> tensor) {
    return std::make_shared<TensorDensity>(std::move(tensor));
}

ProblemData scalar_problem(std::shared_ptr<const Monitor> monitor) {
    GASPARD_CHECK(monitor != nullptr);
    monitor->check();
    auto report = std::make_shared<const MonitorReport>(monitor->report());
    return {.monitor = std::move(monitor), .report = std::move(report)};
}

ProblemData tensor_problem(std::shared_ptr<const TensorMonitor> tensor) {
    GASPARD_CHECK(tensor != nullptr);
    tensor->check();
    auto density = density_of(tensor);
    return {.monitor = std::move(density), .tensor = std::move(tensor)};
}

} // namespace gaspard
