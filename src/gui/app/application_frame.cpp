// The frame of the application; its behaviour is in application.cpp and application_actions.cpp.
#include "core/scenario/time_rows.hpp"
#include "core/session/time_series.hpp"
#include "gui/app/application.hpp"
#include "gui/app/edges.hpp"
#include "gui/base/part_window.hpp"
#include "gui/base/plot_text.hpp"
#include "gui/panels/error_table.hpp"
#include "gui/panels/playback_bar.hpp"
#include "gui/panels/status_bar.hpp"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <iterator>

namespace gaspard {

namespace {

constexpr const char* hint =
    "Drag to pan, wheel to zoom, click a cell to inspect it, H to see all, F1 for help";
constexpr const char* hint_in_space =
    "Drag to rotate, wheel to zoom, click a cell to inspect it, F for the rear, H to see all, F1 for help";
constexpr const char* hint_of_heights =
    "Drag to rotate, wheel to zoom, click a cell to inspect it, H to see all, F1 for help";
constexpr const char* hint_of_plots =
    "Drag to move, wheel to zoom, double-click to see all, B for the computational interval, F1 for help";

constexpr float narrowest_with_panel = 30; // in widths of the font; in smaller windows the mesh has all of it

/// Whether one camera suits both meshes.
bool look_alike(const DocumentRun& one, const DocumentRun& other) {
    return one.snapshot && other.snapshot &&
           one.snapshot->mesh->space_dimension == other.snapshot->mesh->space_dimension &&
           one.scenario.domain.type == other.scenario.domain.type;
}

} // namespace

void Application::frame() {
    items_.clear();
    panel_.begin_frame(!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel));
    begin_burst();
    // The frame of a screenshot ignores the mouse, so that no tooltip is in the image; but a slider that is
    // being dragged would jump.
    taking_screenshot_ = std::exchange(screenshot_, false);
    if (taking_screenshot_ && !ImGui::IsAnyItemActive()) ImGui::GetIO().MousePos = {-FLT_MAX, -FLT_MAX};
    if (viewed_theme() != settings_.window.text("theme")) follow_theme();
    const FrameContext context{theme_, scale_, items_};
    const auto menu_context = [&] {
        return MenuContext{actions_, *catalogue_, run(), settings_.recent, context};
    };
    if (const auto chosen = menus_.draw_bar(menu_context())) follow(*chosen);
    arrange();
    playback_.update(run(), longest(), static_cast<double>(ImGui::GetIO().DeltaTime));
    viewport_pane_.offer_handles(handles_now());
    viewport_pane_.offer_cut_handles(!taking_screenshot_);
    draw_viewport(context);
    if (const auto move = viewport_pane_.take_handle_move(); move && !path_left_) {
        if (!run().status.refused) messages_.clear();
        if (path_.armed() && !path_.drawing()) before_path_ = run().scenario;
        document_.change(run().id, with_handle_at(run().scenario, move->handle, move->place), true);
        path_.add(run().scenario, move->handle.first, ImGui::GetTime());
    }
    path_left_ = path_left_ && ImGui::IsMouseDown(0);
    if (path_.drawing() && !ImGui::IsMouseDown(0)) take_path();
    if (layout_.sidebar.width() > 0) draw_sidebar();
    if (layout_.plots > 0) draw_plots(context);
    if (layout_.plots == 0 && action("plots").is_checked()) draw_plots_left_out(context);
    draw_edges(layout_, settings_.window, context);
    if (action("log").is_checked()) draw_log();
    const Toast message = toast();
    if (toast_.draw(message, layout_.viewport, context)) perform(message.action->name);
    draw_comparison();
    draw_status(context);
    draw_dialogs();
    record_edits();
}

/// A monitor that moves has its centre where it is at the time of the mesh that is shown.
std::vector<Handle> Application::handles_now() {
    if (!run().live() || taking_screenshot_) return {};
    const bool moving = path_.armed() || path_left_;
    std::vector<Handle> handles = monitor_handles(run().scenario, moving);
    if (moving && !path_.drawing())
        if (const auto shown = playback_.snapshot(run()))
            if (const Values* now = values_in_time_.at(run().scenario, time_of(shown->report))) {
                Scenario then = run().scenario;
                then.monitor.values = *now;
                handles = monitor_handles(then, moving);
            }
    if (run().snapshot)
        for (Handle& one : domain_handles(run().scenario, *run().snapshot)) handles.push_back(std::move(one));
    return handles;
}

