// The error studies that the two plots and the table of the window show: when they are computed, and how the
// plots look.
#pragma once

#include "gui/document/document_run.hpp"
#include "gui/document/error_study.hpp"
#include "gui/panels/plot_choice.hpp"
#include "gui/panels/plot_pane.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace gaspard {

class ErrorPlots {
  public:
    using Choices = std::array<PlotChoice, 2>;

    /// `wake`: see ErrorStudy.
    ErrorPlots(const std::shared_ptr<const Catalogue>& catalogue, const std::function<void()>& wake);

    /// Starts what is needed, and stops what is not. `plots`, `table`: whether they are seen at all.
    void follow(const DocumentRun& run, const Choices& choices, bool plots, bool table);
    /// With the present state of the run as a point of its own. The title says what is missing. Plots that
    /// are no error studies are empty.
    std::array<Plot, 2> plots(const DocumentRun& run, const Choices& choices) const;
    /// The results alone, for a file.
    Plot for_file(std::size_t place, const PlotChoice& choice) const;
    std::string csv(std::size_t place) const;
    const ErrorStudy& study(std::size_t place) const { return studies_[place]; }
    /// Over the number of cells.
    const ErrorStudy& table() const { return table_; }

  private:
    std::array<ErrorStudy, 2> studies_; ///< of the plots
    ErrorStudy table_;
};

/// The values of a scenario after a drag across an error study: within the row, and rounded as by a slider.
Scenario with_sweep(const Catalogue& catalogue, const Scenario& scenario, const PlotSweep& sweep);

} // namespace gaspard
