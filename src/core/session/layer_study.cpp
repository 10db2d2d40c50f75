#include "core/session/layer_study.hpp"

#include <initializer_list>
#include <utility>

namespace gaspard {

namespace {

constexpr const char* every_eps = "1,1e-2,1e-4,1e-6,1e-8";

/// Values of a variable as parse_study_axis() reads them. A run in two dimensions costs as much as a hundred
/// in one.
std::string usual_values(StudyVariable variable, bool plane) {
    switch (variable) {
    case StudyVariable::cells:
        return plane ? "8:64" : "8:1024";
    case StudyVariable::eps:
        return plane ? "1:1e-8" : "1:1e-10";
    case StudyVariable::sigma:
        return plane ? "0.5:16:6" : "0.25:16:19";
    case StudyVariable::q:
        return plane ? "0.1:0.9:5" : "0.05:0.95:19";
    }
    return {};
}

} // namespace

std::vector<StudyVariable> study_variables(const Scenario& scenario) {
    if (!scenario.pde.values.has("eps") && !scenario.pde.values.has("eps2")) return {};
    std::vector<StudyVariable> all;
    for (const auto variable :
         {StudyVariable::cells, StudyVariable::eps, StudyVariable::sigma, StudyVariable::q})
        if (!study_key(scenario, variable).empty()) all.push_back(variable);
    return all;
}

std::string study_key(const Scenario& scenario, StudyVariable variable) {
    const auto first = [&](std::initializer_list<const char*> keys) {
        for (const char* key : keys)
            if (study_row(scenario, key)) return std::string(key);
        return std::string();
    };
    switch (variable) {
    case StudyVariable::cells:
        return first({"domain.cells"});
    case StudyVariable::eps:
        return first({"pde.eps", "pde.eps2"});
    case StudyVariable::sigma:
        return first({"method.sigma", "monitor.sigma"});
    case StudyVariable::q: { // of a monitor whose K is given it has no effect
        const Values& monitor = scenario.monitor.values;
        const bool given = monitor.has("K") && monitor.real_or_auto("K").has_value();
        return given ? first({"method.q"}) : first({"method.q", "monitor.q"});
    }
    }
    return {};
}

StudyPlan usual_study(const Catalogue& catalogue, const Scenario& scenario, StudyVariable variable) {
    const bool plane = scenario.domain.type != "interval";
    const std::string cells = plane ? "16,32,64" : "16,64,256,1024";
    const auto axis = [&](StudyVariable of, const std::string& values) {
        const std::string key = study_key(scenario, of);
        return parse_study_axis(catalogue, scenario, key + "=" + values, key);
    };
    StudyPlan plan{.scenario = scenario, .over = {}, .measure = "energy_error"};
    const std::string key = study_key(scenario, variable);
    plan.over = parse_study_numbers(catalogue, scenario, key + "=" + usual_values(variable, plane), key);
    plan.lines = variable == StudyVariable::eps ? axis(StudyVariable::cells, cells)
                                                : axis(StudyVariable::eps, every_eps);
    // What varies is the same in all plans, and what no run needs is off.
    plan.scenario.method.values.set("interpolation", false);
    plan.scenario = study_scenario(catalogue, plan, 0, 0);
    return plan;
}

} // namespace gaspard
