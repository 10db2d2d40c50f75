// The bar below the meshes: buttons to run, pause and step, and a scrubber over the iterates that were
// recorded.
#pragma once

#include "gui/base/actions.hpp"
#include "gui/base/frame_context.hpp"
#include "gui/document/playback.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaspard {

/// The runs whose iterates the bar goes through.
struct PlaybackRuns {
    const DocumentRun* active = nullptr;
    const DocumentRun* longest = nullptr;        ///< the bar spans its iterations
    std::vector<const DocumentRun*> beside = {}; ///< shown beside the active one
    std::size_t recorded = 0;                    ///< bytes of the recordings of all runs
};

/// Draws the bar into the current ImGui window. Returns the name of the action whose button was pressed; the
/// scrubber and the lists change `playback` itself. Notes "action.run" and so on, "playback.scrubber",
/// "playback.position", "playback.rate", "playback.rate=30", and of each
/// run with tangled iterations the first mark, "playback.tangled.0".
std::optional<std::string_view> draw_playback_bar(const PlaybackRuns& runs, Playback& playback,
                                                  std::span<const Action> actions,
                                                  const FrameContext& context);

/// What is recorded of a run, and the memory for it: "Recorded: 28 of 28 iterates" and "38 of 512 MB for all
/// runs". `all`: bytes of the recordings of all runs.
std::string recording_text(const DocumentRun& run, std::size_t all);

/// "tangled 4–6", "tangled from 4": what the scrubber says of them; empty if there are none.
std::string tangled_text(const std::vector<std::pair<int, int>>& ranges, int last);

/// "10 / s", "max": how fast the replay is.
std::string rate_text(double rate);

} // namespace gaspard
