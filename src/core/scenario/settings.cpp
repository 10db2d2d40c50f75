// Setting values of a scenario by their full keys, from TOML or the command line.
#include "core/base/check.hpp"
#include "core/base/growing_values.hpp"
#include "core/base/join.hpp"
#include "core/base/user_path.hpp"
#include "core/monitor/placement.hpp"
#include "core/scenario/catalogue.hpp"
#include "core/scenario/time_rows.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

// Sections that only some problems have, and names reserved for future sections. If a problem does not have
// the section, keys in it produce a specific error.
const std::vector<std::string> reserved = {"domain.target", "monitor.source", "pde"};

bool starts_with_key(std::string_view key, std::string_view prefix) {
    return key == prefix ||
           (key.starts_with(prefix) && key.size() > prefix.size() && key[prefix.size()] == '.');
}

/// The sections with a type in this scenario; monitor.source precedes monitor, which is a prefix of its name.
std::vector<Section*> typed_sections(Scenario& scenario) {
    std::vector<Section*> sections;
    for (Section* section :
         {&scenario.source, &scenario.domain, &scenario.monitor, &scenario.method, &scenario.pde})
        if (!section->type.empty()) sections.push_back(section);
    return sections;
}

std::vector<std::string> all_keys(Scenario& scenario) {
    std::vector<std::string> keys;
    const auto add = [&](const Values& values) {
        for (const auto& row : values.rows()) keys.push_back(values.section() + "." + row.key);
    };
    for (const Section* section : typed_sections(scenario)) {
        keys.push_back(section->values.section() + ".type");
        add(section->values);
    }
    add(scenario.time), add(scenario.view), add(scenario.output);
    return keys;
}

struct Target {
    Values* values = nullptr;   ///< the section's values
    Section* section = nullptr; ///< the section that the key belongs to; null for time, view and output
    std::string key;            ///< "type", or the key of a row
};

bool has_row(const std::vector<ParameterRow>& rows, std::string_view key) {
    return std::any_of(rows.begin(), rows.end(), [&](const ParameterRow& row) { return row.key == key; });
}

bool same_rows(const std::vector<ParameterRow>& a, const std::vector<ParameterRow>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
        return one.key == other.key && one.minimum == other.minimum && one.maximum == other.maximum &&
               one.default_value == other.default_value && one.unit == other.unit &&
               one.slider == other.slider && one.role == other.role && one.scale == other.scale &&
               one.origin == other.origin && one.measure == other.measure && one.choices == other.choices &&
               one.choice_labels == other.choice_labels;
    });
}

std::string list_keys(const Values& values) {
    std::vector<std::string_view> keys;
    for (const auto& row : values.rows()) keys.push_back(row.key);
    return join(keys, ", ");
}

void update_domain_rows(const Catalogue& catalogue, Section& domain);

/// The first choice of the domain's that brings a key, such as "domain.shape = file"; empty if none does.
std::string choice_with_key(const Catalogue& catalogue, const Section& domain, std::string_view key) {
    for (const ParameterRow& row : domain.values.rows())
        if (row.kind == ParameterKind::choice)
            for (const std::string& choice : row.choices) {
                Section other = domain;
                other.values.set(row.key, choice);
                update_domain_rows(catalogue, other);
                if (has_row(other.values.rows(), key)) return "domain." + row.key + " = " + choice;
            }
    return {};
}

