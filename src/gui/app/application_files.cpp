// What the application does with files: scenarios, data, figures.
#include "core/base/error.hpp"
#include "core/base/user_path.hpp"
#include "core/scenario/data_files.hpp"
#include "core/scenario/own_names.hpp"
#include "core/scenario/toml.hpp"
#include "gui/app/application.hpp"

#include <imgui.h>
#include <limits>
#include <utility>

namespace gaspard {

Scenario Application::scenario_to_save() {
    Scenario scenario = run().scenario;
    scenario.view = viewport().view;
    saved_in_ = run().openings;
    return scenario;
}

/// To the file that was chosen for it, else to a new one.
void Application::save_scenario() {
    if (saved_as_.empty())
        files_.save_scenario(scenario_to_save());
    else
        files_.save_scenario_as(scenario_to_save(), saved_as_);
}

void Application::ask_where_to_save() {
    const Scenario& scenario = run().scenario;
    std::filesystem::path file = saved_as_;
    if (file.empty()) file = std::filesystem::absolute(scenario.folder / (scenario_stem(scenario) + ".toml"));
    file_dialogs_.ask_where_to_save(scenario, file);
}

void Application::save_as(const ScenarioToSave& choice) {
    Scenario scenario = scenario_to_save();
    if (choice.title != scenario_title(scenario)) {
        scenario = with_own_names(std::move(scenario));
        scenario.title = choice.title;
    }
    files_.save_scenario_as(scenario, choice.file, choice.packed);
}

void Application::open_file(const std::filesystem::path& file) { files_.open(file); }

void Application::take_answer(const FileAnswer& answer) {
    const auto folder = [](const std::string& file) { return std::filesystem::absolute(file).parent_path(); };
    try {
        if (const auto* opened = std::get_if<FileToOpen>(&answer)) {
            remember_folder(settings_, folder(opened->path));
            files_.open(opened->path);
        } else if (const auto* chosen = std::get_if<FileOfValue>(&answer)) {
            remember_folder(settings_, folder(chosen->path));
            take_file(*chosen);
        } else if (const auto* saved = std::get_if<ScenarioToSave>(&answer)) {
            remember_folder(settings_, folder(saved->file));
            save_as(*saved);
        } else if (const auto* exported = std::get_if<ExportDialog::Choice>(&answer)) {
            export_files(exported->formats, *exported);
        } else if (const auto* figure = std::get_if<FigureDialog::Choice>(&answer)) {
            take_figure(*figure);
        } else if (const auto* film = std::get_if<FilmDialog::Choice>(&answer)) {
            take_film(*film);
        }
    } catch (const InputError& error) {
        messages_.say({error.what(), true});
    }
}

/// Of the iterate that is shown. The view keeps what does not change the window, for the next figure and for
/// scripts.
void Application::take_figure(FigureDialog::Choice choice) {
    const auto snapshot = playback_.snapshot(run());
    if (!snapshot) return messages_.say({"There is no mesh to draw yet.", false});
    for (const char* key :
         {"width", "height", "dpi", "text_size", "background", "axes", "legend", "caption", "note"})
        viewport().view.set(key, choice.view.at(key));
    if (!on_interval()) choice.view = with_range(choice.view, replay_range());
    const auto others = shown_beside();
    const bool among_others = !others.empty();
    const int last = last_iteration(run());
    if (choice.kind != FigureKind::png) {
        if (among_others)
            messages_.say({"Drawings in vectors have the mesh of one run, the active one.", false});
        return files_.save_figure(choice, scenario_title(run().scenario), snapshot, last);
    }
    if (among_others) choice.view.set("caption", false); // each run has its title
    std::vector<NamedSnapshot> beside;
    for (const ShownRun& other : others)
        if (other.snapshot) beside.push_back({title_among_others(other), other.snapshot.get()});
    files_.draw_figure(
        choice, among_others ? title_among_others({&run(), snapshot, {}}) : scenario_title(run().scenario),
        *snapshot,
        ImageOptions{.cache = tessellations_, .last_iteration = last, .beside = std::move(beside)});
}

void Application::ask_how_to_film() {
    const auto recording = std::make_shared<const Recording>(*run().recording);
    const auto newest = recording->at(std::numeric_limits<int>::max());
    if (!newest) return messages_.say({"There is no mesh to film yet.", false});
    // The solver may be ahead of what the window shows, or have begun anew.
    const bool shown = run().snapshot->version == newest->version();
    const auto last = shown ? run().snapshot : newest->restore();
    FilmSubject subject{film_iterates(*recording), playback_.iteration(run()), last->mesh,
                        viewport_pane_.camera_text(), std::string()};
    const char* copied = ImGui::GetClipboardText();
    try {
        const std::string text = copied != nullptr ? copied : "";
        parse_camera(text, {});
        if (!text.empty() && !shows_all(text)) subject.earlier = text;
    } catch (const InputError&) { // something else was copied
    }
    to_film_ = {recording, last, run().scenario};
    file_dialogs_.ask_how_to_film(std::move(subject), viewport().view, files_.export_folder(run().scenario));
}

/// The view keeps size and parts, as those of a figure.
void Application::take_film(const FilmDialog::Choice& choice) {
    if (!to_film_) return;
    const ToFilm what = *std::exchange(to_film_, std::nullopt);
    for (const char* key : {"width", "height", "axes", "legend", "caption", "note"})
        viewport().view.set(key, choice.view.at(key));
    const auto file = std::filesystem::absolute(user_path(choice.file));
    FilmOrder order{choice.plan,   choice.format,  file,     choice.replace,
                    what.scenario, what.recording, what.last};
    order.scenario.view = choice.view;
    films_.begin(std::move(order));
}

void Application::take_file(const FileOfValue& chosen) {
    const std::string value = std::filesystem::absolute(chosen.path).lexically_normal().string();
    Scenario scenario = run().scenario;
    set_value_unlocated(*catalogue_, scenario, chosen.key, value);
    change_values(scenario);
}

void Application::take_data(const DataFile& data) {
    if (!run().live())
        return messages_.say({data.file.string() +
                                  " cannot be used: this run has ended elsewhere and cannot be "
                                  "changed",
                              true});
    if (data.state) {
        document_.start_from(run().id, data.state);
        return messages_.show({"Starting from " + data.file.string(), false});
    }
    try {
        change_values(with_file(*catalogue_, run().opened, run().scenario, data.use, data.file));
        messages_.show({"Using " + data.file.string(), false});
    } catch (const InputError& error) {
        messages_.say({error.what(), true});
    }
}

void Application::reload_data() {
    document_.reread(run().id);
    study_.forget(); // it is of the files as they were
    messages_.show({"Reading the data again", false});
}

/// One edit, whatever changes.
void Application::change_values(const Scenario& scenario) {
    document_.record_views();
    document_.end_gesture();
    if (scenario.domain != run().scenario.domain) viewport().view.set("pick", std::string());
    document_.change(run().id, scenario);
    document_.end_gesture();
}

void Application::open_scenario(const Scenario& scenario) {
    opening_file_.clear();
    document_.replace(run().id, scenario);
}

/// Called when a scenario has been opened.
void Application::take_opening() {
    openings_seen_ = run().openings;
    saved_as_.clear();
    follow_theme();
    viewport_pane_.forget_home();
    const auto file = std::exchange(opening_file_, {});
    if (file.empty()) return;
    remember_recent(settings_, file);
    messages_.say({"Opened " + file.string(), false});
}

void Application::open_builtin(const std::string& name) {
    open_scenario(for_window(*catalogue_, find_scenario(*catalogue_, name)));
    messages_.clear();
}

} // namespace gaspard
