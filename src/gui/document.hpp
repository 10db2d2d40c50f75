// What a window shows, as data: runs being solved on threads of their own, and the viewports that look at
// them. A document belongs to the window's thread; only a run's solver thread works elsewhere.
#pragma once

#include "core/session/solver_thread.hpp"
#include "core/tessellate/plot.hpp"
#include "gui/camera.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {

/// One run with all it has told so far.
struct DocumentRun {
    std::string title;
    Scenario opened;                 ///< as it was opened: the values that reset buttons restore
    Scenario scenario;               ///< as the panels show it; the solver may still be on its way there
    std::vector<StepReport> history; ///< since the run last began anew
    std::shared_ptr<const Snapshot> snapshot; ///< the newest; null until the first
    SolverStatus status;
    std::uint64_t asked = 0, answered = 0; ///< numbers of the last change of values: sent, dealt with
    bool wants_to_run = true;              ///< what the user last asked for; the status follows within a step
    std::unique_ptr<SolverThread> solver;

    bool ended() const { return is_final(status.run); }
    bool solving() const { return status.run == RunStatus::running && wants_to_run; }
};

/// One picture of one run.
struct DocumentViewport {
    std::size_t run = 0;            ///< which of the document's
    std::optional<Camera> camera{}; ///< in window units; empty: home, which follows the viewport's size
    Values view;                    ///< colouring and blending, as in a scenario's view section
};

/// Iterations per second over the last second of solving; nothing before the first iteration.
std::optional<double> iteration_rate(const std::vector<StepReport>& history);

class Document {
  public:
    /// `notify` is called on a solver thread whenever there is something to collect; it must be quick.
    Document(std::shared_ptr<const Catalogue> catalogue, std::function<void()> notify);

    /// Adds a run, which begins to solve at once, and a viewport that looks at it.
    void open(const Scenario& scenario);

    /// Takes over what the solver threads have produced, every report of it. True if there was anything new.
    bool collect();
    /// Lets a run go on with other values, from the map it has.
    void change(std::size_t run, const Scenario& scenario);
    /// Another scenario in the place of a run's, from its own start.
    void replace(std::size_t run, const Scenario& scenario);
    void start(std::size_t run); ///< a run that has ended starts over
    void pause(std::size_t run);
    void step(std::size_t run);  ///< one iteration, then pause
    void reset(std::size_t run); ///< to the start; goes on if it was going, rests if it had ended

    std::vector<DocumentRun>& runs() { return runs_; }
    std::vector<DocumentViewport>& viewports() { return viewports_; }
    /// Against the iteration, on logarithmic axes, one curve per run.
    const Plot& residual_plot() const { return residual_; }
    const Plot& equidistribution_plot() const { return equidistribution_; }

  private:
    void append(std::size_t run, const SolverEvent& event);

    std::shared_ptr<const Catalogue> catalogue_;
    std::function<void()> notify_;
    Plot residual_, equidistribution_;
    std::vector<DocumentViewport> viewports_;
    std::vector<DocumentRun> runs_;
};

} // namespace gaspard