/// Throws a specific InputError if the key belongs to another domain, or to this monitor on another domain.
void refuse_foreign_key(const Catalogue& catalogue, const Scenario& scenario, std::string_view full_key,
                        std::string_view section, std::string_view key) {
    const auto refuse = [&](const Values& here, const std::string& where) {
        throw InputError(std::string(full_key) + " is not a key for domain '" + scenario.domain.type + "'" +
                         where + "; available: " + list_keys(here));
    };
    if (section == "domain") {
        std::vector<std::string> owners;
        for (const auto& type : catalogue.domains)
            if (type.name != scenario.domain.type &&
                has_row(domain_section(catalogue, type.name).values.rows(), key))
                owners.push_back("'" + type.name + "'");
        if (const std::string choice = choice_with_key(catalogue, scenario.domain, key); !choice.empty())
            refuse(scenario.domain.values, " as it is set, but with " + choice);
        if (!owners.empty()) refuse(scenario.domain.values, ", but for " + join(owners, " and "));
    }
    if (section == "method") {
        std::vector<std::string> owners;
        for (const Capability& row : catalogue.capabilities)
            if (has_row(row.method_rows, key)) owners.push_back("'" + row.domain + "'");
        const bool own = std::count(owners.begin(), owners.end(), "'" + scenario.domain.type + "'") > 0;
        if (!owners.empty() && !own) // on its own domain it is for other methods
            refuse(scenario.method.values, ", but for " + join(owners, " and "));
    }
    if (section == "monitor" && scenario.monitor.type != own_monitor)
        for (const auto kind : {SpaceKind::euclidean, SpaceKind::sphere})
            if (has_row(catalogue.monitor(scenario.monitor.type).rows({kind}), key))
                refuse(scenario.monitor.values, "");
}

/// Accepts the keys of earlier versions (ParameterRow::former_key) as well.
std::optional<Target> find_target(Scenario& scenario, std::string_view full_key) {
    const auto key_in = [&](const Values& values) {
        const std::string& name = values.section();
        if (!starts_with_key(full_key, name) || full_key.size() == name.size()) return std::string();
        return std::string(full_key.substr(name.size() + 1));
    };
    for (Section* section : typed_sections(scenario)) {
        const std::string key = key_in(section->values);
        if (key == "type") return Target{&section->values, section, key};
        if (const std::string present = present_key(section->values.rows(), key); !present.empty())
            return Target{&section->values, section, present};
    }
    for (Values* values : {&scenario.time, &scenario.view, &scenario.output})
        if (const std::string key = present_key(values->rows(), key_in(*values)); !key.empty())
            return Target{values, nullptr, key};
    return std::nullopt;
}

Target locate(const Catalogue& catalogue, Scenario& scenario, std::string_view full_key) {
    check_section(scenario, full_key);
    if (auto target = find_target(scenario, full_key)) return *target;
    const auto dot = full_key.find('.');
    const std::string_view section = full_key.substr(0, dot);
    const std::string key(dot == std::string_view::npos ? std::string_view() : full_key.substr(dot + 1));
    refuse_foreign_key(catalogue, scenario, full_key, section, key);
    throw InputError("unknown key " + std::string(full_key) + did_you_mean(full_key, all_keys(scenario)));
}

void set_type(const Catalogue& catalogue, Scenario& scenario, Section& section, const std::string& type) {
    const std::string name = section.values.section();
    if (&section == &scenario.method) {
        set_method(catalogue, scenario, method_section(catalogue, type));
        return;
    }
    if (&section == &scenario.domain)
        section = domain_section(catalogue, type);
    else if (&section == &scenario.pde)
        section = pde_section(catalogue, type);
    else
        section = monitor_section(catalogue, type, space_of(catalogue, scenario), name);
    update_rows(catalogue, scenario);
    if ((&section == &scenario.source || &section == &scenario.pde) && section.type != type)
        throw InputError(name + ".type = " + type + " is not possible on domain '" + scenario.domain.type +
                         "' with method '" + scenario.method.type + "'");
}

/// Copies values that differ from the default, if the key still exists and allows them; on a domain of
/// another size, lengths and places are scaled.
void carry_over(const Values& before, Values& after) {
    for (const auto& row : after.rows()) {
        if (!before.has(row.key) || is_default(before, row.key)) continue;
        const auto& rows = before.rows();
        const auto old = std::find_if(rows.begin(), rows.end(),
                                      [&](const ParameterRow& one) { return one.key == row.key; });
        Value value = before.at(row.key);
        if (auto* real = std::get_if<double>(&value)) *real = transferred(*old, row, *real);
        try {
            after.set(row.key, value);
        } catch (const InputError&) { // out of the new range: keep the default
        }
    }
}

void update_monitor_rows(const Catalogue& catalogue, const Space& space, Section& section) {
    if (section.type.empty() || section.type == own_monitor) return;
    const MonitorType& type = catalogue.monitor(section.type);
    const std::string name = section.values.section();
    Values values = grown_values(
        name, rows_on(type, space), [&](const Values& known) { return further_rows_on(type, known, space); },
        [&](Values& known) { carry_over(section.values, known); });
    if (!same_rows(values.rows(), section.values.rows())) section.values = std::move(values);
}

