// Compares methods: each solves the problem of a document's active run, one after the other, as a run of the
// document. The active run is paused meanwhile.
//
// A comparison is not an edit: starting one, cancelling it, or replacing an older one cannot be undone. Its
// runs are kept runs once they have ended; renaming, hiding and removing them are edits as for any other.
#pragma once

#include "core/session/comparison.hpp"
#include "gui/document/document_run.hpp"

#include <cstddef>
#include <deque>
#include <future>
#include <string>
#include <utility>
#include <vector>

namespace gaspard {

class Document;

class MethodComparison {
  public:
    explicit MethodComparison(Document& document) : document_(document) {}

    /// Discards the runs of the comparison before.
    void begin(const std::vector<std::string>& methods);
    /// Interrupts the method at work; the others do not start.
    void cancel();
    /// Starts the next method if the present one has ended.
    void collect();
    /// The user has started or paused the active run: it is not resumed at the end.
    void leave_active_run() { resume_ = false; }

    bool running() const { return now_ != no_run; }
    /// What was compared; the methods are those of rows().
    const Scenario& scenario() const { return scenario_; }
    double progress() const; ///< 0 to 1
    /// A row for each method that has started and whose run was not removed.
    std::vector<ComparisonRow> rows() const;

  private:
    void begin_next();
    void resume_active_run();
    void end_solver(DocumentRun& run);

    Document& document_;
    Scenario scenario_;
    std::deque<std::string> waiting_;                    ///< methods
    std::vector<std::pair<std::string, RunId>> started_; ///< methods and their runs
    std::size_t total_ = 0;
    RunId now_ = no_run;                     ///< the run at work
    bool resume_ = false;                    ///< the active run was solving before
    std::vector<std::future<void>> leaving_; ///< solvers that are stopping
};

} // namespace gaspard
