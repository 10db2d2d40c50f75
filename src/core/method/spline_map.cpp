#include "core/method/spline_map.hpp"

#include "core/method/patch_form.hpp"

namespace gaspard {

namespace {

/// Of a state with a layout of this dimension.
template <std::size_t D>
std::optional<std::vector<SplineFunction>> map_of(const SplineLayout& layout, std::span<const double> phi) {
    const std::size_t size = layout.cells + static_cast<std::size_t>(layout.degree) -
                             (layout.formulation == Formulation::mixed ? 1 : 0);
    if (phi.size() != tensor_size<D>(size)) return std::nullopt;
    const auto form = make_form<D>(layout);
    std::vector<double> whole = form->identity();
    for (std::size_t i = 0; i < whole.size(); ++i) whole[i] += phi[i];
    const auto map = form->map(whole);
    return std::vector<SplineFunction>(map.begin(), map.end());
}

} // namespace

std::optional<std::vector<SplineFunction>> spline_map(const State& state) {
    const auto layout = parse_spline_layout(state.layout);
    if (!layout || state.arrays.size() != 1) return std::nullopt;
    const auto& phi = state.arrays[0].values;
    return layout->dimension == 2 ? map_of<2>(*layout, phi) : map_of<3>(*layout, phi);
}

template <std::size_t D>
std::optional<SplinePatch> adapted_patch(const State& state, const TensorMap<D>& map) {
    const auto psi = spline_map(state);
    if (!psi || psi->size() != D) return std::nullopt;
    const SplineLayout layout = *parse_spline_layout(state.layout);
    const auto breaks = uniform_knots(layout.degree, layout.cells).breaks();
    const KnotVector line = open_knots(layout.degree, breaks, layout.degree - 2);
    const auto at = greville(line);
    const std::size_t n = at.size();
    Points there(tensor_size<D>(n)), x;
    for (std::size_t i = 0; i < there.size(); ++i) {
        const Vec3 xi{at[i % n], at[i / n % n], D == 3 ? at[i / n / n] : 0};
        const auto component = [&](std::size_t d) {
            return evaluate((*psi)[d].space, (*psi)[d].coefficients, xi);
        };
        there.set(i, {component(0), component(1), D == 3 ? component(D - 1) : 0});
    }
    map.points(there, x);
    return patch_through({std::vector<KnotVector>(D, line)}, x);
}

template std::optional<SplinePatch> adapted_patch(const State& state, const TensorMap<2>& map);
template std::optional<SplinePatch> adapted_patch(const State& state, const TensorMap<3>& map);

} // namespace gaspard
