#include "gui/actions.hpp"

#include "core/base/check.hpp"

#include <algorithm>

namespace gaspard {

std::span<const Action> actions() {
    using Id = ActionId;
    static const std::vector<Action> rows = {
        {Id::run_pause, "run", "Run", "Solve", {"Space"}, true, "Let the mesh move, or pause it."},
        {Id::step, "step", "Step", "Solve", {"N", "Right"}, true, "Do one iteration, then pause."},
        {Id::reset, "reset", "Reset", "Solve", {"R"}, true, "Put every node back to where it started."},
        {Id::keep,
         "keep",
         "Keep",
         "Solve",
         {"K"},
         false,
         "Keep the curves of this run beside those to come."},
        {Id::cancel,
         "cancel",
         "Cancel",
         "Solve",
         {"Escape"},
         false,
         "Close what has come up, or end a preparation or an export under way."},
        {Id::home, "home", "Home", "View", {"H"}, true, "Show the whole mesh again."},
        {Id::theme, "theme", "Theme", "View", {"T"}, false, "Change between dark and light."},
        {Id::sidebar, "sidebar", "Sliders", "View", {"F2"}, false, "Show or hide the sliders."},
        {Id::plots, "plots", "Plots", "View", {"F3"}, false, "Show or hide the plots."},
        {Id::log, "log", "Messages", "View", {"F4"}, false, "Show or hide what has been said so far."},
        {Id::larger, "larger", "Larger text", "View", {"Ctrl+=", "Ctrl++"}, false, "Make everything larger."},
        {Id::smaller, "smaller", "Smaller text", "View", {"Ctrl+-"}, false, "Make everything smaller."},
        {Id::projector,
         "projector",
         "Projector size",
         "View",
         {"F10"},
         false,
         "Make text and lines large enough for a projector, or usual again."},
        {Id::fullscreen, "fullscreen", "Full screen", "View", {"F11"}, false, "Fill the screen, or not."},
        {Id::open, "open", "Open ...", "File", {"Ctrl+O"}, false, "Open a scenario file."},
        {Id::save_scenario,
         "save",
         "Save scenario",
         "File",
         {"Ctrl+S"},
         false,
         "Save what the sliders say as a scenario file."},
        {Id::screenshot,
         "screenshot",
         "Screenshot",
         "File",
         {"F12", "P"},
         true,
         "Save the picture of the mesh as a PNG file."},
        {Id::export_files,
         "export",
         "Export",
         "File",
         {"E"},
         true,
         "Save the meshes, the history and a summary as files."},
        {Id::help, "help", "Keys and mouse", "Help", {"F1"}, false, "Show what keys and mouse do."},
        {Id::quit, "quit", "Quit", "File", {"Ctrl+Q"}, false, "Close the window."},
    };
    return rows;
}

const Action& action(ActionId id) {
    const auto rows = actions();
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const Action& row) { return row.id == id; });
    GASPARD_CHECK(found != rows.end());
    return *found;
}

const Action* action_for_key(std::string_view key) {
    for (const Action& row : actions())
        if (std::find(row.keys.begin(), row.keys.end(), key) != row.keys.end()) return &row;
    return nullptr;
}

std::string describe_keys(const Action& row) {
    std::string text;
    for (const auto key : row.keys) text += (text.empty() ? "" : " or ") + std::string(key);
    return text;
}

std::span<const MouseHelp> mouse_help() {
    static constexpr MouseHelp rows[] = {
        {"Drag the picture", "Pan, with the left or the middle button."},
        {"Wheel", "Zoom at the pointer."},
        {"Double-click", "Show the whole mesh again."},
        {"Drag or wheel on a plot", "Pan and zoom; Shift or Ctrl or an axis for one direction only."},
        {"Right drag on a plot", "Zoom to a rectangle; a double click shows everything again."},
        {"Ctrl+click a slider", "Type its value."},
        {"Drop a .toml file", "Open it."},
    };
    return rows;
}

std::string actions_markdown() {
    std::string text = "| key | action | what it does |\n| --- | --- | --- |\n";
    for (const Action& row : actions())
        text += "| " + describe_keys(row) + " | " + std::string(row.label) + " | " + std::string(row.help) +
                " |\n";
    for (const MouseHelp& row : mouse_help())
        text += "| " + std::string(row.what) + " | | " + std::string(row.help) + " |\n";
    return text;
}

} // namespace gaspard
