#include "core/method/spline_map.hpp"

#include "core/method/patch_form.hpp"

namespace gaspard {

namespace {

using Map = std::array<SplineFunction, 2>;

/// The gradient of a function in S^p (x) S^p.
Map gradient(const KnotVector& line, std::span<const double> phi) {
    const std::size_t n = line.size();
    const KnotVector lower = derivative_space(line);
    Map map{SplineFunction{{{lower, line}}, {}}, SplineFunction{{{line, lower}}, {}}};
    map[1].coefficients.resize(n * (n - 1));
    std::vector<double> column(n);
    for (std::size_t k = 0; k < n; ++k) {
        const auto along = derivative_coefficients(line, phi.subspan(k * n, n));
        map[0].coefficients.insert(map[0].coefficients.end(), along.begin(), along.end());
        for (std::size_t j = 0; j < n; ++j) column[j] = phi[j * n + k];
        const auto across = derivative_coefficients(line, column);
        for (std::size_t j = 0; j + 1 < n; ++j) map[1].coefficients[j * n + k] = across[j];
    }
    return map;
}

} // namespace

std::optional<Map> spline_map(const State& state) {
    const auto layout = parse_spline_layout(state.layout);
    if (!layout || state.arrays.size() != 1) return std::nullopt;
    const auto& phi = state.arrays[0].values;
    const std::size_t size = layout->cells + static_cast<std::size_t>(layout->degree) -
                             (layout->formulation == Formulation::mixed ? 1 : 0);
    if (phi.size() != size * size) return std::nullopt;
    const auto form = make_form(*layout);
    std::vector<double> whole = form->identity();
    for (std::size_t i = 0; i < whole.size(); ++i) whole[i] += phi[i];
    const SplineLine& line = form->line();
    if (layout->formulation == Formulation::standard) return gradient(line.upper, whole);
    auto workspace = form->make_workspace();
    form->expand(whole, SplineForm::Border::given, SplineGrid(line, {0}), 2, workspace);
    return Map{SplineFunction{{{line.upper, line.lower}}, workspace.first},
               SplineFunction{{{line.lower, line.upper}}, workspace.second}};
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
