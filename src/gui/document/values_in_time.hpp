// The values of a monitor that moves at a time, such as that of the mesh that is shown.
#pragma once

#include "core/scenario/clock.hpp"

#include <memory>
#include <optional>

namespace gaspard {

class ValuesInTime {
  public:
    /// Of the monitor at the time t; null if the scenario has no time, if a formula or the path is invalid,
    /// or if one has no valid value there; at other times it need not have one. Valid until the next call.
    /// Computed anew only for another time or other values.
    const Values* at(const Scenario& scenario, std::optional<double> t);

  private:
    void follow(const Scenario& scenario);

    std::optional<Section> monitor_; ///< that the clock is of
    Values time_;                    ///< the same of the section "time"
    std::shared_ptr<const Clock> clock_;
    std::optional<double> t_; ///< of `values_`
    std::optional<Values> values_;
};

} // namespace gaspard
