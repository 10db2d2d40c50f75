// All there is to choose from, and what goes with what: one table of capabilities (domain x boundary x
// monitor x method). The window greys out from it, the command line validates against it. A catalogue is a
// value: tests add fixtures to a copy.
#pragma once

#include "core/mesh/discretisation.hpp"
#include "core/mesh/domain_type.hpp"
#include "core/method/method.hpp"
#include "core/monitor/monitor.hpp"
#include "core/scenario/scenario.hpp"

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// One row: these methods and monitors work on this domain with these boundaries.
struct Capability {
    std::string domain;
    std::vector<std::string> boundaries; ///< of domain.boundary; empty: the domain has no such key
    std::vector<std::string> monitors;
    std::vector<std::string> methods;
    std::function<std::shared_ptr<const Discretisation>(const Values& domain, const Progress&,
                                                        std::stop_token)>
        prepare;
};

struct Catalogue {
    std::vector<DomainType> domains;
    std::vector<MonitorType> monitors;
    std::vector<MethodType> methods;
    std::vector<Capability> capabilities;
    std::vector<ParameterRow> output_rows;

    /// Throw InputError for a name that is not there, with the nearest that is.
    const DomainType& domain(std::string_view name) const;
    const MonitorType& monitor(std::string_view name) const;
    const MethodType& method(std::string_view name) const;
};

/// What Gaspard ships.
Catalogue builtin_catalogue();

/// A section with the defaults of a type; a monitor's rows depend on the space.
Section domain_section(const Catalogue& catalogue, std::string_view type);
Section monitor_section(const Catalogue& catalogue, std::string_view type, const Space& space = {});
Section method_section(const Catalogue& catalogue, std::string_view type);

/// The values of the section "view" for a method: its fields are among the colours.
Values view_section(const Catalogue& catalogue, std::string_view method);

/// The first of every type, with its defaults.
Scenario default_scenario(const Catalogue& catalogue);

/// What the points of a scenario's domain know of distance.
Space space_of(const Catalogue& catalogue, const Scenario& scenario);
/// Gives the monitor the rows that it has on the scenario's domain. Values that were chosen stay where the
/// key is still there and allows them.
void follow_domain(const Catalogue& catalogue, Scenario& scenario);

/// Gives the view the rows that it has with a method. Values that were chosen stay where the method allows
/// them.
void follow_method(const Catalogue& catalogue, std::string_view method, Values& view);

/// Throws InputError if a scenario has no such key, or a reserved one.
void check_key(const Catalogue& catalogue, Scenario& scenario, std::string_view key);
/// Sets one value by its full key ("monitor.amplitude", "monitor.type"). A new type takes that type's
/// defaults; with a new domain, the monitor follows. Throws InputError: unknown or reserved key, wrong kind,
/// out of range.
void set_value(const Catalogue& catalogue, Scenario& scenario, std::string_view key, const Value& value);
/// The same for a list of "key=value" texts from a command line; types first, so that the order does not
/// matter.
void apply_settings(const Catalogue& catalogue, Scenario& scenario, const std::vector<std::string>& settings);

/// A scenario that has passed: combination allowed, monitor positive. Everything a run needs to begin.
struct Problem {
    Scenario scenario;
    std::shared_ptr<const Monitor> monitor;
    const Capability* capability = nullptr; ///< in the catalogue that checked it
};

/// Throws InputError, naming what does not go together and what would. A monitor that the caller brings takes
/// the place of the scenario's, whose section then is of type own_monitor and has no values.
Problem check(const Catalogue& catalogue, Scenario scenario, std::shared_ptr<const Monitor> own = {});
inline constexpr std::string_view own_monitor = "own";

/// The row for a scenario's domain, boundary, monitor and method, or null.
const Capability* find_capability(const Catalogue& catalogue, const Scenario& scenario);

} // namespace gaspard
