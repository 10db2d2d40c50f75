// The bar at the top: menus, the list of scenarios, and buttons; made from the table of actions.
#pragma once

#include "core/scenario/catalogue.hpp"
#include "gui/app/scenario_list.hpp"
#include "gui/base/actions.hpp"
#include "gui/base/frame_context.hpp"
#include "gui/document/document.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gaspard {

/// What the user has selected in this frame.
struct MenuChoice {
    enum class Kind { action, file, scenario, format };
    Kind kind = Kind::action;
    std::string name; ///< of an action, a file to open, a built-in scenario, a format to export in
};

struct MenuContext {
    std::span<const Action> actions;
    const Catalogue& catalogue;
    const DocumentRun& run;                 ///< the active one
    const std::vector<std::string>& recent; ///< files, the newest first
    FrameContext frame;
};

class Menus {
  public:
    /// Keys "menu.File" and, in an open menu, "menu.NAME" of an action, "recent.0", "menu.export-as" and in
    /// that "format.NAME"; "scenario" and, in the open list, "scenario=NAME"; "action.NAME" of the buttons.
    std::optional<MenuChoice> draw_bar(const MenuContext& context);
    /// Of the bar, as last drawn.
    float height() const { return height_; }
    /// Whether the next frame shows more, as pictures in the list of scenarios.
    bool waiting() const { return scenarios_.waiting(); }
    bool opening() const { return scenarios_.opening(); }

  private:
    std::optional<MenuChoice> draw_buttons(const MenuContext& context);
    std::optional<MenuChoice> draw_scenarios(const MenuContext& context, float width);

    float height_ = 0;

    ScenarioList scenarios_;
};

} // namespace gaspard
