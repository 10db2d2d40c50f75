// The bar below the meshes: buttons to run, pause and step, and a scrubber over the iterates that were
// recorded.
#pragma once

#include "gui/base/actions.hpp"
#include "gui/base/frame_context.hpp"
#include "gui/document/playback.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace gaspard {

/// Draws the bar into the current ImGui window. Returns the name of the action whose button was pressed; the
/// scrubber and the lists change `playback` itself. Notes "action.run" and so on, "playback.scrubber",
/// "playback.position", "playback.rate", "playback.rate=30".
std::optional<std::string_view> draw_playback_bar(const DocumentRun& run, Playback& playback,
                                                  std::span<const Action> actions,
                                                  const FrameContext& context);

/// "tangled 4–6", "tangled from 4": what the scrubber says of them; empty if there are none.
std::string tangled_text(const std::vector<std::pair<int, int>>& ranges, int last);

/// "10 / s", "max": how fast the replay is.
std::string rate_text(double rate);

} // namespace gaspard
