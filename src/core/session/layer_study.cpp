#include "core/session/layer_study.hpp"

#include "core/base/error.hpp"
#include "core/base/number_text.hpp"
#include "core/monitor/layer_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace gaspard {

namespace {

constexpr const char* every_eps = "1,1e-2,1e-4,1e-6,1e-8";

std::string first_key(const Scenario& scenario, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
        if (study_row(scenario, key)) return key;
    return {};
}

/// Not a seed, and with two ends.
bool has_a_range(const ParameterRow& row) {
    const bool number = row.kind == ParameterKind::real || row.kind == ParameterKind::real_or_auto ||
                        row.kind == ParameterKind::integer;
    const SliderRange ends = row.slider.value_or(SliderRange{row.minimum, row.maximum});
    return number && row.role != ParameterRole::seed && std::isfinite(ends.maximum - ends.minimum);
}

/// Whether K is given, which is all that q is for.
bool has_weight(const Scenario& scenario) {
    const ParameterRow* row = study_row(scenario, "monitor.K");
    return row && row->kind == ParameterKind::real_or_auto &&
           scenario.monitor.values.real_or_auto("K").has_value();
}

/// Not a parameter of a formula that has the same name.
bool is_layer_row(const ParameterRow& row) {
    const std::vector<ParameterRow> rows = layer_shape_rows();
    return std::any_of(rows.begin(), rows.end(),
                       [&](const ParameterRow& one) { return one.key == row.key && one.label == row.label; });
}

/// The keys of the numbers that the mesh is made of: of a method that has a layer of its own, or that adapts
/// to the solution, those of the method, else those of the monitor.
std::vector<std::string> shaping_keys(const Scenario& scenario) {
    const Values &method = scenario.method.values, &monitor = scenario.monitor.values;
    const bool own = method.has("sigma") || method.has("density");
    std::vector<std::string> keys;
    for (const ParameterRow& row : (own ? method : monitor).rows()) {
        static constexpr std::array of_methods = {"eps", "q", "sigma", "beta", "smoothing"};
        const bool shapes =
            !own || std::find(of_methods.begin(), of_methods.end(), row.key) != of_methods.end();
        if (!shapes || !has_a_range(row)) continue;
        if (!own && row.key == "q" && has_weight(scenario)) continue;
        keys.push_back((own ? "method." : "monitor.") + row.key);
    }
    return keys;
}

StudyVariable name_of_key(const std::string& key) {
    const std::string last = key.substr(key.rfind('.') + 1);
    // Others are what plots are drawn against.
    const bool taken = last == "cells" || last == "eps" || last == "iterations" || last == "seconds";
    return taken ? key : last;
}

/// All of a few integers, else four values per power of ten on a logarithmic scale, within reason.
int usual_count(const ParameterRow& row, SliderRange ends, bool plane) {
    constexpr int most = 25, few_logarithmic = 13, few = 19;
    if (plane) return 6;
    const double span = ends.maximum - ends.minimum;
    if (row.kind == ParameterKind::integer && span < most) return static_cast<int>(span) + 1;
    if (row.scale != ParameterScale::logarithmic || ends.minimum <= 0) return few;
    const double decades = std::log10(ends.maximum / ends.minimum);
    return std::clamp(static_cast<int>(std::lround(4 * decades)) + 1, few_logarithmic, most);
}

/// The usual values of a key as parse_study_axis() reads them. A run in two dimensions costs as much as a
/// hundred in one.
std::string usual_values(const ParameterRow& row, const std::string& key, bool plane) {
    if (key == "domain.cells") return plane ? "8:64" : "8:1024";
    if (key == "pde.eps" || key == "pde.eps2") return plane ? "1:1e-8" : "1:1e-10";
    const bool of_layers = is_layer_row(row);
    if (of_layers && row.key == "sigma") return plane ? "0.5:16:6" : "0.25:16:19";
    if (of_layers && row.key == "q") return plane ? "0.1:0.9:5" : "0.05:0.95:19";
    const SliderRange ends = row.slider.value_or(SliderRange{row.minimum, row.maximum});
    return format_number(ends.minimum) + ":" + format_number(ends.maximum) + ":" +
           std::to_string(usual_count(row, ends, plane));
}

bool is_plane(const Scenario& scenario) { return scenario.domain.type != "interval"; }

/// With the number that the scenario has, if it is within the others.
void include_present(StudyAxis& axis, const Scenario& scenario) {
    const auto present = study_number(scenario, axis.key);
    if (!present) return;
    std::vector<double> numbers;
    for (const std::string& value : axis.values) numbers.push_back(parse_number(value).value_or(0));
    const bool falling = numbers.front() > numbers.back();
    const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
    if (*present < *low || *present > *high) return;
    if (std::find(numbers.begin(), numbers.end(), *present) != numbers.end()) return;
    const auto after = std::find_if(numbers.begin(), numbers.end(),
                                    [&](double one) { return falling ? one < *present : one > *present; });
    axis.values.insert(axis.values.begin() + (after - numbers.begin()), format_number(*present));
}

} // namespace

