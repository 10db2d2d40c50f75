#include "cli/commands.hpp"
#include "cli/scenario_input.hpp"
#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/scenario/data_files.hpp"
#include "core/scenario/own_names.hpp"
#include "core/scenario/time_rows.hpp"

#include <iostream>
#include <utility>

namespace gaspard {

namespace {

void print_rows(const Values& values) {
    for (const auto& row : values.rows()) {
        const std::string key = values.section() + "." + row.key;
        std::cout << "    " << key << std::string(key.size() < 28 ? 28 - key.size() : 1, ' ')
                  << format_value(row.default_value) << "  [" << describe_range(row) << "]"
                  << (row.unit.empty() ? "" : " " + row.unit) << "  " << row.help << "\n";
    }
}

void print_head(const std::string& name, const std::string& help) {
    std::cout << "  " << name << std::string(name.size() < 19 ? 19 - name.size() : 1, ' ') << help << "\n";
}

/// Further choices of view.color.
void print_colours(const std::vector<FieldInfo>& fields) {
    for (const FieldInfo& field : fields)
        std::cout << "    view.color = " << field.name << "  " << field.help << "\n";
}

void list_scenarios(const Catalogue& catalogue) {
    std::cout << "Scenarios\n";
    for (const auto& builtin : builtin_scenarios()) {
        const std::string name(builtin.name);
        print_head(name, find_scenario(catalogue, name).description);
    }
}

void list_domains(const Catalogue& catalogue) {
    std::cout << "Domains (domain.type)\n";
    for (const auto& type : catalogue.domains) {
        print_head(type.name, type.help);
        print_rows(domain_section(catalogue, type.name).values);
    }
}

void list_monitors(const Catalogue& catalogue) {
    std::cout << "Monitors (monitor.type)\n";
    for (const auto& type : catalogue.monitors) {
        print_head(type.name, type.help + ": " + type.equation);
        print_colours(type.fields);
        const Values plane = monitor_section(catalogue, type.name).values;
        const Values sphere = monitor_section(catalogue, type.name, {SpaceKind::sphere}).values;
        print_rows(plane);
        if (sphere == plane) continue;
        std::cout << "    on a sphere:\n";
        print_rows(sphere);
    }
}

/// The rows that a method has on some domains only, after the names of these.
void print_rows_on_domains(const Catalogue& catalogue, const std::string& method) {
    std::vector<std::string> domains;
    std::vector<ParameterRow> rows;
    for (const DomainType& domain : catalogue.domains)
        if (auto there = method_rows_on(catalogue, domain.name, method); !there.empty()) {
            domains.push_back(domain.name);
            rows = std::move(there);
        }
    if (rows.empty()) return;
    std::cout << "    on " << join(domains, ", ") << ":\n";
    print_rows(Values("method", rows));
}

void list_methods(const Catalogue& catalogue) {
    std::cout << "Methods (method.type)\n";
    for (const auto& type : catalogue.methods) {
        print_head(type.name, type.help);
        print_rows(method_section(catalogue, type.name).values);
        print_rows_on_domains(catalogue, type.name);
        print_colours(type.fields);
    }
}

void list_time(const Catalogue&) {
    std::cout << "Time\n";
    print_head("time.monitor.KEY", "monitor.KEY as a formula in t, such as time.monitor.center_x");
    print_rows(Values("time", time_rows({})));
}

void list_view(const Catalogue& catalogue) {
    std::cout << "View\n";
    print_rows(view_section(catalogue, catalogue.methods.front().name, catalogue.monitors.front().name));
}

void list_output(const Catalogue& catalogue) {
    std::cout << "Output\n";
    print_rows(Values("output", catalogue.output_rows));
}

void list_formats(const Catalogue&) {
    std::cout << "Formats (--formats)\n";
    for (const auto& format : formats()) print_head(format.name, format.help);
}

} // namespace

int list_command(const Catalogue& catalogue, const std::string& what) {
    using Lister = void (*)(const Catalogue&);
    const std::vector<std::pair<std::string, Lister>> lists = {
        {"scenarios", list_scenarios}, {"domains", list_domains}, {"monitors", list_monitors},
        {"methods", list_methods},     {"time", list_time},       {"formats", list_formats},
        {"view", list_view},           {"output", list_output}};
    bool found = false;
    for (const auto& [name, lister] : lists)
        if (what.empty() || what == name) {
            if (found) std::cout << "\n";
            lister(catalogue);
            found = true;
        }
    if (!found) {
        std::vector<std::string> names;
        for (const auto& list : lists) names.push_back(list.first);
        throw InputError("unknown list '" + what + "'" + did_you_mean(what, names) +
                         "; allowed: " + join(names, ", "));
    }
    return 0;
}

int show_command(const Catalogue& catalogue, const std::string& name,
                 const std::vector<std::string>& settings, const ShowOptions& options) {
    ScenarioInput input = load_input(catalogue, name, settings);
    check_input(catalogue, input);
    check_domain(catalogue, input);
    check_data(catalogue, input);
    Scenario scenario = input.scenario;
    if (options.as_formula && scenario.monitor.type != "formula") {
        auto typed = with_formula(catalogue, scenario);
        if (!typed)
            throw InputError("--as-formula: monitor '" + scenario.monitor.type +
                             "' cannot be written as a formula");
        scenario = std::move(*typed);
    }
    scenario.modified = modified_keys(input.named, scenario);
    if (!scenario.modified.empty()) scenario = with_own_names(std::move(scenario));
    if (options.portable)
        scenario = with_packed_data(std::move(scenario));
    else if (!scenario.folder.empty())
        scenario = with_absolute_paths(std::move(scenario));
    std::cout << to_toml(scenario);
    return 0;
}

} // namespace gaspard
