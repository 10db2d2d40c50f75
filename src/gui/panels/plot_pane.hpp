// The plots of a document as parts of the window. Each has a line above it to choose what it shows and a menu
// for what can be done with it.
#pragma once

#include "gui/base/frame_context.hpp"
#include "gui/document/document.hpp"
#include "gui/panels/plot_choice.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace gaspard {

/// What a user asks to do with a plot; the application, which has clipboard and files, does it.
struct PlotWish {
    enum class Kind { copy_csv, save_png, save_svg };
    Kind kind = Kind::copy_csv;
    PlotChoice choice;
    PlotZoom zoom;
    std::size_t place = 0; ///< which of the plots
};

/// A drag across an error study: its variable is to have this value.
struct PlotSweep {
    StudyVariable variable;
    double value = 0;
};

class PlotPane {
  public:
    /// Draws both plots, each into a window of its own. Notes "plot.first" and "plot.first.quantity",
    /// ".quantity=jacobian" (while the list is open), ".abscissa", ".log", ".menu", ".menu.csv" (while it is
    /// open), ".curves"; likewise "plot.second". `studies`: what the two show where they are error studies.
    /// `longest`: the run along which one goes, the active one or one beside it. `cursor`: the row of its
    /// history that is shown; null: the newest.
    std::optional<PlotWish> frame(const Document& document, const ItemRectangle& first,
                                  const ItemRectangle& second, const FrameContext& context,
                                  const DocumentRun& longest, const std::array<Plot, 2>& studies = {},
                                  const StepReport* cursor = nullptr);
    /// The iteration of the longest run that was pointed at in this frame, with a fraction.
    std::optional<double> take_pointed() { return std::exchange(pointed_, std::nullopt); }
    /// Whether a plot was double-clicked in this frame.
    bool take_double_click() { return std::exchange(double_clicked_, false); }
    /// Whether curves of earlier solves are shown.
    bool shows_earlier() const { return earlier_; }
    void show_earlier(bool shown) { earlier_ = shown; }
    /// What this frame's drag across an error study asks for.
    std::optional<PlotSweep> take_sweep() { return std::exchange(sweep_, std::nullopt); }

    /// What the plots show; to be remembered and restored.
    std::array<PlotChoice, 2> choices() const { return {plots_[0].choice, plots_[1].choice}; }
    void choose(std::size_t plot, const PlotChoice& choice);
    const PlotZoom& zoom(std::size_t plot) const { return plots_[plot].zoom; }

  private:
    struct Shown {
        PlotChoice choice;
        PlotZoom zoom;
    };
    void draw_header(const std::string& name, const Document& document, Shown& plot,
                     const FrameContext& context);
    std::optional<PlotWish> draw_menu(const std::string& name, const Document& document, Shown& plot,
                                      const FrameContext& context);
    void suit(const Document& document);
    void suit_time(const DocumentRuns& runs);
    /// True when a menu is asked for.
    bool draw_curves(const Document& document, Shown& plot, const Plot& study, const FrameContext& context,
                     const DocumentRun& longest, const StepReport* cursor);

    std::array<Shown, 2> plots_{Shown{}, Shown{{.plot = "equidistribution"}, {}}};
    std::optional<PlotSweep> sweep_;
    std::optional<double> pointed_;
    bool double_clicked_ = false;
    bool earlier_ = true;
    bool moved_ = false;     ///< a run had made a time step in the last frame
    bool fits_time_ = false; ///< what the plots show was chosen again for the time steps
};

} // namespace gaspard
