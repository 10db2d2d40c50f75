// What a document records as edits, and how undo and redo apply them.
#include "core/base/check.hpp"
#include "gui/document/document.hpp"
#include "gui/document/value_changes.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace gaspard {

namespace {

std::string key_of(const char* what, RunId run) {
    return what + std::to_string(static_cast<std::uint64_t>(run));
}

std::string pick_of(const Values& view) { return view.has("pick") ? view.text("pick") : std::string(); }

void set_pick(Values& view, const std::string& pick) {
    if (view.has("pick")) view.set("pick", pick);
}

} // namespace

RunValues Document::values_of(const DocumentRun& run) {
    RunValues values{run.id, run.opened, run.scenario};
    values.scenario.view = {};
    // What the values are called is not part of them: saving gives names without an edit.
    values.scenario.name = values.opened.name;
    values.scenario.title = values.opened.title;
    values.scenario.description = values.opened.description;
    values.scenario.modified = values.opened.modified;
    return values;
}

ViewportState Document::state_of(std::size_t viewport) const {
    ViewportState state{viewport, viewports_[viewport].run, viewports_[viewport].view};
    set_pick(state.view, {});
    return state;
}

/// The states of all viewports that show a run.
std::vector<EditPart> Document::views_of(RunId run) const {
    std::vector<EditPart> views;
    for (std::size_t i = 0; i < viewports_.size(); ++i)
        if (viewports_[i].run == run) views.emplace_back(state_of(i));
    return views;
}

void Document::record(Edit edit) {
    if (edit.before == edit.after) return;
    moves_.clear();
    edits_.record(std::move(edit));
    std::erase_if(removed_, [this](const DocumentRun& run) { return !edits_.mentions(run.id); });
}

void Document::record_views(std::string_view gesture) {
    for (std::size_t i = recorded_.size(); i < viewports_.size(); ++i)
        recorded_.push_back(viewports_[i].view);
    for (std::size_t i = 0; i < viewports_.size(); ++i) {
        if (viewports_[i].view == recorded_[i]) continue;
        const DocumentRun* run = runs_.find(viewports_[i].run);
        // The view that comes with what is opened replaces this one.
        if (run && run->opening && run->opening->from_history) {
            recorded_[i] = viewports_[i].view;
            continue;
        }
        const Values before = std::exchange(recorded_[i], viewports_[i].view);
        Edit edit{.key = "view " + std::to_string(i), .before = {state_of(i)}, .after = {state_of(i)}};
        auto& old = std::get<ViewportState>(edit.before.front()).view;
        old = before;
        set_pick(old, {});
        std::set<std::string> changed; // low and high belong to the range
        for (const ValueChange& one : section_changes("view", before, recorded_[i]))
            if (one.key != "view.pick")
                changed.insert(one.key == "view.low" || one.key == "view.high" ? "view.range" : one.key);
        for (const std::string& key : changed) edit.key += " " + key;
        edit.key += gesture;
        record(std::move(edit));
    }
}

/// The solver has accepted a scenario that was to be opened.
void Document::finish_opening(DocumentRun& run) {
    record_views();
    const RunOpening& opening = *run.opening;
    Edit edit{.key = "open", .before = {values_of(run)}, .after = {}};
    for (EditPart& view : views_of(run.id)) edit.before.push_back(std::move(view));
    run.opened = opening.opened;
    run.scenario = opening.scenario;
    if (!opening.from_history) name_opened(run.opened, run.opened);
    name_values(run);
    run.name = describe_scenario(*catalogue_, run.opened, run.scenario);
    run.wants_to_run = true;
    run.earlier.clear();
    run.solved.reset(); // so that the solve before the opening does not become an earlier one
    set_others_aside(run);
    if (run.id == active_) comparison_.leave_active_run();
    ++run.openings;
    for (std::size_t i = 0; i < viewports_.size(); ++i) {
        if (viewports_[i].run != run.id) continue;
        Values view = opening.scenario.view;
        if (is_default(view, "theme")) view.set("theme", viewports_[i].view.text("theme"));
        for (const ViewportState& state : opening.viewports)
            if (state.viewport == i) view = state.view;
        viewports_[i].view = recorded_[i] = std::move(view);
    }
    update_views(run);
    if (opening.from_history) return;
    edit.after = {values_of(run)};
    for (EditPart& view : views_of(run.id)) edit.after.push_back(std::move(view));
    end_gesture();
    record(std::move(edit));
}

