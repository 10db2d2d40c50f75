// What the figures of McRae, Cotter, Budd share: shipped scenarios, solved with other settings.
#pragma once

#include "core/published/published.hpp"
#include "core/session/run.hpp"
#include "core/tessellate/plot.hpp"

#include <string>
#include <vector>

namespace gaspard {

/// Everything that a recipe is given.
struct Workshop {
    const std::shared_ptr<const Catalogue>& catalogue;
    const Announce& announce;
    std::stop_token stop;
};

/// A built-in scenario with settings ("domain.cells=30"), not yet stepped.
Run begin_run(const Workshop& workshop, const std::string& scenario, const std::vector<std::string>& settings,
              const std::string& title);
/// To the end; throws Interrupted.
void finish(Run& run, const Workshop& workshop);
/// Both, of a run that converges.
Run solve(const Workshop& workshop, const std::string& scenario, const std::vector<std::string>& settings,
          const std::string& title);

/// One of the series of a run as a curve; rows without a value are left out.
Curve history_curve(const Run& run, const std::string& label, std::string_view series);

/// A recipe of a function of the workshop.
Recipe make_recipe(const std::string& id, const std::string& title,
                   std::function<Reproduction(const Workshop&)> make);

// The figures of the sphere, and those about refinement.
std::vector<Recipe> mcrae_sphere_recipes();
std::vector<Recipe> mcrae_newton_recipes();
std::vector<Recipe> mcrae_refinement_recipes();

} // namespace gaspard
