// The list from which the type of a monitor is chosen: a picture, a name and the formula of each.
#pragma once

#include "core/scenario/scenario.hpp"
#include "gui/panels/monitor_pictures.hpp"
#include "gui/panels/sections.hpp"

#include <imgui.h>
#include <optional>
#include <string>

namespace gaspard {

struct PanelContext; // gui/panels/parameter_panel.hpp

/// How the list writes the formula of a type: with letters of this size, and typeset where it can be.
struct ListedFormula {
    std::string text;
    float size = 0;
    bool typeset = true;
};
/// So that it fits into `room`, if necessary smaller and without its last clauses; nullopt if it does not.
std::optional<ListedFormula> listed_formula(const MonitorType& type, ImVec2 room);

class MonitorList {
  public:
    /// Before the list, in every frame.
    void begin_frame() { pictures_.begin_frame(); }
    /// How wide the list is.
    static float width();
    /// The part of an entry that its formula may take.
    static ImVec2 formula_room();
    /// In the open list of a section, of the monitor or of the source density: the scenario with the type
    /// that was chosen. Notes items such as "monitor.type=ring".
    std::optional<Scenario> draw(SectionKind kind, const PanelContext& context, const Scenario& scenario);
    /// Whether pictures are still to come, in the next frames.
    bool waiting() const { return pictures_.waiting(); }

  private:
    struct Entry {
        const MonitorType* type;
        std::optional<Scenario> candidate; ///< with this type
        bool selected = false;
        bool possible() const { return candidate || selected; }
    };
    bool draw_entry(SectionKind kind, const PanelContext& context, const Entry& entry, const Scenario& shown,
                    const Box& region);

    MonitorPictures pictures_;
};

} // namespace gaspard
