// Everything a user can do with a key, a menu item or a button: one row per action with its facts and what it
// does. Buttons, menus, shortcuts, the help window and the table in docs/window.md are made from the rows,
// which gui/app/application_actions.cpp lists.
#pragma once

#include "gui/base/icons.hpp"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct Action {
    std::string_view name{};              ///< for scripts and tests: "run"
    std::string_view label{};             ///< "Run"
    std::string_view menu{};              ///< the menu that lists it: "File"
    std::vector<std::string_view> keys{}; ///< "Space", "R", "F12", "Ctrl+Q"; any of them
    int toolbar = 0;                      ///< its group of buttons in the bar at the top, from 1; 0: none
    Icon icon = Icon::none;               ///< of the button
    std::string_view help{};              ///< one sentence
    bool needs_solver = false;            ///< does nothing in a window that shows a finished run

    std::function<void()> run{};
    std::function<bool()> enabled{};            ///< empty: always
    std::function<bool()> checked{};            ///< empty: never
    std::function<std::string()> reason{};      ///< why it is disabled; empty if that is obvious
    std::function<std::string()> state_label{}; ///< the label where it depends on the state

    bool is_enabled() const { return !enabled || enabled(); }
    bool is_checked() const { return checked && checked(); }
    std::string why_disabled() const { return reason ? reason() : std::string(); }
    std::string current_label() const { return state_label ? state_label() : std::string(label); }
};

/// The action of this name, which must exist.
const Action& find_action(std::span<const Action> actions, std::string_view name);
/// Null if no action has this key. Keys are written as in the table; letters are upper case.
const Action* action_for_key(std::span<const Action> actions, std::string_view key);
/// "N or Right".
std::string describe_keys(const Action& action);
/// Help and keys, as a button shows them.
std::string tooltip_of(const Action& action);

/// What the mouse does: "Wheel", "Zoom at the pointer."
struct MouseHelp {
    std::string_view what, help;
};
std::span<const MouseHelp> mouse_help();

/// The rows as a Markdown table, followed by those of the mouse.
std::string actions_markdown(std::span<const Action> actions);

} // namespace gaspard
