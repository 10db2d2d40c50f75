// A monitor that is known on its domain alone (DataContext::within), which methods ask for points beside it.
#pragma once

#include "core/monitor/monitor.hpp"

#include <utility>

namespace gaspard {

/// m at the points of the domain that stand for the given ones.
class InsideMonitor final : public Monitor {
  public:
    InsideMonitor(std::shared_ptr<const Monitor> whole, std::shared_ptr<const DensityDomain> within)
        : whole_(std::move(whole)), within_(std::move(within)) {}

    void values(const Points& x, std::span<double> values) const override {
        whole_->values(inside(x), values);
    }
    void gradients(const Points& x, Points& gradients) const override {
        whole_->gradients(inside(x), gradients);
    }
    void check() const override { whole_->check(); }
    std::optional<SpaceKind> made_for() const override { return whole_->made_for(); }
    std::vector<Field> fields(const Points& x) const override { return whole_->fields(inside(x)); }
    MonitorReport report() const override { return whole_->report(); }
    std::shared_ptr<const ScalarFunction> solution() const override { return whole_->solution(); }

  private:
    Points inside(const Points& x) const {
        Points result(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) result.set(i, within_->into(x[i]));
        return result;
    }

    std::shared_ptr<const Monitor> whole_;
    std::shared_ptr<const DensityDomain> within_;
};

} // namespace gaspard