/// The iterates that the playback stands at.
void Application::draw_viewport(const FrameContext& context) {
    const std::vector<ShownRun> others = shown_beside();
    Values& view = viewport().view;
    const double blend = view.real("blend");
    if (playback_.blends()) view.set("blend", playback_.blend());
    ShownRun shown{&run(), playback_.snapshot(run()), replay_range()};
    if (playback_.compares() && on_interval()) shown.compared = replay_ends_.of(run());
    viewport_pane_.frame(shown, viewport(), layout_.viewport, context, others);
    view.set("blend", blend);
}

/// The range of the colours while recorded iterates are looked at.
std::optional<ColourRange> Application::replay_range() {
    if (!playback_.compares()) return std::nullopt;
    return replay_range_.of(run(), colour_choice(viewport().view));
}

/// What helps, what was said, or why the run did not converge.
Toast Application::toast() {
    if (const std::string note = remedy_note(run()); !note.empty())
        return {note, Tone::warning, &action("quadratic"), false};
    if (const Notice& last = messages_.last(); !last.text.empty())
        return {last.text, last.error ? Tone::bad : Tone::good, nullptr};
    const Action* tangled = first_tangled() && playback_.live() ? &action("first-tangled") : nullptr;
    return {closing_note(run(), action("reset")), Tone::warning, tangled};
}

/// The first recorded iteration with tangled cells.
std::optional<int> Application::first_tangled() {
    return run().recording ? run().recording->first_tangled() : std::nullopt;
}

/// Runs with time go to the time of that iterate.
void Application::go_to_tangled() {
    const int first = first_tangled().value_or(0);
    const bool same = iteration_beside(run(), longest(), first) == first;
    playback_.go_to(same ? longest() : run(), first, &longest());
}

/// Of the runs whose meshes are shown, the one that ends last.
const DocumentRun& Application::longest() { return longest_run(run(), runs_shown_beside()); }

std::vector<const DocumentRun*> Application::runs_shown_beside() {
    return viewport().view.text("layout") == "runs" ? runs_beside() : std::vector<const DocumentRun*>();
}

/// Their iterates that are shown.
std::vector<ShownRun> Application::shown_beside() {
    std::vector<ShownRun> shown;
    for (const DocumentRun* other : runs_shown_beside())
        shown.push_back({other, playback_.snapshot(*other), {}});
    return shown;
}

std::vector<const DocumentRun*> Application::runs_beside() {
    std::vector<const DocumentRun*> others;
    for (const DocumentRun& other : document_.runs())
        if (&other != &run() && !other.hidden && look_alike(other, run())) others.push_back(&other);
    return others;
}

void Application::arrange() {
    const Values& window = settings_.window;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    const LayoutChoice choice{.sidebar = window.boolean("sidebar") && size.x >= narrowest_with_panel * em,
                              .plots = window.boolean("plots"),
                              .log = window.boolean("log"),
                              .sidebar_width = static_cast<float>(window.real("sidebar_width")),
                              .plots_share = static_cast<float>(window.real("plots_share"))};
    layout_ = compute_layout(size.x, size.y, em, menus_.height(), choice);
}

