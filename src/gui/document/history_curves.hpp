// A run's history in columns, as its plots are drawn: per series the iterations, the seconds and the values.
// They only grow, so that nothing is copied when a frame is drawn; when time steps are left out of the
// history, they are made anew.
#pragma once

#include "core/session/snapshot.hpp"
#include "core/tessellate/extremes.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// One series of a run. All columns are of equal length; iterations and seconds never decrease.
struct Trace {
    std::vector<double> iterations, seconds, values;
    Extremes extremes; ///< of the values
    /// The same of the time steps alone: their times and values.
    std::vector<double> times, values_in_time;
    Extremes extremes_in_time;

    void append(const StepReport& report, double value);
};

struct SeriesTrace {
    SeriesInfo info;
    std::string plot; ///< the name of the plot that shows it
    Trace trace;
};

/// Iterates for which a series has no value leave out its row.
class HistoryCurves {
  public:
    HistoryCurves() { follow(common_series()); }
    void append(const StepReport& report);
    /// Adds what has been measured of the last report since it was appended.
    void complete(const StepReport& last, const StepReport& completed);
    void clear() { *this = {}; }

    /// What the run reports, and has reported with other methods before.
    const std::vector<SeriesTrace>& all() const { return traces_; }
    /// By the name of the series; null where there is none of that name.
    const SeriesTrace* find(std::string_view name) const;

  private:
    void follow(const std::shared_ptr<const SeriesTable>& table);

    std::vector<SeriesTrace> traces_;
    std::shared_ptr<const SeriesTable> table_; ///< of the last report
    std::vector<std::size_t> of_place_;        ///< which trace belongs to each series of the table
};

/// The name of the plot that shows a series, as settings and files have it: "step-size".
std::string plot_name(const SeriesInfo& info);

} // namespace gaspard
