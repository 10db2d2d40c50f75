// The sections of a scenario as the panels show them: their titles, their types, and how one type replaces
// another.
#pragma once

#include "core/scenario/catalogue.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gaspard {

enum class SectionKind { domain, monitor, source, method, pde };
/// From the problem to how it is solved, as the panel shows them.
inline constexpr SectionKind all_sections[] = {SectionKind::domain, SectionKind::pde, SectionKind::monitor,
                                               SectionKind::source, SectionKind::method};

/// "Domain", as a heading.
const char* section_title(SectionKind kind);
/// "monitor.source", as in the keys of values.
const char* section_key(SectionKind kind);
/// Whether the scenario has such a section; source and pde are there only for some problems.
bool has_section(const Scenario& scenario, SectionKind kind);
Section& section_of(Scenario& scenario, SectionKind kind);
const Section& section_of(const Scenario& scenario, SectionKind kind);

/// An entry in a list of types.
struct TypeEntry {
    const std::string *name, *label, *help;
};
/// The types that a section may have, in the order of the catalogue, which owns the texts.
std::vector<TypeEntry> type_entries(const Catalogue& catalogue, SectionKind kind);

/// The equation of the section's type with the symbols of its rows; of a typed formula that formula. Empty if
/// it has none.
std::string equation_of(const Catalogue& catalogue, SectionKind kind, const Section& section);

/// `scenario` with another type in one section; nothing if it cannot be combined with the other sections.
/// With another domain, a monitor or method that does not fit is replaced by the first one that does.
std::optional<Scenario> with_type(const Catalogue& catalogue, const Scenario& opened,
                                  const Scenario& scenario, SectionKind kind, const std::string& type);

} // namespace gaspard
