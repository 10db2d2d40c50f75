#include "gui/document/replay_range.hpp"

#include <algorithm>
#include <limits>

namespace gaspard {

namespace {

/// Diverged values would leave the rest one colour.
std::shared_ptr<const RecordedIterate> last_sound(const Recording& recording) {
    auto last = recording.at(std::numeric_limits<int>::max());
    if (!last || last->report().tangled_cells.value_or(0) == 0) return last;
    const auto tangled = recording.first_tangled();
    return tangled ? recording.at(*tangled - 1) : last;
}

std::optional<ColourRange> range_of(const RecordedIterate& iterate, const DocumentRun& run,
                                    const ColourChoice& choice) {
    // The newest is shown in double precision.
    const bool newest = run.snapshot && run.snapshot->version == iterate.version();
    const auto colouring = make_colouring(newest ? *run.snapshot : *iterate.restore(), choice);
    return colouring ? std::optional(colouring->range) : std::nullopt;
}

std::optional<ColourRange> covering(const std::optional<ColourRange>& a,
                                    const std::optional<ColourRange>& b) {
    if (!a || !b) return a ? a : b;
    return ColourRange{std::min(a->low, b->low), std::max(a->high, b->high)};
}

} // namespace

std::optional<ColourRange> ReplayRange::of(const DocumentRun& run, const ColourChoice& choice) {
    if (!run.recording) return std::nullopt;
    const auto first = run.recording->at(std::numeric_limits<int>::min()), last = last_sound(*run.recording);
    if (!first || !last) return std::nullopt;
    const Known now{first->version(), last->version(), run.id, choice};
    if (known_ == now) return range_;
    known_ = now;
    range_ = covering(range_of(*first, run, choice), range_of(*last, run, choice));
    return range_;
}

} // namespace gaspard
