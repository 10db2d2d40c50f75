// All there is to choose from, and what goes with what: one table of capabilities (domain x boundary x
// monitor x method). The window disables choices by it, the command line validates against it. A catalogue is
// a value: tests add fixtures to a copy.
#pragma once

#include "core/mesh/discretisation.hpp"
#include "core/mesh/domain_type.hpp"
#include "core/method/method.hpp"
#include "core/monitor/monitor.hpp"
#include "core/scenario/pde_type.hpp"
#include "core/scenario/scenario.hpp"

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// What the operators of a domain are made from. They may take long: prepare reports progress and throws
/// Interrupted when asked to stop.
struct PrepareContext {
    const Scenario& scenario;
    Progress progress{};
    std::stop_token stop{};
};

/// One row: these methods and monitors work on this domain with these boundaries.
struct Capability {
    std::string domain;
    std::vector<std::string> boundaries; ///< values of domain.boundary; empty: the domain has no such key
    std::vector<std::string> monitors;
    std::vector<std::string> methods;
    std::function<std::shared_ptr<const Discretisation>(const PrepareContext&)> prepare;
    /// The nonlinear problem on what `prepare` made; empty if the methods bring their own.
    std::function<std::unique_ptr<NonlinearProblem>(std::shared_ptr<const Discretisation>)> problem{};
    std::vector<std::string>
        targets{};                   ///< monitors of section monitor.target; empty: there is no such section
    std::vector<std::string> pdes{}; ///< types of section pde; empty: there is no such section
};

struct Catalogue {
    std::vector<DomainType> domains;
    std::vector<MonitorType> monitors;
    std::vector<MethodType> methods;
    std::vector<PdeType> pdes{};
    std::vector<Capability> capabilities;
    std::vector<ParameterRow> output_rows;

    /// Throw InputError for a name that is not there, with the nearest that is.
    const DomainType& domain(std::string_view name) const;
    const MonitorType& monitor(std::string_view name) const;
    const MethodType& method(std::string_view name) const;
    const PdeType& pde(std::string_view name) const;
};

/// What Gaspard ships.
Catalogue builtin_catalogue();

/// A section with the defaults of a type; a monitor's rows depend on the space. `section`: "monitor" or
/// "monitor.target".
Section domain_section(const Catalogue& catalogue, std::string_view type);
Section monitor_section(const Catalogue& catalogue, std::string_view type, const Space& space = {},
                        const std::string& section = "monitor");
Section method_section(const Catalogue& catalogue, std::string_view type);
Section pde_section(const Catalogue& catalogue, std::string_view type);

/// The values of the section "view" for a method: its fields are among the colours.
Values view_section(const Catalogue& catalogue, std::string_view method);

/// The first of every type, with its defaults.
Scenario default_scenario(const Catalogue& catalogue);

/// What the points of a scenario's domain know of distance.
Space space_of(const Catalogue& catalogue, const Scenario& scenario);
/// Gives every section the rows that it has for the scenario's other values: monitors depend on the domain's
/// space, further rows on values, and the sections monitor.target and pde on domain and method. Values that
/// were chosen stay if the key still exists and allows them.
void update_rows(const Catalogue& catalogue, Scenario& scenario);

/// Gives the view the rows that it has with a method. Values that were chosen stay where the method allows
/// them.
void update_view_rows(const Catalogue& catalogue, std::string_view method, Values& view);

/// Throws InputError if a scenario has no such key, or a reserved one.
void check_key(const Catalogue& catalogue, Scenario& scenario, std::string_view key);
/// Throws InputError if a key, or a section, belongs to a section that this scenario does not have.
void check_section(Scenario& scenario, std::string_view key);
bool has_key(Scenario& scenario, std::string_view key);
/// Sets one value by its full key ("monitor.amplitude", "monitor.type"). A new type takes that type's
/// defaults; with a new domain, the monitor follows. Throws InputError: unknown or reserved key, wrong kind,
/// out of range.
void set_value(const Catalogue& catalogue, Scenario& scenario, std::string_view key, const Value& value);
/// The same for a list of "key=value" texts from a command line; types first, so that the order does not
/// matter.
void apply_settings(const Catalogue& catalogue, Scenario& scenario, const std::vector<std::string>& settings);

/// A scenario whose combination of domain, boundary, monitor and method is allowed.
struct Problem {
    Scenario scenario;
    const Capability* capability = nullptr; ///< in the catalogue that checked it
};

/// Throws InputError, naming what does not go together and what would. Makes nothing and reads no file. A
/// monitor that the caller brings takes the place of the scenario's, whose section then has the type
/// own_monitor and no values.
Problem check(const Catalogue& catalogue, Scenario scenario, const Monitor* own = nullptr);
inline constexpr std::string_view own_monitor = "own";

/// Makes the monitors of a scenario, reading their files, and checks them. `own`: the caller's monitor, or
/// null. Throws InputError and Interrupted.
ProblemData make_problem_data(const Catalogue& catalogue, const Scenario& scenario,
                              std::shared_ptr<const Monitor> own, const MonitorContext& context);
/// Whether two scenarios have the same problem data on the same domain.
bool same_problem_data(const Scenario& a, const Scenario& b);

/// The row for a scenario's domain, boundary, monitor and method, or null.
const Capability* find_capability(const Catalogue& catalogue, const Scenario& scenario);

} // namespace gaspard
