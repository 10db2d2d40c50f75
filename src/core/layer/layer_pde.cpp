#include "core/layer/layer_pde.hpp"

#include "core/function/coefficient.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace gaspard {

namespace {

constexpr const char* in_x = "a formula in x and eps";
constexpr const char* in_x_2 = "a formula in x, eps1 and eps2";

bool has_default(const Values& values, const std::vector<std::string>& keys) {
    return std::all_of(keys.begin(), keys.end(), [&](const auto& key) { return is_default(values, key); });
}

Points on_line(std::span<const double> x) {
    Points points(x.size());
    points.x.assign(x.begin(), x.end());
    return points;
}

/// One component; `convection` may be empty.
IntervalProblem scalar(double diffusion, Coefficient convection, Coefficient reaction, Coefficient source) {
    return {{diffusion}, [=](std::span<const double> x, IntervalCoefficients& at) {
                const Points points = on_line(x);
                if (convection) convection(points, at.convection);
                reaction(points, at.reaction);
                source(points, at.source);
            }};
}

/// Of -eps^2 u'' + u = 1 - x: 1 - x with multiples of exp(-(x - a)/eps) and exp(-(b - x)/eps) that vanish at
/// the ends.
IntervalExact exact_reaction_diffusion(double eps, Interval on) {
    const double decay = std::exp(-(on.b - on.a) / eps); // of one layer at the other end
    const double determinant = -std::expm1(-2 * (on.b - on.a) / eps);
    const double at_a = -((1 - on.a) - (1 - on.b) * decay) / determinant;
    const double at_b = -((1 - on.b) - (1 - on.a) * decay) / determinant;
    return {[=](double x) {
                return 1 - x + at_a * std::exp(-(x - on.a) / eps) + at_b * std::exp(-(on.b - x) / eps);
            },
            [=](double x) {
                return -1 + (at_b * std::exp(-(on.b - x) / eps) - at_a * std::exp(-(x - on.a) / eps)) / eps;
            }};
}

/// Of -eps u'' + u' = 1: x - a - (b - a) (exp(-(b - x)/eps) - exp(-(b - a)/eps)) / (1 - exp(-(b - a)/eps)).
IntervalExact exact_convection_diffusion(double eps, Interval on) {
    const double length = on.b - on.a, decay = std::exp(-length / eps), rest = -std::expm1(-length / eps);
    return {[=](double x) { return x - on.a - length * (std::exp(-(on.b - x) / eps) - decay) / rest; },
            [=](double x) { return 1 - length * std::exp(-(on.b - x) / eps) / (eps * rest); }};
}

IntervalPde reaction_diffusion(const Values& values, Interval on) {
    const double eps = values.real("eps");
    const std::map<std::string, double> names = {{"eps", eps}};
    IntervalPde pde{scalar(eps * eps, {}, coefficient_from_zero(values, "reaction", 1, names),
                           coefficient(values, "source", 1, names))};
    if (has_default(values, {"reaction", "source"})) pde.exact = exact_reaction_diffusion(eps, on);
    return pde;
}

IntervalPde convection_diffusion(const Values& values, Interval on) {
    const double eps = values.real("eps");
    const std::map<std::string, double> names = {{"eps", eps}};
    IntervalPde pde{scalar(eps, coefficient(values, "convection", 1, names),
                           coefficient(values, "reaction", 1, names),
                           coefficient(values, "source", 1, names))};
    if (has_default(values, {"convection", "reaction", "source"}))
        pde.exact = exact_convection_diffusion(eps, on);
    return pde;
}

IntervalPde coupled(const Values& values) {
    const double eps1 = values.real("eps1"), eps2 = values.real("eps2");
    const std::map<std::string, double> names = {{"eps1", eps1}, {"eps2", eps2}};
    std::array<Coefficient, 4> reaction;
    std::array<Coefficient, 2> source;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string row = std::to_string(i + 1);
        source[i] = coefficient(values, "source_" + row, 1, names);
        for (std::size_t j = 0; j < 2; ++j)
            reaction[2 * i + j] = (i == j ? coefficient_from_zero : coefficient)(
                values, "reaction_" + row + std::to_string(j + 1), 1, names);
    }
    return {{{eps1 * eps1, eps2 * eps2}, [=](std::span<const double> x, IntervalCoefficients& at) {
                 const Points points = on_line(x);
                 std::vector<double> one(x.size());
                 const auto put = [&](const Coefficient& f, std::vector<double>& all, std::size_t place,
                                      std::size_t stride) {
                     f(points, one);
                     for (std::size_t i = 0; i < one.size(); ++i) all[i * stride + place] = one[i];
                 };
                 for (std::size_t k = 0; k < 4; ++k) put(reaction[k], at.reaction, k, 4);
                 for (std::size_t k = 0; k < 2; ++k) put(source[k], at.source, k, 2);
             }}};
}

} // namespace

