// The edits of a document, for undo and redo: what was changed, and the state before and after it. The
// history only stores edits; Document applies them.
#pragma once

#include "gui/document/document_run.hpp"

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace gaspard {

/// The values of a live run. The view of `scenario` is not part of them.
struct RunValues {
    RunId run{};
    Scenario opened, scenario;
    friend bool operator==(const RunValues&, const RunValues&) = default;
};

/// How a run appears in lists and plots.
struct RunEntry {
    RunId run{};
    std::string name;
    bool hidden = false;
    friend bool operator==(const RunEntry&, const RunEntry&) = default;
};

/// Whether a kept run is in the document, and at which place.
struct RunPresence {
    RunId run{};
    bool present = false;
    std::size_t place = 0;
    std::string name; ///< for describe_edit()
    friend bool operator==(const RunPresence&, const RunPresence&) = default;
};

using EditPart = std::variant<RunValues, ViewportState, RunEntry, RunPresence>;

struct Edit {
    std::string key; ///< edits of one gesture with equal keys become one
    std::vector<EditPart> before, after;
    bool settled = true; ///< false: the solver may still refuse it
};

/// What an edit does, for the menu: "amplitude", "remove Ring".
std::string describe_edit(const Edit& edit);

class EditHistory {
  public:
    static constexpr std::size_t limit = 200; ///< older edits are dropped

    /// Adds an edit, or merges it with the last one of the same gesture. Clears the edits to redo. An edit
    /// that changes nothing in the end is not kept.
    void record(Edit edit);
    /// Whether an edit with this key would be merged with the last one.
    bool continues(const std::string& key) const {
        return gesture_ && done_ > 0 && done_ == edits_.size() && edits_.back().key == key;
    }
    /// Ends a gesture, such as the drag of a slider: the next edit is a new one.
    void end_gesture() { gesture_ = false; }

    bool can_undo() const { return done_ > 0; }
    bool can_redo() const { return done_ < edits_.size(); }
    std::size_t undo_count() const { return done_; }
    /// What undo and redo would do, as describe_edit() says it; empty if there is no edit.
    std::string undo_label() const { return can_undo() ? describe_edit(edits_[done_ - 1]) : std::string(); }
    std::string redo_label() const { return can_redo() ? describe_edit(edits_[done_]) : std::string(); }
    /// Moves by one edit and returns it; the caller applies `before` or `after`.
    const Edit& step_back();
    const Edit& step_forward();

    /// The solver has accepted all changes of a run.
    void settle(RunId run);
    /// The solver has refused changes of a run, which now has the values `good`: edits that it did not accept
    /// are removed, or cut back to the last values that it did.
    void withdraw(const RunValues& good);
    /// Drops all edits about a run that cannot be brought back.
    void forget(RunId run);
    bool mentions(RunId run) const;

  private:
    void erase(std::size_t index);

    std::vector<Edit> edits_; ///< the first `done_` can be undone, the others redone
    std::size_t done_ = 0;
    bool gesture_ = false; ///< the last edit may be merged with the next one
};

} // namespace gaspard
