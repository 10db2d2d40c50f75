#include "gui/app/application.hpp"

#include "core/base/error.hpp"
#include "core/base/user_path.hpp"
#include "core/scenario/data_files.hpp"
#include "core/scenario/own_names.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/time_series.hpp"
#include "core/tessellate/interval_plots.hpp"
#include "core/tessellate/ticks.hpp"
#include "gui/document/runs_csv.hpp"
#include "gui/panels/status_bar.hpp"

#include <algorithm>
#include <imgui.h>
#include <imgui_internal.h> // ClosePopupToLevel, ImGuiContext
#include <utility>

namespace gaspard {

namespace {

constexpr ImGuiPopupFlags any_popup = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;

} // namespace

Application::Application(std::shared_ptr<const Catalogue> catalogue, ApplicationOptions options)
    : catalogue_(catalogue), settings_(std::move(options.settings)), messages_(options.wake),
      theme_(dark_theme()), files_(catalogue, messages_.board(), std::move(options.output)),
      films_(messages_.board()), study_(catalogue, options.wake), error_plots_(catalogue, options.wake),
      document_(std::move(catalogue), std::move(options.wake),
                [cache = tessellations_](const Snapshot& snapshot) {
                    cache->get(snapshot);
                    if (cell_dimension(snapshot.mesh->kind) == 3) cache->faces(snapshot);
                }) {
    std::size_t place = 0;
    for (const char* key : {"first_plot", "second_plot"}) {
        const auto choice = parse_choice(settings_.window.text(key));
        if (choice && choice->plot != section_plot) plot_pane_.choose(place, *choice); // there is no line yet
        ++place;
    }
    plot_pane_.show_earlier(settings_.window.boolean("earlier_solves"));
    if (options.in_background) viewport_pane_.work_in_background();
    for (std::string& complaint : options.complaints) messages_.note({std::move(complaint), true});
}

Application::Application(std::shared_ptr<const Catalogue> catalogue, const Scenario& scenario,
                         ApplicationOptions options)
    : Application(std::move(catalogue), options) {
    document_.open(scenario, options.named);
    follow_theme();
}

Application::Application(std::shared_ptr<const Catalogue> catalogue, const FinishedRun& finished,
                         ApplicationOptions options)
    : Application(std::move(catalogue), std::move(options)) {
    document_.show(finished);
    follow_theme();
}

bool Application::collect() {
    files_.forget_drawn();
    films_.work();
    bool news = document_.collect();
    news = messages_.collect() || news;
    take_messages();
    if (run().openings != openings_seen_) take_opening();
    note_what_is_missing();
    const std::string note = closing_note(run(), action("reset"));
    if (note != closing_note_ && !note.empty()) messages_.note({note, false});
    closing_note_ = note;
    if (const auto opened = files_.take_opened()) {
        open_scenario(opened->scenario);
        opening_file_ = opened->file;
        news = true;
    }
    for (const DataFile& data : files_.take_data()) take_data(data), news = true;
    follow_study();
    if (auto listing = files_.take_listing()) file_dialogs_.set_listing(std::move(*listing)), news = true;
    for (const ScenarioOnDisk& saved : files_.take_saved()) {
        if (run().openings != saved_in_) continue;
        document_.name_saved(run().id, saved.scenario);
        if (saved.chosen) saved_as_ = saved.file;
        remember_recent(settings_, saved.file);
        news = true;
    }
    return news;
}

/// The errors against the number of cells are those of the values that the run rests at.
void Application::follow_study() {
    error_plots_.follow(run(), plot_pane_.choices(), settings_.window.boolean("plots"),
                        error_table_shown_ && settings_.window.boolean("sidebar"));
    if (!study_panel_.wanted() || !run().live() || study_.describes(run().scenario)) return;
    study_.cancel();
    if (run().ended() && run().changes.settled()) study_.begin(run().scenario);
}

/// Messages of the active run are shown at once, those of other runs are in the log only. A value refused
/// while a handle is dragged, or a formula is typed, is reported in the status bar and below the formula
/// only, because a dialog would interrupt.
void Application::take_messages() {
    for (DocumentRun& one : document_.runs())
        for (RunMessage& message : std::exchange(one.messages, {})) {
            if (&one != &run())
                messages_.note({one.name + ": " + message.text, message.error});
            else if (message.dragging && run().solver->status().run != RunStatus::failed) {
                if (message.error) panel_.refuse_formula(message.text);
                messages_.show({std::move(message.text), message.error});
            } else
                messages_.say({std::move(message.text), message.error});
        }
}

/// Once for each mesh.
void Application::note_what_is_missing() {
    if (!run().snapshot || run().snapshot->mesh == looked_for_missing_) return;
    looked_for_missing_ = run().snapshot->mesh;
    const std::string note = missing_note(viewport().view, *run().snapshot);
    if (!note.empty()) messages_.say({note, false});
    const auto& patches = run().snapshot->patches;
    const std::string patch = patches ? run().scenario.domain.values.text("file") + ": " + patches->note : "";
    if (patch != patch_note_ && !patch.empty()) messages_.say({patch, false});
    patch_note_ = patch;
}

/// Whether a text field that is being edited handles the key itself.
static bool belongs_to_text(std::string_view key) {
    const bool function_key = key.size() > 1 && key[0] == 'F';
    const bool command =
        key.starts_with("Ctrl+") && std::string_view("ACVXYZ").find(key.back()) == std::string_view::npos;
    return !function_key && !command;
}

bool Application::press_key(std::string_view key) {
    const Action* row = action_for_key(actions_, key);
    constexpr std::string_view shifted = "Ctrl+Shift+"; // the same as Ctrl where it has no meaning of its own
    if (!row && key.starts_with(shifted)) return press_key("Ctrl+" + std::string(key.substr(shifted.size())));
    if (!row) return false;
    document_.record_views(); // changes by keys since the last frame, so that undo includes them
    const bool dialog = messages_.error().open() || file_dialogs_.open(); // comes first
    if (dialog && row->name != "cancel" && row->name != "quit") return false;
    if (!dialog && text_expected() && belongs_to_text(key)) return false;
    if (!row->is_enabled()) {
        const std::string why = run().snapshot ? row->why_disabled() : std::string();
        if (!why.empty()) messages_.say({why, false});
        return false;
    }
    perform(row->name);
    return true;
}

/// A text field has the keyboard, or gets it in the next frames. WantTextInput alone follows a frame late.
bool Application::text_expected() const {
    const ImGuiContext& ui = *ImGui::GetCurrentContext();
    const bool in_text = ui.ActiveId != 0 && (ui.IO.WantTextInput || ui.WantTextInputNextFrame > 0);
    return in_text || panel_.awaits_text();
}

bool Application::working() {
    return !run().status.activity.empty() || run().status.run == RunStatus::preparing;
}

void Application::perform(std::string_view name) {
    const Action& row = action(name);
    if (row.needs_solver && !run().live()) return; // the window shows a finished run
    messages_.clear();
    document_.end_gesture();
    row.run();
}

WindowState Application::window_state() const {
    return {theme_,
            settings_.window.text("theme"),
            static_cast<float>(settings_.window.real("text_size")),
            fullscreen_,
            quit_,
            (file_dialogs_.opening() || panel_.awaits_text() || menus_.opening()) &&
                !messages_.error().open(),
            viewport_pane_.changing() || panel_.waiting() || playback_.playing() || playback_.blends() ||
                menus_.waiting()};
}

void Application::follow(const MenuChoice& choice) {
    switch (choice.kind) {
    case MenuChoice::Kind::action:
        return perform(choice.name);
    case MenuChoice::Kind::file:
        return files_.open(choice.name);
    case MenuChoice::Kind::scenario:
        return open_builtin(choice.name);
    case MenuChoice::Kind::format:
        return export_files(choice.name);
    }
}

/// One button and one key for both: the solver while the newest iterate is shown, else the replay. A run that
/// has ended is replayed.
void Application::run_or_pause() {
    DocumentRun& one = run();
    if (playback_.playing()) return playback_.pause();
    if (playback_.live() && one.solving()) return document_.pause(one.id);
    const bool recorded = one.recording && one.history.size() > 1;
    if (recorded && (!playback_.live() || one.ended())) return playback_.play(longest());
    document_.start(one.id);
}

/// The next iterate that was recorded, else a new one.
void Application::step_forward() {
    if (!playback_.live()) return playback_.go_forward(longest());
    document_.step(run().id);
}

bool Application::on_interval() { return run().snapshot && is_interval(*run().snapshot->mesh); }

bool Application::in_space() {
    const bool elevated = !views().empty() && views().front().scene.elevation > 0;
    return elevated || (run().snapshot && run().snapshot->mesh->space_dimension == 3);
}

bool Application::shows_solid() { return !views().empty() && views().front().scene.cell_dimension == 3; }

/// Opens as it was cut before, or by a plane through the middle.
void Application::toggle_cut() {
    Values& view = viewport().view;
    const ShownView& shown = views().front();
    if (const std::string text = view.text("cut"); !text.empty()) {
        closed_cut_ = text, cut_box_ = bounding_box(shown.scene.mesh->nodes);
        return view.set("cut", std::string());
    }
    if (closed_cut_.empty() || cut_box_ != bounding_box(shown.scene.mesh->nodes)) // of another solid
        closed_cut_ = format_cut({{usual_cut(shown.scene.home_box, towards_viewer(shown.camera))}});
    view.set("cut", closed_cut_);
}

void Application::flip_cut() {
    Values& view = viewport().view;
    try {
        view.set("cut", format_cut(flipped(parse_cut(view.text("cut")))));
    } catch (const InputError& error) {
        messages_.say({error.what(), true});
    }
}

bool Application::available(const std::string& choice) const {
    const auto missing = viewport_pane_.unavailable();
    return viewport_pane_.shows() && std::find(missing.begin(), missing.end(), choice) == missing.end();
}

/// Restarts, because the map that linear cells have failed with is rarely a usable start.
void Application::use_quadratic_cells() {
    Scenario scenario = run().scenario;
    const auto remedy = find_remedy(scenario.domain.values);
    if (!remedy) return;
    scenario.domain.values.set(remedy->key, remedy->value);
    viewport().view.set("pick", std::string());
    document_.change(run().id, scenario);
    document_.reset(run().id);
    messages_.clear();
    run().solver->post(StartCommand{});
    run().wants_to_run = true;
}

bool Application::has_formula() {
    const std::string& name = run().scenario.monitor.type;
    const auto& types = catalogue_->monitors;
    return run().live() && std::any_of(types.begin(), types.end(), [&](const MonitorType& type) {
               return type.name == name && type.formula;
           });
}

void Application::edit_as_formula() {
    try {
        const auto scenario = with_formula(*catalogue_, run().scenario);
        if (!scenario) return;
        change_values(*scenario);
        settings_.window.set("sidebar", true); // where the field is
        panel_.focus_formula("monitor.expression");
    } catch (const InputError& error) { // such as a formula of the target that is being typed
        messages_.say({error.what(), true});
    }
}

void Application::look_from(const std::string& direction) {
    viewport().view.set("direction", direction);
    viewport_pane_.go_home(viewport());
}

void Application::copy_camera() {
    const std::string text = viewport_pane_.camera_text();
    ImGui::SetClipboardText(text.c_str());
    messages_.show({"Copied: " + text, false});
}

void Application::paste_camera() {
    const char* text = ImGui::GetClipboardText();
    try {
        parse_camera(text ? text : "", {});
        viewport_pane_.look_as(viewport(), text);
    } catch (const InputError& error) {
        messages_.say({error.what(), true});
    }
}

/// Takes the theme of the view for the window.
void Application::follow_theme() {
    settings_.window.set("theme", viewed_theme());
    theme_ = theme_named(viewed_theme());
}

void Application::set_text_size(double size) {
    settings_.window.set("text_size", within(settings_.window, "text_size", size));
}

bool Application::can_cancel() {
    return ImGui::IsPopupOpen("", any_popup) || messages_.error().open() || file_dialogs_.open() ||
           help_.open() || about_.open() || working() || files_.figure_progress() ||
           document_.comparison().running() || comparison_panel_.open() || path_.armed() ||
           !viewport().view.text("pick").empty() || films_.busy();
}

/// Closes or cancels the topmost thing only.
void Application::cancel() {
    const bool dialog = messages_.error().open() || file_dialogs_.open();
    if (ImGui::IsPopupOpen("", any_popup) && !dialog)
        ImGui::ClosePopupToLevel(0, true); // a menu or a list
    else if (messages_.error().open())
        messages_.error().close();
    else if (file_dialogs_.open())
        file_dialogs_.close();
    else if (about_.open())
        about_.close();
    else if (help_.open())
        help_.close();
    else if (path_.armed())
        leave_path();
    else if (document_.comparison().running())
        document_.cancel_comparison();
    else if (working())
        run().solver->cancel();
    else if (files_.figure_progress())
        files_.cancel_figures();
    else if (comparison_panel_.open())
        comparison_panel_.close();
    else if (!viewport().view.text("pick").empty())
        viewport().view.set("pick", std::string());
    else
        films_.cancel(); // last, because it may have taken minutes
}

/// The chosen folder, if any, is that of the dialog.
void Application::export_files(const std::string& formats, const ExportDialog::Choice& choice) {
    // The files use the colours and the camera of the viewport.
    Scenario scenario = run().scenario;
    scenario.view = viewport().view;
    if (!choice.formats.empty()) scenario.output.set("formats", choice.formats);
    if (scenario != run().scenario) document_.change(run().id, scenario);
    ExportOrder order{.formats = formats, .replace = choice.replace};
    if (!choice.folder.empty()) order.folder = std::filesystem::absolute(user_path(choice.folder));
    if (order.folder.lexically_normal() == files_.export_folder(run().scenario) && !order.replace)
        order.folder.clear(); // the usual one, or another where that cannot be written
    files_.export_run(run(), std::move(order));
    messages_.show(
        {playback_.live() ? "Exporting ..." : "Exporting the newest iterate, not the one that is shown ...",
         false});
}

void Application::ask_what_to_export() {
    const bool splines = catalogue_->domain(run().scenario.domain.type).spline_patch;
    file_dialogs_.ask_what_to_export(run().scenario, splines, files_.export_folder(run().scenario));
}

void Application::save_image(Image image) {
    files_.save_image(run().scenario, "screenshot", std::move(image));
}

Settings Application::settings() {
    Settings settings = settings_;
    settings.window.set("camera", viewport().view.text("camera"));
    settings.window.set("camera_scenario", run().scenario.name);
    return settings;
}

void Application::keep() {
    if (const auto kept = document_.keep(run().id))
        messages_.say({"Kept as " + document_.runs().find(*kept)->name, false});
}

void Application::go_on() {
    const auto from = run().recording->with_state(playback_.iteration(run()));
    if (!from) return;
    const auto back = document_.go_on_from(run().id, *from);
    if (!back) return;
    playback_.go_to_end();
    const auto time = time_of(from->report());
    const std::string place =
        time ? "t = " + short_number(*time) : "iteration " + std::to_string(from->iteration());
    const std::string kept =
        back->kept ? "; the earlier run is kept as " + document_.runs().find(*back->kept)->name : "";
    messages_.say({"Back at " + place + kept + ". Change values, or press Space to go on.", false});
}

void Application::begin_path() {
    path_.arm();
    messages_.say(
        {"Drag the centre of the monitor along a path, or press Escape to leave it as it is.", false});
}

/// Without a path; one that is being drawn is taken back.
void Application::leave_path() {
    if (path_.drawing()) {
        document_.change(run().id, before_path_, true);
        document_.end_gesture();
        path_left_ = true;
    }
    path_.give_up();
}

void Application::move_in_history(bool forward) {
    const EditHistory& edits = document_.edits();
    const std::string label = forward ? edits.redo_label() : edits.undo_label();
    const double spin = viewport().view.real("spin");
    if (!(forward ? document_.redo() : document_.undo())) return;
    if (viewport().view.real("spin") != spin) viewport_pane_.stop_turning();
    opening_file_.clear();
    messages_.show({(forward ? "Redone: " : "Undone: ") + label, false});
}

/// Keys that step a field, as the wheel does.
static bool steps_by_key() {
    return ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_UpArrow)) ||
           ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_DownArrow));
}

