#include "core/method/spline_map.hpp"

#include "core/method/patch_form.hpp"

namespace gaspard {

std::optional<std::array<SplineFunction, 2>> spline_map(const State& state) {
    const auto layout = parse_spline_layout(state.layout);
    if (!layout || state.arrays.size() != 1) return std::nullopt;
    const auto& phi = state.arrays[0].values;
    const std::size_t size = layout->cells + static_cast<std::size_t>(layout->degree) -
                             (layout->formulation == Formulation::mixed ? 1 : 0);
    if (phi.size() != size * size) return std::nullopt;
    const auto form = make_form(*layout);
    std::vector<double> whole = form->identity();
    for (std::size_t i = 0; i < whole.size(); ++i) whole[i] += phi[i];
    return form->map(whole);
}

std::optional<SplinePatch> adapted_patch(const State& state, const PatchMap& map) {
    const auto psi = spline_map(state);
    if (!psi) return std::nullopt;
    const SplineLayout layout = *parse_spline_layout(state.layout);
    const auto breaks = uniform_knots(layout.degree, layout.cells).breaks();
    const KnotVector line = open_knots(layout.degree, breaks, layout.degree - 2);
    const auto at = greville(line);
    Points there(at.size() * at.size()), x;
    for (std::size_t j = 0; j < at.size(); ++j)
        for (std::size_t i = 0; i < at.size(); ++i) {
            const Vec3 xi{at[i], at[j], 0};
            there.set(j * at.size() + i, {evaluate((*psi)[0].space, (*psi)[0].coefficients, xi),
                                          evaluate((*psi)[1].space, (*psi)[1].coefficients, xi), 0});
        }
    map.points(there, x);
    return patch_through({{line, line}}, x);
}

} // namespace gaspard
