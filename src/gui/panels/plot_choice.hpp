// What a plot of the window shows of the document's runs: which quantity, against what, on which axes.
#pragma once

#include "gui/document/document.hpp"
#include "gui/plot/plot_axes.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gaspard {

enum class Quantity { residual, equidistribution, jacobian, step_size };
enum class Abscissa { iterations, seconds };

struct PlotChoice {
    Quantity quantity = Quantity::residual;
    Abscissa abscissa = Abscissa::iterations;
    bool log_x = false, log_y = true;
    friend bool operator==(const PlotChoice&, const PlotChoice&) = default;
};

std::span<const Quantity> quantities();
std::span<const Abscissa> abscissas();
std::string_view name_of(Quantity quantity); ///< for settings and keys: "step-size"
std::string_view name_of(Abscissa abscissa);
std::string_view label_of(Quantity quantity); ///< for people: "Step size"
std::string_view label_of(Abscissa abscissa);

/// As one word for a file of settings: "residual,iterations,linear,log"; the last two are the axes x and y.
std::string format_choice(const PlotChoice& choice);
/// Nothing where the text is not such a word.
std::optional<PlotChoice> parse_choice(std::string_view text);

/// The curves and marks of all runs that are not hidden. Valid until the runs change.
PlotView view_of_runs(const DocumentRuns& runs, const PlotChoice& choice);

/// The same with its own numbers and with a title, for a file; long curves are thinned out to what a picture
/// can show. `zoom`: what is to be seen of it.
Plot plot_of_runs(const DocumentRuns& runs, const PlotChoice& choice, const PlotZoom& zoom = {});

} // namespace gaspard
