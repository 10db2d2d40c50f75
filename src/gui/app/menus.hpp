// The menu bar, the toolbar, and the list of scenarios at its end, made from the table of actions.
#pragma once

#include "core/scenario/catalogue.hpp"
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
    std::string name; ///< of an action, a file to open, a built-in scenario, an export format to switch
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
    /// Keys "menu.File" and, in an open menu, "menu.NAME" of an action, "recent.0", "format.NAME".
    std::optional<MenuChoice> draw_menu_bar(const MenuContext& context);
    /// Keys "action.NAME", "scenario" and, in the open list, "scenario=NAME".
    std::optional<MenuChoice> draw_toolbar(const MenuContext& context, const ItemRectangle& place);

  private:
    std::optional<MenuChoice> draw_scenarios(const MenuContext& context);

    std::vector<Scenario> shipped_; ///< for the list of scenarios, once it has been opened
};

} // namespace gaspard
