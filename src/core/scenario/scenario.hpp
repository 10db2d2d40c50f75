// A scenario describes what to solve, as plain data. It is complete, and every value is checked against its
// row; `gaspard list` shows all keys with their ranges. Scenarios are made by default_scenario() or
// find_scenario() and changed by set_value().
#pragma once

#include "core/base/export.hpp"
#include "core/base/parameter.hpp"
#include "core/mesh/space.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace gaspard GASPARD_API {

/// A section whose rows depend on its type: domain, monitor, monitor.source, method, pde.
struct Section {
    std::string type; ///< empty: the problem has no such section
    Values values;
    friend bool operator==(const Section&, const Section&) = default;
};

/// Where a domain lies, and what its files hold; kept by locate_domain() and update_rows(), so that a file is
/// read once for its name. It follows from the other values, so that any two are equal.
struct DomainPlace {
    std::string files;                     ///< the values that name the files
    std::shared_ptr<const void> content{}; ///< DomainType::read
    Space space;
    friend bool operator==(const DomainPlace&, const DomainPlace&) { return true; }
};

struct Scenario {
    std::string name;        ///< "plane-ring"; for a file its name without extension
    std::string title;       ///< one line, shown to the user
    std::string description; ///< one line
    Section domain, monitor, method;
    Section source{}; ///< "monitor.source": the density on the source domain
    Section pde{};    ///< "pde": the PDE that is solved on the mesh
    Values view, output;
    Values time{}; ///< when the monitor moves, and how; no rows: it does not
    /// Base of relative paths among the values (ParameterRole::file): the folder of the scenario's file;
    /// empty: the working directory.
    std::filesystem::path folder{};
    DomainPlace place{};
    /// The keys that were changed since name and title were given; see modified_keys(). Whoever changes
    /// values sets it; it is not checked.
    std::vector<std::string> modified{};
    friend bool operator==(const Scenario&, const Scenario&) = default;
};

/// The keys of domain, monitor, method, PDE and time whose values in `scenario` differ from those in `named`:
/// "monitor.amplitude", or "monitor.type" alone if the types differ. View and output do not count.
std::vector<std::string> modified_keys(const Scenario& named, const Scenario& scenario);

/// The title, or the name if there is none; followed by " (modified)" if the scenario was modified.
std::string scenario_title(const Scenario& scenario);
/// A name for files and folders: "plane-ring", or "plane-ring-modified" if the scenario was modified.
std::string scenario_stem(const Scenario& scenario);

} // namespace GASPARD_API
