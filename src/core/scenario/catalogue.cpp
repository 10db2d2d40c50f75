#include "core/scenario/catalogue.hpp"

#include "core/base/check.hpp"
#include "core/fem/plane_q2.hpp"
#include "core/fem/surface_q2.hpp"
#include "core/scenario/output_rows.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/spline/spline_domain.hpp"

#include <algorithm>

namespace gaspard {

namespace {

template <class Type>
const Type& find(const std::vector<Type>& types, std::string_view name, const char* what) {
    std::vector<std::string> known;
    for (const auto& type : types) {
        if (type.name == name) return type;
        known.push_back(type.name);
    }
    std::string list;
    for (const auto& one : known) list += (list.empty() ? "" : ", ") + one;
    throw InputError("unknown " + std::string(what) + " '" + std::string(name) + "'" +
                     did_you_mean(name, known) + "; there are: " + list);
}

bool contains(const std::vector<std::string>& list, const std::string& word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

std::string join(const std::vector<std::string>& words) {
    std::string list;
    for (const auto& word : words) list += (list.empty() ? "" : ", ") + word;
    return list;
}

std::string boundary_of(const Scenario& scenario) {
    return scenario.domain.values.has("boundary") ? scenario.domain.values.text("boundary") : std::string();
}

Capability plane_capability() {
    return {.domain = "plane",
            .boundaries = {"periodic", "walls"},
            .monitors = {"ring", "bell", "ring-and-bell", "random-bells", "random-waves", "constant"},
            .methods = {"relaxation", "accelerated", "quasi-newton", "newton", "auto"},
            .prepare = [](const Values& domain, const Progress& progress,
                          std::stop_token) -> std::shared_ptr<const Discretisation> {
                if (progress) progress(0, "preparing the operators of the plane");
                return std::make_shared<PlaneQ2>(LineGrid{static_cast<std::size_t>(domain.integer("cells")),
                                                          domain.text("boundary") == "periodic"});
            }};
}

Capability sphere_capability(const std::string& domain_type) {
    return {.domain = domain_type,
            .boundaries = {},
            .monitors = {"x-n", "cross", "ring", "bell", "ring-and-bell", "random-bells", "random-waves",
                         "constant"},
            .methods = {"relaxation", "accelerated", "quasi-newton", "newton", "auto"},
            .prepare = [](const Values& domain, const Progress& progress,
                          std::stop_token stop) -> std::shared_ptr<const Discretisation> {
                return std::make_shared<SurfaceQ2>(
                    sphere_setup(sphere_grid(domain), static_cast<int>(domain.integer("geometry_order")),
                                 domain.real("radius"), domain.text("monitor_nodes") == "vertices"),
                    progress, stop);
            }};
}

Capability spline_capability(const std::string& domain_type) {
    return {.domain = domain_type,
            .boundaries = {},
            .monitors = {"circle", "spiral", "three-circles", "two-circles", "cosine-waves", "sine-waves",
                         "ring", "bell", "ring-and-bell", "random-bells", "random-waves", "constant"},
            .methods = {"picard", "picard-mixed", "newton", "accelerated", "auto"},
            .prepare = [domain_type](const Values& domain, const Progress& progress,
                                     std::stop_token) -> std::shared_ptr<const Discretisation> {
                if (progress) progress(0, "preparing the patch");
                return make_spline_domain(domain_type, domain);
            }};
}

} // namespace

const DomainType& Catalogue::domain(std::string_view name) const {
    return find(domains, name, "domain.type");
}
const MonitorType& Catalogue::monitor(std::string_view name) const {
    return find(monitors, name, "monitor.type");
}
const MethodType& Catalogue::method(std::string_view name) const {
    return find(methods, name, "method.type");
}

Catalogue builtin_catalogue() {
    Catalogue catalogue{.domains = {plane_domain(), cubed_sphere_domain(), icosahedral_sphere_domain()},
                        .monitors = monitor_types(),
                        .methods = {relaxation_method(), accelerated_method(), quasi_newton_method(),
                                    newton_method(), automatic_method(), picard_method(),
                                    picard_mixed_method()},
                        .capabilities = {plane_capability(), sphere_capability("cubed-sphere"),
                                         sphere_capability("icosahedral-sphere")},
                        .output_rows = output_rows()};
    for (auto& domain : spline_domains()) {
        catalogue.capabilities.push_back(spline_capability(domain.name));
        catalogue.domains.push_back(std::move(domain));
    }
    return catalogue;
}

Section domain_section(const Catalogue& catalogue, std::string_view type) {
    return {std::string(type), Values("domain", catalogue.domain(type).rows)};
}

Section monitor_section(const Catalogue& catalogue, std::string_view type, const Space& space) {
    return {std::string(type), Values("monitor", catalogue.monitor(type).rows(space))};
}

Section method_section(const Catalogue& catalogue, std::string_view type) {
    auto rows = catalogue.method(type).rows;
    for (auto& row : common_method_rows()) rows.push_back(std::move(row));
    return {std::string(type), Values("method", std::move(rows))};
}

Values view_section(const Catalogue& catalogue, std::string_view method) {
    return {"view", view_rows(catalogue.method(method).fields)};
}

Scenario default_scenario(const Catalogue& catalogue) {
    return {.name = "untitled",
            .title = {},
            .description = {},
            .domain = domain_section(catalogue, catalogue.domains.front().name),
            .monitor = monitor_section(catalogue, catalogue.monitors.front().name),
            .method = method_section(catalogue, catalogue.methods.front().name),
            .view = view_section(catalogue, catalogue.methods.front().name),
            .output = Values("output", catalogue.output_rows)};
}

const Capability* find_capability(const Catalogue& catalogue, const Scenario& scenario) {
    const std::string boundary = boundary_of(scenario);
    for (const auto& row : catalogue.capabilities)
        if (row.domain == scenario.domain.type &&
            (row.boundaries.empty() || contains(row.boundaries, boundary)) &&
            (scenario.monitor.type == own_monitor || contains(row.monitors, scenario.monitor.type)) &&
            contains(row.methods, scenario.method.type))
            return &row;
    return nullptr;
}

Problem check(const Catalogue& catalogue, Scenario scenario, std::shared_ptr<const Monitor> own) {
    if (own) {
        scenario.monitor = {std::string(own_monitor), Values("monitor", {})};
        const auto made_for = own->made_for();
        if (made_for && *made_for != space_of(catalogue, scenario).kind)
            throw InputError("the monitor is a function of " + std::string(name_of(*made_for)) +
                             ", which domain '" + scenario.domain.type + "' is not");
    }
    const Capability* capability = find_capability(catalogue, scenario);
    if (!capability) {
        std::string possible;
        for (const auto& row : catalogue.capabilities)
            if (row.domain == scenario.domain.type)
                possible +=
                    "; possible there: monitors " + join(row.monitors) + " with methods " + join(row.methods);
        const std::string boundary = boundary_of(scenario);
        throw InputError("monitor '" + scenario.monitor.type + "' and method '" + scenario.method.type +
                         "' do not go together on domain '" + scenario.domain.type + "'" +
                         (boundary.empty() ? "" : " with boundary '" + boundary + "'") + possible);
    }
    auto monitor = std::move(own);
    if (!monitor)
        monitor = catalogue.monitor(scenario.monitor.type)
                      .make(scenario.monitor.values, space_of(catalogue, scenario));
    monitor->check();
    return {std::move(scenario), std::move(monitor), capability};
}

} // namespace gaspard
