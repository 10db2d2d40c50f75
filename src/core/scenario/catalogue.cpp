#include "core/scenario/catalogue.hpp"

#include "core/base/check.hpp"
#include "core/base/growing_values.hpp"
#include "core/base/join.hpp"
#include "core/layer/interval_domain.hpp"
#include "core/layer/layer_pde.hpp"
#include "core/layer/quadrilateral_domain.hpp"
#include "core/method/interval_method.hpp"
#include "core/method/plane_equation.hpp"
#include "core/method/quadrilateral_mesh_pde.hpp"
#include "core/method/spline_equation.hpp"
#include "core/method/surface_equation.hpp"
#include "core/monitor/inside_monitor.hpp"
#include "core/monitor/own_problem.hpp"
#include "core/monitor/placement.hpp"
#include "core/scenario/output_rows.hpp"
#include "core/scenario/problem_on.hpp"
#include "core/scenario/time_rows.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/spline/solid_domain.hpp"
#include "core/spline/spline_domain.hpp"
#include "core/transport/transport_domain.hpp"

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
    throw InputError("unknown " + std::string(what) + " '" + std::string(name) + "'" +
                     did_you_mean(name, known) + "; available: " + join(known, ", "));
}

bool contains(const std::vector<std::string>& list, const std::string& word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

Capability plane_capability() {
    return {.domain = "plane",
            .boundaries = {"periodic", "walls"},
            .monitors = {"ring", "bell", "ring-and-bell", "random-bells", "random-waves", "constant",
                         "formula", "image", "field", "derived", "combine"},
            .methods = {"relaxation", "accelerated", "quasi-newton", "newton", "auto"},
            .prepare = [](const PrepareContext& context) -> std::shared_ptr<const Discretisation> {
                const Values& domain = context.scenario.domain.values;
                if (context.progress) context.progress(0, "preparing the operators of the plane");
                return std::make_shared<PlaneQ2>(LineGrid{static_cast<std::size_t>(domain.integer("cells")),
                                                          domain.text("boundary") == "periodic"});
            },
            .problem = problem_on<PlaneEquation, PlaneQ2>};
}

/// Flows are periodic.
Capability flow_capability() {
    Capability row = plane_capability();
    row.boundaries = {"periodic"}, row.monitors = {"flow"};
    return row;
}

Capability sphere_capability(const DomainType& type, SphereGrid (*grid)(const Values&)) {
    return {.domain = type.name,
            .boundaries = {},
            .monitors = {"x-n", "cross", "ring", "bell", "ring-and-bell", "random-bells", "random-waves",
                         "constant", "formula", "image", "field", "derived", "combine"},
            .methods = {"relaxation", "accelerated", "quasi-newton", "newton", "auto"},
            .prepare = [grid](const PrepareContext& context) -> std::shared_ptr<const Discretisation> {
                const Values& domain = context.scenario.domain.values;
                return std::make_shared<SurfaceQ2>(
                    sphere_setup(grid(domain), static_cast<int>(domain.integer("geometry_order")),
                                 domain.real("radius"), domain.text("monitor_nodes") == "vertices"),
                    context.progress, context.stop);
            },
            .problem = problem_on<SurfaceEquation, SurfaceQ2>};
}

Capability spline_capability(const std::string& domain_type) {
    return {.domain = domain_type,
            .boundaries = {},
            .monitors = {"circle", "spiral", "three-circles", "two-circles", "cosine-waves", "sine-waves",
                         "ring", "bell", "ring-and-bell", "random-bells", "random-waves", "constant",
                         "formula", "image", "field", "derived", "combine"},
            .methods = {"picard", "picard-mixed", "newton", "accelerated", "auto"},
            .prepare = [](const PrepareContext& context) -> std::shared_ptr<const Discretisation> {
                if (context.progress) context.progress(0, "preparing the patch");
                return make_spline_domain(context.scenario.domain.type, context.scenario.domain.values,
                                          context.scenario.folder, context.scenario.place.content);
            },
            .problem = problem_on<SplineEquation, SplineDomain>,
            .method_rows = {measure_row()}};
}

Capability solid_capability(const std::string& domain_type) {
    return {.domain = domain_type,
            .boundaries = {},
            .monitors = {"cosine-waves", "ring", "bell", "ring-and-bell", "random-bells", "random-waves",
                         "constant", "formula", "field", "derived", "combine"},
            .methods = {"picard", "picard-mixed", "newton", "accelerated", "auto"},
            .prepare = [](const PrepareContext& context) -> std::shared_ptr<const Discretisation> {
                if (context.progress) context.progress(0, "preparing the solid");
                return make_solid_domain(context.scenario.domain.type, context.scenario.domain.values,
                                         context.scenario.folder, context.scenario.place.content);
            },
            .problem = problem_on<SolidEquation, SolidDomain>,
            .makers = {{"picard", picard_in_solids(false)}, {"picard-mixed", picard_in_solids(true)}},
            .method_rows = {measure_row()}};
}

Capability interval_capability() {
    return {.domain = "interval",
            .boundaries = {},
            .monitors = {"layer", "two-layers", "constant", "formula", "burgers"},
            .methods = {"mesh-pde", "bakhvalov", "shishkin", "equidistribute", "solution-adapted"},
            .prepare = [](const PrepareContext& context) -> std::shared_ptr<const Discretisation> {
                return make_interval(context.scenario.domain.values);
            },
            .pdes = {"none", "reaction-diffusion", "coupled-reaction-diffusion", "convection-diffusion"}};
}

Capability quadrilateral_capability() {
    return {.domain = "quadrilateral",
            .boundaries = {},
            .monitors = {"layer-tensor", "layer", "constant", "formula"},
            .methods = {"mesh-pde", "solution-adapted"},
            .prepare = [](const PrepareContext& context) -> std::shared_ptr<const Discretisation> {
                return make_quadrilateral(context.scenario.domain.values);
            },
            .pdes = {"none", "reaction-diffusion-2d", "convection-diffusion-2d"},
            .makers = {{"mesh-pde", quadrilateral_mesh_pde},
                       {"solution-adapted", quadrilateral_solution_adapted}}};
}

Capability transport_capability() {
    const std::vector<std::string> densities = {"constant",      "ring",         "bell",
                                                "ring-and-bell", "random-bells", "random-waves",
                                                "formula",       "image",        "field"};
    return {.domain = "convex",
            .boundaries = {},
            .monitors = densities,
            .methods = {"nvfem"},
            .prepare = [](const PrepareContext& context) -> std::shared_ptr<const Discretisation> {
                return make_transport_domain(context.scenario.domain.values, context.scenario.folder,
                                             context.scenario.place.content, context.stop);
            },
            .sources = densities};
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
const PdeType& Catalogue::pde(std::string_view name) const { return find(pdes, name, "pde.type"); }

Catalogue builtin_catalogue() {
    Catalogue catalogue{
        .domains = {plane_domain(), cubed_sphere_domain(), icosahedral_sphere_domain()},
        .monitors = monitor_types(),
        .methods = {relaxation_method(), accelerated_method(), quasi_newton_method(), newton_method(),
                    automatic_method(), picard_method(), picard_mixed_method(), mesh_pde_method(),
                    bakhvalov_method(), shishkin_method(), equidistribute_method(), solution_adapted_method(),
                    nvfem_method()},
        .pdes = {no_pde(), reaction_diffusion_pde(), coupled_pde(), convection_diffusion_pde(),
                 plane_reaction_diffusion_pde(), plane_convection_diffusion_pde()},
        .capabilities = {plane_capability(), sphere_capability(cubed_sphere_domain(), cubed_sphere_grid),
                         sphere_capability(icosahedral_sphere_domain(), icosahedral_sphere_grid)},
        .output_rows = output_rows()};
    for (auto& domain : spline_domains()) {
        catalogue.capabilities.push_back(spline_capability(domain.name));
        catalogue.domains.push_back(std::move(domain));
    }
    for (auto& domain : solid_domains()) {
        catalogue.capabilities.push_back(solid_capability(domain.name));
        catalogue.domains.push_back(std::move(domain));
    }
    catalogue.domains.push_back(interval_domain());
    catalogue.capabilities.push_back(interval_capability());
    catalogue.domains.push_back(quadrilateral_domain());
    catalogue.capabilities.push_back(quadrilateral_capability());
    catalogue.domains.push_back(transport_domain());
    catalogue.capabilities.push_back(transport_capability());
    catalogue.capabilities.push_back(flow_capability());
    return catalogue;
}

Section domain_section(const Catalogue& catalogue, std::string_view type) {
    const DomainType& domain = catalogue.domain(type);
    const auto further = [&](const Values& values) {
        return domain.further_rows ? domain.further_rows(values) : std::vector<ParameterRow>();
    };
    return {std::string(type), grown_values("domain", domain.rows, further, [](Values&) {})};
}

Section monitor_section(const Catalogue& catalogue, std::string_view type, const Space& space,
                        const std::string& section) {
    const MonitorType& monitor = catalogue.monitor(type);
    const auto further = [&](const Values& values) { return further_rows_on(monitor, values, space); };
    return {std::string(type), grown_values(section, rows_on(monitor, space), further, [](Values&) {})};
}

Section method_section(const Catalogue& catalogue, std::string_view type) {
    return {std::string(type), default_values(catalogue.method(type))};
}

std::vector<ParameterRow> method_rows_on(const Catalogue& catalogue, std::string_view domain,
                                         std::string_view method) {
    for (const Capability& row : catalogue.capabilities) // all rows of a domain agree
        if (row.domain == domain && contains(row.methods, std::string(method))) return row.method_rows;
    return {};
}

Section pde_section(const Catalogue& catalogue, std::string_view type) {
    return {std::string(type), Values("pde", catalogue.pde(type).rows)};
}

Values view_section(const Catalogue& catalogue, std::string_view method, std::string_view monitor) {
    std::vector<FieldInfo> fields = catalogue.method(method).fields;
    if (monitor != own_monitor)
        for (const FieldInfo& field : catalogue.monitor(monitor).fields) fields.push_back(field);
    return {"view", view_rows(fields, catalogue.method(method).colour)};
}

Scenario default_scenario(const Catalogue& catalogue) {
    Scenario scenario{
        .name = "untitled",
        .title = {},
        .description = {},
        .domain = domain_section(catalogue, catalogue.domains.front().name),
        .monitor = monitor_section(catalogue, catalogue.monitors.front().name),
        .method = method_section(catalogue, catalogue.methods.front().name),
        .view = view_section(catalogue, catalogue.methods.front().name, catalogue.monitors.front().name),
        .output = Values("output", catalogue.output_rows)};
    update_rows(catalogue, scenario);
    return scenario;
}

/// Whether an optional section has one of the offered types, or is absent if none is offered.
static bool fits(const std::vector<std::string>& offered, const Section& section) {
    return offered.empty() ? section.type.empty() : contains(offered, section.type);
}

/// Whether the methods of a row are for scalar monitors, as those of a caller are.
static bool takes_scalars(const Catalogue& catalogue, const Capability& row) {
    return std::any_of(catalogue.monitors.begin(), catalogue.monitors.end(), [&](const MonitorType& type) {
        return type.make != nullptr && contains(row.monitors, type.name);
    });
}

const Capability* find_capability(const Catalogue& catalogue, const Scenario& scenario) {
    for (const auto& row : catalogue.capabilities)
        if (row.domain == scenario.domain.type &&
            (row.boundaries.empty() || contains(row.boundaries, scenario.domain.values.text("boundary"))) &&
            (scenario.monitor.type == own_monitor ? takes_scalars(catalogue, row)
                                                  : contains(row.monitors, scenario.monitor.type)) &&
            contains(row.methods, scenario.method.type) && fits(row.sources, scenario.source) &&
            fits(row.pdes, scenario.pde))
            return &row;
    return nullptr;
}

[[noreturn]] static void refuse(const Catalogue& catalogue, const Scenario& scenario) {
    std::string possible, boundary;
    for (const auto& row : catalogue.capabilities) {
        if (row.domain != scenario.domain.type) continue;
        if (!row.boundaries.empty()) {
            const std::string& present = scenario.domain.values.text("boundary");
            boundary = " with boundary '" + present + "'";
            if (!contains(row.boundaries, present)) continue;
        }
        possible +=
            "; possible: monitors " + join(row.monitors, ", ") + " with methods " + join(row.methods, ", ");
    }
    throw InputError("monitor '" + scenario.monitor.type + "' and method '" + scenario.method.type +
                     "' cannot be combined on domain '" + scenario.domain.type + "'" + boundary + possible);
}

Problem check(const Catalogue& catalogue, Scenario scenario, const Monitor* own) {
    if (own) {
        scenario.monitor = {std::string(own_monitor), Values("monitor", {})};
        const auto made_for = own->made_for();
        if (made_for && *made_for != space_of(catalogue, scenario).kind)
            throw InputError("the monitor is a function on " + std::string(name_of(*made_for)) +
                             ", but domain '" + scenario.domain.type + "' is not");
    }
    const Capability* capability = find_capability(catalogue, scenario);
    if (!capability) refuse(catalogue, scenario);
    return {std::move(scenario), capability};
}

/// After what the monitor says.
static void add_notes(ProblemData& data, const std::vector<std::string>& notes) {
    if (notes.empty()) return;
    MonitorReport report = data.report ? *data.report : MonitorReport{};
    report.notes.insert(report.notes.end(), notes.begin(), notes.end());
    data.report = std::make_shared<const MonitorReport>(std::move(report));
}

/// About values of time that have no effect.
static std::vector<std::string> notes_on_time(const Scenario& scenario) {
    const Values& time = scenario.time;
    const bool follows = find_role(scenario.monitor.values.rows(), ParameterRole::time) != nullptr;
    if (has_time(time) && !has_motion(time) && !follows)
        return {"Time passes, but the monitor does not move: time.path and the formulas time.monitor.* are "
                "empty."};
    if (!has_time(time) && has_motion(time))
        return {"The monitor does not move: time.end is not after time.start."};
    if (time.real("end") < time.real("start")) return {"No time passes: time.end is before time.start."};
    return {};
}

ProblemData make_problem_data(const Catalogue& catalogue, const Scenario& scenario,
                              std::shared_ptr<const Monitor> own, const MonitorContext& context) {
    MonitorContext on_target = context, on_source = context;
    if (context.discretisation) {
        on_target.within = context.discretisation->target_region();
        on_source.within = context.discretisation->source_region();
    }
    const bool moved_by_caller = own != nullptr;
    const bool has_box = !on_target.within && !catalogue.domain(scenario.domain.type).spline_patch;
    const auto in_its_unit = [&](std::shared_ptr<const Monitor> monitor) {
        ProblemData plain = scalar_problem(monitor);
        if (!context.discretisation) return plain;
        const Mesh& mesh = *context.discretisation->mesh();
        ProblemData scaled =
            own_problem(std::move(monitor), extent_of(mesh, context.space, has_box), mesh.nodes);
        return scaled.unit == 1 ? plain : scaled;
    };
    const auto make = [&](const Section& section, const MonitorContext& place) {
        const MonitorType& type = catalogue.monitor(section.type);
        MonitorContext with_pde = place;
        if (!scenario.pde.type.empty()) with_pde.pde = &scenario.pde.values;
        return type.make_tensor ? tensor_problem(type.make_tensor(section.values, with_pde))
                                : in_its_unit(make_on(type, section.values, with_pde));
    };
    const auto make_own = [&] {
        GASPARD_CHECK(context.discretisation != nullptr);
        const Mesh& mesh = *context.discretisation->mesh();
        if (own && on_target.within) own = std::make_shared<InsideMonitor>(std::move(own), on_target.within);
        return own_problem(std::move(own), extent_of(mesh, context.space, has_box), mesh.nodes);
    };
    ProblemData data = own ? make_own() : make(scenario.monitor, on_target);
    if (!scenario.source.type.empty()) {
        on_source.space = source_space_of(catalogue, scenario);
        const ProblemData source = make(scenario.source, on_source);
        data.source = source.monitor;
        std::vector<std::string> notes;
        if (source.report)
            for (const std::string& note : source.report->notes) notes.push_back("Source: " + note);
        add_notes(data, notes);
    }
    if (context.discretisation) add_notes(data, context.discretisation->notes());
    if (!moved_by_caller) add_notes(data, notes_on_time(scenario));
    if (!scenario.pde.type.empty()) {
        data.pde_type = scenario.pde.type;
        data.pde = std::make_shared<const Values>(scenario.pde.values);
    }
    return data;
}

bool same_problem_data(const Scenario& a, const Scenario& b) {
    return a.domain == b.domain && a.monitor == b.monitor && a.source == b.source && a.pde == b.pde &&
           a.folder == b.folder && same_time(a.time, b.time);
}

} // namespace gaspard
