// Setting one value of a scenario by its full key, from TOML or from a command line.
#include "core/base/check.hpp"
#include "core/scenario/catalogue.hpp"

#include <algorithm>
#include <functional>

namespace gaspard {

namespace {

// Names kept for what is to come: using one now is an error with a sentence of its own.
const std::vector<std::string> reserved = {"domain.target", "monitor.target", "pde", "time"};

bool starts_with_key(std::string_view key, std::string_view prefix) {
    return key == prefix ||
           (key.starts_with(prefix) && key.size() > prefix.size() && key[prefix.size()] == '.');
}

std::vector<std::string> all_keys(const Scenario& scenario) {
    std::vector<std::string> keys = {"domain.type", "monitor.type", "method.type"};
    for (const Values* values : {&scenario.domain.values, &scenario.monitor.values, &scenario.method.values,
                                 &scenario.view, &scenario.output})
        for (const auto& row : values->rows()) keys.push_back(values->section() + "." + row.key);
    return keys;
}

struct Target {
    Values* values = nullptr;   ///< the section's values
    Section* section = nullptr; ///< where the key is a type
    std::string key;
};

bool has_row(const std::vector<ParameterRow>& rows, std::string_view key) {
    return std::any_of(rows.begin(), rows.end(), [&](const ParameterRow& row) { return row.key == key; });
}

bool same_rows(const std::vector<ParameterRow>& a, const std::vector<ParameterRow>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
        return one.key == other.key && one.minimum == other.minimum && one.maximum == other.maximum &&
               one.default_value == other.default_value && one.unit == other.unit &&
               one.choices == other.choices;
    });
}

std::string list_keys(const Values& values) {
    std::string list;
    for (const auto& row : values.rows()) list += (list.empty() ? "" : ", ") + row.key;
    return list;
}

/// A key that another domain has, or the monitor on another domain: it is known, but has no meaning here.
void refuse_foreign_key(const Catalogue& catalogue, const Scenario& scenario, std::string_view full_key,
                        std::string_view section, std::string_view key) {
    const auto refuse = [&](const Values& here, const std::string& where) {
        throw InputError(std::string(full_key) + " has no meaning on domain '" + scenario.domain.type + "'" +
                         where + "; there are: " + list_keys(here));
    };
    if (section == "domain") {
        std::string owners;
        for (const auto& type : catalogue.domains)
            if (has_row(type.rows, key)) owners += (owners.empty() ? "'" : " and '") + type.name + "'";
        if (!owners.empty()) refuse(scenario.domain.values, ", it belongs to " + owners);
    }
    if (section == "monitor" && scenario.monitor.type != own_monitor)
        for (const auto kind : {SpaceKind::euclidean, SpaceKind::sphere})
            if (has_row(catalogue.monitor(scenario.monitor.type).rows({kind}), key))
                refuse(scenario.monitor.values, "");
}

Target locate(const Catalogue& catalogue, Scenario& scenario, std::string_view full_key) {
    for (const auto& name : reserved)
        if (starts_with_key(full_key, name))
            throw InputError(std::string(full_key) + ": " + name +
                             " is reserved and has no meaning for domain '" + scenario.domain.type + "'");
    const auto dot = full_key.find('.');
    const std::string_view section = full_key.substr(0, dot);
    const std::string key(dot == std::string_view::npos ? std::string_view() : full_key.substr(dot + 1));
    for (Section* typed : {&scenario.domain, &scenario.monitor, &scenario.method})
        if (section == typed->values.section()) {
            if (key == "type") return {nullptr, typed, key};
            if (typed->values.has(key)) return {&typed->values, nullptr, key};
        }
    for (Values* values : {&scenario.view, &scenario.output})
        if (section == values->section() && values->has(key)) return {values, nullptr, key};
    refuse_foreign_key(catalogue, scenario, full_key, section, key);
    throw InputError("unknown key " + std::string(full_key) + did_you_mean(full_key, all_keys(scenario)));
}

void set_type(const Catalogue& catalogue, Scenario& scenario, Section& section, const std::string& type) {
    if (&section == &scenario.domain) {
        section = domain_section(catalogue, type);
        follow_domain(catalogue, scenario);
    } else if (&section == &scenario.monitor)
        section = monitor_section(catalogue, type, space_of(catalogue, scenario));
    else {
        section = method_section(catalogue, type);
        follow_method(catalogue, type, scenario.view);
    }
}

/// Values that were chosen stay where the key is still there and allows them.
void keep_values(const Values& before, Values& now) {
    for (const auto& row : now.rows()) {
        if (!before.has(row.key) || is_default(before, row.key)) continue;
        try {
            now.set(row.key, before.at(row.key));
        } catch (const InputError&) { // not allowed here: the default stands
        }
    }
}

} // namespace

Space space_of(const Catalogue& catalogue, const Scenario& scenario) {
    return catalogue.domain(scenario.domain.type).space(scenario.domain.values);
}

void follow_domain(const Catalogue& catalogue, Scenario& scenario) {
    if (scenario.monitor.type == own_monitor) return; // its caller's business
    const Values before = scenario.monitor.values;
    Section section = monitor_section(catalogue, scenario.monitor.type, space_of(catalogue, scenario));
    if (same_rows(section.values.rows(), before.rows())) return;
    keep_values(before, section.values);
    scenario.monitor = std::move(section);
}

void follow_method(const Catalogue& catalogue, std::string_view method, Values& view) {
    Values now = view_section(catalogue, method);
    if (same_rows(now.rows(), view.rows())) return;
    keep_values(view, now);
    view = std::move(now);
}

void check_key(const Catalogue& catalogue, Scenario& scenario, std::string_view key) {
    locate(catalogue, scenario, key);
}

void set_value(const Catalogue& catalogue, Scenario& scenario, std::string_view key, const Value& value) {
    const Target target = locate(catalogue, scenario, key);
    if (target.values) return target.values->set(target.key, value);
    const auto* type = std::get_if<std::string>(&value);
    if (!type) throw InputError(std::string(key) + " wants a name, not '" + format_value(value) + "'");
    set_type(catalogue, scenario, *target.section, *type);
}

void apply_settings(const Catalogue& catalogue, Scenario& scenario,
                    const std::vector<std::string>& settings) {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const auto& setting : settings) {
        const auto equals = setting.find('=');
        if (equals == std::string::npos || equals == 0)
            throw InputError("--set wants key=value, not '" + setting + "'");
        pairs.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
    }
    std::stable_partition(pairs.begin(), pairs.end(),
                          [](const auto& pair) { return pair.first.ends_with(".type"); });
    for (const auto& [key, text] : pairs) {
        const Target target = locate(catalogue, scenario, key);
        if (target.section)
            set_type(catalogue, scenario, *target.section, text);
        else
            target.values->parse(target.key, text);
    }
}

} // namespace gaspard
