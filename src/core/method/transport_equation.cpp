#include "core/method/transport_equation.hpp"

#include "core/base/check.hpp"
#include "core/base/eigenvalues.hpp"
#include "core/base/error.hpp"
#include "core/method/power_monitor.hpp"
#include "core/transport/exact_transport.hpp"
#include "core/transport/moved_monitor.hpp"
#include "core/transport/recovered_function.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace gaspard {

namespace {

constexpr int fewest_rings = 6;      ///< of a coarser mesh
constexpr double damped_step = 0.25; ///< along direction(), whose operator is not the exact linearisation

std::string layout_of(const TransportDomain::Setup& setup) {
    const std::string mesh =
        setup.mesh ? " file " + setup.mesh->topology + " refined " + std::to_string(setup.refinements)
                   : (setup.curved && setup.degree > 1 ? " curved" : "") + std::string(" n=") +
                         std::to_string(setup.rings);
    return "transport P" + std::to_string(setup.degree) + mesh + " from " + setup.source_name;
}
std::string layout_of(const TransportDomain& domain) { return layout_of(domain.setup()); }

/// A layout without its source.
std::string_view mesh_of(const std::string& layout) {
    return std::string_view(layout).substr(0, layout.find(" from "));
}

/// The mesh of the same source that has the layout; the one given if there is none.
TransportDomain::Setup setup_of(const std::string& layout, const TransportDomain::Setup& like) {
    TransportDomain::Setup setup = like;
    const auto fits = [&] { return layout_of(setup) == layout; };
    for (setup.degree = 1; setup.degree <= highest_triangle_degree; ++setup.degree) {
        if (setup.mesh) {
            for (setup.refinements = 0; setup.refinements <= most_domain_refinements; ++setup.refinements)
                if (fits()) return setup;
            continue;
        }
        for (const bool curved : {true, false})
            for (setup.rings = fewest_domain_rings; setup.rings <= most_domain_rings; ++setup.rings) {
                setup.curved = curved;
                if (fits()) return setup;
            }
    }
    return like;
}

} // namespace

TransportEquation::TransportEquation(std::shared_ptr<const TransportDomain> domain, Recovery recovery,
                                     std::stop_token stop)
    : NonlinearProblem(layout_of(*domain), domain->unknowns(), "u"), domain_(std::move(domain)),
      form_(std::make_shared<const NonvariationalSpace>(domain_->elements(), recovery, stop),
            domain_->setup().source, domain_->setup().target),
      preconditioner_(form_.shared_space(), stop) {
    if (stop.stop_requested()) throw Interrupted();
    start_ = form_.start();
    move(start_);
}

std::optional<State> TransportEquation::adopt(const State& other, const Discretisation* of) {
    if (other.arrays.size() != 1 || other.arrays[0].name != "u") return std::nullopt;
    const auto& u = other.arrays[0].values;
    if (u.size() == size() && mesh_of(other.layout) == mesh_of(layout()))
        return state_of(u); // also of another source: then for nodes with the same numbers
    const auto* there = dynamic_cast<const TransportDomain*>(of);
    const auto setup = setup_of(other.layout, there ? there->setup() : domain_->setup());
    const auto domain = std::make_shared<const TransportDomain>(setup);
    if (domain->unknowns() != u.size() || other.layout != layout_of(*domain) ||
        setup.source_name != domain_->setup().source_name)
        return std::nullopt;
    TransportEquation from(domain, form_.space().recovery());
    return adopt(from, u);
}

State TransportEquation::adopt(NonlinearProblem& other, std::span<const double> unknowns) {
    auto& from = dynamic_cast<TransportEquation&>(other);
    std::vector<double> u = recovered_values(from.form_.space(), unknowns.first(from.size() - 1),
                                             form_.space().elements().nodes());
    double mean = 0;
    const auto loads = form_.space().loads();
    for (std::size_t i = 0; i < u.size(); ++i) mean += u[i] * loads[i] / form_.space().area();
    for (double& value : u) value -= mean;
    u.push_back(unknowns.back());
    return state_of(std::move(u));
}

std::unique_ptr<NonlinearProblem> TransportEquation::coarser(const Progress&, std::stop_token stop) const {
    TransportDomain::Setup setup = domain_->setup();
    if (setup.mesh) {
        if (setup.refinements == 0) return nullptr;
        --setup.refinements;
        if (!has_inner_nodes(refined(setup.mesh->convex, setup.refinements))) return nullptr;
    } else {
        setup.rings = (setup.rings + 1) / 2;
        if (setup.rings < fewest_rings) return nullptr;
    }
    return std::make_unique<TransportEquation>(
        std::make_shared<const TransportDomain>(std::move(setup), stop), form_.space().recovery(),
        std::move(stop));
}

Evaluation TransportEquation::evaluate(const ProblemData& data, std::span<const double> unknowns) {
    form_.evaluate(densities(data), unknowns);
    factorised_ = false;
    derivatives_.assign(form_.derivatives().begin(), form_.derivatives().end());
    stop_ = data.stop;
    take_positions();
    const double area = form_.image_area(derivatives_), area_of_target = domain_->setup().target->area();
    return {.residual = form_.normalised_residual(),
            .series = {form_.theta() * data.unit, unknowns.back(), form_.convexity(), form_.boundary_defect(),
                       form_.boundary_scale(), area, area_of_target, area / area_of_target - 1}};
}

