// A run's history in columns, as its plots are drawn: per quantity the iterations, the seconds and the
// values. They only grow, so that nothing is copied or searched through when a frame is drawn.
#pragma once

#include "core/session/snapshot.hpp"
#include "core/tessellate/extremes.hpp"

#include <vector>

namespace gaspard {

/// One quantity of a run. All columns are of equal length; iterations and seconds never decrease.
struct Trace {
    std::vector<double> iterations, seconds, values;
    Extremes extremes; ///< of the values

    void append(const StepReport& report, double value);
};

/// What was not measured leaves out its row, and so does a step size where no step was made.
struct HistoryCurves {
    Trace residual, equidistribution, min_jacobian, max_jacobian, step_size;

    void append(const StepReport& report);
    void clear() { *this = {}; }
};

} // namespace gaspard
