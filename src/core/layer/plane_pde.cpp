// Problems with layers on a quadrilateral, from values to what the solver takes.
#include "core/function/coefficient.hpp"
#include "core/layer/layer_pde.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace gaspard {

namespace {

constexpr const char* in_x_y = "a formula in x, y and eps";

/// Which sides are held, in the order of TriangleProblem::held.
constexpr std::array<std::pair<const char*, const char*>, 4> sides = {{{"hold_left", "Hold left side"},
                                                                       {"hold_right", "Hold right side"},
                                                                       {"hold_bottom", "Hold lower side"},
                                                                       {"hold_top", "Hold upper side"}}};

void add_side_rows(std::vector<ParameterRow>& rows) {
    for (const auto& [key, label] : sides)
        rows.push_back({.key = key,
                        .label = label,
                        .kind = ParameterKind::boolean,
                        .default_value = true,
                        .help = "u = 0 on the side; off: no flux through it"});
}

std::array<bool, 4> held_sides(const Values& values) {
    std::array<bool, 4> held{};
    for (std::size_t k = 0; k < 4; ++k) held[k] = values.boolean(sides[k].first);
    return held;
}

/// Evaluates one coefficient after the other; `put` sets it in the coefficients of a point.
class Evaluation {
  public:
    explicit Evaluation(const Points& x, std::span<TriangleCoefficients> all)
        : x_(x), all_(all), values_(all.size()) {}
    template <class Put>
    void operator()(const Coefficient& coefficient, const Put& put) {
        coefficient(x_, values_);
        for (std::size_t i = 0; i < values_.size(); ++i) put(all_[i], values_[i]);
    }

  private:
    const Points& x_;
    std::span<TriangleCoefficients> all_;
    std::vector<double> values_;
};

TriangleProblem reaction_diffusion(const Values& values) {
    const double eps = values.real("eps");
    const bool squared = values.boolean("squared");
    const std::map<std::string, double> names = {{"eps", eps}};
    const auto width = [&](const char* key) {
        return (squared ? coefficient : coefficient_from_zero)(values, key, 2, names);
    };
    const auto diffusion = [=](double k) { return squared ? eps * k * (eps * k) : eps * k; };
    return {
        [=, kx = width("diffusion_x"), ky = width("diffusion_y"),
         r = coefficient_from_zero(values, "reaction", 2, names),
         f = coefficient(values, "source", 2, names)](const Points& x, std::span<TriangleCoefficients> all) {
            Evaluation set(x, all);
            set(kx, [&](auto& at, double k) { at.k1 = diffusion(k); });
            set(ky, [&](auto& at, double k) { at.k2 = diffusion(k); });
            set(r, [](auto& at, double value) { at.r = value; });
            set(f, [](auto& at, double value) { at.f = value; });
        },
        held_sides(values)};
}

TriangleProblem convection_diffusion(const Values& values) {
    const double eps = values.real("eps");
    const auto formula = [&](const char* key) { return coefficient(values, key, 2, {{"eps", eps}}); };
    return {[=, cx = formula("convection_x"), cy = formula("convection_y"), r = formula("reaction"),
             f = formula("source")](const Points& x, std::span<TriangleCoefficients> all) {
                for (TriangleCoefficients& at : all) at.k1 = at.k2 = eps;
                Evaluation set(x, all);
                set(cx, [](auto& at, double value) { at.c1 = value; });
                set(cy, [](auto& at, double value) { at.c2 = value; });
                set(r, [](auto& at, double value) { at.r = value; });
                set(f, [](auto& at, double value) { at.f = value; });
            },
            held_sides(values)};
}

} // namespace

PdeType plane_reaction_diffusion_pde() {
    PdeType type{.name = "reaction-diffusion-2d",
                 .label = "Reaction and diffusion",
                 .help = "layers at sides, whose width varies with the diffusion",
                 .equation = "-((ε k₁)² uₓ)ₓ - ((ε k₂)² u_y)_y + r u = f",
                 .rows = {perturbation_row("eps", "ε", 1e-3),
                          coefficient_row("diffusion_x", "Diffusion in x", "k₁", "1", in_x_y),
                          coefficient_row("diffusion_y", "Diffusion in y", "k₂", "1", in_x_y),
                          {.key = "squared",
                           .label = "Squared diffusion",
                           .kind = ParameterKind::boolean,
                           .default_value = true,
                           .help = "the diffusion is (ε k)²; off: ε k"},
                          coefficient_row("reaction", "Reaction", "r", "1", in_x_y),
                          coefficient_row("source", "Source", "f", "1", in_x_y)}};
    add_side_rows(type.rows);
    return type;
}

PdeType plane_convection_diffusion_pde() {
    PdeType type{.name = "convection-diffusion-2d",
                 .label = "Convection and diffusion",
                 .help = "exponential layers where the flow leaves, parabolic ones along it",
                 .equation = "-ε Δu + c₁ uₓ + c₂ u_y + r u = f",
                 .rows = {perturbation_row("eps", "ε", 1e-3),
                          coefficient_row("convection_x", "Convection in x", "c₁", "1", in_x_y),
                          coefficient_row("convection_y", "Convection in y", "c₂", "0", in_x_y),
                          coefficient_row("reaction", "Reaction", "r", "0", in_x_y),
                          coefficient_row("source", "Source", "f", "1", in_x_y)}};
    add_side_rows(type.rows);
    return type;
}

std::optional<TriangleProblem> plane_pde(const std::string& type, const Values& values) {
    if (type == plane_reaction_diffusion_pde().name) return reaction_diffusion(values);
    if (type == plane_convection_diffusion_pde().name) return convection_diffusion(values);
    return std::nullopt;
}

} // namespace gaspard