TransportDensities TransportEquation::densities(const ProblemData& data) {
    const TransportDensities given{data.source, data.monitor};
    if (given == given_) return relative_;
    const auto& setup = domain_->setup();
    const auto moved = [](const std::shared_ptr<const Monitor>& monitor, Vec3 origin) {
        return monitor && origin != Vec3{} ? std::make_shared<MovedMonitor>(monitor, origin) : monitor;
    };
    relative_ = {moved(given.source, setup.source_origin), moved(given.target, setup.target_origin)};
    given_ = given;
    return relative_;
}

std::shared_ptr<const Points> TransportEquation::exact(const ProblemData& data) {
    const auto& setup = domain_->setup();
    if (!setup.source) return nullptr;
    const auto map = exact_transport(*setup.source, *setup.target, densities(data));
    if (!map) return nullptr;
    const Points& nodes = domain_->mesh()->nodes;
    auto images = std::make_shared<Points>(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
        images->set(i, setup.target_origin + (*map)(nodes[i] - setup.source_origin));
    return images;
}

void TransportEquation::move(std::span<const double> unknowns) {
    form_.space().differentiate(unknowns.first(size() - 1), derivatives_);
    take_positions();
}

void TransportEquation::take_positions() {
    const std::vector<double> at = domain_->at_mesh_nodes(derivatives_, derivative_count);
    positions_.resize(at.size() / derivative_count);
    for (std::size_t i = 0; i < positions_.size(); ++i)
        positions_.set(i, domain_->setup().target_origin +
                              Vec3{at[derivative_count * i + g1], at[derivative_count * i + g2], 0});
}

std::vector<SeriesInfo> TransportEquation::series() const {
    return {
        {.name = "theta",
         .label = "Mass ratio",
         .symbol = "θ",
         .help = "the mass of the target's density, divided by that of the source's"},
        {.name = "multiplier",
         .label = "Multiplier",
         .symbol = "c",
         .help =
             "the constant that is added to the equation, so that its integral vanishes; tends to 0 with h"},
        {.name = "convexity",
         .label = "Convexity",
         .symbol = "λ_min",
         .help =
             "the smallest eigenvalue of the Hessian, averaged around a node; positive: u is convex, though "
             "cells of a coarse mesh may fold"},
        {.name = "boundary_defect",
         .label = "Boundary defect",
         .symbol = "|b|/|grad b|",
         .unit = "length",
         .scale = ParameterScale::logarithmic,
         .help = "the largest distance of the image of a boundary node from the target's boundary"},
        {.name = "boundary_scale",
         .label = "Scale of b",
         .symbol = "s",
         .help = "the factor of the boundary condition, chosen so that its derivative is the conormal one"},
        {.name = "image_area",
         .label = "Area of the image",
         .help = "the area of the image of the source, which tends to that of the target"},
        {.name = "target_area", .label = "Area of the target", .help = "the area of the target"},
        {.name = "area_error",
         .label = "Error of the area",
         .help = "the area of the image divided by that of the target, minus 1"}};
}

IterateShape TransportEquation::shape() const {
    return {.admissibility = form_.convexity(), .stable_step = damped_step, .condition = 1};
}

void TransportEquation::direction(std::span<double> d) {
    if (!std::exchange(factorised_, true)) preconditioner_.factorise(form_.derivatives(), stop_);
    precondition(form_.residual(), d);
}

void TransportEquation::linearise(const ProblemData& data, Linearised) {
    stop_ = data.stop;
    form_.linearise();
    if (!std::exchange(factorised_, true)) preconditioner_.factorise(form_.derivatives(), stop_);
}

ProblemData TransportEquation::continued(const ProblemData& data, double t) const {
    ProblemData result = data;
    result.monitor = std::make_shared<PowerMonitor>(data.monitor, t);
    if (data.source) result.source = std::make_shared<PowerMonitor>(data.source, t);
    return result;
}

std::string TransportEquation::name_of_continued(double t) const {
    char text[48];
    std::snprintf(text, sizeof text, "densities to the power %.3g", t);
    return text;
}

std::vector<std::vector<double>> TransportEquation::fields() const {
    const std::size_t n = form_.space().size();
    std::vector<double> convexity(n), defect = form_.boundary_defects(derivatives_);
    for (std::size_t i = 0; i < n; ++i) {
        const double* d = derivatives_.data() + derivative_count * i;
        convexity[i] = symmetric_eigenvalues(d[h11], d[h12], d[h22]).smallest;
    }
    return {domain_->at_mesh_nodes(convexity, 1), domain_->at_mesh_nodes(defect, 1)};
}

std::vector<FieldInfo> nvfem_fields() {
    return {{.name = "convexity",
             .label = "Convexity",
             .symbol = "λ_min",
             .help = "the smaller eigenvalue of the recovered Hessian of u, which is convex where it is "
                     "positive; cells of a "
                     "coarse mesh may fold all the same"},
            {.name = "boundary_defect",
             .label = "Boundary defect",
             .symbol = "|b|/|grad b|",
             .unit = "length",
             .help = "of boundary nodes, the distance of their image from the target's boundary; 0 inside"}};
}

} // namespace gaspard
