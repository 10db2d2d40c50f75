// Common parts of the figures of McRae, Cotter, Budd: built-in scenarios, solved with other settings.
#pragma once

#include "core/published/published.hpp"
#include "core/session/run.hpp"
#include "core/tessellate/plot.hpp"

#include <string>
#include <vector>

namespace gaspard {

/// The arguments of a recipe.
struct Workshop {
    const std::shared_ptr<const Catalogue>& catalogue;
    const Announce& announce;
    std::stop_token stop;
};

/// A run of a built-in scenario with settings such as "domain.cells=30", before its first step.
Run begin_run(const Workshop& workshop, const std::string& scenario, const std::vector<std::string>& settings,
              const std::string& title);
/// Steps until the run ends. Throws Interrupted.
void finish(Run& run, const Workshop& workshop);
/// begin_run and finish; the run must converge.
Run solve(const Workshop& workshop, const std::string& scenario, const std::vector<std::string>& settings,
          const std::string& title);

/// One of the series of a run as a curve; rows without a value are left out.
Curve history_curve(const Run& run, const std::string& label, std::string_view series);

using MakeInWorkshop = std::function<Reproduction(const Workshop&)>;
/// A recipe from functions of the workshop; `full` as Recipe::full.
Recipe make_recipe(const std::string& id, const std::string& title, MakeInWorkshop make,
                   MakeInWorkshop full = {});

// Recipes for the flow, the sphere and for refinement.
std::vector<Recipe> mcrae_flow_recipes();
std::vector<Recipe> mcrae_sphere_recipes();
std::vector<Recipe> mcrae_newton_recipes();
std::vector<Recipe> mcrae_refinement_recipes();
// Figures of solids of Bahari and others.
std::vector<Recipe> bahari_solid_recipes();

} // namespace gaspard