void Application::draw_sidebar() {
    begin_part("##sidebar", layout_.sidebar, ImGuiWindowFlags_None); // it may have to scroll
    Scenario scenario = run().scenario;
    const std::shared_ptr<const Snapshot> snapshot = run().snapshot; // while the panel shows its patches
    const auto shown = playback_.snapshot(run());
    const std::optional<double> now = shown ? time_of(shown->report) : std::nullopt;
    const PatchList* patches = snapshot && run().changes.settled() ? snapshot->patches.get() : nullptr;
    const PanelContext context{*catalogue_,
                               run().opened,
                               theme_,
                               items_,
                               viewport_pane_.unavailable(),
                               patches,
                               snapshot ? snapshot->monitor_report.get() : nullptr,
                               viewport().view.text("color"),
                               narrow_feature_.warning(*catalogue_, run()),
                               snapshot.get(),
                               viewport().view.text("color_map"),
                               values_in_time_.at(run().scenario, now),
                               now.value_or(0)};
    bool changed = false;
    for (const auto kind : all_sections) {
        if (!has_section(scenario, kind)) continue;
        if (kind == SectionKind::monitor && panel_.awaits_text()) ImGui::SetNextItemOpen(true);
        const bool open = ImGui::CollapsingHeader(
            section_title(kind), ImGuiTreeNodeFlags_DefaultOpen | ImGuiTreeNodeFlags_AllowItemOverlap);
        if (kind == SectionKind::monitor) draw_formula_button();
        if (open) changed |= panel_.draw_section(kind, context, scenario);
        ImGui::Spacing();
    }
    const bool time_changed = draw_time_section(context, scenario);
    changed |= time_changed;
    if (scenario.method.values.has("interpolation")) {
        const bool open = ImGui::CollapsingHeader("Why adapt?");
        remember_item(items_, "why");
        if (open) changed |= draw_why_section(scenario);
        ImGui::Spacing();
    }
    draw_error_section();
    if (ImGui::CollapsingHeader("Runs", ImGuiTreeNodeFlags_DefaultOpen)) {
        if (run_list_.draw(document_, action("keep"), {theme_, scale_, items_})) perform("keep");
        const Action& row = action("compare");
        ImGui::SameLine();
        ImGui::BeginDisabled(!row.is_enabled());
        if (ImGui::Button(std::string(row.label).c_str())) perform(row.name);
        ImGui::EndDisabled();
        remember_item(items_, "runs.compare");
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(row.help).c_str());
    }
    ImGui::Spacing();
    if (ImGui::CollapsingHeader("View", ImGuiTreeNodeFlags_DefaultOpen)) draw_view(context);
    if (scenario.domain != run().scenario.domain) viewport().view.set("pick", std::string());
    scenario.view = viewport().view;
    const bool formula = panel_.take_formula_applied();
    if (formula) document_.end_gesture();
    if (changed) { // once per frame; of those that wait, the solver takes the newest
        messages_.clear();
        // A time that is dragged may lead a formula out of its range; a dialog would interrupt.
        const bool dragged = time_changed && ImGui::IsAnyItemActive();
        document_.change(run().id, scenario, formula || dragged);
    }
    if (formula) document_.end_gesture();
    if (const auto wish = panel_.take_file_wish()) file_dialogs_.ask_for_value(*wish, run().scenario);
    if (const auto field = panel_.take_field_wish()) viewport().view.set("color", *field);
    ImGui::End();
}

/// True if it changes the scenario.
bool Application::draw_time_section(const PanelContext& context, Scenario& scenario) {
    const auto flags = has_time(scenario.time) ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None;
    const bool open = ImGui::CollapsingHeader("Time", flags);
    remember_item(items_, "time");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("The monitor moves from the start to the end, and the mesh follows");
    bool changed = false;
    if (open) {
        std::vector<std::string> keys;
        for (const ParameterRow& row : scenario.time.rows()) keys.push_back(row.key);
        changed = panel_.draw_rows(context, run().opened.time, scenario.time, keys, &scenario);
    }
    ImGui::Spacing();
    return changed;
}

/// The path that was drawn begins anew, from its start.
void Application::take_path() {
    const auto moving = path_.finish(*catalogue_, before_path_);
    document_.change(run().id, moving ? *moving : before_path_, true); // one edit with the drag
    document_.end_gesture();
    if (!moving) {
        messages_.say({"The path is too short; draw it again.", false});
        return;
    }
    perform("run-again");
    messages_.say(
        {"The monitor follows the path for " + short_number(moving->time.real("end")) + " units of time.",
         false});
}

void Application::draw_error_section() {
    error_table_shown_ = false;
    if (!run().live() || study_variables(run().scenario).empty()) return;
    error_table_shown_ = ImGui::CollapsingHeader("Errors");
    remember_item(items_, "errors");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("The energy errors of other numbers of cells and ε, solved in the background");
    if (error_table_shown_) draw_error_table(error_plots_.table(), items_);
    ImGui::Spacing();
}

/// True if it changes the scenario.
bool Application::draw_why_section(Scenario& scenario) {
    const bool measured = scenario.method.values.boolean("interpolation");
    const bool changed = follow(draw_why(run().snapshot.get(), measured, items_), scenario);
    if (!run().live()) return changed;
    const bool before = study_panel_.wanted();
    study_panel_.draw(study_.result(), study_.describes(run().scenario), {theme_, scale_, items_});
    if (before && !study_panel_.wanted()) study_.cancel();
    if (!before) follow_study();
    return changed;
}

/// True if it changes the scenario.
bool Application::follow(WhyWish wish, Scenario& scenario) {
    Values& view = viewport().view;
    switch (wish) {
    case WhyWish::none:
        return false;
    case WhyWish::measure:
        scenario.method.values.set("interpolation", true);
        return true;
    case WhyWish::maps:
        view.set("color", std::string("interpolation_error"));
        view.set("layout", std::string("side-by-side"));
        return false;
    case WhyWish::factors:
        view.set("color", std::string("interpolation_ratio"));
        view.set("layout", std::string("single"));
        return false;
    }
    return false;
}