/// Hides runs of other problems, whose curves say nothing beside those of this one, until theirs is back.
void Document::set_others_aside(const DocumentRun& run) {
    for (DocumentRun& other : runs_) {
        if (other.id == run.id) continue;
        const bool comparable = alike(other.scenario, run.scenario);
        if (comparable ? other.set_aside : !other.hidden) other.hidden = other.set_aside = !comparable;
    }
}

/// Null before the first report.
DocumentRun* Document::add_copy(RunId run) {
    collect();
    const DocumentRun* source = runs_.find(run);
    GASPARD_CHECK(source);
    if (source->history.empty()) return nullptr;
    DocumentRun kept;
    kept.id = RunId{++last_id_};
    kept.title = source->title;
    kept.opened = source->opened;
    // The values that made the history, as the solver may not have the newest ones yet.
    kept.scenario = source->status.scenario ? *source->status.scenario : source->scenario;
    kept.history = source->history;
    kept.curves = source->curves;
    kept.snapshot = source->snapshot;
    if (source->recording) kept.recording = std::make_shared<Recording>(*source->recording);
    kept.status = source->status;
    kept.wants_to_run = false;
    kept.solved = source->solved;
    kept.colour = free_colour();
    kept.name = free_name(describe_scenario(*catalogue_, kept.opened, kept.scenario));
    DocumentRun& added = runs_.push_back(std::move(kept));
    share_memory();
    return &added;
}

std::optional<RunId> Document::keep(RunId run) {
    const DocumentRun* added = add_copy(run);
    if (!added) return std::nullopt;
    const RunPresence present{added->id, true, runs_.size() - 1, added->name};
    RunPresence absent = present;
    absent.present = false;
    end_gesture();
    record({.key = "keep", .before = {absent}, .after = {present}});
    return added->id;
}

void Document::remove(RunId run) {
    const DocumentRun* entry = runs_.find(run);
    GASPARD_CHECK(entry && !entry->live() && run != active_);
    const RunPresence present{run, true, runs_.place_of(run), entry->name};
    RunPresence absent = present;
    absent.present = false;
    Edit edit{.key = "remove", .before = {present}, .after = {absent}};
    for (const EditPart& view : views_of(run)) {
        edit.before.push_back(view);
        edit.after.push_back(view);
        std::get<ViewportState>(edit.after.back()).run = active_;
    }
    apply(absent);
    end_gesture();
    record(std::move(edit));
}

/// Removes a run for good.
void Document::discard(RunId run) {
    edits_.forget(run);
    std::erase_if(removed_, [run](const DocumentRun& one) { return one.id == run; });
    if (!runs_.find(run)) return;
    apply(RunPresence{run, false, 0, {}});
    removed_.pop_back();
}

void Document::rename(RunId run, const std::string& name) {
    DocumentRun* entry = runs_.find(run);
    GASPARD_CHECK(entry);
    const RunEntry before{run, std::exchange(entry->name, name), entry->hidden};
    record({.key = key_of("name ", run), .before = {before}, .after = {RunEntry{run, name, entry->hidden}}});
}

void Document::hide(RunId run, bool hidden) {
    DocumentRun* entry = runs_.find(run);
    GASPARD_CHECK(entry);
    const RunEntry before{run, entry->name, std::exchange(entry->hidden, hidden)};
    entry->set_aside = false;
    end_gesture();
    record({.key = key_of("hide ", run), .before = {before}, .after = {RunEntry{run, entry->name, hidden}}});
    end_gesture();
}

bool Document::undo() {
    record_views();
    if (!edits_.can_undo()) return false;
    move(false, true);
    return true;
}

bool Document::redo() {
    record_views();
    if (!edits_.can_redo()) return false;
    move(true, true);
    return true;
}