/// One burst of the wheel or of keys is one edit, other than what was done before it.
void Application::begin_burst() {
    constexpr double longest_pause = 0.5; // seconds between two steps of a burst
    const bool steps = ImGui::GetIO().MouseWheel != 0 || steps_by_key();
    const double now = ImGui::GetTime();
    wheel_burst_ = wheel_burst_ && !ImGui::IsAnyItemActive() && now - wheeled_ < longest_pause;
    if (!steps) return;
    if (!wheel_burst_) document_.end_gesture();
    wheel_burst_ = true, wheeled_ = now;
}

/// Makes an edit of what this frame has changed in the view. One drag is one edit, too.
void Application::record_edits() {
    document_.record_views(ImGui::GetIO().MouseWheel != 0 ? " wheel" : "");
    if (!ImGui::IsAnyItemActive() && !wheel_burst_) document_.end_gesture();
}

void Application::fulfil(const PlotWish& wish) {
    switch (wish.kind) {
    case PlotWish::Kind::copy_csv:
        if (wish.choice.plot == error_study_plot) {
            ImGui::SetClipboardText(error_plots_.csv(wish.place).c_str());
            return messages_.say({"Copied the numbers of the error study", false});
        }
        if (wish.choice.plot == section_plot) {
            ImGui::SetClipboardText(viewport_pane_.section_csv().c_str());
            return messages_.say({"Copied the numbers along the section line", false});
        }
        ImGui::SetClipboardText(runs_csv(document_.runs()).c_str());
        return messages_.say({"Copied the numbers of all runs that are shown", false});
    case PlotWish::Kind::save_png:
        plot_to_save_ = plot_for_file(wish);
        plot_name_ = wish.choice.plot;
        return;
    case PlotWish::Kind::save_svg:
        return files_.save_svg(run().scenario, wish.choice.plot, plot_for_file(wish));
    }
}

