// What the colours, and the axes of plots, cover while recorded iterates are compared: one range for the
// whole solve, so that a colour or a height means the same value in every iterate.
#pragma once

#include "core/tessellate/colouring.hpp"
#include "gui/document/document_run.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace gaspard {

class ReplayRange {
  public:
    /// Covers the automatic ranges of the first iterate and of the newest; instead of the newest, if that has
    /// tangled cells, the last iterate before the first tangled one. Nothing if neither has such values.
    /// Computed anew only for another choice or other iterates.
    std::optional<ColourRange> of(const DocumentRun& run, const ColourChoice& choice);

  private:
    struct Known {
        std::uint64_t first = 0, last = 0; ///< versions of the iterates
        RunId run{};
        ColourChoice choice{};
        friend bool operator==(const Known&, const Known&) = default;
    };
    std::optional<Known> known_;
    std::optional<ColourRange> range_;
};

/// The iterates that such a range covers: the first, and the newest or the last before the first tangled one.
class ReplayEnds {
  public:
    /// Restored only if they are others than in the last call; none if nothing was recorded.
    const std::vector<std::shared_ptr<const Snapshot>>& of(const DocumentRun& run);

  private:
    std::vector<std::shared_ptr<const RecordedIterate>> iterates_;
    std::vector<std::shared_ptr<const Snapshot>> snapshots_;
};

} // namespace gaspard
