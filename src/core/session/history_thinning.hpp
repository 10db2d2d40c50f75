// Bounds the history of a run that follows a time, so that a long run needs no more memory than a short one.
#pragma once

#include "core/session/snapshot.hpp"

#include <cstddef>
#include <vector>

namespace gaspard {

/// So many time steps are kept at most.
constexpr std::size_t most_time_steps = 8192;

/// If a history has more than `most` (at least 2) time steps: keeps one of every 2, 4, 8, ... successive
/// ones, so that at most half of `most` are left between the first and the last, which stay, as all rows
/// before them do. Of successive ones that is the first with tangled cells; otherwise the first with a note,
/// then the first that was measured.
/// The inner iterations of a row that is left out are added to the row before it. Rows keep their iteration
/// numbers. Returns whether rows were left out.
bool thin_out_time_steps(std::vector<StepReport>& history, std::size_t most = most_time_steps);

} // namespace gaspard
