#include "gui/actions.hpp"

#include "core/base/check.hpp"

#include <algorithm>

namespace gaspard {

std::span<const Action> actions() {
    static const std::vector<Action> rows = {
        {ActionId::run_pause, "run", "Run", "Solve", {"Space"}, true, "Let the mesh move, or pause it."},
        {ActionId::step, "step", "Step", "Solve", {"N", "Right"}, true, "Do one iteration, then pause."},
        {ActionId::reset, "reset", "Reset", "Solve", {"R"}, true, "Put every node back to where it started."},
        {ActionId::keep,
         "keep",
         "Keep",
         "Solve",
         {"K"},
         false,
         "Keep the curves of this run beside those to come."},
        {ActionId::home, "home", "Home", "View", {"H"}, true, "Show the whole mesh again."},
        {ActionId::screenshot,
         "screenshot",
         "Screenshot",
         "File",
         {"F12", "P"},
         true,
         "Save the picture of the mesh as a PNG file."},
        {ActionId::export_files,
         "export",
         "Export",
         "File",
         {"E"},
         true,
         "Save the meshes, the history and a summary as files."},
        {ActionId::help, "help", "Keys and mouse", "Help", {"F1"}, false, "Show what keys and mouse do."},
        {ActionId::quit, "quit", "Quit", "File", {"Ctrl+Q"}, false, "Close the window."},
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

std::string actions_markdown() {
    std::string text = "| key | action | what it does |\n| --- | --- | --- |\n";
    for (const Action& row : actions())
        text += "| " + describe_keys(row) + " | " + std::string(row.label) + " | " + std::string(row.help) +
                " |\n";
    return text;
}

} // namespace gaspard
