// Densities for boundary layers of width eps / beta at sides of the domain, Hill, Madden (2021):
//
//   layer        (18), (34)   rho = max{ 1, sum_s K beta/eps exp(-beta d_s / (sigma eps)) }
//   two-layers   (27)         rho = 1 + sum_s sum_j K beta/eps_j exp(-beta d_s / (sigma eps_j)),  j = 1, 2
//
// d_s is the distance from side s along an axis: x - a and b - x on an interval. K = q / (sigma (1 - q)) puts
// a share of about q of the cells into a layer (21).
#include "core/base/error.hpp"
#include "core/monitor/monitor.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace gaspard {

namespace {

/// One term of the density: at one side, with one eps.
struct Term {
    double sign, end;     ///< d = sign (x - end)
    double height, decay; ///< height exp(-decay d)
};

/// Both monitors; the larger of 1 and the sum of the terms, or their sum.
class LayerDensity final : public Monitor {
  public:
    LayerDensity(std::vector<Term> terms, bool sum) : terms_(std::move(terms)), base_(sum ? 1 : 0) {}

    void values(const Points& x, std::span<double> values) const override {
        for (std::size_t i = 0; i < values.size(); ++i) {
            double rho = base_;
            for (const Term& term : terms_)
                rho += term.height * std::exp(-term.decay * std::max(0.0, term.sign * (x.x[i] - term.end)));
            values[i] = std::max(1.0, rho);
        }
    }

  private:
    std::vector<Term> terms_;
    double base_;
};

Box ends_of(const Space& space) {
    return space.reach.empty() ? Box{{0, 0, 0}, {1, 0, 0}} : space.reach.front();
}

std::vector<Term> terms(const Values& values, const Space& space, const std::vector<double>& all_eps) {
    const double sigma = values.real("sigma"), beta = values.real("beta"), q = values.real("q");
    const double k = values.real_or_auto("K").value_or(q / (sigma * (1 - q)));
    const Box ends = ends_of(space);
    std::vector<Term> found;
    for (const double eps : all_eps) {
        const double height = k * beta / eps, decay = beta / (sigma * eps);
        if (values.boolean("left")) found.push_back({1, ends.low.x, height, decay});
        if (values.boolean("right")) found.push_back({-1, ends.high.x, height, decay});
    }
    return found;
}

/// eps and its relatives: of the monitor, or of the problem where they are automatic.
std::vector<double> eps_of(const Values& values, const std::vector<std::string>& keys,
                           const MonitorContext& context) {
    std::vector<double> found;
    for (const std::string& key : keys) {
        const auto own = values.real_or_auto(key);
        if (!own && (!context.pde || !context.pde->has(key)))
            throw InputError(values.section() + "." + key + " = auto: the problem has no " + key +
                             "; set it to a number");
        found.push_back(own ? *own : context.pde->real(key));
    }
    return found;
}

ParameterRow eps_row(const std::string& key, const char* symbol) {
    return {.key = key,
            .label = "Layer width",
            .symbol = symbol,
            .kind = ParameterKind::real_or_auto,
            .minimum = 1e-12,
            .maximum = 1,
            .scale = ParameterScale::logarithmic,
            .default_value = std::string("auto"),
            .help = "the layer decays as exp(-β d/ε); auto: that of the problem"};
}

ParameterRow side_row(const char* key, const char* label, bool on) {
    return {.key = key,
            .label = label,
            .kind = ParameterKind::boolean,
            .default_value = on,
            .help = "a layer at this end"};
}

std::vector<ParameterRow> rows(std::vector<ParameterRow> eps, bool both_sides, Value k) {
    std::vector<ParameterRow> all = std::move(eps);
    const std::vector<ParameterRow> others = {
        {.key = "q",
         .label = "Share in a layer",
         .symbol = "q",
         .minimum = 0.01,
         .maximum = 0.99,
         .default_value = 0.5,
         .help = "share of the cells in a layer, where K is automatic"},
        {.key = "sigma",
         .label = "Order",
         .symbol = "σ",
         .minimum = 0.1,
         .maximum = 20,
         .scale = ParameterScale::logarithmic,
         .default_value = 2.5,
         .help = "the cells grow from the side as the layer to the power 1/σ; usually the order of the "
                 "method or a little more"},
        {.key = "beta",
         .label = "Decay",
         .symbol = "β",
         .minimum = 0.01,
         .maximum = 100,
         .scale = ParameterScale::logarithmic,
         .default_value = 0.99,
         .help = "the layer decays as exp(-β d/ε)"},
        {.key = "K",
         .label = "Weight",
         .symbol = "K",
         .kind = ParameterKind::real_or_auto,
         .minimum = 1e-3,
         .maximum = 100,
         .scale = ParameterScale::logarithmic,
         .default_value = std::move(k),
         .help = "weight of a layer against the rest; auto: q/(σ(1 - q))"},
        side_row("left", "Left end", true),
        side_row("right", "Right end", both_sides)};
    all.insert(all.end(), others.begin(), others.end());
    return all;
}

} // namespace

MonitorType layer_monitor_type() {
    return {
        .name = "layer",
        .label = "Layer",
        .help = "cells as in Bakhvalov's meshes, for a boundary layer",
        .equation = "ρ(x) = max{1, Σ K β/ε exp(-β d/(σ ε))}, d the distance from an end",
        .spaces = {SpaceKind::euclidean},
        .rows = [](const Space&) { return rows({eps_row("eps", "ε")}, false, std::string("auto")); },
        .make = [](const Values& values, const MonitorContext& context) -> std::shared_ptr<const Monitor> {
            return std::make_shared<LayerDensity>(
                terms(values, context.space, eps_of(values, {"eps"}, context)), false);
        }};
}

MonitorType two_layers_monitor_type() {
    return {
        .name = "two-layers",
        .label = "Two layers",
        .help = "for boundary layers of two widths at the same place",
        .equation = "ρ(x) = 1 + Σ K β/ε₁ exp(-β d/(σ ε₁)) + K β/ε₂ exp(-β d/(σ ε₂))",
        .spaces = {SpaceKind::euclidean},
        .rows =
            [](const Space&) {
                return rows({eps_row("eps1", "ε₁"), eps_row("eps2", "ε₂")}, true, 0.1);
            },
        .make = [](const Values& values, const MonitorContext& context) -> std::shared_ptr<const Monitor> {
            return std::make_shared<LayerDensity>(
                terms(values, context.space, eps_of(values, {"eps1", "eps2"}, context)), true);
        }};
}

} // namespace gaspard
