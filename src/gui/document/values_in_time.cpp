#include "gui/document/values_in_time.hpp"

#include "core/base/error.hpp"
#include "core/scenario/time_rows.hpp"

namespace gaspard {

const Values* ValuesInTime::at(const Scenario& scenario, std::optional<double> t) {
    if (monitor_ != scenario.monitor || time_ != scenario.time) follow(scenario);
    if (!clock_ || !t) return nullptr;
    if (t_ != t) {
        t_ = t, values_.reset();
        try {
            values_ = clock_->at(*t).monitor.values;
        } catch (const InputError&) { // the solver says what is wrong
        }
    }
    return values_ ? &*values_ : nullptr;
}

void ValuesInTime::follow(const Scenario& scenario) {
    monitor_ = scenario.monitor, time_ = scenario.time;
    clock_.reset(), t_.reset();
    if (!has_time(scenario.time)) return;
    try { // without a check of values at other times, since this may be done in every frame
        clock_ = std::make_shared<const Clock>(scenario, 0);
    } catch (const InputError&) { // the solver says what is wrong
    }
}

} // namespace gaspard
