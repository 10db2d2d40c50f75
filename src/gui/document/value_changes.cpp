#include "gui/document/value_changes.hpp"

#include "core/tessellate/ticks.hpp"

#include <cctype>
#include <map>
#include <set>
#include <string_view>

namespace gaspard {

namespace {

/// As a word within a sentence.
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

void add_changes(const char* name, const Section& before, const Section& after,
                 std::vector<ValueChange>& changes) {
    const std::string section(name);
    if (before.type != after.type) {
        changes.push_back({section + ".type", section, before.type, after.type});
        return;
    }
    for (const ParameterRow& row : after.values.rows()) {
        if (!before.values.has(row.key)) continue;
        const Value &old = before.values.at(row.key), &now = after.values.at(row.key);
        if (old == now) continue;
        changes.push_back({section + "." + row.key, uncapitalised(row.label), std::visit(ValueText{}, old),
                           std::visit(ValueText{}, now)});
    }
}

std::string monitor_label(const Catalogue& catalogue, const Scenario& scenario) {
    for (const MonitorType& type : catalogue.monitors)
        if (type.name == scenario.monitor.type) return type.label;
    return scenario.monitor.type;
}

} // namespace

std::vector<ValueChange> value_changes(const Scenario& before, const Scenario& after) {
    std::vector<ValueChange> changes;
    add_changes("domain", before.domain, after.domain, changes);
    add_changes("monitor", before.monitor, after.monitor, changes);
    add_changes("method", before.method, after.method, changes);
    return changes;
}

std::string describe_changes(const std::vector<ValueChange>& changes) {
    std::string text;
    for (const ValueChange& change : changes)
        text += (text.empty() ? "" : ", ") + change.label + " " + change.before + " to " + change.after;
    return text;
}

std::string describe_scenario(const Catalogue& catalogue, const Scenario& opened, const Scenario& scenario) {
    std::string text = monitor_label(catalogue, scenario);
    for (const ValueChange& change : value_changes(opened, scenario))
        if (change.key != "monitor.type") text += ", " + change.label + " " + change.after;
    return text;
}

namespace {

std::vector<std::string> parts_of(std::string_view text) {
    std::vector<std::string> parts;
    constexpr std::string_view between = ", ";
    for (std::size_t end = 0; (end = text.find(between)) != std::string_view::npos;
         text.remove_prefix(end + between.size()))
        parts.emplace_back(text.substr(0, end));
    parts.emplace_back(text);
    return parts;
}

} // namespace

std::vector<std::string> what_differs(const std::vector<std::string>& texts) {
    if (texts.size() < 2) return texts;
    std::map<std::string, std::size_t> holders; // how many texts have a part
    for (const std::string& text : texts) {
        const std::vector<std::string> parts = parts_of(text);
        for (const std::string& part : std::set<std::string>(parts.begin(), parts.end())) ++holders[part];
    }
    std::vector<std::string> found;
    for (const std::string& text : texts) {
        const std::vector<std::string> parts = parts_of(text);
        std::string rest;
        for (const std::string& part : parts)
            if (holders[part] < texts.size()) rest += (rest.empty() ? "" : ", ") + part;
        found.push_back(rest.empty() ? parts.front() : rest);
    }
    return found;
}

} // namespace gaspard
