#include "gui/app/application.hpp"

#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/run_files.hpp"
#include "core/io/svg.hpp"
#include "core/scenario/toml.hpp"
#include "gui/document/runs_csv.hpp"
#include "gui/panels/status_bar.hpp"

#include <algorithm>
#include <imgui.h>
#include <imgui_internal.h> // ClosePopupToLevel
#include <utility>

namespace gaspard {

namespace {

bool needs_solver(ActionId id) {
    using enum ActionId;
    for (const ActionId one : {run_pause, step, reset, export_files, cancel, keep, quadratic})
        if (id == one) return true;
    return false;
}

constexpr ImGuiPopupFlags any_popup = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
constexpr double projector_size = 1.7, text_step = 1.1;
constexpr double usual_spin = 12; // degrees per second

} // namespace

Application::Application(std::shared_ptr<const Catalogue> catalogue, ApplicationOptions options)
    : catalogue_(catalogue), output_(std::move(options.output)), settings_(std::move(options.settings)),
      board_(std::make_shared<NoticeBoard>(options.wake)), theme_(dark_theme()), writer_(board_),
      document_(std::move(catalogue), std::move(options.wake),
                [cache = tessellations_](const Snapshot& snapshot) { cache->get(snapshot); }) {
    if (const auto choice = parse_choice(settings_.window.text("first_plot"))) plot_pane_.choose(0, *choice);
    if (const auto choice = parse_choice(settings_.window.text("second_plot"))) plot_pane_.choose(1, *choice);
    for (std::string& complaint : options.complaints) log_.add({std::move(complaint), true});
}

Application::Application(std::shared_ptr<const Catalogue> catalogue, const Scenario& scenario,
                         ApplicationOptions options)
    : Application(std::move(catalogue), std::move(options)) {
    document_.open(scenario);
    follow_theme();
}

Application::Application(std::shared_ptr<const Catalogue> catalogue, const FinishedRun& finished,
                         ApplicationOptions options)
    : Application(std::move(catalogue), std::move(options)) {
    document_.show(finished);
    follow_theme();
}

/// Into the log and the status line; what went wrong comes up as well.
void Application::say(Notice notice) {
    log_.add(notice);
    if (notice.error) error_.show(notice.text);
    message_ = std::move(notice);
}

bool Application::collect() {
    bool news = document_.collect();
    for (Notice& notice : board_->take()) say(std::move(notice)), news = true;
    take_messages();
    if (run().openings != openings_seen_) take_opening();
    note_what_is_missing();
    const std::string note = closing_note(run());
    if (note != closing_note_ && !note.empty()) log_.add({note, false});
    closing_note_ = note;
    std::optional<Arrivals::Arrival> arrival;
    {
        std::lock_guard lock(arrivals_->mutex);
        arrival = std::exchange(arrivals_->newest, std::nullopt);
    }
    if (arrival) {
        open_scenario(arrival->scenario);
        opening_file_ = arrival->file;
        news = true;
    }
    return news;
}

/// Those of the first run are for the user at once; those of other runs can be read in the log. What is
/// refused while a handle is dragged is for the status line alone: a dialog would take the handle out of the
/// hand.
void Application::take_messages() {
    for (DocumentRun& one : document_.runs())
        for (RunMessage& message : std::exchange(one.messages, {})) {
            if (&one != &run())
                log_.add({one.name + ": " + message.text, message.error});
            else if (message.by_hand && run().solver->status().run != RunStatus::failed)
                message_ = {std::move(message.text), message.error};
            else
                say({std::move(message.text), message.error});
        }
}

/// Said once for each mesh.
void Application::note_what_is_missing() {
    if (!run().snapshot || run().snapshot->mesh == looked_for_missing_) return;
    looked_for_missing_ = run().snapshot->mesh;
    const std::string note = missing_note(viewport().view, *run().snapshot);
    if (!note.empty()) say({note, false});
}

/// Whether a field that is being written in wants a key for itself.
static bool belongs_to_text(std::string_view key) {
    const bool function_key = key.size() > 1 && key[0] == 'F';
    const bool command =
        key.starts_with("Ctrl+") && std::string_view("ACVXYZ").find(key.back()) == std::string_view::npos;
    return !function_key && !command;
}

bool Application::press_key(std::string_view key) {
    const Action* row = action_for_key(key);
    if (!row) return false;
    const bool dialog = error_.open() || open_dialog_.open(); // it comes first
    if (dialog && row->id != ActionId::cancel && row->id != ActionId::quit) return false;
    if (ImGui::GetIO().WantTextInput && !dialog && belongs_to_text(key)) return false;
    if (!possible(row->id)) {
        if (const std::string why = obstacle(row->id); !why.empty()) say({why, false});
        return false;
    }
    perform(row->id);
    return true;
}

bool Application::working() {
    return !run().status.activity.empty() || run().status.run == RunStatus::preparing;
}

bool Application::possible(ActionId id) {
    switch (id) {
    case ActionId::cancel:
        return ImGui::IsPopupOpen("", any_popup) || error_.open() || open_dialog_.open() || help_ ||
               working() || document_.comparing() || comparison_panel_.open() ||
               !viewport().view.text("pick").empty();
    case ActionId::front:
    case ActionId::back:
    case ActionId::left:
    case ActionId::right:
    case ActionId::top:
    case ActionId::bottom:
        return run().snapshot && run().snapshot->mesh->space_dimension == 3;
    case ActionId::copy_camera:
        return !viewport_pane_.views().empty();
    case ActionId::spin:
        return run().snapshot && run().snapshot->mesh->space_dimension == 3 && !checked(ActionId::map);
    case ActionId::front_and_rear:
        return available("layout=front-and-rear");
    case ActionId::runs:
        return document_.runs().size() > 1;
    case ActionId::compare:
        return run().live();
    case ActionId::map:
        return available("layout=map");
    case ActionId::overlay:
        return available("overlay=exact");
    case ActionId::quadratic:
        return has_linear_cells(run());
    default:
        break;
    }
    if (id == ActionId::step) return !run().ended();
    return id != ActionId::keep || !run().history.empty();
}

/// Why an action that looks as if it did something does nothing here; empty where that is plain to see.
std::string Application::obstacle(ActionId id) {
    if (!run().snapshot) return {};
    const std::string name(action(id).label);
    switch (id) {
    case ActionId::front:
    case ActionId::back:
    case ActionId::left:
    case ActionId::right:
    case ActionId::top:
    case ActionId::bottom:
    case ActionId::front_and_rear:
        return name + " is for meshes in space; this one lies in the plane.";
    case ActionId::runs:
        return name + ": there is only one; K keeps this run, C compares methods.";
    case ActionId::map:
        return name + " is for meshes on a sphere.";
    case ActionId::spin:
        return name + (checked(ActionId::map) ? " is for a globe; M leads back from the map to it."
                                              : " is for meshes in space; this one lies in the plane.");
    case ActionId::overlay:
        return name +
               " is for monitors on a sphere that have an axis; the exact mesh of this one is not known.";
    case ActionId::quadratic:
        return name + ": only linear cells on a sphere can become quadratic; these are not.";
    case ActionId::step:
        return "The run has ended; " + describe_keys(action(ActionId::run_pause)) + " begins it again.";
    default:
        return {};
    }
}

void Application::perform(ActionId id) {
    if (!run().live() && needs_solver(id)) return; // a run to be looked at
    message_ = {};
    switch (id) {
    case ActionId::run_pause:
        return toggle_running();
    case ActionId::step:
        return document_.step(0);
    case ActionId::reset:
        return document_.reset(0);
    case ActionId::keep:
        return keep();
    case ActionId::cancel:
        return cancel();
    case ActionId::home:
        return look_from(run().opened.view.text("direction"));
    case ActionId::front:
    case ActionId::back:
    case ActionId::left:
    case ActionId::right:
    case ActionId::top:
    case ActionId::bottom:
        return look_from(std::string(action(id).name));
    case ActionId::compare:
        if (comparison_panel_.open())
            comparison_panel_.close();
        else
            comparison_panel_.show();
        return;
    case ActionId::side_by_side:
    case ActionId::runs:
    case ActionId::front_and_rear:
    case ActionId::map:
        viewport().view.set("layout", std::string(checked(id) ? "single" : action(id).name));
        return;
    case ActionId::spin:
        viewport().view.set("spin", checked(id) ? 0.0 : usual_spin);
        return;
    case ActionId::overlay:
        viewport().view.set("overlay", std::string(checked(id) ? "none" : "exact"));
        return;
    case ActionId::quadratic:
        return use_quadratic_cells();
    case ActionId::lines:
        return toggle_view("lines");
    case ActionId::arrows:
        return toggle_view("arrows");
    case ActionId::copy_camera:
        return copy_camera();
    case ActionId::paste_camera:
        return paste_camera();
    case ActionId::theme:
        viewport().view.set("theme", std::string(viewed_theme() == "dark" ? "light" : "dark"));
        return follow_theme();
    case ActionId::sidebar:
        return toggle("sidebar");
    case ActionId::plots:
        return toggle("plots");
    case ActionId::log:
        return toggle("log");
    case ActionId::larger:
        return set_text_size(settings_.window.real("text_size") * text_step);
    case ActionId::smaller:
        return set_text_size(settings_.window.real("text_size") / text_step);
    case ActionId::projector:
        return set_text_size(checked(ActionId::projector) ? 1 : projector_size);
    case ActionId::fullscreen:
        fullscreen_ = !fullscreen_;
        return;
    case ActionId::open:
        return open_dialog_.show();
    case ActionId::save_scenario:
        return save_scenario();
    case ActionId::screenshot:
        screenshot_ = true;
        return;
    case ActionId::export_files:
        return export_files();
    case ActionId::help:
        help_ = !help_;
        return;
    case ActionId::quit:
        quit_ = true;
        return;
    }
}

bool Application::checked(ActionId id) const {
    const Values& view = document_.viewports().front().view;
    switch (id) {
    case ActionId::compare:
        return comparison_panel_.open();
    case ActionId::side_by_side:
    case ActionId::runs:
    case ActionId::front_and_rear:
    case ActionId::map:
        return view.text("layout") == action(id).name;
    case ActionId::spin:
        return view.real("spin") != 0;
    case ActionId::overlay:
        return view.text("overlay") == "exact";
    case ActionId::lines:
        return view.boolean("lines");
    case ActionId::arrows:
        return view.boolean("arrows");
    case ActionId::sidebar:
        return settings_.window.boolean("sidebar");
    case ActionId::plots:
        return settings_.window.boolean("plots");
    case ActionId::log:
        return settings_.window.boolean("log");
    case ActionId::projector:
        return settings_.window.real("text_size") >= projector_size;
    case ActionId::fullscreen:
        return fullscreen_;
    default:
        return false;
    }
}

bool Application::available(const std::string& choice) const {
    const auto missing = viewport_pane_.unavailable();
    return !viewport_pane_.views().empty() &&
           std::find(missing.begin(), missing.end(), choice) == missing.end();
}

/// From the beginning: what linear cells leave when they fail is seldom a map to go on from.
void Application::use_quadratic_cells() {
    Scenario scenario = run().scenario;
    const auto remedy = find_remedy(scenario.domain.values);
    if (!remedy) return;
    scenario.domain.values.set(remedy->key, remedy->value);
    viewport().view.set("pick", std::string());
    document_.change(0, scenario);
    document_.reset(0);
    message_ = {};
    run().solver->post(StartCommand{});
    run().wants_to_run = true;
}

void Application::toggle_running() {
    if (run().solving())
        document_.pause(0);
    else
        document_.start(0);
}

void Application::toggle(const char* setting) {
    settings_.window.set(setting, !settings_.window.boolean(setting));
}

void Application::toggle_view(const char* key) { viewport().view.set(key, !viewport().view.boolean(key)); }

void Application::look_from(const std::string& direction) {
    viewport().view.set("direction", direction);
    viewport_pane_.go_home(viewport());
}

void Application::copy_camera() {
    const std::string text = viewport_pane_.camera_text();
    ImGui::SetClipboardText(text.c_str());
    message_ = {"Copied: " + text, false};
}

void Application::paste_camera() {
    const char* text = ImGui::GetClipboardText();
    try {
        parse_camera(text ? text : "", {});
        viewport_pane_.look_as(viewport(), text);
    } catch (const InputError& error) {
        say({error.what(), true});
    }
}

/// The window looks as its viewport's view says.
void Application::follow_theme() {
    settings_.window.set("theme", viewed_theme());
    theme_ = theme_named(viewed_theme());
}

void Application::set_text_size(double size) {
    settings_.window.set("text_size", within(settings_.window, "text_size", size));
}

/// What lies on top goes first.
void Application::cancel() {
    if (ImGui::IsPopupOpen("", any_popup) && !error_.open() && !open_dialog_.open())
        ImGui::ClosePopupToLevel(0, true); // a menu or a list
    else if (error_.open())
        error_.close();
    else if (open_dialog_.open())
        open_dialog_.close();
    else if (help_)
        help_ = false;
    else if (document_.comparing())
        document_.cancel_comparison();
    else if (working())
        run().solver->cancel();
    else if (comparison_panel_.open())
        comparison_panel_.close();
    else
        viewport().view.set("pick", std::string());
}

std::filesystem::path Application::output_folder() { return output_ / run().scenario.name; }

/// At least one format stays.
void Application::toggle_format(const std::string& name) {
    std::string names;
    for (const Format& format : formats()) {
        const bool chosen = exports(run().scenario, format.name) != (format.name == name);
        if (chosen) names += (names.empty() ? "" : ",") + format.name;
    }
    if (names.empty()) return;
    Scenario scenario = run().scenario;
    scenario.output.set("formats", names);
    document_.change(0, scenario);
}

void Application::export_files() {
    // The files are coloured as the viewport is.
    Scenario scenario = run().scenario;
    scenario.view = viewport().view;
    if (scenario != run().scenario) document_.change(0, scenario);
    // The board is shared, for the task may come to its turn when the window is already closing.
    run().solver->post(InspectCommand{
        [board = board_, folder = output_folder(), catalogue = catalogue_,
         names = run().scenario.output.text("formats")](Run& solved, const Activity& activity) {
            report_outcome(*board, [&] {
                Scenario chosen = solved.scenario();
                chosen.output.set("formats", names);
                const auto formats = formats_of(*catalogue, chosen);
                check_writable(folder);
                write_run_files(folder, solved, formats, activity.progress, activity.stop);
                return "Exported to " + folder.string();
            });
        }});
    message_ = {"Exporting ...", false};
}

void Application::save_image(Image image) { writer_.write_image(output_folder(), "view", std::move(image)); }

Settings Application::settings() {
    Settings settings = settings_;
    settings.window.set("camera", viewport().view.text("camera"));
    settings.window.set("camera_scenario", run().scenario.name);
    return settings;
}

void Application::keep() {
    if (const auto kept = document_.keep(0)) say({"Kept as " + document_.runs()[*kept].name, false});
}

void Application::fulfil(const PlotWish& wish) {
    switch (wish.kind) {
    case PlotWish::Kind::copy_csv:
        ImGui::SetClipboardText(runs_csv(document_.runs()).c_str());
        return say({"Copied the numbers of all runs that are shown", false});
    case PlotWish::Kind::save_png:
        plot_picture_ = plot_of_runs(document_.runs(), wish.choice, wish.zoom);
        plot_name_ = wish.choice.plot;
        return;
    case PlotWish::Kind::save_svg:
        return writer_.run([folder = output_folder(), name = wish.choice.plot,
                            plot = plot_of_runs(document_.runs(), wish.choice, wish.zoom)] {
            check_writable(folder);
            const auto file = free_name(folder, name, ".svg");
            write_svg(file, plot);
            return "Saved " + file.string();
        });
    }
}

void Application::draw_comparison() {
    using Wish = ComparisonPanel::Wish;
    switch (comparison_panel_.draw(document_, *catalogue_, theme_, items_)) {
    case Wish::none:
        return;
    case Wish::begin:
        return document_.compare(comparison_panel_.chosen(document_, *catalogue_));
    case Wish::cancel:
        return document_.cancel_comparison();
    case Wish::copy:
        ImGui::SetClipboardText(comparison_csv(document_.comparison_rows()).c_str());
        return say({"Copied the table of methods", false});
    case Wish::meshes:
        return perform(ActionId::runs);
    }
}

void Application::save_plot(const std::function<Image(const Plot&)>& draw) {
    const auto plot = std::exchange(plot_picture_, std::nullopt);
    if (!plot) return;
    try {
        writer_.write_image(output_folder(), plot_name_, draw(*plot));
    } catch (const MachineError& error) {
        say({error.what(), true});
    }
}

void Application::save_scenario() {
    Scenario scenario = run().scenario;
    scenario.view = viewport().view;
    writer_.run([folder = output_folder(), name = scenario.name, text = to_toml(scenario)] {
        check_writable(folder);
        const auto file = free_name(folder, name, ".toml");
        write_atomically(file, text);
        return "Saved " + file.string();
    });
}

void Application::open_file(const std::filesystem::path& file) {
    const auto absolute = std::filesystem::absolute(file);
    writer_.run([catalogue = catalogue_, arrivals = arrivals_, absolute] {
        if (absolute.extension() != ".toml")
            throw InputError(absolute.string() + " is no scenario: its name does not end in .toml");
        Scenario scenario = load_scenario(*catalogue, absolute);
        check(*catalogue, scenario);
        check_view(scenario.view);
        std::lock_guard lock(arrivals->mutex);
        arrivals->newest = {std::move(scenario), absolute};
        return "Opening " + absolute.string();
    });
}

void Application::open_scenario(const Scenario& scenario) {
    opening_file_.clear();
    document_.replace(0, scenario);
}

/// A scenario has been found good and is there.
void Application::take_opening() {
    openings_seen_ = run().openings;
    if (is_default(viewport().view, "theme")) // it has no wish of its own
        viewport().view.set("theme", theme_name());
    follow_theme();
    viewport_pane_.forget_home();
    if (opening_file_.empty()) return;
    remember_recent(settings_, opening_file_);
    say({"Opened " + opening_file_.string(), false});
}

void Application::open_builtin(const std::string& name) {
    open_scenario(for_window(*catalogue_, find_scenario(*catalogue_, name)));
    message_ = {};
}

std::string Application::label_of(const Action& row) {
    if (row.id != ActionId::run_pause) return std::string(row.label);
    return run().solving() ? "Pause" : run().ended() ? "Run again" : std::string(row.label);
}

} // namespace gaspard
