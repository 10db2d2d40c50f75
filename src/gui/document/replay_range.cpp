#include "gui/document/replay_range.hpp"

#include <limits>
#include <utility>

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

const std::vector<std::shared_ptr<const Snapshot>>& ReplayEnds::of(const DocumentRun& run) {
    std::vector<std::shared_ptr<const RecordedIterate>> ends;
    if (run.recording)
        for (auto& one : {run.recording->at(std::numeric_limits<int>::min()), last_sound(*run.recording)})
            if (one) ends.push_back(one);
    if (ends == iterates_) return snapshots_;
    iterates_ = std::move(ends);
    snapshots_.clear();
    for (const auto& one : iterates_) snapshots_.push_back(one->restore());
    return snapshots_;
}

} // namespace gaspard
