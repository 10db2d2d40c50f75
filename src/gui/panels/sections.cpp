#include "gui/panels/sections.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

namespace {

template <class AnyScenario>
auto& find_section(AnyScenario& scenario, SectionKind kind) {
    switch (kind) {
    case SectionKind::domain:
        return scenario.domain;
    case SectionKind::monitor:
        return scenario.monitor;
    case SectionKind::source:
        return scenario.source;
    case SectionKind::method:
        return scenario.method;
    case SectionKind::pde:
        return scenario.pde;
    }
    check_failed("the section has a kind");
}

Section fresh_section(const Catalogue& catalogue, const Scenario& opened, SectionKind kind,
                      const std::string& type) {
    if (const Section& before = section_of(opened, kind); before.type == type) return before;
    switch (kind) {
    case SectionKind::domain:
        return domain_section(catalogue, type);
    case SectionKind::monitor:
        return monitor_section(catalogue, type); // with the plane's rows; update_rows() adapts them
    case SectionKind::source:
        return monitor_section(catalogue, type, {}, section_key(kind));
    case SectionKind::method:
        return method_section(catalogue, type);
    case SectionKind::pde:
        return pde_section(catalogue, type);
    }
    return {};
}

} // namespace

Section& section_of(Scenario& scenario, SectionKind kind) { return find_section(scenario, kind); }
const Section& section_of(const Scenario& scenario, SectionKind kind) { return find_section(scenario, kind); }

const char* section_key(SectionKind kind) {
    switch (kind) {
    case SectionKind::domain:
        return "domain";
    case SectionKind::monitor:
        return "monitor";
    case SectionKind::source:
        return "monitor.source";
    case SectionKind::method:
        return "method";
    case SectionKind::pde:
        return "pde";
    }
    return "";
}

std::vector<TypeEntry> type_entries(const Catalogue& catalogue, SectionKind kind) {
    std::vector<TypeEntry> entries;
    const auto add = [&](const auto& types) {
        for (const auto& type : types) entries.push_back({&type.name, &type.label, &type.help});
    };
    if (kind == SectionKind::domain)
        add(catalogue.domains);
    else if (kind == SectionKind::monitor || kind == SectionKind::source)
        add(catalogue.monitors);
    else if (kind == SectionKind::method)
        add(catalogue.methods);
    else
        add(catalogue.pdes);
    return entries;
}

std::string equation_of(const Catalogue& catalogue, SectionKind kind, const Section& section) {
    const auto among = [&](const auto& types) {
        for (const auto& type : types)
            if (type.name == section.type) return type.equation;
        return std::string();
    };
    if (kind == SectionKind::pde) return among(catalogue.pdes);
    if (kind != SectionKind::monitor && kind != SectionKind::source) return {};
    const ParameterRow* formula = find_role(section.values.rows(), ParameterRole::formula);
    const bool typed = formula != nullptr && section.type == "formula";
    return typed ? "m = " + section.values.text(formula->key) : among(catalogue.monitors);
}

const char* section_title(SectionKind kind) {
    switch (kind) {
    case SectionKind::domain:
        return "Domain";
    case SectionKind::monitor:
        return "Monitor";
    case SectionKind::source:
        return "Source density";
    case SectionKind::method:
        return "Method";
    case SectionKind::pde:
        return "PDE";
    }
    return "";
}

bool has_section(const Scenario& scenario, SectionKind kind) {
    return !section_of(scenario, kind).type.empty();
}

std::optional<Scenario> with_type(const Catalogue& catalogue, const Scenario& opened,
                                  const Scenario& scenario, SectionKind kind, const std::string& type) {
    Scenario changed = scenario;
    if (kind == SectionKind::method)
        set_method(catalogue, changed, fresh_section(catalogue, opened, kind, type));
    else
        section_of(changed, kind) = fresh_section(catalogue, opened, kind, type);
    update_typed_rows(catalogue, changed);
    if (find_capability(catalogue, changed)) return changed;
    if (kind != SectionKind::domain) return std::nullopt;
    const auto row = std::find_if(catalogue.capabilities.begin(), catalogue.capabilities.end(),
                                  [&](const Capability& one) { return one.domain == type; });
    if (row == catalogue.capabilities.end()) return std::nullopt;
    const auto adapt = [&](SectionKind other, const std::vector<std::string>& allowed) {
        const std::string& present = section_of(changed, other).type;
        if (allowed.empty() || std::find(allowed.begin(), allowed.end(), present) != allowed.end()) return;
        section_of(changed, other) = fresh_section(catalogue, opened, other, allowed.front());
    };
    adapt(SectionKind::monitor, row->monitors);
    adapt(SectionKind::method, row->methods);
    update_typed_rows(catalogue, changed);
    return find_capability(catalogue, changed) ? std::optional(std::move(changed)) : std::nullopt;
}

} // namespace gaspard
