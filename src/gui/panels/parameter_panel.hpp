// Panels made from parameter rows: a field to drag, a reset button and a tooltip for every number, a list for
// every choice. They draw into the current ImGui window and need no graphics backend.
//
// A panel edits a scenario and returns whether it changed; it knows no solver. It offers only valid values:
// numbers are limited to their range, and types that cannot be combined (by the catalogue's capabilities) are
// greyed out.
#pragma once

#include "core/mesh/patch_list.hpp"
#include "core/monitor/monitor.hpp"
#include "core/scenario/catalogue.hpp"
#include "gui/base/item_rectangles.hpp"
#include "gui/base/theme.hpp"
#include "gui/panels/awaited_field.hpp"
#include "gui/panels/file_row.hpp"
#include "gui/panels/formula_field.hpp"
#include "gui/panels/monitor_list.hpp"
#include "gui/panels/sections.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace gaspard {

struct Snapshot;

/// What the panels need besides the values that they edit.
struct PanelContext {
    const Catalogue& catalogue;
    const Scenario& opened; ///< as it was opened: the values that reset buttons restore
    const Theme& theme;
    /// Filled with "monitor.amplitude" (its field or list), "monitor.amplitude.input" while it is typed,
    /// "monitor.stage.Average", "monitor.amplitude.reset", "monitor.type", and "monitor.type=ring" while the
    /// list is open; "monitor.more".
    ItemRectangles& items;
    std::vector<std::string> unavailable{}; ///< other choices to grey out: "layout=projection"
    const PatchList* patches =
        nullptr; ///< of the domain's file, to choose from ("domain.patch=3"); may be null
    const MonitorReport* report = nullptr; ///< of the monitor as it is solved for; may be null
    std::string shown_field{};             ///< that the cells are coloured by
    std::string warning{};                 ///< about the monitor on this mesh; may be empty
    const Snapshot* snapshot = nullptr;    ///< that shows where the domain is; may be null
    std::string colours = "automatic";     ///< view.color_map
    /// Of a monitor that moves, at the time of the mesh that is shown; null: it has no time.
    const Values* monitor_now = nullptr;
    double now = 0; ///< that time
};

class ParameterPanel {
  public:
    /// One section: its type and its rows. True when `scenario` changed.
    bool draw_section(SectionKind kind, const PanelContext& context, Scenario& scenario);
    /// The rows of a section without types, such as view; `keys` names the rows to show. `scenario`: the one
    /// that the values are of, by which formulas are checked; may be null if there are none.
    bool draw_rows(const PanelContext& context, const Values& opened, Values& values,
                   const std::vector<std::string>& keys, const Scenario* scenario = nullptr);

    /// The file that the user wants to choose for a value, once.
    std::optional<FileWish> take_file_wish() { return std::exchange(file_wish_, std::nullopt); }
    /// Whether a formula was applied since the last call: it is an edit of its own.
    bool take_formula_applied() { return std::exchange(formula_applied_, false); }
    /// The formula applied last was refused by the solver.
    void refuse_formula(const std::string& why) { formulas_.refuse(why); }
    /// The field of a formula gets the keyboard: "monitor.expression".
    void focus_formula(const std::string& key) { formulas_.focus(key); }
    /// A text field is about to get the keyboard.
    bool awaits_text() const { return formulas_.awaits_text() || focus_.pending(); }
    /// At the beginning of a frame, whether or not the panel is drawn in it. `takes_keys`: no list or dialog
    /// is open that they are meant for.
    void begin_frame(bool takes_keys);
    /// Something will happen without input.
    bool waiting() const { return formulas_.waiting() || monitors_.waiting(); }

    /// The field that the user wants to see, once.
    std::optional<std::string> take_field_wish() { return std::exchange(field_wish_, std::nullopt); }

  private:
    enum class Drawn { unchanged, changed, other_rows };
    Drawn draw_scenario_row(SectionKind kind, const PanelContext& context, const ParameterRow& row,
                            Scenario& scenario);
    void draw_clock_row(const PanelContext& context, const ParameterRow& row, const Values& values);
    bool draw_types(SectionKind kind, const PanelContext& context, Scenario& scenario);
    bool draw_stage(const PanelContext& context, const MonitorStage& stage, const ParameterRow* toggle,
                    Values& values);
    bool draw_section_rows(SectionKind kind, const PanelContext& context, Scenario& scenario);
    std::vector<ParameterRow> rows_in_sight(const std::vector<ParameterRow>& rows, const Values* opened,
                                            const Values& values);
    void draw_more(const PanelContext& context, const std::string& section);
    void draw_control(const PanelContext& context, const ParameterRow& row, const std::string& key,
                      const Values* opened, Values& values, const Scenario* scenario);
    void draw_formula(const PanelContext& context, const ParameterRow& row, const std::string& key,
                      Values& values, const Scenario& scenario);
    void draw_motion(const PanelContext& context, const ParameterRow& row, const std::string& key,
                     Values& values, const Scenario& scenario);
    std::size_t situation_of(const std::string& key, const Scenario& scenario);
    SliderRange ends_of(const ParameterRow& row, const std::string& key, double value);
    void draw_text(const PanelContext& context, const ParameterRow& row, const std::string& key,
                   Values& values);
    bool draw_row(const PanelContext& context, const ParameterRow& row, const Values* opened, Values& values,
                  const Scenario* scenario);
    void draw_number_or_auto(const PanelContext& context, const ParameterRow& row, const std::string& key,
                             const Values* opened, Values& values);
    bool draw_number(const PanelContext& context, const ParameterRow& row, const std::string& key,
                     double& value, float width);
    void follow_pointer(bool clicked, bool hovered);
    bool draw_typed(const PanelContext& context, const ParameterRow& row, const std::string& key,
                    double& value, float width);

    std::set<std::string, std::less<>> opened_; ///< the sections that show all rows
    std::size_t hidden_rows_ = 0;               ///< of the section that is drawn
    std::string focused_;                       ///< the key of the number that was clicked last
    bool pointed_ = false;  ///< the pointer was brought to it, not it to the pointer by scrolling
    double scrolled_ = -10; ///< when the wheel was last turned elsewhere, by ImGui::GetTime()
    bool takes_keys_ = true;
    std::string typing_;     ///< the key whose text field is being edited
    double typed_value_ = 0; ///< its content so far; it takes effect when the field is left
    std::string typed_text_; ///< the same for texts
    std::map<std::string, double> before_auto_; ///< by key: the number that "auto" replaced
    struct Widened {
        SliderRange said, ends;
    };
    std::map<std::string, Widened> widened_; ///< sliders whose ends the row says, by key
    FormulaField formulas_;
    std::optional<Scenario> checked_for_; ///< what formulas that are not applied were checked for last
    std::size_t situation_ = 0;           ///< counts its changes
    MonitorList monitors_;
    bool formula_applied_ = false;
    std::optional<FileWish> file_wish_;
    std::optional<std::string> field_wish_;
    AwaitedField focus_; ///< of a number
};

} // namespace gaspard
