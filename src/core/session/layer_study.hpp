// The studies of problems with layers that the window offers and the command `study` makes by default.
#pragma once

#include "core/session/parameter_study.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// What a study of a problem with layers varies, by a name that also fits other problems: "cells", "eps", or
/// the key of a number that the mesh is made of, such as "sigma", of the method where that has it, else of
/// the monitor. With its section ("monitor.eps") where the key alone is another name.
using StudyVariable = std::string;

/// Those that the scenario has; none if nothing is solved on its mesh. Numbers of a monitor that the method
/// does not use are left out, and q where K is given.
std::vector<StudyVariable> study_variables(const Scenario& scenario);
/// "monitor.sigma", or "method.sigma"; empty if the scenario has no such variable.
std::string study_key(const Scenario& scenario, std::string_view variable);
/// For people: "σ"; "Layer width" where another variable has the same symbol. The name itself if the scenario
/// has no such variable.
std::string study_label(const Scenario& scenario, std::string_view variable);
/// The present value of such a key: what "auto" stands for where that is known; nullopt where it is not.
std::optional<double> study_number(const Scenario& scenario, std::string_view key);

/// Values of a numeric row of a scenario in a range that shows what happens, fewer of meshes in two
/// dimensions. Throws InputError if the row has no ends.
StudyAxis usual_axis(const Catalogue& catalogue, const Scenario& scenario, const std::string& key);
/// The energy error over this variable, one line per eps (per number of cells, if eps varies). Of a variable
/// other than cells and eps, the present eps has a line, too; of eps the present number of cells.
StudyPlan usual_study(const Catalogue& catalogue, const Scenario& scenario, std::string_view variable);

} // namespace gaspard
