// A monitor in coordinates relative to an origin.
#pragma once

#include "core/monitor/monitor.hpp"

#include <utility>

namespace gaspard {

/// m(origin + x).
class MovedMonitor final : public Monitor {
  public:
    MovedMonitor(std::shared_ptr<const Monitor> whole, Vec3 origin)
        : whole_(std::move(whole)), origin_(origin) {}

    void values(const Points& x, std::span<double> values) const override {
        whole_->values(moved(x), values);
    }
    void gradients(const Points& x, Points& gradients) const override {
        whole_->gradients(moved(x), gradients);
    }

  private:
    Points moved(const Points& x) const {
        Points result(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) result.set(i, origin_ + x[i]);
        return result;
    }

    std::shared_ptr<const Monitor> whole_;
    Vec3 origin_;
};

} // namespace gaspard
