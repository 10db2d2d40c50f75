// What a plot of the window shows of the document's runs: which series, against what, on which axes.
#pragma once

#include "core/session/layer_study.hpp"
#include "gui/document/document.hpp"
#include "gui/plot/plot_axes.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// What a plot is drawn against: "iterations", "seconds" or "time" of the runs; of an error study a
/// StudyVariable.
using Abscissa = std::string;
/// The plot of errors of other runs (gui/document/error_study.hpp).
inline constexpr std::string_view error_study_plot = "error-study";
/// The plot along the line of the view (core/tessellate/line_section.hpp), and what it is drawn against.
inline constexpr std::string_view section_plot = "section", along_section = "arc-length";
/// Whether a plot is made elsewhere, not of the series of the runs.
inline bool is_made_elsewhere(std::string_view plot) {
    return plot == error_study_plot || plot == section_plot;
}

struct PlotChoice {
    std::string plot = "residual"; ///< by its name, see plots_of()
    Abscissa abscissa = "iterations";
    bool log_x = false, log_y = true;
    friend bool operator==(const PlotChoice&, const PlotChoice&) = default;
};

/// A plot that can be chosen.
struct RunPlot {
    std::string_view name;  ///< for settings and keys: "step-size"
    std::string_view label; ///< for people: "Step size"
    const SeriesInfo* info; ///< of its first series
};
/// error_study_plot if a live run's problem has layers; then those of all series of all runs, in the order in
/// which they report them; section_plot if a mesh lies in the plane. Valid until the runs change.
std::vector<RunPlot> plots_of(const DocumentRuns& runs);
/// For people; the name itself where no run has such a plot.
std::string_view plot_label(const DocumentRuns& runs, std::string_view name);

/// Whether a plot has values, but none that its logarithmic axis can show.
bool is_blank(const DocumentRuns& runs, const PlotChoice& choice);
/// Whether a run that is not hidden has made a time step.
bool has_time_steps(const DocumentRuns& runs);
/// Those that a plot of this name can have for these runs.
std::vector<Abscissa> abscissas_of(const DocumentRuns& runs, std::string_view plot);
/// Another plot, or another abscissa, on the axes that suit it.
PlotChoice with_plot(const DocumentRuns& runs, const PlotChoice& choice, const RunPlot& plot);
PlotChoice with_abscissa(const DocumentRuns& runs, const PlotChoice& choice, const Abscissa& abscissa);
/// For people: "σ".
std::string label_of(const DocumentRuns& runs, const Abscissa& abscissa);

/// As one word for a file of settings: "residual,iterations,linear,log"; the last two are the axes x and y.
std::string format_choice(const PlotChoice& choice);
/// Nothing where the text is not such a word.
std::optional<PlotChoice> parse_choice(std::string_view text);

/// The curves of all runs that are not hidden. Valid until the runs change. `earlier`: also those of earlier
/// solves with other values, faded, the older the more.
PlotView view_of_runs(const DocumentRuns& runs, const PlotChoice& choice, bool earlier = true);

/// The same with its own numbers and with a title, for a file; long curves are thinned out to what a picture
/// can show. `zoom`: what is to be seen of it.
Plot plot_of_runs(const DocumentRuns& runs, const PlotChoice& choice, const PlotZoom& zoom = {});
/// A plot of which a file is to show this part.
Plot zoomed(Plot plot, const PlotZoom& zoom);

} // namespace gaspard
