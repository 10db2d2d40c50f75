#include "gui/document/value_changes.hpp"

#include "core/base/join.hpp"
#include "core/tessellate/ticks.hpp"

#include <cctype>
#include <map>
#include <set>
#include <string_view>

namespace gaspard {

namespace {

/// A label as it is written within a sentence.
std::string uncapitalised(std::string text) {
    const bool abbreviation = text.size() > 1 && std::isupper(static_cast<unsigned char>(text[1])) != 0;
    if (!text.empty() && !abbreviation)
        text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
    return text;
}

struct ValueText {
    std::string operator()(double value) const { return short_number(value, 6); }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(bool value) const { return value ? "on" : "off"; }
    std::string operator()(const std::string& value) const { return value; }
};

void add_changes(const std::string& section, const Values& before, const Values& after,
                 std::vector<ValueChange>& changes) {
    for (const ParameterRow& row : after.rows()) {
        if (!before.has(row.key)) continue;
        const Value &old = before.at(row.key), &now = after.at(row.key);
        if (old == now) continue;
        changes.push_back({section + "." + row.key, uncapitalised(row.label), std::visit(ValueText{}, old),
                           std::visit(ValueText{}, now)});
    }
}

void add_changes(const std::string& section, const Section& before, const Section& after,
                 std::vector<ValueChange>& changes) {
    if (before.type != after.type)
        changes.push_back({section + ".type", section, before.type, after.type});
    else
        add_changes(section, before.values, after.values, changes);
}

std::string monitor_label(const Catalogue& catalogue, const Scenario& scenario) {
    for (const MonitorType& type : catalogue.monitors)
        if (type.name == scenario.monitor.type) return type.label;
    return scenario.monitor.type;
}

/// The data of a monitor by the name of their file, without its folder; empty if they have none.
std::string data_name(const Values& monitor) {
    const ParameterRow* row = find_role(monitor.rows(), ParameterRole::file);
    if (!row) return {};
    const std::string& path = monitor.text(row->key);
    return path.starts_with("data:") ? std::string() : path.substr(path.find_last_of("/:") + 1);
}

} // namespace

std::vector<ValueChange> value_changes(const Scenario& before, const Scenario& after) {
    std::vector<ValueChange> changes;
    add_changes("domain", before.domain, after.domain, changes);
    add_changes("monitor", before.monitor, after.monitor, changes);
    add_changes("monitor.source", before.source, after.source, changes);
    add_changes("method", before.method, after.method, changes);
    add_changes("pde", before.pde, after.pde, changes);
    return changes;
}

std::vector<ValueChange> scenario_changes(const Scenario& before, const Scenario& after) {
    std::vector<ValueChange> changes = value_changes(before, after);
    add_changes("output", before.output, after.output, changes);
    return changes;
}

std::vector<ValueChange> section_changes(const std::string& section, const Values& before,
                                         const Values& after) {
    std::vector<ValueChange> changes;
    add_changes(section, before, after, changes);
    return changes;
}

std::string name_changes(const std::vector<ValueChange>& changes) {
    if (changes.size() > 3) return std::to_string(changes.size()) + " values";
    std::vector<std::string> names;
    for (const ValueChange& change : changes)
        names.push_back(change.label + (change.key.ends_with(".type") ? " type" : ""));
    return join(names, ", ");
}

std::string describe_scenario(const Catalogue& catalogue, const Scenario& opened, const Scenario& scenario) {
    std::vector<std::string> texts = {monitor_label(catalogue, scenario)};
    const Values& monitor = scenario.monitor.values;
    const ParameterRow* file = find_role(monitor.rows(), ParameterRole::file);
    if (const std::string data = data_name(monitor); data != data_name(opened.monitor.values))
        if (!data.empty()) texts.front() += " " + data;
    for (const ValueChange& change : value_changes(opened, scenario))
        if (change.key != "monitor.type" && !(file && change.key == "monitor." + file->key))
            texts.push_back(change.label + " " + change.after);
    return join(texts, ", ");
}

std::vector<std::string> what_differs(const std::vector<std::string>& texts) {
    if (texts.size() < 2) return texts;
    std::map<std::string_view, std::size_t> holders; // how many texts have a part
    for (const std::string& text : texts) {
        const auto parts = split(text, ", ");
        for (const std::string_view part : std::set<std::string_view>(parts.begin(), parts.end()))
            ++holders[part];
    }
    std::vector<std::string> found;
    for (const std::string& text : texts) {
        const auto parts = split(text, ", ");
        std::vector<std::string_view> rest;
        for (const std::string_view part : parts)
            if (holders[part] < texts.size()) rest.push_back(part);
        found.push_back(rest.empty() ? std::string(parts.front()) : join(rest, ", "));
    }
    return found;
}

} // namespace gaspard