std::vector<StudyVariable> study_variables(const Scenario& scenario) {
    if (!scenario.pde.values.has("eps") && !scenario.pde.values.has("eps2")) return {};
    std::vector<StudyVariable> all;
    for (const char* one : {"cells", "eps"})
        if (!study_key(scenario, one).empty()) all.emplace_back(one);
    for (const std::string& key : shaping_keys(scenario)) all.push_back(name_of_key(key));
    // What a mesh depends on most comes first.
    std::stable_partition(all.begin(), all.end(), [](const StudyVariable& one) {
        return one == "cells" || one == "eps" || one == "sigma" || one == "q";
    });
    return all;
}

std::string study_key(const Scenario& scenario, std::string_view variable) {
    if (variable == "cells") return first_key(scenario, {"domain.cells"});
    if (variable == "eps") return first_key(scenario, {"pde.eps", "pde.eps2"});
    for (std::string& key : shaping_keys(scenario))
        if (name_of_key(key) == variable) return std::move(key);
    return {};
}

std::string study_label(const Scenario& scenario, std::string_view variable) {
    const ParameterRow* row = study_row(scenario, study_key(scenario, variable));
    if (variable == "cells" || !row) return std::string(variable);
    if (row->symbol.empty()) return row->label;
    for (const StudyVariable& other : study_variables(scenario)) {
        if (other == variable) break;
        if (study_row(scenario, study_key(scenario, other))->symbol == row->symbol) return row->label;
    }
    return row->symbol;
}

std::optional<double> study_number(const Scenario& scenario, std::string_view key) {
    const ParameterRow* row = study_row(scenario, key);
    if (!row) return std::nullopt;
    for (const Section* section : {&scenario.domain, &scenario.monitor, &scenario.method, &scenario.pde}) {
        const Values& values = section->values;
        if (!key.starts_with(values.section() + ".") || !values.has(row->key)) continue;
        if (row->kind == ParameterKind::integer) return static_cast<double>(values.integer(row->key));
        if (row->kind == ParameterKind::real) return values.real(row->key);
        if (row->kind != ParameterKind::real_or_auto) return std::nullopt;
        if (const auto number = values.real_or_auto(row->key)) return number;
        if (row->key.starts_with("eps")) return layer_width_of(&scenario.pde.values, row->key);
        if (row->key == "K" && values.has("sigma")) return layer_weight_of(values);
    }
    return std::nullopt;
}

StudyAxis usual_axis(const Catalogue& catalogue, const Scenario& scenario, const std::string& key) {
    const ParameterRow* row = study_row(scenario, key);
    if (!row || !has_a_range(*row))
        throw InputError(key + " has no range of numbers to take values from; write " + key + "=VALUES");
    return parse_study_numbers(catalogue, scenario, key + "=" + usual_values(*row, key, is_plane(scenario)),
                               key);
}

StudyPlan usual_study(const Catalogue& catalogue, const Scenario& scenario, std::string_view variable) {
    const std::string cells = is_plane(scenario) ? "16,32,64" : "16,64,256,1024";
    const auto axis = [&](const char* of, const std::string& values) {
        const std::string key = study_key(scenario, of);
        return parse_study_axis(catalogue, scenario, key + "=" + values, key);
    };
    StudyPlan plan{.scenario = scenario, .over = {}, .measure = "energy_error"};
    plan.over = usual_axis(catalogue, scenario, study_key(scenario, variable));
    plan.lines = variable == "eps" ? axis("cells", cells) : axis("eps", every_eps);
    if (variable != "cells") include_present(plan.lines, scenario);
    // What varies is the same in all plans, and what no run needs is off.
    plan.scenario.method.values.set("interpolation", false);
    plan.scenario = study_scenario(catalogue, plan, 0, 0);
    return plan;
}

} // namespace gaspard