/// Takes back an edit or applies it again. `with_values`: also the values of live runs.
void Document::move(bool forward, bool with_values) {
    const Edit& edit = forward ? edits_.step_forward() : edits_.step_back();
    apply(forward ? edit.after : edit.before, with_values);
    if (!with_values) return;
    const bool waiting = std::any_of(runs_.begin(), runs_.end(), [](const DocumentRun& run) {
        return run.live() && !run.changes.settled();
    });
    if (waiting) moves_.push_back(forward);
}

/// The solver has refused values, and the run is back at the last valid ones: so is the history.
void Document::take_back_refused(DocumentRun& run) {
    const std::vector<bool> moves = std::exchange(moves_, {});
    if (moves.empty()) edits_.withdraw(values_of(run));
    for (std::size_t i = moves.size(); i-- > 0;) move(!moves[i], false);
}

void Document::apply(const std::vector<EditPart>& parts, bool with_values) {
    bool opens = false; // the views follow once the solver has accepted the scenario
    for (const EditPart& part : parts) {
        if (const auto* values = std::get_if<RunValues>(&part)) {
            const DocumentRun* run = runs_.find(values->run);
            opens = run && values->opened != run->opened;
            if (run && with_values) apply(*values, parts);
        } else if (const auto* entry = std::get_if<RunEntry>(&part)) {
            if (DocumentRun* run = runs_.find(entry->run))
                run->name = entry->name, run->hidden = entry->hidden;
        } else if (const auto* presence = std::get_if<RunPresence>(&part)) {
            apply(*presence);
        } else if (!opens) {
            apply(std::get<ViewportState>(part));
        }
    }
}

void Document::apply(const RunValues& values, const std::vector<EditPart>& parts) {
    DocumentRun& run = live(values.run);
    Scenario scenario = values.scenario;
    if (values.opened == run.opened) {
        scenario.view = run.scenario.view;
        for (DocumentViewport& viewport : viewports_) // another domain has other cells
            if (viewport.run == run.id && scenario.domain != run.scenario.domain) set_pick(viewport.view, {});
        post_change(run, scenario);
        return;
    }
    scenario.view = values.opened.view;
    RunOpening opening{.opened = values.opened, .scenario = std::move(scenario), .from_history = true};
    for (const EditPart& part : parts)
        if (const auto* view = std::get_if<ViewportState>(&part)) opening.viewports.push_back(*view);
    if (opening.viewports.empty() && run.opening) opening.viewports = run.opening->viewports;
    post_opening(run, std::move(opening));
}

void Document::apply(const ViewportState& state) {
    if (state.viewport >= viewports_.size()) return;
    DocumentRun* run = runs_.find(state.run);
    if (run && run->opening && run->opening->from_history) { // together with the scenario on its way
        std::erase_if(run->opening->viewports,
                      [&](const ViewportState& one) { return one.viewport == state.viewport; });
        run->opening->viewports.push_back(state);
        return;
    }
    DocumentViewport& viewport = viewports_[state.viewport];
    const std::string pick = pick_of(viewport.view);
    viewport.run = run ? state.run : active_;
    viewport.view = state.view;
    set_pick(viewport.view, pick);
    recorded_[state.viewport] = viewport.view;
}

void Document::apply(const RunPresence& presence) {
    if (!presence.present) {
        removed_.splice(removed_.end(), runs_.take(presence.run));
        for (DocumentViewport& viewport : viewports_)
            if (viewport.run == presence.run) viewport.run = active_;
        removed_.back().recording.reset(); // what can be brought back is its curves and its last mesh
        share_memory();
        return;
    }
    const auto found = std::find_if(removed_.begin(), removed_.end(),
                                    [&](const DocumentRun& run) { return run.id == presence.run; });
    if (found == removed_.end()) return;
    std::list<DocumentRun> taken;
    taken.splice(taken.end(), removed_, found);
    taken.front().name = free_name(taken.front().name);
    runs_.put_back(presence.place, std::move(taken));
}

} // namespace gaspard
