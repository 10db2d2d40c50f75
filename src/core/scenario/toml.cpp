#include "core/scenario/toml.hpp"

#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/base/user_path.hpp"
#include "core/base/utf8.hpp"
#include "core_assets.hpp"

#include <algorithm>
#include <cctype>
#include <deque>
#include <sstream>
#include <toml++/toml.h>

namespace gaspard {

namespace {

std::string place(const std::string& origin, const toml::source_region& source) {
    return origin + ":" + std::to_string(source.begin.line) + ": ";
}

Value to_value(const toml::node& node, const std::string& key) {
    if (const auto* real = node.as_floating_point()) return real->get();
    if (const auto* whole = node.as_integer()) return whole->get();
    if (const auto* boolean = node.as_boolean()) return boolean->get();
    if (const auto* text = node.as_string()) return text->get();
    throw InputError(key + " must be a single value, not a section or a list");
}

using Entries = std::deque<std::pair<std::string, const toml::node*>>;

/// The keys of a table. Tables in that of a monitor, a domain or the time, such as [monitor.u], are parts of
/// it, whose keys begin with their name; monitor.source is a section of its own.
void add_entries(Entries& entries, const toml::table& table, const std::string& section) {
    for (const auto& [key, node] : table) {
        const std::string name = section + "." + std::string(key.str());
        const bool has_parts =
            section.starts_with("monitor") || section.starts_with("domain") || section.starts_with("time");
        const auto* part = has_parts ? node.as_table() : nullptr;
        if (name == "monitor.source" && part) continue;
        if (part && !part->empty())
            add_entries(entries, *part, name);
        else
            entries.emplace_back(name, &node);
    }
}

/// Sets every key of one table, the types first, those of parts after those of what they belong to. Keys that
/// do not exist yet are postponed, because they may depend on the values of others. Errors name file and
/// line.
void read_section(const Catalogue& catalogue, Scenario& scenario, const toml::table& table,
                  const std::string& section, const std::string& origin, ScenarioSource& source) {
    Entries entries;
    add_entries(entries, table, section);
    const auto types = std::stable_partition(
        entries.begin(), entries.end(), [](const auto& entry) { return entry.first.ends_with(".type"); });
    std::stable_sort(entries.begin(), types, [](const auto& a, const auto& b) {
        return std::ranges::count(a.first, '.') < std::ranges::count(b.first, '.');
    });
    if (table.empty()) {
        try {
            check_section(scenario, section);
        } catch (const InputError& error) {
            throw InputError(place(origin, table.source()) + error.what());
        }
    }
    for (std::size_t waiting = 0; !entries.empty();) {
        const auto [key, node] = entries.front();
        entries.pop_front();
        if (!has_key(scenario, key) && waiting <= entries.size()) {
            ++waiting;
            entries.emplace_back(key, node);
            continue;
        }
        waiting = 0;
        try {
            check_key(catalogue, scenario, key); // has specific messages for reserved and unknown sections
            set_value_unlocated(catalogue, scenario, key, to_value(*node, key));
            source.lines[key] = node->source().begin.line;
        } catch (const InputError& error) {
            throw InputError(place(origin, node->source()) + error.what());
        }
    }
}

/// Throws InputError if TOML cannot hold the text, such as a path in another encoding.
std::string quoted(const std::string& text) {
    if (!is_utf8(text))
        throw InputError("'" + text +
                         "' is not text in UTF-8, as scenarios must be; rename the file if it is one");
    std::ostringstream out;
    out << toml::value<std::string>(text);
    return out.str();
}

// A real number keeps its decimal point, so that it is read back as a real number.
std::string toml_value(const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
    std::string number = format_value(value);
    if (std::holds_alternative<double>(value) && number.find_first_of(".en") == std::string::npos)
        number += ".0";
    return number;
}

void write_section(std::ostream& out, const std::string& type, const Values& values) {
    out << "\n[" << values.section() << "]\n";
    if (!type.empty()) out << "type = " << quoted(type) << "\n";
    for (const auto& row : values.rows()) {
        if (row.role == ParameterRole::motion && is_default(values, row.key)) continue; // it does not move
        out << row.key << " = " << toml_value(values.at(row.key)) << "\n";
    }
}

bool has_changes(const Values& values) {
    return std::ranges::any_of(values.rows(), [&](const auto& row) { return !is_default(values, row.key); });
}

/// What the parser says, without its own names and its story: "1e400 could not be interpreted as a value".
std::string in_short(std::string_view what) {
    what = what.substr(0, what.find(" (TOML"));
    if (const auto colon = what.find(": "); what.starts_with("Error while parsing") && colon != what.npos)
        what.remove_prefix(colon + 2);
    std::string text(what);
    if (!text.empty()) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

} // namespace

Scenario parse_scenario(const Catalogue& catalogue, std::string_view text, const std::string& origin,
                        ScenarioSource* source, const std::filesystem::path& folder) {
    ScenarioSource found{origin, {}};
    const std::vector<std::string> sections = {"domain", "method", "monitor", "pde",
                                               "time",   "view",   "output"};
    toml::table document;
    try {
        document = toml::parse(text, origin);
    } catch (const toml::parse_error& error) {
        throw InputError(place(origin, error.source()) +
                         "TOML syntax error: " + in_short(error.description()));
    }
    Scenario scenario = default_scenario(catalogue);
    scenario.name = std::filesystem::path(origin).stem().string();
    scenario.folder = folder; // before the sections: ranges of monitors depend on the patch in the file
    for (const auto& [key, node] : document) {
        const std::string name(key.str());
        try {
            if (name == "title" || name == "description") {
                if (!node.is_string()) throw InputError(name + " must be a string");
                (name == "title" ? scenario.title : scenario.description) = node.as_string()->get();
            } else if (std::find(sections.begin(), sections.end(), name) != sections.end()) {
                if (!node.is_table()) throw InputError(name + " is a section; write [" + name + "]");
            } else {
                auto known = sections;
                known.insert(known.end(), {"title", "description"});
                throw InputError("unknown section or key '" + name + "'" + did_you_mean(name, known));
            }
        } catch (const InputError& error) {
            throw InputError(place(origin, node.source()) + error.what());
        }
    }
    // Domain and method first: the available sections and rows depend on them.
    for (const auto& name : sections) {
        if (const auto* table = document[name].as_table())
            read_section(catalogue, scenario, *table, name, origin, found);
        if (name == "domain") locate_domain(catalogue, scenario);
        if (name != "monitor") continue;
        if (const auto* table = document[name]["source"].as_table())
            read_section(catalogue, scenario, *table, "monitor.source", origin, found);
    }
    if (source != nullptr) *source = std::move(found);
    return scenario;
}

Scenario load_scenario(const Catalogue& catalogue, const std::filesystem::path& file,
                       ScenarioSource* source) {
    return parse_scenario(catalogue, read_file(file, largest_scenario_file), file.string(), source,
                          file.parent_path());
}

std::string with_place(const ScenarioSource& source, const std::string& message) {
    const auto is_named = [&](const std::string& key) {
        const auto at = message.find(key);
        const auto after = at + key.size();
        return at != std::string::npos && (after == message.size() || message[after] == ' ' ||
                                           message[after] == ':' || message[after] == ',');
    };
    for (const auto& [key, line] : source.lines)
        if (is_named(key)) return source.name + ":" + std::to_string(line) + ": " + message;
    return message;
}

bool is_scenario_file(std::string_view name_or_file) { return has_extension(name_or_file, ".toml"); }

std::string to_toml(const Scenario& scenario) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << "title = " << quoted(scenario.title) << "\n";
    out << "description = " << quoted(scenario.description) << "\n";
    write_section(out, scenario.domain.type, scenario.domain.values);
    for (const Section* section : {&scenario.monitor, &scenario.source, &scenario.method, &scenario.pde})
        if (!section->values.section().empty()) write_section(out, section->type, section->values);
    if (has_changes(scenario.time)) write_section(out, {}, scenario.time);
    write_section(out, {}, scenario.view);
    write_section(out, {}, scenario.output);
    return out.str();
}

/// Natural order: alphabetical, with numbers compared by value (x8 before x16).
static bool comes_before(std::string_view a, std::string_view b) {
    const auto [at, bt] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    std::size_t begin = static_cast<std::size_t>(at - a.begin());
    const auto digit = [](std::string_view text, std::size_t i) {
        return i < text.size() && text[i] >= '0' && text[i] <= '9';
    };
    while (begin > 0 && digit(a, begin - 1)) --begin;
    const auto digits = [&](std::string_view text) {
        std::size_t count = 0;
        while (digit(text, begin + count)) ++count;
        return count;
    };
    const std::size_t ours = digits(a), theirs = digits(b);
    return ours > 0 && theirs > 0 && ours != theirs ? ours < theirs : a < b;
}

std::vector<BuiltinScenario> builtin_scenarios() {
    std::vector<BuiltinScenario> scenarios;
    constexpr std::string_view folder = "assets/scenarios/", ending = ".toml";
    for (const auto& file : core_assets::files())
        if (file.path.starts_with(folder) && file.path.ends_with(ending)) {
            std::string_view name = file.path.substr(folder.size());
            name.remove_suffix(ending.size());
            scenarios.push_back({name, file.bytes});
        }
    std::sort(scenarios.begin(), scenarios.end(),
              [](const auto& a, const auto& b) { return comes_before(a.name, b.name); });
    return scenarios;
}

Scenario find_scenario(const Catalogue& catalogue, const std::string& name_or_file, ScenarioSource* source) {
    if (name_or_file == "-")
        return parse_scenario(catalogue, read_file("/dev/stdin", largest_scenario_file), "stdin", source);
    std::vector<std::string> names;
    for (const auto& builtin : builtin_scenarios()) {
        if (builtin.name == name_or_file)
            return parse_scenario(catalogue, builtin.toml, name_or_file + ".toml", source);
        names.emplace_back(builtin.name);
    }
    if (is_scenario_file(name_or_file)) return load_scenario(catalogue, user_path(name_or_file), source);
    throw InputError("unknown scenario '" + name_or_file + "'" + did_you_mean(name_or_file, names) +
                     "; see `gaspard list scenarios`, or give a file whose name ends in .toml");
}

} // namespace gaspard
