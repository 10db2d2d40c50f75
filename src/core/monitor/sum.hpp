// Several features in one monitor:  m(x) = 1 + sum of (m_i(x) - 1).
#pragma once

#include "core/monitor/monitor.hpp"

namespace gaspard {

class SumMonitor final : public Monitor {
  public:
    /// None of the parts may be below 1 anywhere, so that the sum is not either.
    explicit SumMonitor(std::vector<std::shared_ptr<const Monitor>> parts) : parts_(std::move(parts)) {}

    void values(const Points& x, std::span<double> values) const override;
    void gradients(const Points& x, Points& gradients) const override;
    void check() const override;

  private:
    std::vector<std::shared_ptr<const Monitor>> parts_;
};

} // namespace gaspard
