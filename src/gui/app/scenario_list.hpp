// The list of scenarios: the built-in ones in groups, each with a sentence, and the files opened last. What
// is typed into the field above narrows it down.
#pragma once

#include "core/scenario/catalogue.hpp"
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
    /// A list of this width; in it "scenario=NAME" and "scenario.search".
    std::optional<ScenarioChoice> draw(const Catalogue& catalogue, const DocumentRun& run,
                                       const std::vector<std::string>& recent, float width,
                                       const FrameContext& context);

  private:
    std::optional<ScenarioChoice> draw_rows(const DocumentRun& run, const FrameContext& context);

    std::vector<Scenario> shipped_; ///< once the list has been opened; by group
    std::string search_;
};

} // namespace gaspard
