#include "core/session/history_thinning.hpp"

#include "core/base/check.hpp"
#include "core/session/time_series.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

namespace {

using Row = std::vector<StepReport>::iterator;

/// Of rows that stand for each other, the one with the highest rank is kept.
int rank(const StepReport& report) {
    if (report.tangled_cells.value_or(0) > 0) return 3;
    if (!report.note.empty()) return 2;
    return report.measured() ? 1 : 0;
}

/// Rows [begin, end) in groups of `stride` successive iterations, counted from `first`.
class Groups {
  public:
    Groups(int first, int stride) : first_(first), stride_(stride) {}
    Row end_of(Row begin, Row end) const {
        const int group = number(*begin);
        return std::find_if(begin, end, [&](const StepReport& row) { return number(row) != group; });
    }
    std::size_t count(Row begin, Row end) const {
        std::size_t groups = 0;
        for (; begin != end; begin = end_of(begin, end)) ++groups;
        return groups;
    }

  private:
    int number(const StepReport& row) const { return (row.iteration - first_) / stride_; }
    int first_, stride_;
};

} // namespace

bool thin_out_time_steps(std::vector<StepReport>& history, std::size_t most) {
    GASPARD_CHECK(most >= 2);
    if (history.size() <= most) return false;
    const Row first = std::partition_point(history.begin(), history.end(),
                                           [](const StepReport& row) { return !is_time_step(row); });
    if (static_cast<std::size_t>(history.end() - first) <= most) return false;
    const Row begin = first + 1, last = history.end() - 1; // those in between are thinned out
    int stride = 2;
    while (Groups(first->iteration + 1, stride).count(begin, last) > most / 2) stride *= 2;
    const Groups groups(first->iteration + 1, stride);
    Row kept = first;
    for (Row group = begin; group != last;) {
        const Row end = groups.end_of(group, last);
        const Row best = std::max_element(
            group, end, [](const StepReport& a, const StepReport& b) { return rank(a) < rank(b); });
        for (Row row = group; row != best; ++row) kept->inner_iterations += row->inner_iterations;
        int others = 0;
        for (Row row = best + 1; row != end; ++row) others += row->inner_iterations;
        if (++kept != best) *kept = std::move(*best);
        kept->inner_iterations += others;
        group = end;
    }
    if (++kept != last) *kept = std::move(*last);
    history.erase(kept + 1, history.end());
    return true;
}

} // namespace gaspard