void update_domain_rows(const Catalogue& catalogue, Section& domain) {
    const DomainType& type = catalogue.domain(domain.type);
    if (!type.further_rows) return;
    Values values = grown_values("domain", type.rows, type.further_rows,
                                 [&](Values& known) { carry_over(domain.values, known); });
    if (!same_rows(values.rows(), domain.values.rows())) domain.values = std::move(values);
}

void update_method_rows(const Catalogue& catalogue, const Section& domain, Section& method) {
    const auto type = std::ranges::find(catalogue.methods, method.type, &MethodType::name);
    if (type == catalogue.methods.end()) return; // the run will refuse it
    Values values = default_values(*type, method_rows_on(catalogue, domain.type, method.type));
    if (same_rows(values.rows(), method.values.rows())) return;
    carry_over(method.values, values);
    method.values = std::move(values);
}

/// There is a motion for every real parameter of the monitor.
void update_time_rows(Scenario& scenario) {
    Values now("time", time_rows(scenario.monitor.values.rows()));
    if (same_rows(now.rows(), scenario.time.rows())) return;
    carry_over(scenario.time, now);
    scenario.time = std::move(now);
}

/// A path on the command line is relative to the working directory, also if the scenario has a folder.
std::string working_path(const Scenario& scenario, const Values& values, const std::string& key,
                         const std::string& text) {
    const auto row = std::find_if(values.rows().begin(), values.rows().end(),
                                  [&](const ParameterRow& one) { return one.key == key; });
    const bool file = row != values.rows().end() && row->role == ParameterRole::file;
    return file && is_path(text) && !scenario.folder.empty()
               ? std::filesystem::absolute(user_path(text)).string()
               : text;
}

/// Adds, keeps or removes a section that only some domains and methods have; `offered`: its possible types.
template <class Make>
void update_optional(Section& section, const std::vector<std::string>& offered, const Make& make) {
    if (offered.empty())
        section = {};
    else if (std::find(offered.begin(), offered.end(), section.type) == offered.end())
        section = make(offered.front());
}

} // namespace

/// Whether the domain has files, with the values that it has now.
static bool has_files(const Catalogue& catalogue, const Scenario& scenario) {
    return catalogue.domain(scenario.domain.type).read &&
           find_role(scenario.domain.values.rows(), ParameterRole::file) != nullptr;
}

/// All that DomainType::read may depend on.
static std::string files_key(const Scenario& scenario) {
    std::string key = scenario.domain.type + '\n' + scenario.folder.string();
    for (const ParameterRow& row : scenario.domain.values.rows())
        if (row.role == ParameterRole::file || row.role == ParameterRole::patch)
            key += '\n' + scenario.domain.values.text(row.key);
    return key;
}

/// The place as far as it is known without reading: while another file is not read yet, that of the one
/// before.
static DomainPlace known_place(const Catalogue& catalogue, const Scenario& scenario) {
    const DomainType& type = catalogue.domain(scenario.domain.type);
    if (!has_files(catalogue, scenario)) return {{}, {}, type.space(scenario.domain.values, {})};
    DomainPlace place = scenario.place;
    if (place.files == files_key(scenario))
        place.space = type.space(scenario.domain.values, place.content);
    else if (!place.files.starts_with(scenario.domain.type + '\n'))
        place = {{}, {}, type.space(scenario.domain.values, {})};
    return place;
}

Space space_of(const Catalogue& catalogue, const Scenario& scenario) {
    return known_place(catalogue, scenario).space;
}

Space source_space_of(const Catalogue& catalogue, const Scenario& scenario) {
    const DomainType& type = catalogue.domain(scenario.domain.type);
    return type.source_space ? type.source_space(scenario.domain.values, scenario.place.content)
                             : space_of(catalogue, scenario);
}

bool is_located(const Catalogue& catalogue, const Scenario& scenario) {
    return !has_files(catalogue, scenario) || scenario.place.files == files_key(scenario);
}

