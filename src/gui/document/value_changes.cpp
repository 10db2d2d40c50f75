#include "gui/document/value_changes.hpp"

#include "core/base/join.hpp"
#include "gui/base/value_text.hpp"

#include <cctype>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace gaspard {

namespace {

/// A label as it is written within a sentence.
std::string uncapitalised(std::string text) {
    const bool abbreviation = text.size() > 1 && std::isupper(static_cast<unsigned char>(text[1])) != 0;
    if (!text.empty() && !abbreviation)
        text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
    return text;
}

/// "Amplitude A = 20", "Boundary: walls"; of long texts, such as lists of points, only that they have
/// changed.
std::string name_of(const ParameterRow& row, const Value& value) {
    const std::string text = value_text(row, value);
    const bool number = std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value);
    if (number) return row.label + (row.symbol.empty() ? "" : " " + row.symbol) + " = " + text;
    constexpr std::size_t longest = 48;
    if (text.size() > longest || text.find(", ") != std::string::npos) return row.label + " changed";
    return row.label + ": " + text;
}

template <class Types>
std::string label_among(const Types& types, const std::string& name) {
    for (const auto& type : types)
        if (type.name == name) return type.label;
    return name;
}

/// Of the type of a section.
std::string type_label(const Catalogue& catalogue, const std::string& key, const std::string& name) {
    if (key == "domain.type") return label_among(catalogue.domains, name);
    if (key == "method.type") return label_among(catalogue.methods, name);
    if (key == "pde.type") return label_among(catalogue.pdes, name);
    return label_among(catalogue.monitors, name);
}

void add_changes(const std::string& section, const Values& before, const Values& after,
                 std::vector<ValueChange>& changes) {
    for (const ParameterRow& row : after.rows()) {
        if (!before.has(row.key)) continue;
        const Value &old = before.at(row.key), &now = after.at(row.key);
        if (old == now) continue;
        changes.push_back({section + "." + row.key, uncapitalised(row.label), value_text(row, old),
                           value_text(row, now), name_of(row, old), name_of(row, now)});
    }
}

void add_changes(const std::string& section, const Section& before, const Section& after,
                 std::vector<ValueChange>& changes) {
    if (before.type != after.type)
        changes.push_back({section + ".type", section, before.type, after.type});
    else
        add_changes(section, before.values, after.values, changes);
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
    add_changes("time", before.time, after.time, changes);
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

static std::vector<std::string> names_of(const Catalogue& catalogue, const std::vector<ValueChange>& changes,
                                         std::string ValueChange::*value, std::string ValueChange::*name) {
    std::vector<std::string> names;
    for (const ValueChange& change : changes)
        names.push_back(change.key.ends_with(".type") ? type_label(catalogue, change.key, change.*value)
                                                      : change.*name);
    return names;
}

std::vector<std::string> names_after(const Catalogue& catalogue, const std::vector<ValueChange>& changes) {
    return names_of(catalogue, changes, &ValueChange::after, &ValueChange::name_after);
}

std::vector<std::string> names_before(const Catalogue& catalogue, const std::vector<ValueChange>& changes) {
    return names_of(catalogue, changes, &ValueChange::before, &ValueChange::name_before);
}

std::string describe_scenario(const Catalogue& catalogue, const Scenario& opened, const Scenario& scenario) {
    std::vector<std::string> texts = {label_among(catalogue.monitors, scenario.monitor.type)};
    const Values& monitor = scenario.monitor.values;
    const ParameterRow* file = find_role(monitor.rows(), ParameterRole::file);
    if (const std::string data = data_name(monitor); data != data_name(opened.monitor.values))
        if (!data.empty()) texts.front() += " " + data;
    std::vector<ValueChange> changes = value_changes(opened, scenario);
    std::erase_if(changes, [&](const ValueChange& change) {
        return change.key == "monitor.type" || (file && change.key == "monitor." + file->key);
    });
    for (std::string& name : names_after(catalogue, changes)) texts.push_back(std::move(name));
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
