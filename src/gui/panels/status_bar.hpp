// The status bar at the bottom of the window: state and numbers of a run, and a message.
#pragma once

#include "gui/base/actions.hpp"
#include "gui/base/item_rectangles.hpp"
#include "gui/base/notice.hpp"
#include "gui/base/theme.hpp"
#include "gui/document/document.hpp"

#include <string>
#include <vector>

namespace gaspard {

enum class Tone { plain, good, busy, warning, bad };

ImVec4 tone_colour(const Theme& theme, Tone tone);

/// A label and its value.
struct StatusCell {
    std::string label, value;
    Tone tone = Tone::plain;
};

/// "Running", "Paused", "Converged" ... with its tone.
StatusCell describe_state(const SolverStatus& status, bool wants_to_run);
/// State, iteration, residual, equidistribution, smallest Jacobian, tangled cells, rate: always all of them,
/// in this order. Numbers that a report leaves out are taken from the last report that has them.
std::vector<StatusCell> status_cells(const DocumentRun& run);
/// The last note of the method, such as "Automatic, from iteration 9: Newton's method takes over"; empty if
/// there is none.
std::string method_note(const DocumentRun& run, const Catalogue& catalogue);
/// Why the run did not converge, if its last report says so; else empty.
std::string closing_note(const DocumentRun& run, const Action& reset);

/// Whether the run has linear cells (domain.geometry_order = 1) on a domain that also has curved ones.
bool has_linear_cells(const DocumentRun& run);
/// What helps a run that failed with linear cells; else empty.
std::string remedy_note(const DocumentRun& run);

/// What the status bar says while there is no message; any may be empty.
struct StatusTexts {
    std::string closing; ///< why the run did not converge; else the others are shown
    std::string method;  ///< the note of the method
    std::string hint;    ///< after the note, as far as it fits
};

/// Draws the cells, and below them the message or the texts, into the current ImGui window. Keys "status.0",
/// ... and "message".
void draw_status_bar(const DocumentRun& run, const Notice& message, const StatusTexts& texts,
                     const Theme& theme, ItemRectangles& items);

} // namespace gaspard
