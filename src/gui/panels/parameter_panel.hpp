// Panels made from parameter rows alone: a slider, a typed value, a reset button and a tooltip for every
// number, a list for every choice. They draw into the current ImGui window and need no graphics backend.
//
// A panel edits a scenario and says that it changed; it knows no solver. What cannot be is not offered:
// numbers stay in their range, and names that do not go together (by the catalogue's capabilities) are greyed
// out.
#pragma once

#include "core/scenario/catalogue.hpp"
#include "gui/base/item_rectangles.hpp"
#include "gui/base/theme.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gaspard {

enum class SectionKind { domain, monitor, method };

/// "Domain", as a heading.
const char* section_title(SectionKind kind);

/// What the panels show, and what they go back to.
struct PanelContext {
    const Catalogue& catalogue;
    const Scenario& opened; ///< as it was opened: the values that reset buttons restore
    const Theme& theme;
    /// Filled with "monitor.amplitude" (its slider or list), "monitor.amplitude.input",
    /// "monitor.amplitude.reset", "monitor.type", and "monitor.type=ring" while the list is open.
    ItemRectangles& items;
    std::vector<std::string> unavailable{}; ///< choices greyed out for other reasons: "layout=map"
};

class ParameterPanel {
  public:
    /// One section: its type and its rows. True when `scenario` changed.
    bool draw_section(SectionKind kind, const PanelContext& context, Scenario& scenario);
    /// The rows of a section without types, such as view; `keys` names the rows to show.
    bool draw_rows(const PanelContext& context, const Values& opened, Values& values,
                   const std::vector<std::string>& keys);

  private:
    void draw_text(const ParameterRow& row, const std::string& key, Values& values);
    bool draw_row(const PanelContext& context, const ParameterRow& row, const Values* opened, Values& values,
                  const Scenario* scenario);
    void draw_number_or_auto(const PanelContext& context, const ParameterRow& row, const std::string& key,
                             Values& values);
    /// `taken`: how much of the slider's room is not its own.
    bool draw_number(const PanelContext& context, const ParameterRow& row, const std::string& key,
                     double& value, float taken = 0);
    bool draw_typed(const PanelContext& context, const ParameterRow& row, const std::string& key,
                    double& value);

    std::string typing_;     ///< the key whose field is being typed into
    double typed_value_ = 0; ///< what stands there so far; taken over when the field is left
    std::string typed_text_; ///< likewise
    std::string focus_;      ///< the key whose field is to get the keyboard
};

/// `scenario` with another type in one section, or nothing where that does not go with the rest. Another
/// domain brings along the first monitor and method that go with it.
std::optional<Scenario> with_type(const Catalogue& catalogue, const Scenario& opened,
                                  const Scenario& scenario, SectionKind kind, const std::string& type);

} // namespace gaspard
