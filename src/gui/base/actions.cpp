#include "gui/base/actions.hpp"

#include "core/base/check.hpp"

#include <algorithm>

namespace gaspard {

std::span<const Action> actions() {
    using Id = ActionId;
    static const std::vector<Action> rows = {
        {Id::run_pause, "run", "Run", "Solve", {"Space"}, true, "Let the mesh move, or pause it."},
        {Id::step, "step", "Step", "Solve", {"N", "Right"}, true, "Do one iteration, then pause."},
        {Id::reset, "reset", "Reset", "Solve", {"R"}, true, "Put every node back to where it started."},
        {Id::undo,
         "undo",
         "Undo",
         "Edit",
         {"Ctrl+Z"},
         false,
         "Undo the last change of values, view or kept runs."},
        {Id::redo,
         "redo",
         "Redo",
         "Edit",
         {"Ctrl+Shift+Z", "Ctrl+Y"},
         false,
         "Apply again what was undone."},
        {Id::keep,
         "keep",
         "Keep",
         "Solve",
         {"K"},
         false,
         "Keep the curves of this run beside those to come."},
        {Id::compare,
         "compare",
         "Compare methods",
         "Solve",
         {"C"},
         false,
         "Choose methods, solve this problem with each, and see their curves, meshes and numbers together."},
        {Id::quadratic,
         "quadratic",
         "Use quadratic cells",
         "Solve",
         {"Q"},
         false,
         "Go on with curved cells, which follow strong monitors on a sphere where linear ones tangle."},
        {Id::cancel,
         "cancel",
         "Cancel",
         "Solve",
         {"Escape"},
         false,
         "Close what has come up, or end a preparation or an export under way."},
        {Id::home, "home", "Home", "View", {"H"}, true, "Show the whole mesh again."},
        {Id::front, "front", "From the front", "View", {"1"}, false, "Look at a mesh in space along y."},
        {Id::back, "back", "From the back", "View", {"2"}, false, "Look at a mesh in space against y."},
        {Id::left, "left", "From the left", "View", {"3"}, false, "Look at a mesh in space along x."},
        {Id::right, "right", "From the right", "View", {"4"}, false, "Look at a mesh in space against x."},
        {Id::top, "top", "From above", "View", {"5"}, false, "Look down at a mesh in space."},
        {Id::bottom, "bottom", "From below", "View", {"6"}, false, "Look up at a mesh in space."},
        {Id::side_by_side,
         "side-by-side",
         "Side by side",
         "View",
         {"B"},
         false,
         "Show the computational mesh beside the physical one, or only one of them."},
        {Id::runs,
         "runs",
         "Meshes of all runs",
         "View",
         {"V"},
         false,
         "Show the meshes of all runs beside each other, or only that of the present one."},
        {Id::front_and_rear,
         "front-and-rear",
         "Front and rear",
         "View",
         {"F"},
         false,
         "Show a mesh in space from both sides, or only from one."},
        {Id::map, "map", "Map", "View", {"M"}, false, "Show a sphere as an equal-area map, or as a globe."},
        {Id::spin, "spin", "Spin", "View", {"S"}, false, "Let a mesh in space turn slowly, or stop it."},
        {Id::overlay,
         "exact",
         "Exact mesh",
         "View",
         {"X"},
         false,
         "Show or hide the lines of the exact mesh, where it is known."},
        {Id::lines, "lines", "Lines", "View", {"L"}, false, "Show or hide the cells' edges."},
        {Id::arrows, "arrows", "Arrows", "View", {"A"}, false, "Show or hide arrows from xi to x."},
        {Id::copy_camera,
         "copy-camera",
         "Copy camera",
         "View",
         {"Ctrl+C"},
         false,
         "Copy where one looks from as text, as view.camera takes it."},
        {Id::paste_camera,
         "paste-camera",
         "Paste camera",
         "View",
         {"Ctrl+V"},
         false,
         "Look from where a copied text says."},
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
        {"Drag the picture",
         "Pan; turn a mesh in space, which pans with Shift, the middle or the right button."},
        {"Drag the monitor's centre",
         "A small circle with a cross: the monitor moves, and the mesh follows."},
        {"Drag a control point",
         "A small square, of a patch in the plane: the patch bends, and the mesh follows."},
        {"Wheel", "Zoom at the pointer."},
        {"Click", "Pick a node or a cell: a card tells what is known of it. Beside the mesh: none."},
        {"Double-click", "Bring a point to the middle; a globe turns it to the front."},
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