ParameterRow perturbation_row(const char* key, const char* symbol, double value) {
    return {.key = key,
            .label = "Perturbation",
            .symbol = symbol,
            .minimum = 1e-12,
            .maximum = 1,
            .scale = ParameterScale::logarithmic,
            .default_value = value,
            .help = "the smaller, the thinner the layers of the solution"};
}

PdeType no_pde() {
    return {.name = "none", .label = "None", .help = "only the mesh is computed", .equation = {}, .rows = {}};
}

PdeType reaction_diffusion_pde() {
    return {.name = "reaction-diffusion",
            .label = "Reaction and diffusion",
            .help = "layers at the ends, where f/r is not zero",
            .equation = "-ε² u'' + r u = f, u = 0 at the ends",
            .rows = {perturbation_row("eps", "ε", 1e-4),
                     coefficient_row("reaction", "Reaction", "r", "1", in_x),
                     coefficient_row("source", "Source", "f", "1 - x", in_x)}};
}

PdeType coupled_pde() {
    return {.name = "coupled-reaction-diffusion",
            .label = "Two coupled equations",
            .help = "layers of two widths at both ends",
            .equation = "-εₖ² uₖ'' + rₖ₁ u₁ + rₖ₂ u₂ = fₖ, k = 1, 2, uₖ = 0 at the ends",
            .rows = {perturbation_row("eps1", "ε₁", 1e-8), perturbation_row("eps2", "ε₂", 1e-4),
                     coefficient_row("reaction_11", "Reaction 11", "r₁₁", "2*(x + 1)^2", in_x_2),
                     coefficient_row("reaction_12", "Reaction 12", "r₁₂", "-(1 + x^3)", in_x_2),
                     coefficient_row("reaction_21", "Reaction 21", "r₂₁", "-2*cos(pi*x/4)", in_x_2),
                     coefficient_row("reaction_22", "Reaction 22", "r₂₂", "(1 + sqrt(2))*exp(1 - x)", in_x_2),
                     coefficient_row("source_1", "Source 1", "f₁", "2*exp(x)", in_x_2),
                     coefficient_row("source_2", "Source 2", "f₂", "10*x + 1", in_x_2)}};
}

PdeType convection_diffusion_pde() {
    return {.name = "convection-diffusion",
            .label = "Convection and diffusion",
            .help = "an exponential layer where the flow leaves",
            .equation = "-ε u'' + c u' + r u = f, u = 0 at the ends",
            .rows = {perturbation_row("eps", "ε", 1e-4),
                     coefficient_row("convection", "Convection", "c", "1", in_x),
                     coefficient_row("reaction", "Reaction", "r", "0", in_x),
                     coefficient_row("source", "Source", "f", "1", in_x)}};
}

std::optional<IntervalPde> interval_pde(const std::string& type, const Values& values, Interval interval) {
    if (type == reaction_diffusion_pde().name) return reaction_diffusion(values, interval);
    if (type == convection_diffusion_pde().name) return convection_diffusion(values, interval);
    if (type == coupled_pde().name) return coupled(values);
    return std::nullopt;
}

EnergyBound one_layer_bound(double eps, double n) { return {std::sqrt(eps) / n, "√ε / N"}; }

EnergyBound two_layers_bound(double eps1, double eps2, double n) {
    return {(std::sqrt(eps1) + std::sqrt(eps2)) / n + 1 / (n * n), "(√ε₁ + √ε₂) / N + 1 / N²"};
}

EnergyBound plane_layers_bound(double eps, double n) {
    return {std::sqrt(eps) / n + 1 / (n * n), "√ε / N + 1 / N²"};
}

std::optional<EnergyBound> energy_bound(const std::string& type, const Values& values, double n) {
    if (type == reaction_diffusion_pde().name) return one_layer_bound(values.real("eps"), n);
    if (type == coupled_pde().name) return two_layers_bound(values.real("eps1"), values.real("eps2"), n);
    if (type == plane_reaction_diffusion_pde().name) return plane_layers_bound(values.real("eps"), n);
    if (type == convection_diffusion_pde().name || type == plane_convection_diffusion_pde().name)
        return EnergyBound{1 / n, "1 / N"};
    return std::nullopt;
}

} // namespace gaspard
