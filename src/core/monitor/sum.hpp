// The sum of several monitors:
//
//   m(x) = 1 + sum_i (m_i(x) - 1)
#pragma once

#include "core/monitor/monitor.hpp"

namespace gaspard {

class SumMonitor final : public Monitor {
  public:
    /// Every part must satisfy m_i >= 1, so that m >= 1.
    explicit SumMonitor(std::vector<std::shared_ptr<const Monitor>> parts) : parts_(std::move(parts)) {}

    void values(const Points& x, std::span<double> values) const override;
    void gradients(const Points& x, Points& gradients) const override;
    void check() const override;

  private:
    std::vector<std::shared_ptr<const Monitor>> parts_;
};

} // namespace gaspard
