// How a run stands, in words and numbers, for the bar along the window's bottom edge.
#pragma once

#include "gui/base/actions.hpp"
#include "gui/base/item_rectangles.hpp"
#include "gui/base/notice.hpp"
#include "gui/base/theme.hpp"
#include "gui/document/document.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

enum class Tone { plain, good, busy, warning, bad };

ImVec4 tone_colour(const Theme& theme, Tone tone);

/// One cell of the bar: what it is and how much.
struct StatusCell {
    std::string label, value;
    Tone tone = Tone::plain;
};

/// "Running", "Paused", "Converged" ... and what to make of it.
StatusCell describe_state(const SolverStatus& status, bool wants_to_run);
/// State, iteration, residual, equidistribution, smallest Jacobian, tangled cells, rate: always as many, in
/// order. Numbers that a report leaves out are taken from the last that has them.
std::vector<StatusCell> status_cells(const DocumentRun& run);
/// What the method has last said of what it does: "Automatic, from iteration 9: Newton's method takes over";
/// empty where it has said nothing.
std::string method_note(const DocumentRun& run, const Catalogue& catalogue);
/// What the last report has to say, if the run has ended with a remark about why it did not converge.
std::string closing_note(const DocumentRun& run, const Action& reset);

/// Whether the run's cells are linear where they could be curved: domain.geometry_order is 1.
bool has_linear_cells(const DocumentRun& run);
/// What would help a run that failed with linear cells; empty where that is not so.
std::string remedy_note(const DocumentRun& run);

/// Draws cells and message, or else the note or the hint, into the current ImGui window; keys "status.0",
/// ... and "message".
void draw_status_bar(const DocumentRun& run, const Notice& message, std::string_view note,
                     std::string_view hint, const Theme& theme, ItemRectangles& items);

} // namespace gaspard
