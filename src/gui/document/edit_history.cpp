#include "gui/document/edit_history.hpp"

#include "core/base/check.hpp"
#include "gui/document/value_changes.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

namespace {

RunId run_of(const EditPart& part) {
    return std::visit([](const auto& one) { return one.run; }, part);
}

bool about(const Edit& edit, RunId run) {
    const auto names = [run](const EditPart& part) {
        return !std::holds_alternative<ViewportState>(part) && run_of(part) == run;
    };
    return std::any_of(edit.before.begin(), edit.before.end(), names);
}

/// The values of a run among the parts; null if there are none.
RunValues* values_of(std::vector<EditPart>& parts, RunId run) {
    for (EditPart& part : parts)
        if (auto* values = std::get_if<RunValues>(&part); values && values->run == run) return values;
    return nullptr;
}

struct Describe {
    const EditPart& after;

    std::string operator()(const RunValues& before) const {
        const auto& now = std::get<RunValues>(after);
        if (before.opened != now.opened) return "open " + scenario_title(now.opened);
        return name_changes(scenario_changes(before.scenario, now.scenario));
    }
    std::string operator()(const ViewportState& before) const {
        return name_changes(section_changes("view", before.view, std::get<ViewportState>(after).view));
    }
    std::string operator()(const RunEntry& before) const {
        const auto& now = std::get<RunEntry>(after);
        if (before.hidden != now.hidden) return (now.hidden ? "hide " : "show ") + now.name;
        return "rename to " + now.name;
    }
    std::string operator()(const RunPresence& before) const {
        return (before.present ? "remove " : "keep ") + before.name;
    }
};

} // namespace

std::string describe_edit(const Edit& edit) {
    GASPARD_CHECK(!edit.before.empty() && edit.before.size() == edit.after.size());
    return std::visit(Describe{edit.after.front()}, edit.before.front());
}

void EditHistory::record(Edit edit) {
    edits_.resize(done_);
    const bool merges = continues(edit.key);
    gesture_ = true;
    if (merges) {
        edits_.back().after = std::move(edit.after);
        edits_.back().settled = edit.settled;
    } else {
        edits_.push_back(std::move(edit));
    }
    if (edits_.back().before == edits_.back().after) {
        edits_.pop_back();
        gesture_ = false; // the edit before it belongs to another gesture
    }
    if (edits_.size() > limit) edits_.erase(edits_.begin());
    done_ = edits_.size();
}

const Edit& EditHistory::step_back() {
    GASPARD_CHECK(can_undo());
    end_gesture();
    return edits_[--done_];
}

const Edit& EditHistory::step_forward() {
    GASPARD_CHECK(can_redo());
    end_gesture();
    return edits_[done_++];
}

void EditHistory::settle(RunId run) {
    for (Edit& edit : edits_)
        if (about(edit, run)) edit.settled = true;
}

void EditHistory::withdraw(const RunValues& good) {
    std::vector<std::size_t> refused; // newest first
    for (std::size_t i = done_; i-- > 0;) {
        const RunValues* after = values_of(edits_[i].after, good.run);
        if (!after) continue;
        if (edits_[i].settled || *after == good) break;
        refused.push_back(i);
        if (*values_of(edits_[i].before, good.run) == good) break;
    }
    if (refused.empty()) return;
    const std::size_t oldest = refused.back();
    for (const std::size_t i : refused)
        if (i != oldest) erase(i);
    *values_of(edits_[oldest].after, good.run) = good;
    if (*values_of(edits_[oldest].before, good.run) == good) erase(oldest);
}

void EditHistory::forget(RunId run) {
    for (std::size_t i = edits_.size(); i-- > 0;)
        if (about(edits_[i], run)) erase(i);
}

bool EditHistory::mentions(RunId run) const {
    return std::any_of(edits_.begin(), edits_.end(), [run](const Edit& edit) { return about(edit, run); });
}

void EditHistory::erase(std::size_t index) {
    edits_.erase(edits_.begin() + static_cast<std::ptrdiff_t>(index));
    if (index >= done_) return;
    if (index + 1 == done_) gesture_ = false; // the edit before it belongs to another gesture
    --done_;
}

} // namespace gaspard