void locate_domain(const Catalogue& catalogue, Scenario& scenario) {
    if (is_located(catalogue, scenario)) return;
    scenario.place.content =
        catalogue.domain(scenario.domain.type).read(scenario.domain.values, scenario.folder);
    scenario.place.files = files_key(scenario);
    update_rows(catalogue, scenario);
}

/// `update(section, space)` updates the rows of a section of monitors.
template <class Update>
static void update_sections(const Catalogue& catalogue, Scenario& scenario, const Update& update) {
    update_domain_rows(catalogue, scenario.domain);
    update_method_rows(catalogue, scenario.domain, scenario.method);
    scenario.place = known_place(catalogue, scenario);
    const Space of_source = source_space_of(catalogue, scenario);
    std::vector<std::string> sources, pdes;
    for (const Capability& row : catalogue.capabilities) {
        if (row.domain != scenario.domain.type) continue;
        if (std::find(row.methods.begin(), row.methods.end(), scenario.method.type) == row.methods.end())
            continue;
        sources.insert(sources.end(), row.sources.begin(), row.sources.end());
        pdes.insert(pdes.end(), row.pdes.begin(), row.pdes.end());
    }
    update_optional(scenario.source, sources, [&](const std::string& type) {
        return monitor_section(catalogue, type, of_source, "monitor.source");
    });
    update_optional(scenario.pde, pdes,
                    [&](const std::string& type) { return pde_section(catalogue, type); });
    update(scenario.monitor, scenario.place.space);
    update(scenario.source, of_source);
    update_time_rows(scenario);
    update_view_rows(catalogue, scenario, scenario.view);
}

void update_rows(const Catalogue& catalogue, Scenario& scenario) {
    update_sections(catalogue, scenario, [&](Section& section, const Space& space) {
        update_monitor_rows(catalogue, space, section);
    });
}

void update_typed_rows(const Catalogue& catalogue, Scenario& scenario) {
    update_sections(catalogue, scenario, [&](Section& section, const Space& space) {
        try {
            update_monitor_rows(catalogue, space, section);
        } catch (const InputError&) { // keep the rows
        }
    });
}

void set_method(const Catalogue& catalogue, Scenario& scenario, Section method) {
    const Section before = std::exchange(scenario.method, std::move(method));
    update_typed_rows(catalogue, scenario);
    for (const ParameterRow& row : method_rows_on(catalogue, scenario.domain.type, scenario.method.type))
        if (before.values.has(row.key)) scenario.method.values.set(row.key, before.values.at(row.key));
}

/// The rows' ranges as monitor.ranges.
static std::string written_ranges(const std::vector<ParameterRow>& rows) {
    std::vector<std::string> ranges;
    for (const ParameterRow& row : rows)
        ranges.push_back(row.key + " " + format_number(row.minimum) + " " + format_number(row.maximum) +
                         (row.scale == ParameterScale::logarithmic ? " log" : ""));
    return join(ranges, ", ");
}

std::optional<Scenario> with_formula(const Catalogue& catalogue, const Scenario& scenario) {
    if (scenario.monitor.type.empty() || scenario.monitor.type == own_monitor) return std::nullopt;
    const MonitorType& type = catalogue.monitor(scenario.monitor.type);
    if (!type.formula) return std::nullopt;
    const Values& before = scenario.monitor.values;
    Scenario changed = scenario;
    set_value_unlocated(catalogue, changed, "monitor.type", std::string("formula"));
    const std::string expression = type.formula(space_of(catalogue, scenario));
    set_value_unlocated(catalogue, changed, "monitor.expression", expression);
    set_value_unlocated(catalogue, changed, "monitor.ranges", written_ranges(before.rows()));
    for (const ParameterRow& row : before.rows())
        if (has_key(changed, "monitor." + row.key)) // a formula need not use all, such as a third coordinate
            set_value_unlocated(catalogue, changed, "monitor." + row.key, before.at(row.key));
    for (const ParameterRow& row :
         scenario.time.rows()) // they were left out while the formula was another one
        if (row.role == ParameterRole::motion && changed.time.has(row.key))
            changed.time.set(row.key, scenario.time.at(row.key));
    return changed;
}

