// The studies of problems with layers that the window offers and the command `study` makes by default.
#pragma once

#include "core/session/parameter_study.hpp"

#include <string>
#include <vector>

namespace gaspard {

/// What a study of a problem with layers can vary.
enum class StudyVariable { cells, eps, sigma, q };
/// Those that the scenario has; none if nothing is solved on its mesh.
std::vector<StudyVariable> study_variables(const Scenario& scenario);
/// "monitor.sigma", or "method.sigma" if the method makes its mesh of it; empty if there is none, or if it
/// has no effect.
std::string study_key(const Scenario& scenario, StudyVariable variable);
/// The energy error over this variable, one line per eps (per number of cells, if eps varies), in a range
/// that shows what happens; of meshes in two dimensions fewer.
StudyPlan usual_study(const Catalogue& catalogue, const Scenario& scenario, StudyVariable variable);

} // namespace gaspard
