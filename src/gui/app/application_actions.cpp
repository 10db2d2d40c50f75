// The table of actions: one row for each, with its keys, texts and what it does.
#include "core/scenario/data_files.hpp"
#include "core/scenario/view_directions.hpp"
#include "gui/app/application.hpp"
#include "gui/panels/status_bar.hpp"

#include <iterator>
#include <utility>

namespace gaspard {

namespace {

constexpr double projector_size = 1.7, text_step = 1.1;
constexpr double usual_spin = 12; // degrees per second

/// Why an action does nothing with a planar mesh.
std::string only_in_space(std::string_view label) {
    return std::string(label) + ": only for meshes in space; this mesh is planar.";
}

/// Why an action does nothing with an interval.
std::string not_for_plots(std::string_view label) {
    return std::string(label) + ": an interval is shown as plots.";
}

std::string only_for_solids(std::string_view label) {
    return std::string(label) + ": only for meshes of solid cells.";
}

void append(std::vector<Action>& rows, std::vector<Action> more) {
    std::move(more.begin(), more.end(), std::back_inserter(rows));
}

} // namespace

std::vector<Action> Application::make_actions() {
    std::vector<Action> rows;
    append(rows, edit_actions());
    append(rows, solve_actions());
    append(rows, camera_actions());
    append(rows, layout_actions());
    append(rows, show_actions());
    append(rows, window_actions());
    append(rows, file_actions());
    return rows;
}

std::vector<Action> Application::edit_actions() {
    return {
        {.name = "undo",
         .label = "Undo",
         .menu = "Edit",
         .keys = {"Ctrl+Z"},
         .toolbar = 1,
         .icon = Icon::undo,
         .help = "Undo the last change of parameters, view or kept runs.",
         .run = [this] { move_in_history(false); },
         .enabled = [this] { return document_.edits().can_undo(); },
         .reason = [] { return "There is nothing to undo."; },
         .state_label =
             [this] {
                 const EditHistory& edits = document_.edits();
                 return edits.can_undo() ? "Undo " + edits.undo_label() : std::string("Undo");
             }},
        {.name = "redo",
         .label = "Redo",
         .menu = "Edit",
         .keys = {"Ctrl+Shift+Z", "Ctrl+Y"},
         .toolbar = 1,
         .icon = Icon::redo,
         .help = "Redo the last change that was undone.",
         .run = [this] { move_in_history(true); },
         .enabled = [this] { return document_.edits().can_redo(); },
         .reason = [] { return "There is nothing to redo."; },
         .state_label =
             [this] {
                 const EditHistory& edits = document_.edits();
                 return edits.can_redo() ? "Redo " + edits.redo_label() : std::string("Redo");
             }},
        {.name = "as-formula",
         .label = "Edit as formula",
         .menu = "Edit",
         .keys = {"Ctrl+E"},
         .help = "Turn the monitor into a formula with the same values, to change it.",
         .needs_solver = true,
         .run = [this] { edit_as_formula(); },
         .enabled = [this] { return has_formula(); },
         .reason =
             [this] {
                 return run().scenario.monitor.type == "formula"
                            ? "Edit as formula: the monitor is a formula already."
                            : "Edit as formula: this monitor cannot be written as a formula.";
             }},
    };
}

std::vector<Action> Application::solve_actions() {
    return {
        {.name = "run",
         .label = "Run",
         .menu = "Solve",
         .keys = {"Space"},
         .help = "Start or pause the solver; replay a solve that has ended, or that is looked at again.",
         .needs_solver = true,
         .run = [this] { run_or_pause(); },
         .state_label =
             [this] {
                 if (playback_.playing() || (playback_.live() && run().solving())) return "Pause";
                 return playback_.live() && !run().ended() ? "Run" : "Replay";
             }},
        {.name = "step",
         .label = "Step",
         .menu = "Solve",
         .keys = {"N", "Right"},
         .help = "Show the next iterate; at the newest one, do one iteration, then pause.",
         .needs_solver = true,
         .run = [this] { step_forward(); },
         .enabled = [this] { return !playback_.live() || !run().ended(); },
         .reason =
             [this] {
                 return "The run has ended; press " + describe_keys(action("run-again")) +
                        " to run it again.";
             }},
        {.name = "step-back",
         .label = "Step back",
         .menu = "Solve",
         .keys = {"Left"},
         .help = "Show the iterate before this one.",
         .run = [this] { playback_.go_back(longest()); },
         .enabled = [this] { return playback_.iteration(longest()) > 0; },
         .reason = [] { return "This is the start."; }},
        {.name = "to-start",
         .label = "To the start",
         .menu = "Solve",
         .keys = {"Home"},
         .help = "Show the start of the solve.",
         .run = [this] { playback_.go_to_start(longest()); },
         .enabled = [this] { return playback_.iteration(longest()) > 0; },
         .reason = [] { return "This is the start."; }},
        {.name = "to-end",
         .label = "To the end",
         .menu = "Solve",
         .keys = {"End"},
         .help = "Show the newest iterate.",
         .run = [this] { playback_.go_to_end(); },
         .enabled = [this] { return !playback_.live(); },
         .reason = [] { return "This is the newest iterate."; }},
        {.name = "first-tangled",
         .label = "First tangled iteration",
         .menu = "Solve",
         .keys = {"G"},
         .help = "Show the first iterate with tangled cells.",
         .run = [this] { go_to_tangled(); },
         .enabled = [this] { return first_tangled().has_value(); },
         .reason = [] { return "First tangled iteration: no mesh of this solve is tangled."; }},
        {.name = "go-on",
         .label = "Go on from here",
         .menu = "Solve",
         .keys = {"Ctrl+G"},
         .help = "Keep this run, and go back to the recorded iterate or time that is shown, to solve on from "
                 "there.",
         .needs_solver = true,
         .run = [this] { go_on(); },
         .enabled = [this] { return !playback_.live() && run().recording != nullptr; },
         .reason = [] { return "Go on from here: go back to an iterate or a time first."; }},
        {.name = "draw-path",
         .label = "Draw a path",
         .menu = "Solve",
         .keys = {"Ctrl+M"},
         .help = "Drag the centre of the monitor: its path and speed are recorded, and the mesh follows.",
         .needs_solver = true,
         .run = [this] { path_.armed() ? leave_path() : begin_path(); },
         .enabled = [this] { return !monitor_handles(run().scenario, true).empty(); },
         .checked = [this] { return path_.armed(); },
         .reason = [] { return "Draw a path: this monitor has no centre that could move."; }},
        {.name = "loop",
         .label = "Loop",
         .menu = "Solve",
         .keys = {"Ctrl+L"},
         .help = "Begin the replay again at its end.",
         .run = [this] { playback_.set_loops(!playback_.loops()); },
         .checked = [this] { return playback_.loops(); }},
        {.name = "blend-loop",
         .label = "Blend back and forth",
         .menu = "View",
         .keys = {"O"},
         .help = "Move the picture back and forth between the computational and the physical mesh.",
         .run = [this] { playback_.set_blends(!playback_.blends()); },
         .checked = [this] { return playback_.blends(); }},
        {.name = "reset",
         .label = "Reset",
         .menu = "Solve",
         .keys = {"R"},
         .help = "Move every node back to its start position, and pause.",
         .needs_solver = true,
         .run = [this] { document_.reset(run().id); }},
        {.name = "run-again",
         .label = "Run again",
         .menu = "Solve",
         .keys = {"Ctrl+R"},
         .help = "Solve again from the start.",
         .needs_solver = true,
         .run =
             [this] {
                 document_.reset(run().id);
                 document_.start(run().id);
             }},
        {.name = "keep",
         .label = "Keep",
         .menu = "Solve",
         .keys = {"K"},
         .help = "Keep the curves and the mesh of this run for comparison with later runs.",
         .needs_solver = true,
         .run = [this] { keep(); },
         .enabled = [this] { return !run().history.empty(); }},
        {.name = "compare",
         .label = "Compare methods",
         .menu = "Solve",
         .keys = {"C"},
         .help = "Select methods, solve this problem with each, and compare curves, meshes and numbers.",
         .run = [this] { comparison_panel_.open() ? comparison_panel_.close() : comparison_panel_.show(); },
         .enabled = [this] { return run().live(); },
         .checked = [this] { return comparison_panel_.open(); }},
        {.name = "quadratic",
         .label = "Use quadratic cells",
         .menu = "Solve",
         .keys = {"Q"},
         .help = "Restart with quadratic cells, which on a sphere follow monitors that tangle linear cells.",
         .needs_solver = true,
         .run = [this] { use_quadratic_cells(); },
         .enabled = [this] { return has_linear_cells(run()); },
         .reason = [] { return "Use quadratic cells: only for linear cells on a sphere."; }},
        {.name = "cancel",
         .label = "Cancel",
         .menu = "Solve",
         .keys = {"Escape"},
         .help = "Close the topmost menu, dialog or panel, or cancel work in progress.",
         .needs_solver = true,
         .run = [this] { cancel(); },
         .enabled = [this] { return can_cancel(); }},
    };
}

std::vector<Action> Application::camera_actions() {
    const auto directions = view_directions();
    std::vector<Action> rows = {
        {.name = "home",
         .label = "Home",
         .menu = "View",
         .keys = {"H"},
         .toolbar = 2,
         .icon = Icon::home,
         .help = directions.front().help,
         .run = [this] { look_from(run().opened.view.text("direction")); }},
    };
    constexpr std::string_view digits = "123456789";
    for (std::size_t i = 1; i < directions.size(); ++i)
        rows.push_back({.name = directions[i].name,
                        .label = directions[i].label,
                        .menu = "View",
                        .keys = {digits.substr(i - 1, 1)},
                        .help = directions[i].help,
                        .run = [this, name = std::string(directions[i].name)] { look_from(name); },
                        .enabled = [this] { return in_space(); },
                        .reason = [label = directions[i].label] { return only_in_space(label); }});
    return rows;
}

/// An action that switches between a layout, of the same name, and a single view.
Action Application::layout_action(std::string_view name, std::string_view label, std::string_view key,
                                  std::string_view help) {
    return {.name = name,
            .label = label,
            .menu = "View",
            .keys = {key},
            .help = help,
            .run =
                [this, name] {
                    const bool shown = viewport().view.text("layout") == name;
                    viewport().view.set("layout", std::string(shown ? "single" : name));
                },
            .checked = [this, name] { return viewport().view.text("layout") == name; }};
}

std::vector<Action> Application::layout_actions() {
    std::vector<Action> rows = {
        layout_action("side-by-side", "Side by side", "B",
                      "Show the computational and the physical mesh side by side, or only one."),
        layout_action("field-and-mesh", "Field and mesh", "Ctrl+B",
                      "Show the colours and the mesh without them beside each other, or only one picture."),
        layout_action("runs", "Meshes of all runs", "V",
                      "Show the meshes of all runs side by side, or only the current one."),
        layout_action("front-and-rear", "Front and rear", "F",
                      "Show a mesh in space from both sides, or only from one."),
        layout_action("projection", "Projection", "M",
                      "Show the sphere as an equal-area projection, or as a globe.")};
    Action &runs = rows[2], &rear = rows[3], &projection = rows[4];
    runs.enabled = [this] { return action("runs").is_checked() || !runs_beside().empty(); };
    runs.reason = [this]() -> std::string {
        if (document_.runs().size() > 1)
            return "Meshes of all runs: the other runs are hidden, or their meshes are on another domain.";
        return "Meshes of all runs: there is only one; press " + describe_keys(action("keep")) +
               " to keep this run or " + describe_keys(action("compare")) + " to compare methods.";
    };
    rear.enabled = [this] { return available("layout=front-and-rear"); };
    rear.reason = [] { return only_in_space("Front and rear"); };
    projection.enabled = [this] { return available("layout=projection"); };
    projection.reason = [] { return "Projection: only for meshes on a sphere."; };
    return rows;
}

/// An action that switches a setting of the view.
Action Application::view_toggle(std::string_view key, std::string_view label, std::string_view shortcut,
                                std::string_view help) {
    return {.name = key,
            .label = label,
            .menu = "View",
            .keys = {shortcut},
            .help = help,
            .run = [this, key] { viewport().view.set(key, !viewport().view.boolean(key)); },
            .checked = [this, key] { return viewport().view.boolean(key); }};
}

std::vector<Action> Application::show_actions() {
    Action arrows = view_toggle("arrows", "Arrows", "A", "Show or hide arrows from ξ to x.");
    arrows.enabled = [this] { return !on_interval(); };
    arrows.reason = [] { return not_for_plots("Arrows"); };
    Action axes = view_toggle("axes", "Axes", "D", "Show or hide the axes of a mesh in the plane.");
    axes.enabled = [this] { return !on_interval() && !in_space(); };
    axes.reason = [this] {
        return on_interval() ? not_for_plots("Axes") : "Axes: only for meshes in the plane.";
    };
    return {
        {.name = "spin",
         .label = "Spin",
         .menu = "View",
         .keys = {"S"},
         .help = "Start or stop rotating a mesh in space.",
         .run = [this] { viewport().view.set("spin", viewport().view.real("spin") != 0 ? 0.0 : usual_spin); },
         .enabled = [this] { return in_space() && !action("projection").is_checked(); },
         .checked = [this] { return viewport().view.real("spin") != 0; },
         .reason =
             [this] {
                 return action("projection").is_checked()
                            ? "Spin: only for a globe; press " + describe_keys(action("projection")) +
                                  " to show a globe."
                            : only_in_space("Spin");
             }},
        {.name = "exact",
         .label = "Exact mesh",
         .menu = "View",
         .keys = {"X"},
         .help = "Show or hide the edges of the exact mesh, where it is known.",
         .run =
             [this] {
                 const bool shown = viewport().view.text("overlay") == "exact";
                 viewport().view.set("overlay", std::string(shown ? "none" : "exact"));
             },
         .enabled = [this] { return available("overlay=exact"); },
         .checked = [this] { return viewport().view.text("overlay") == "exact"; },
         .reason =
             [] { return "Exact mesh: known only on a sphere, for monitors symmetric about an axis."; }},
        {.name = "cut",
         .label = "Cut open",
         .menu = "View",
         .keys = {"I"},
         .help = "Cut a solid open with a plane that can be dragged and turned, or close it.",
         .run = [this] { toggle_cut(); },
         .enabled = [this] { return shows_solid(); },
         .checked = [this] { return !viewport().view.text("cut").empty(); },
         .reason = [] { return only_for_solids("Cut open"); }},
        {.name = "flip-cut",
         .label = "Flip the cut",
         .menu = "View",
         .keys = {"J"},
         .help = "Turn every plane of a cut round, so that it hides its other side.",
         .run = [this] { flip_cut(); },
         .enabled = [this] { return shows_solid() && !viewport().view.text("cut").empty(); },
         .reason =
             [this] {
                 return shows_solid()
                            ? "Flip the cut: press " + describe_keys(action("cut")) + " to cut first."
                            : only_for_solids("Flip the cut");
             }},
        view_toggle("lines", "Lines", "L", "Show or hide the cell edges, or the nodes of an interval."),
        std::move(axes),
        std::move(arrows),
        {.name = "copy-camera",
         .label = "Copy camera",
         .menu = "View",
         .keys = {"Ctrl+C"},
         .help = "Copy the camera to the clipboard, as text for view.camera.",
         .run = [this] { copy_camera(); },
         .enabled = [this] { return !views().empty(); },
         .reason =
             [this] {
                 return on_interval() ? not_for_plots("Copy camera")
                                      : std::string("Copy camera: there is no mesh yet.");
             }},
        {.name = "paste-camera",
         .label = "Paste camera",
         .menu = "View",
         .keys = {"Ctrl+V"},
         .help = "Apply the camera from the clipboard.",
         .run = [this] { paste_camera(); },
         .enabled = [this] { return !on_interval(); },
         .reason = [] { return not_for_plots("Paste camera"); }},
    };
}

/// An action that shows or hides a part of the window, which a setting of the same name remembers.
Action Application::part_toggle(std::string_view setting, std::string_view label, std::string_view key,
                                std::string_view help) {
    return {.name = setting,
            .label = label,
            .menu = "View",
            .keys = {key},
            .help = help,
            .run = [this, setting] { settings_.window.set(setting, !settings_.window.boolean(setting)); },
            .checked = [this, setting] { return settings_.window.boolean(setting); }};
}

std::vector<Action> Application::window_actions() {
    const auto large = [this] { return settings_.window.real("text_size") >= projector_size; };
    return {
        {.name = "theme",
         .label = "Theme",
         .menu = "View",
         .keys = {"T"},
         .help = "Switch between the dark and the light theme.",
         .run =
             [this] {
                 viewport().view.set("theme", std::string(viewed_theme() == "dark" ? "light" : "dark"));
                 follow_theme();
             }},
        part_toggle("sidebar", "Parameters", "F2", "Show or hide the parameter panel."),
        part_toggle("plots", "Plots", "F3", "Show or hide the plots."),
        part_toggle("log", "Message log", "F4", "Show or hide the message log."),
        {.name = "larger",
         .label = "Larger text",
         .menu = "View",
         .keys = {"Ctrl+=", "Ctrl++"},
         .help = "Increase the size of texts, lines and controls.",
         .run = [this] { set_text_size(settings_.window.real("text_size") * text_step); }},
        {.name = "smaller",
         .label = "Smaller text",
         .menu = "View",
         .keys = {"Ctrl+-"},
         .help = "Decrease the size of texts, lines and controls.",
         .run = [this] { set_text_size(settings_.window.real("text_size") / text_step); }},
        {.name = "projector",
         .label = "Projector size",
         .menu = "View",
         .keys = {"F10"},
         .help = "Switch between a size for projectors, without the parameter panel, and the normal size.",
         .run =
             [this, large] {
                 if (!large()) sidebar_before_ = settings_.window.boolean("sidebar");
                 settings_.window.set("sidebar", large() && sidebar_before_);
                 set_text_size(large() ? 1 : projector_size);
             },
         .checked = large},
        {.name = "fullscreen",
         .label = "Full screen",
         .menu = "View",
         .keys = {"F11"},
         .help = "Toggle full screen.",
         .run = [this] { fullscreen_ = !fullscreen_; },
         .checked = [this] { return fullscreen_; }},
    };
}

std::vector<Action> Application::file_actions() {
    return {
        {.name = "open",
         .label = "Open ...",
         .menu = "File",
         .keys = {"Ctrl+O"},
         .help = "Open a scenario, or use an image, a field, a spline patch or a state in this one.",
         .run = [this] { file_dialogs_.ask_what_to_open(settings_); }},
        {.name = "reload",
         .label = "Reload data",
         .menu = "File",
         .keys = {"F5"},
         .help = "Read the files of the scenario again, which may have changed.",
         .needs_solver = true,
         .run = [this] { reload_data(); },
         .enabled = [this] { return has_data_files(run().scenario); },
         .reason = [] { return "Reload data: the scenario refers to no file."; }},
        {.name = "save",
         .label = "Save scenario",
         .menu = "File",
         .keys = {"Ctrl+S"},
         .help = "Save the current parameters as a new scenario file, or to the one chosen with Save as.",
         .run = [this] { save_scenario(); }},
        {.name = "save-as",
         .label = "Save scenario as ...",
         .menu = "File",
         .keys = {"Ctrl+Shift+S"},
         .help = "Save the current parameters as a file whose name and title you choose.",
         .run = [this] { ask_where_to_save(); }},
        {.name = "screenshot",
         .label = "Screenshot",
         .menu = "File",
         .keys = {"F12", "P"},
         .help = "Save an image of the view as a PNG file.",
         .run = [this] { screenshot_ = true; }},
        {.name = "figure",
         .label = "Figure ...",
         .menu = "File",
         .keys = {"Ctrl+P"},
         .toolbar = 3,
         .icon = Icon::image,
         .help = "Save the view as PNG, SVG or PDF, in the size and with the parts that you choose.",
         .run =
             [this] { file_dialogs_.ask_how_to_draw(viewport().view, files_.export_folder(run().scenario)); },
         .enabled = [this] { return run().snapshot != nullptr; },
         .reason = [] { return "Figure: there is no mesh yet."; }},
        {.name = "record-film",
         .label = "Record film ...",
         .menu = "File",
         .keys = {"Ctrl+Shift+P"},
         .help = "Make a film of the iterates or time steps that were recorded, of a turn, or of the way "
                 "from ξ to x.",
         .run = [this] { ask_how_to_film(); },
         .enabled = [this] { return run().snapshot && run().recording && !films_.busy(); },
         .reason =
             [this] {
                 return films_.busy() ? "Record film: wait for the film that is being made, or cancel it."
                                      : "Record film: no iterate was recorded.";
             }},
        {.name = "export",
         .label = "Export",
         .menu = "File",
         .keys = {"E"},
         .help =
             "Save the meshes, the history and a summary as files in a new folder, in the chosen formats.",
         .needs_solver = true,
         .run = [this] { export_files(run().scenario.output.text("formats")); }},
        {.name = "export-to",
         .label = "Export ...",
         .menu = "File",
         .keys = {"Ctrl+Shift+E"},
         .toolbar = 3,
         .icon = Icon::save,
         .help = "Choose formats and a folder, and save the meshes, the history and a summary there.",
         .needs_solver = true,
         .run = [this] { ask_what_to_export(); },
         .enabled = [this] { return run().live(); }},
        {.name = "help",
         .label = "Keys and mouse",
         .menu = "Help",
         .keys = {"F1"},
         .help = "Show what keys and mouse do.",
         .run = [this] { help_.toggle(); }},
        {.name = "about",
         .label = "About Gaspard",
         .menu = "Help",
         .keys = {"Ctrl+F1"},
         .help = "Show the version, the licence, and where the documentation is.",
         .run = [this] { about_.toggle(); }},
        {.name = "quit",
         .label = "Quit",
         .menu = "File",
         .keys = {"Ctrl+Q"},
         .help = "Close the window.",
         .run = [this] { quit_ = true; }},
    };
}

} // namespace gaspard
