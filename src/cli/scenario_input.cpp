#include "cli/scenario_input.hpp"

#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/io/svg.hpp"
#include "core/scenario/time_rows.hpp"
#include "core/session/run.hpp"
#include "core/tessellate/check_view.hpp"

#include <algorithm>
#include <cstdio>

namespace gaspard {

namespace {

template <class Check>
void with_place_of(const ScenarioSource& source, const Check& check_values) {
    try {
        check_values();
    } catch (const InputError& error) {
        throw InputError(with_place(source, error.what()));
    }
}

/// Where time passes, a time of the monitor is that of the clock.
void refuse_times(const Scenario& scenario, const std::vector<std::string>& settings) {
    if (!has_time(scenario.time)) return;
    for (const std::string& setting : settings)
        for (const ParameterRow& row : scenario.monitor.values.rows())
            if (const std::string key = "monitor." + row.key;
                row.role == ParameterRole::time && setting.starts_with(key + "="))
                throw InputError(key + " goes from time.start to time.end and cannot be set; with time.end=" +
                                 format_number(scenario.time.real("start")) + " no time passes");
}

} // namespace

ScenarioInput load_input(const Catalogue& catalogue, const std::string& name,
                         const std::vector<std::string>& settings) {
    ScenarioInput input;
    input.scenario = input.named = find_scenario(catalogue, name, &input.source);
    change_input(catalogue, input, settings);
    return input;
}

void change_input(const Catalogue& catalogue, ScenarioInput& input,
                  const std::vector<std::string>& settings) {
    apply_settings(catalogue, input.scenario, settings);
    for (const std::string& setting : settings)
        input.source.lines.erase(setting.substr(0, setting.find('=')));
    refuse_times(input.scenario, settings);
    note_changes(input);
}

void note_changes(ScenarioInput& input) {
    input.scenario.modified = modified_keys(input.named, input.scenario);
}

void check_input(const Catalogue& catalogue, ScenarioInput& input) {
    with_place_of(input.source, [&] {
        check(catalogue, input.scenario);
        check_view(input.scenario.view);
        input.formats = formats_of(catalogue, input.scenario);
    });
}

void check_domain(const Catalogue& catalogue, const ScenarioInput& input) {
    const Values& view = input.scenario.view;
    const bool needs_mesh = find_role(input.scenario.domain.values.rows(), ParameterRole::file) != nullptr ||
                            !is_default(view, "pick") || !is_default(view, "layout") ||
                            !is_default(view, "camera") || !is_default(view, "elevation_camera");
    if (needs_mesh) check_with_mesh(input, *prepare(check(catalogue, input.scenario), {}, {})->mesh());
}

void check_data(const Catalogue& catalogue, const ScenarioInput& input) {
    const Scenario& scenario = input.scenario;
    const auto depends = [](const Section& section) {
        const auto& rows = section.values.rows();
        return std::any_of(rows.begin(), rows.end(), redefines_rows);
    };
    if (!depends(scenario.monitor) && !depends(scenario.source)) return;
    const auto discretisation = prepare(check(catalogue, scenario), {}, {});
    make_problem_data(catalogue, scenario, nullptr,
                      {.space = space_of(catalogue, scenario),
                       .discretisation = discretisation.get(),
                       .folder = scenario.folder});
}

void check_with_mesh(const ScenarioInput& input, const Mesh& mesh) {
    with_place_of(input.source, [&] {
        const Values& view = input.scenario.view;
        check_view(view, &mesh);
        const auto is_svg = [](const Format* one) { return one->name == "svg" || one->name == "pdf"; };
        if (std::none_of(input.formats.begin(), input.formats.end(), is_svg)) return;
        const double aspect =
            static_cast<double>(view.integer("height")) / static_cast<double>(view.integer("width"));
        for (const std::string key : {"camera", "elevation_camera"}) try {
                check_svg_camera(mesh.nodes, view.text(key), aspect);
            } catch (const InputError& error) {
                throw InputError("view." + key + ": " + error.what());
            }
    });
}

void print_left_over(const std::vector<std::string>& names) {
    if (!names.empty()) std::printf("not of this run, but left there: %s\n", join(names, ", ").c_str());
}

} // namespace gaspard
