// Panels made from parameter rows: a slider, a text field, a reset button and a tooltip for every number, a
// list for every choice. They draw into the current ImGui window and need no graphics backend.
//
// A panel edits a scenario and returns whether it changed; it knows no solver. It offers only valid values:
// numbers are limited to their range, and types that cannot be combined (by the catalogue's capabilities) are
// greyed out.
#pragma once

#include "core/mesh/patch_list.hpp"
#include "core/scenario/catalogue.hpp"
#include "gui/base/item_rectangles.hpp"
#include "gui/base/theme.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {

enum class SectionKind { domain, monitor, target, method, pde };
inline constexpr SectionKind all_sections[] = {SectionKind::domain, SectionKind::monitor, SectionKind::target,
                                               SectionKind::method, SectionKind::pde};

/// "Domain", as a heading.
const char* section_title(SectionKind kind);
/// Whether the scenario has such a section; target and pde are there only for some problems.
bool has_section(const Scenario& scenario, SectionKind kind);

/// What the panels need besides the values that they edit.
struct PanelContext {
    const Catalogue& catalogue;
    const Scenario& opened; ///< as it was opened: the values that reset buttons restore
    const Theme& theme;
    /// Filled with "monitor.amplitude" (its slider or list), "monitor.amplitude.input",
    /// "monitor.amplitude.reset", "monitor.type", and "monitor.type=ring" while the list is open.
    ItemRectangles& items;
    std::vector<std::string> unavailable{}; ///< other choices to grey out: "layout=projection"
    const PatchList* patches =
        nullptr; ///< of the domain's file, to choose from ("domain.patch=3"); may be null
};

class ParameterPanel {
  public:
    /// One section: its type and its rows. True when `scenario` changed.
    bool draw_section(SectionKind kind, const PanelContext& context, Scenario& scenario);
    /// The rows of a section without types, such as view; `keys` names the rows to show.
    bool draw_rows(const PanelContext& context, const Values& opened, Values& values,
                   const std::vector<std::string>& keys);

  private:
    void draw_text(const PanelContext& context, const ParameterRow& row, const std::string& key,
                   Values& values);
    bool draw_row(const PanelContext& context, const ParameterRow& row, const Values* opened, Values& values,
                  const Scenario* scenario);
    void draw_number_or_auto(const PanelContext& context, const ParameterRow& row, const std::string& key,
                             const Values* opened, Values& values);
    /// `taken`: width to the left of the slider that something else uses.
    bool draw_number(const PanelContext& context, const ParameterRow& row, const std::string& key,
                     double& value, float taken = 0);
    bool draw_typed(const PanelContext& context, const ParameterRow& row, const std::string& key,
                    double& value);

    std::string typing_;     ///< the key whose text field is being edited
    double typed_value_ = 0; ///< its content so far; it takes effect when the field is left
    std::string typed_text_; ///< the same for texts
    std::map<std::string, double> before_auto_; ///< by key: the number that "auto" replaced
    std::string focus_;      ///< the key whose text field gets the keyboard focus
};

/// `scenario` with another type in one section; nothing if it cannot be combined with the other sections. With
/// another domain, a monitor or method that does not fit is replaced by the first one that does.
std::optional<Scenario> with_type(const Catalogue& catalogue, const Scenario& opened,
                                  const Scenario& scenario, SectionKind kind, const std::string& type);

} // namespace gaspard
