// The monitor m^t, for the continuation from a constant monitor (t = 0) to m itself (t = 1).
#pragma once

#include "core/monitor/monitor.hpp"

#include <cmath>
#include <utility>

namespace gaspard {

class PowerMonitor final : public Monitor {
  public:
    PowerMonitor(std::shared_ptr<const Monitor> whole, double power)
        : whole_(std::move(whole)), power_(power) {}

    void values(const Points& x, std::span<double> values) const override {
        whole_->values(x, values);
        for (double& value : values) value = std::pow(value, power_);
    }
    void gradients(const Points& x, Points& gradients) const override {
        whole_->gradients(x, gradients);
        std::vector<double> m(x.size());
        whole_->values(x, m);
        for (std::size_t i = 0; i < m.size(); ++i) // grad m^t = t m^(t-1) grad m
            gradients.set(i, (power_ * std::pow(m[i], power_ - 1)) * gradients[i]);
    }
    void check() const override { whole_->check(); }

  private:
    std::shared_ptr<const Monitor> whole_;
    double power_;
};

} // namespace gaspard
