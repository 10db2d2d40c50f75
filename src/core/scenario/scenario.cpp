#include "core/scenario/scenario.hpp"

#include "core/base/error.hpp"
#include "core/base/user_path.hpp"

#include <string_view>
#include <system_error>

namespace gaspard {

namespace {

/// The file that a path names; the text itself if it is no path, or cannot be resolved.
std::string named_file(const std::string& text, const std::filesystem::path& folder) {
    if (!is_path(text)) return text;
    try {
        std::error_code failed;
        const auto file = std::filesystem::absolute(user_path(text, folder), failed);
        return failed ? text : file.lexically_normal().string();
    } catch (const InputError&) { // no home folder
        return text;
    }
}

/// A section, and the base of its paths.
struct Place {
    const Section& section;
    const std::filesystem::path& folder;
};

/// Paths are equal if they name the same file: a scenario is saved with absolute ones.
bool same_value(const Place& named, const Place& now, const ParameterRow& row) {
    if (!named.section.values.has(row.key)) // a motion comes with a parameter of another monitor
        return row.role == ParameterRole::motion && is_default(now.section.values, row.key);
    const Value &one = named.section.values.at(row.key), &other = now.section.values.at(row.key);
    const auto *text = std::get_if<std::string>(&one), *other_text = std::get_if<std::string>(&other);
    if (row.role != ParameterRole::file || !text || !other_text) return one == other;
    return named_file(*text, named.folder) == named_file(*other_text, now.folder);
}

void add_modified(const Place& place_of_named, const Place& place, std::vector<std::string>& keys) {
    const Section &named = place_of_named.section, &now = place.section;
    const std::string& section = (now.type.empty() ? named : now).values.section();
    if (named.type != now.type) {
        keys.push_back(section + ".type");
        return;
    }
    for (const ParameterRow& row : now.values.rows())
        if (!same_value(place_of_named, place, row)) keys.push_back(section + "." + row.key);
}

/// Once is enough, also for a scenario that was saved and modified again.
std::string with_ending(std::string text, std::string_view ending, bool modified) {
    if (modified && !text.ends_with(ending)) text += ending;
    return text;
}

} // namespace

std::vector<std::string> modified_keys(const Scenario& named, const Scenario& scenario) {
    std::vector<std::string> keys;
    for (const auto section :
         {&Scenario::domain, &Scenario::monitor, &Scenario::source, &Scenario::method, &Scenario::pde})
        add_modified({named.*section, named.folder}, {scenario.*section, scenario.folder}, keys);
    add_modified({{"", named.time}, {}}, {{"", scenario.time}, {}}, keys);
    return keys;
}

std::string scenario_title(const Scenario& scenario) {
    return with_ending(scenario.title.empty() ? scenario.name : scenario.title, " (modified)",
                       !scenario.modified.empty());
}

std::string scenario_stem(const Scenario& scenario) {
    return with_ending(scenario.name, "-modified", !scenario.modified.empty());
}

} // namespace gaspard
