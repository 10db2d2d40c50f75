// The catalogue of domains, monitors, methods and PDEs, and the table of capabilities: which domains,
// boundaries, monitors and methods can be combined. The window disables choices and the command line
// validates settings by this table. A catalogue is a value: tests add fixtures to a copy.
#pragma once

#include "core/base/export.hpp"
#include "core/mesh/discretisation.hpp"
#include "core/mesh/domain_type.hpp"
#include "core/method/method.hpp"
#include "core/monitor/monitor.hpp"
#include "core/monitor/pde_type.hpp"
#include "core/scenario/scenario.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard GASPARD_API {

/// Arguments of Capability::prepare, which may take long: it reports progress, and throws Interrupted if
/// asked to stop.
struct PrepareContext {
    const Scenario& scenario;
    Progress progress{};
    std::stop_token stop{};
};

/// One row of the table: these methods and monitors work on this domain with these boundaries.
struct Capability {
    std::string domain;
    std::vector<std::string> boundaries; ///< values of domain.boundary; empty: the domain has no such key
    std::vector<std::string> monitors;
    std::vector<std::string> methods;
    /// Makes the discretisation of the domain.
    std::function<std::shared_ptr<const Discretisation>(const PrepareContext&)> prepare;
    /// Makes the nonlinear problem on that discretisation; empty if the methods do not use one.
    std::function<std::unique_ptr<NonlinearProblem>(std::shared_ptr<const Discretisation>)> problem{};
    std::vector<std::string> sources{};          ///< types of section monitor.source; empty: no such section
    std::vector<std::string> pdes{};             ///< types of section pde; empty: no such section
    std::map<std::string, MethodMaker> makers{}; ///< of the methods that this domain makes in its own way
    std::vector<ParameterRow> method_rows{};     ///< that all methods have here, before their common rows
};

struct Catalogue {
    std::vector<DomainType> domains;
    std::vector<MonitorType> monitors;
    std::vector<MethodType> methods;
    std::vector<PdeType> pdes{};
    std::vector<Capability> capabilities;
    std::vector<ParameterRow> output_rows;

    /// Throw InputError if the name is unknown; the message names the nearest known name.
    const DomainType& domain(std::string_view name) const;
    const MonitorType& monitor(std::string_view name) const;
    const MethodType& method(std::string_view name) const;
    const PdeType& pde(std::string_view name) const;
};

/// The catalogue of the program.
Catalogue builtin_catalogue();

/// A section with the default values of a type. The rows of a monitor depend on the space; `section` is
/// "monitor" or "monitor.source".
Section domain_section(const Catalogue& catalogue, std::string_view type);
Section monitor_section(const Catalogue& catalogue, std::string_view type, const Space& space = {},
                        const std::string& section = "monitor");
Section method_section(const Catalogue& catalogue, std::string_view type);
Section pde_section(const Catalogue& catalogue, std::string_view type);

/// The rows that a method has on a domain besides its own (Capability::method_rows).
std::vector<ParameterRow> method_rows_on(const Catalogue& catalogue, std::string_view domain,
                                         std::string_view method);

/// The values of the section "view" for a method and a monitor: their fields are among the colours.
Values view_section(const Catalogue& catalogue, std::string_view method, std::string_view monitor);

/// The first domain, monitor and method of the catalogue, with default values.
Scenario default_scenario(const Catalogue& catalogue);

/// The space of the scenario's domain, as far as it is known (locate_domain).
Space space_of(const Catalogue& catalogue, const Scenario& scenario);
/// Where the density of monitor.source lies.
Space source_space_of(const Catalogue& catalogue, const Scenario& scenario);
/// Reads the files of the domain, if they are not read yet, and updates the rows: ranges and values of
/// monitors fit the size and the place of a patch. Files that are invalid are reported when the domain is
/// made.
void locate_domain(const Catalogue& catalogue, Scenario& scenario);
/// Whether locate_domain() would not read anything.
bool is_located(const Catalogue& catalogue, const Scenario& scenario);
/// Updates the rows of every section: monitors depend on the space of the domain, further rows on values, and
/// the sections monitor.source and pde on domain and method. Values set by the user are kept if the key still
/// exists and allows them; on a domain of another size they are scaled. Reads no file.
void update_rows(const Catalogue& catalogue, Scenario& scenario);
/// The same while values are being typed: a monitor whose texts are invalid keeps its rows, and the run says
/// what is wrong. Throws nothing.
void update_typed_rows(const Catalogue& catalogue, Scenario& scenario);

/// Replaces the method. Values of the rows that the methods have on the domain (method_rows_on) are kept.
void set_method(const Catalogue& catalogue, Scenario& scenario, Section method);

/// The scenario with its monitor as a formula to change, with the same values and ranges; nullopt if the
/// monitor has none (MonitorType::formula).
std::optional<Scenario> with_formula(const Catalogue& catalogue, const Scenario& scenario);

/// Updates the rows of a view of the scenario, for its method and its monitor. Values set by the user are
/// kept if these allow them.
void update_view_rows(const Catalogue& catalogue, const Scenario& scenario, Values& view);

/// Throws InputError if the scenario has no such key, or if the key is reserved.
void check_key(const Catalogue& catalogue, Scenario& scenario, std::string_view key);
/// Throws InputError if the key is, or belongs to, a reserved section that the scenario does not have.
void check_section(Scenario& scenario, std::string_view key);
bool has_key(Scenario& scenario, std::string_view key);
/// Sets one value by its full key ("monitor.amplitude", "monitor.type"). Setting a type sets the defaults of
/// that type; setting the domain also updates the rows of the monitor. Throws InputError if the key is
/// unknown or reserved, or if the value has the wrong kind or is out of range.
void set_value(const Catalogue& catalogue, Scenario& scenario, std::string_view key, const Value& value);
/// The same without reading the files of the domain, for several of its keys in turn.
void set_value_unlocated(const Catalogue& catalogue, Scenario& scenario, std::string_view key,
                         const Value& value);
/// Like set_value, for a list of "key=value" from the command line. Types are set first, so the order does
/// not matter. Throws InputError; the settings before the invalid one may have been applied.
void apply_settings(const Catalogue& catalogue, Scenario& scenario, const std::vector<std::string>& settings);

/// A scenario whose combination of domain, boundary, monitor and method is allowed.
struct Problem {
    Scenario scenario;
    const Capability* capability = nullptr; ///< in the catalogue that checked it
};

/// Throws InputError if the combination is not allowed; the message names possible ones. Makes nothing and
/// reads no file. The caller's monitor `own`, if not null, replaces that of the scenario, whose section then
/// has the type own_monitor and no values.
Problem check(const Catalogue& catalogue, Scenario scenario, const Monitor* own = nullptr);
inline constexpr std::string_view own_monitor = "own";

/// Makes and checks the monitors of a scenario; reads their files. `own`: the caller's monitor, or null.
/// Throws InputError, and Interrupted if asked to stop.
ProblemData make_problem_data(const Catalogue& catalogue, const Scenario& scenario,
                              std::shared_ptr<const Monitor> own, const MonitorContext& context);
/// Whether two scenarios have the same problem data on the same domain.
bool same_problem_data(const Scenario& a, const Scenario& b);

/// The row for the scenario's domain, boundary, monitor and method; null if there is none.
const Capability* find_capability(const Catalogue& catalogue, const Scenario& scenario);

} // namespace GASPARD_API
