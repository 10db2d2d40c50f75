// The list of scenarios: a card with a picture for each of the built-in ones, in groups, and for the files
// opened last; a sentence about the one under the mouse. What is typed into the field above narrows it down;
// arrow keys and Enter choose.
#pragma once

#include "core/scenario/catalogue.hpp"
#include "gui/app/thumbnails.hpp"
#include "gui/base/frame_context.hpp"
#include "gui/document/document.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct ScenarioChoice {
    bool file = false; ///< a path, else a built-in name
    std::string name;
};

/// "Plane" of "plane-ring" and "walls-ring": the heading of a built-in scenario.
std::string_view scenario_group(std::string_view name);
/// The description up to where its source is quoted.
std::string short_description(const std::string& description);

class ScenarioList {
  public:
    /// A list of this width; in it "scenario=NAME", "recent=PATH" and "scenario.search".
    std::optional<ScenarioChoice> draw(const Catalogue& catalogue, const DocumentRun& run,
                                       const std::vector<std::string>& recent, float width,
                                       const FrameContext& context);
    /// Whether pictures are still to come, in the next frames.
    bool waiting() const { return thumbnails_.waiting(); }
    /// It has opened, but its search field does not take letters yet.
    bool opening() const { return opening_; }

  private:
    struct Card {
        ScenarioChoice choice;
        std::string group, title, text;
    };
    void open(const Catalogue& catalogue);
    std::vector<Card> cards(const std::vector<std::string>& recent) const;
    void move_mark(const std::vector<Card>& cards, int columns);
    bool draw_card(const Card& card, bool lit, bool current, const FrameContext& context);
    std::optional<ScenarioChoice> draw_cards(const std::vector<Card>& cards, int columns,
                                             const DocumentRun& run, const FrameContext& context);

    std::vector<Scenario> shipped_; ///< once the list has been opened; by group
    std::string search_;
    int marked_ = -1, hovered_ = -1; ///< of the cards that are shown; -1: none
    bool scroll_to_mark_ = false;
    Thumbnails thumbnails_;
    bool opening_ = false;
};

} // namespace gaspard
