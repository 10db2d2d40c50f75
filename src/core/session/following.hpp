// How the mesh of a run follows the time of its scenario. Immutable: a time step makes another one.
#pragma once

#include "core/scenario/clock.hpp"
#include "core/session/extrapolation.hpp"
#include "core/session/step_tolerance.hpp"

#include <memory>
#include <optional>

namespace gaspard {

struct Following {
    std::shared_ptr<const Clock> clock;
    int step = 0;         ///< of the clock
    bool arrived = false; ///< the first mesh is solved: from here on, steps of the run are time steps
    Extrapolation maps{}; ///< once arrived
    std::optional<StepTolerance> tolerance{}; ///< of time.rule = equidistribution, once arrived
    int unsolved = 0, tangled = 0;            ///< time steps so far
    std::shared_ptr<const Points> before{};   ///< the nodes at the time before
    double before_time = 0;

    double time() const { return clock->time(step); }
    bool ends() const { return step >= clock->steps(); }
};

} // namespace gaspard