/// At the right end of the monitor's heading.
void Application::draw_formula_button() {
    const Action& row = action("as-formula");
    const std::string label(row.label);
    const float padding = ImGui::GetStyle().FramePadding.x;
    const float width = ImGui::CalcTextSize(label.c_str()).x + 2 * padding;
    const float left = ImGui::GetWindowContentRegionMax().x - width - padding;
    const float heading =
        ImGui::GetTreeNodeToLabelSpacing() + ImGui::CalcTextSize(section_title(SectionKind::monitor)).x;
    if (left < heading + padding) return; // a narrow panel
    ImGui::SameLine(left);
    ImGui::BeginDisabled(!row.is_enabled());
    if (ImGui::SmallButton(label.c_str())) perform(row.name);
    ImGui::EndDisabled();
    remember_item(items_, "monitor.as-formula");
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("%s", row.is_enabled() ? tooltip_of(row).c_str() : row.why_disabled().c_str());
}

void Application::draw_view(const PanelContext& context) {
    Values& view = viewport().view;
    const bool was_fixed = view.text("range") == "fixed";
    const std::vector<std::string> keys = view_keys();
    panel_.draw_rows(context, run().opened.view, view, keys);
    if (!was_fixed && view.text("range") == "fixed") viewport_pane_.fix_range(viewport());
}

/// The settings of the view that change something for this mesh.
std::vector<std::string> Application::view_keys() {
    const Values& view = viewport().view;
    const bool fixed = view.text("range") == "fixed";
    std::vector<std::string> keys;
    if (view.text("layout") != "computational") keys.emplace_back("blend");
    keys.emplace_back("color");
    if (!on_interval()) keys.emplace_back("color_map");
    keys.insert(keys.end(), {"log", "range"});
    if (fixed) keys.insert(keys.end(), {"low", "high"});
    if (on_interval()) {
        keys.insert(keys.end(), {"x_axis", "lines", "layout"});
        return keys;
    }
    keys.insert(keys.end(), {"histogram", "histogram_counts", "lines"});
    const MeshScene* scene = views().empty() ? nullptr : &views().front().scene;
    const bool in_plane = run().snapshot && run().snapshot->mesh->space_dimension == 2;
    if (scene != nullptr && scene->cell_dimension > 1 && scene->colouring != nullptr && !scene->flat()) {
        keys.emplace_back("contours");
        if (in_plane) keys.emplace_back("elevation");
    }
    if (scene != nullptr && scene->cell_dimension == 3) {
        keys.insert(keys.end(), {"cut", "cut_cells", "peel", "only", "explode"});
        if (run().snapshot->mesh->lattice[0] > 0) keys.emplace_back("layers");
    }
    if (scene != nullptr && has_section_line(*scene->mesh)) keys.insert(keys.end(), {"axes", "section"});
    keys.insert(keys.end(), {"arrows", "layout"});
    const bool projection = view.text("layout") == "projection" && available("layout=projection");
    if (projection) keys.insert(keys.end(), {"projection_longitude", "projection_camera"});
    if (!projection) keys.emplace_back(scene != nullptr ? camera_key(*scene) : "camera");
    if (in_space() && !projection) keys.insert(keys.end(), {"direction", "spin"});
    if (run().snapshot && (run().snapshot->mesh->space_dimension == 3 || run().snapshot->exact))
        keys.emplace_back("overlay");
    return keys;
}

/// The row of the longest history that is shown; null before the first.
const StepReport* Application::shown_report() {
    const auto& history = longest().history;
    const int iteration = playback_.iteration(longest());
    const auto after = std::upper_bound(history.begin(), history.end(), iteration,
                                        [](int at, const StepReport& row) { return at < row.iteration; });
    return after == history.begin() ? nullptr : &*std::prev(after);
}

void Application::draw_plots(const FrameContext& context) {
    auto studies = error_plots_.plots(run(), plot_pane_.choices());
    for (std::size_t i = 0; i < studies.size(); ++i)
        if (plot_pane_.choices()[i].plot == section_plot) studies[i] = section_of(plot_pane_.choices()[i]);
    const auto before = plot_pane_.choices();
    const auto wish = plot_pane_.frame(document_, layout_.first_plot, layout_.second_plot, context, longest(),
                                       studies, playback_.live() ? nullptr : shown_report());
    offer_section_line(before);
    if (wish) fulfil(*wish);
    if (const auto iteration = plot_pane_.take_pointed()) {
        before_click_ = playback_.live() ? std::nullopt : std::optional(playback_.iteration(longest()));
        playback_.go_to(longest(), *iteration);
    }
    if (plot_pane_.take_double_click()) // its first click has gone to another iterate
        before_click_ ? playback_.go_to(longest(), *before_click_) : playback_.go_to_end();
    settings_.window.set("earlier_solves", plot_pane_.shows_earlier());
    if (const auto wanted = plot_pane_.take_sweep()) sweep(*wanted);
    const auto choices = plot_pane_.choices();
    settings_.window.set("first_plot", format_choice(choices[0]));
    settings_.window.set("second_plot", format_choice(choices[1]));
}

