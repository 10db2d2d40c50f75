// The status bar at the bottom of the window: the state of a run, and the numbers of the iterate shown.
#pragma once

#include "gui/base/actions.hpp"
#include "gui/base/frame_context.hpp"
#include "gui/document/document.hpp"

#include <limits>
#include <string>
#include <vector>

namespace gaspard {

enum class Tone { plain, good, busy, warning, bad };

ImVec4 tone_colour(const Theme& theme, Tone tone);

/// A label and its value.
struct StatusCell {
    std::string label, value;
    Tone tone = Tone::plain;
    std::string help{}; ///< what the number is
};

/// "Running", "Paused", "Converged" ... with its tone.
StatusCell describe_state(const SolverStatus& status, bool wants_to_run);
/// State, iteration, residual, equidistribution, smallest Jacobian, tangled cells, rate: always all of them,
/// in this order, as they were at this iteration. Numbers that a report leaves out are taken from the last
/// report before it that has them.
std::vector<StatusCell> status_cells(const DocumentRun& run, int iteration = std::numeric_limits<int>::max());
/// The last note of the method up to an iteration, such as "Automatic, from iteration 9: Newton's method
/// takes over"; empty if there is none.
std::string method_note(const DocumentRun& run, const Catalogue& catalogue,
                        int iteration = std::numeric_limits<int>::max());
/// Why the run did not converge, if its last report says so; else empty.
std::string closing_note(const DocumentRun& run, const Action& reset);

/// Whether the run has linear cells (domain.geometry_order = 1) on a domain that also has curved ones.
bool has_linear_cells(const DocumentRun& run);
/// What helps a run that failed with linear cells; else empty.
std::string remedy_note(const DocumentRun& run);

/// Draws the state, and below it the other cells and at the right end as much as fits of the note of the
/// method and of the hint, into the current ImGui window. Keys "status.0", ... and "hint".
void draw_status_bar(const std::vector<StatusCell>& cells, const std::string& note, const std::string& hint,
                     const FrameContext& context);

} // namespace gaspard
