// Everything a user can do with a key or a button, once: name, label, keys, menu and help. Toolbar, menus,
// shortcuts, the help overlay and the README's table are made from these rows.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

enum class ActionId {
    run_pause,
    step,
    reset,
    undo,
    redo,
    keep,
    compare,
    quadratic,
    cancel,
    home,
    front,
    back,
    left,
    right,
    top,
    bottom,
    side_by_side,
    runs,
    front_and_rear,
    map,
    spin,
    overlay,
    lines,
    arrows,
    copy_camera,
    paste_camera,
    theme,
    sidebar,
    plots,
    log,
    larger,
    smaller,
    projector,
    fullscreen,
    open,
    save_scenario,
    screenshot,
    export_files,
    help,
    quit
};

struct Action {
    ActionId id;
    std::string_view name;              ///< for scripts and tests: "run"
    std::string_view label;             ///< on a button: "Run"
    std::string_view menu;              ///< the menu it stands in: "File"
    std::vector<std::string_view> keys; ///< "Space", "R", "F12", "Ctrl+Q"; any of them
    bool toolbar;                       ///< has a button above the picture
    std::string_view help;              ///< one sentence
};

/// In the order of toolbar and menus.
std::span<const Action> actions();
const Action& action(ActionId id);
/// Null where no action has this key. Keys are written as in the table; letters are upper case.
const Action* action_for_key(std::string_view key);
/// "N or Right".
std::string describe_keys(const Action& action);

/// What the mouse does: "Wheel", "Zoom at the pointer."
struct MouseHelp {
    std::string_view what, help;
};
std::span<const MouseHelp> mouse_help();

/// The rows as a Markdown table, those of the mouse at its end.
std::string actions_markdown();

} // namespace gaspard