void Application::draw_plots_left_out(const FrameContext& context) {
    const ItemRectangle& place = layout_.plots_note;
    const float em = ImGui::GetFontSize();
    std::string text = "No space for the plots: enlarge the window, or " + describe_keys(action("smaller"));
    if (text_size(text).x > place.width() - 2 * em) text = "No space for the plots";
    begin_part("##plots-note", place, ImGuiWindowFlags_NoInputs);
    write_text(*ImGui::GetWindowDrawList(), {place.left + em, place.top + 0.2F * em},
               context.theme.faint_text, shortened(text, place.width() - 2 * em));
    ImGui::End();
    context.items["plots.note"] = place;
}

/// A plot that is chosen without a line gets one through the middle of the mesh.
void Application::offer_section_line(const std::array<PlotChoice, 2>& before) {
    Values& view = viewport().view;
    const auto now = plot_pane_.choices();
    for (std::size_t i = 0; i < now.size(); ++i)
        if (now[i].plot == section_plot && before[i].plot != section_plot && view.text("section").empty() &&
            !views().empty() && has_section_line(*views().front().scene.mesh))
            view.set("section", format_section_line(usual_section_line(views().front().scene)));
}

Plot Application::section_of(const PlotChoice& choice) {
    Plot plot = viewport_pane_.section_plot();
    plot.x.logarithmic = choice.log_x, plot.y.logarithmic = choice.log_y;
    return plot;
}

void Application::draw_status(const FrameContext& context) {
    begin_part("##status", layout_.status);
    const bool in_space = !views().empty() && !views().front().scene.planar();
    const bool elevated = in_space && views().front().scene.elevation > 0;
    draw_status_bar(status(), method_note(run(), *catalogue_, playback_.iteration(run())),
                    on_interval() ? hint_of_plots
                    : elevated    ? hint_of_heights
                    : in_space    ? hint_in_space
                                  : hint,
                    context);
    ImGui::End();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        {0.8F * ImGui::GetFontSize(), 0.5F * ImGui::GetFontSize()});
    begin_part("##playback", layout_.playback,
               ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                   ImGuiWindowFlags_NoScrollWithMouse,
               true);
    ImGui::PopStyleVar();
    if (const auto pressed =
            draw_playback_bar({&run(), &longest(), runs_shown_beside(), recorded_bytes(document_.runs())},
                              playback_, actions_, context))
        perform(*pressed);
    ImGui::End();
}

void Application::draw_log() {
    begin_part("##log", layout_.log);
    messages_.log().draw(theme_, items_);
    ImGui::End();
}

/// Of the work that the active run or a figure waits for; and above it that of a film.
void Application::draw_progress_bars() {
    const SolverStatus& status = run().status;
    if (working()) {
        if (draw_progress(status.activity.empty() ? "preparing" : status.activity, status.progress,
                          layout_.viewport, items_))
            run().solver->cancel();
    } else if (document_.comparison().running() && !comparison_panel_.open()) {
        if (draw_progress("comparing methods", document_.comparison().progress(), layout_.viewport, items_))
            document_.cancel_comparison();
    } else if (const auto drawn = files_.figure_progress()) {
        if (draw_progress("drawing the figure", *drawn, layout_.viewport, items_)) files_.cancel_figures();
    }
    const auto film = films_.progress();
    if (!film) return;
    ItemRectangle place = layout_.viewport;
    if (const auto below = items_.find("progress"); below != items_.end())
        place.bottom = below->second.top - 0.6F * ImGui::GetFontSize();
    if (draw_progress(film->what, film->done, place, items_, "film-progress")) films_.cancel();
}

void Application::draw_dialogs() {
    draw_progress_bars();
    if (auto wish = file_dialogs_.take_wish()) files_.list(std::move(*wish));
    help_.draw(actions_, theme_, items_);
    about_.draw(theme_, items_);
    if (messages_.error().open()) // two dialogs at once would close each other
        messages_.error().draw(items_);
    else if (const auto answer = file_dialogs_.draw(settings_, items_))
        take_answer(*answer);
    if (!file_dialogs_.open()) to_film_.reset(); // of a dialog that was cancelled
}

} // namespace gaspard
