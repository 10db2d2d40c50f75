#include "gui/document/replay_range.hpp"

#include <limits>

namespace gaspard {

std::optional<ColourRange> ReplayRange::of(const DocumentRun& run, const ColourChoice& choice) {
    if (!run.recording) return std::nullopt;
    const auto first = run.recording->at(std::numeric_limits<int>::min()), last = last_sound(*run.recording);
    if (!first || !last) return std::nullopt;
    const Known now{first->version(), last->version(), run.id, choice};
    if (known_ == now) return range_;
    known_ = now;
    range_ = range_of_recording(*run.recording, run.snapshot.get(), choice);
    return range_;
}

} // namespace gaspard