Plot Application::plot_for_file(const PlotWish& wish) {
    if (wish.choice.plot == section_plot) return zoomed(section_of(wish.choice), wish.zoom);
    if (wish.choice.plot == error_study_plot)
        return zoomed(error_plots_.for_file(wish.place, wish.choice), wish.zoom);
    return plot_of_runs(document_.runs(), wish.choice, wish.zoom);
}

/// One edit per drag, as of a slider.
void Application::sweep(const PlotSweep& sweep) {
    if (!run().live()) return;
    const Scenario scenario = with_sweep(*catalogue_, run().scenario, sweep);
    if (scenario == run().scenario) return;
    messages_.clear();
    document_.change(run().id, scenario);
}

void Application::draw_comparison() {
    using Wish = ComparisonPanel::Wish;
    const ItemRectangle &plots = layout_.first_plot, &view = layout_.viewport;
    const bool beside = layout_.plots_beside && plots.width() > 0;
    const ItemRectangle area = beside ? plots : ItemRectangle{view.right, view.top, view.right, view.bottom};
    switch (comparison_panel_.draw(document_, *catalogue_, area, theme_, items_)) {
    case Wish::none:
        return;
    case Wish::begin:
        return document_.compare(comparison_panel_.chosen(document_, *catalogue_));
    case Wish::cancel:
        return document_.cancel_comparison();
    case Wish::copy:
        ImGui::SetClipboardText(comparison_csv(document_.comparison().rows()).c_str());
        return messages_.say({"Copied the table of methods", false});
    case Wish::meshes:
        return perform("runs");
    }
}

void Application::save_plot(const std::function<Image(const Plot&)>& draw) {
    const auto plot = std::exchange(plot_to_save_, std::nullopt);
    if (!plot) return;
    try {
        files_.save_image(run().scenario, plot_name_, draw(*plot));
    } catch (const MachineError& error) {
        messages_.say({error.what(), true});
    }
}

} // namespace gaspard
