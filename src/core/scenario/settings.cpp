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

Target locate(Scenario& scenario, std::string_view full_key) {
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
    throw InputError("unknown key " + std::string(full_key) + did_you_mean(full_key, all_keys(scenario)));
}

void set_type(const Catalogue& catalogue, Scenario& scenario, Section& section, const std::string& type) {
    if (&section == &scenario.domain)
        section = domain_section(catalogue, type);
    else if (&section == &scenario.monitor)
        section = monitor_section(catalogue, type);
    else
        section = method_section(catalogue, type);
}

} // namespace

void check_key(Scenario& scenario, std::string_view key) { locate(scenario, key); }

void set_value(const Catalogue& catalogue, Scenario& scenario, std::string_view key, const Value& value) {
    const Target target = locate(scenario, key);
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
        const Target target = locate(scenario, key);
        if (target.section)
            set_type(catalogue, scenario, *target.section, text);
        else
            target.values->parse(target.key, text);
    }
}

} // namespace gaspard