void update_view_rows(const Catalogue& catalogue, const Scenario& scenario, Values& view) {
    const auto known = [](const auto& types, const std::string& name) {
        return std::any_of(types.begin(), types.end(), [&](const auto& type) { return type.name == name; });
    };
    const std::string& monitor = scenario.monitor.type;
    if (!known(catalogue.methods, scenario.method.type) ||
        (monitor != own_monitor && !known(catalogue.monitors, monitor)))
        return; // the run will refuse it
    Values now = view_section(catalogue, scenario.method.type, monitor);
    if (same_rows(now.rows(), view.rows())) return;
    carry_over(view, now);
    view = std::move(now);
}

void check_key(const Catalogue& catalogue, Scenario& scenario, std::string_view key) {
    locate(catalogue, scenario, key);
}

void check_section(Scenario& scenario, std::string_view key) {
    const auto sections = typed_sections(scenario);
    const auto present = [&](const std::string& name) {
        return std::any_of(sections.begin(), sections.end(), [&](const Section* section) {
            const auto& rows = section->values.rows();
            return section->values.section() == name ||
                   std::any_of(rows.begin(), rows.end(), [&](const ParameterRow& row) { // a part of a section
                       return starts_with_key(section->values.section() + "." + row.key, name);
                   });
        });
    };
    for (const auto& name : reserved)
        if (starts_with_key(key, name) && !present(name))
            throw InputError((key == name ? "" : std::string(key) + ": ") + name +
                             " is reserved and not available for domain '" + scenario.domain.type + "'");
}

bool has_key(Scenario& scenario, std::string_view key) { return find_target(scenario, key).has_value(); }

void set_value(const Catalogue& catalogue, Scenario& scenario, std::string_view key, const Value& value) {
    set_value_unlocated(catalogue, scenario, key, value);
    locate_domain(catalogue, scenario);
}

void set_value_unlocated(const Catalogue& catalogue, Scenario& scenario, std::string_view key,
                         const Value& value) {
    const Target target = locate(catalogue, scenario, key);
    if (target.section && target.key == "type") {
        const auto* type = std::get_if<std::string>(&value);
        if (!type) throw InputError(std::string(key) + " must be a name, not '" + format_value(value) + "'");
        Scenario changed = scenario;
        set_type(catalogue, changed, *find_target(changed, key)->section, *type);
        scenario = std::move(changed);
        return;
    }
    Scenario changed = scenario; // update_rows may throw; then nothing changes
    const Target there = *find_target(changed, key);
    there.values->set(there.key, value);
    if (there.section) update_rows(catalogue, changed);
    scenario = std::move(changed);
}

/// Types first, of which the domain and the method decide what else there is; then the domain, to which
/// ranges and values of the monitor refer.
static int order_of_key(std::string_view key) {
    if (key == "domain.type") return 0;
    if (key == "method.type") return 1;
    if (key.ends_with(".type")) return 2;
    return key.starts_with("domain.") ? 3 : 4;
}

void apply_settings(const Catalogue& catalogue, Scenario& scenario,
                    const std::vector<std::string>& settings) {
    std::deque<std::pair<std::string, std::string>> pairs;
    for (const auto& setting : settings) {
        const auto equals = setting.find('=');
        if (equals == std::string::npos || equals == 0)
            throw InputError("--set must be key=value, not '" + setting + "'");
        pairs.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const auto& one, const auto& other) {
        return order_of_key(one.first) < order_of_key(other.first);
    });
    // Some keys exist only after another one is set (the constants of a formula); they are postponed.
    for (std::size_t waiting = 0; !pairs.empty();) {
        auto [key, text] = std::move(pairs.front());
        pairs.pop_front();
        if (!has_key(scenario, key) &&
            waiting <= pairs.size()) { // once round, so that an error names the first
            ++waiting;
            pairs.emplace_back(std::move(key), std::move(text));
            continue;
        }
        waiting = 0;
        if (!key.starts_with("domain.")) locate_domain(catalogue, scenario);
        const Target target = locate(catalogue, scenario, key);
        if (target.section && target.key == "type") {
            set_type(catalogue, scenario, *target.section, text);
        } else {
            target.values->parse(target.key, working_path(scenario, *target.values, target.key, text));
            if (target.section) update_rows(catalogue, scenario);
        }
    }
    locate_domain(catalogue, scenario);
}

} // namespace gaspard
