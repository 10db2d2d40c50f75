#include "core/published/hill_problems.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace gaspard {

namespace {

constexpr double beta = 0.99, sigma = 2.5;

std::shared_ptr<const Monitor> density(const Catalogue& catalogue, const std::string& type, double k,
                                       const std::vector<std::pair<std::string, double>>& eps) {
    const MonitorType& layers = catalogue.monitor(type);
    const Space line{.dimension = 1};
    Values values("monitor", layers.rows(line));
    values.set("beta", beta), values.set("sigma", sigma), values.set("K", k);
    for (const auto& [key, value] : eps) values.set(key, value);
    return layers.make(values, {.space = line});
}

/// The defaults of the problems are those of the paper.
IntervalPde problem(const PdeType& type, const std::vector<std::pair<std::string, double>>& eps) {
    Values values("pde", type.rows);
    for (const auto& [key, value] : eps) values.set(key, value);
    return interval_pde(type.name, values, {}).value();
}

/// One layer of width eps / beta, `away` from its side.
double layer(double k, double eps, double away) {
    return k * beta / eps * std::exp(-beta * away / (sigma * eps));
}

} // namespace

HillInterval hill_scalar(const Catalogue& catalogue, double eps) {
    return {density(catalogue, "layer", 0.4, {{"eps", eps}}),
            problem(reaction_diffusion_pde(), {{"eps", eps}}),
            {.start_cells = 4, .inner = 3, .tolerance = 0.4}};
}

HillInterval hill_coupled(const Catalogue& catalogue, double eps1, double eps2) {
    return {density(catalogue, "two-layers", 0.1, {{"eps1", eps1}, {"eps2", eps2}}),
            problem(coupled_pde(), {{"eps1", eps1}, {"eps2", eps2}}),
            {.start_cells = 4, .inner = 5, .tolerance = 0.5}};
}

HillSquare hill_irregular(double eps) {
    return {[eps](const Points& x, std::span<double> m11, std::span<double> m22) {
                for (std::size_t i = 0; i < m22.size(); ++i) {
                    m11[i] = 1;
                    m22[i] =
                        std::max(1.0, layer(0.28, eps, x.y[i] - x.x[i] / 2) + layer(0.28, eps, 1 - x.y[i]));
                }
            },
            {.form = MeshPdeForm::one_direction, .corners = {Vec3{0, 0}, {1, 0.5}, {0, 1}, {1, 1}}},
            {.coefficients = pointwise([eps](double x, double) {
                 return TriangleCoefficients{.k1 = eps * eps, .k2 = eps * eps, .f = x};
             }),
             .held = {true, false, true, true}}};
}

HillSquare hill_varying(double eps, Diffusion diffusion) {
    const auto eps1 = [eps](double y) { return eps * (1 + 2 * y) * (1 + 2 * y); };
    const auto eps2 = [eps](double x) { return eps * (3 - 2 * x) * (3 - 2 * x); };
    const double power = diffusion == Diffusion::squared ? 2 : 1;
    return {[=](const Points& x, std::span<double> m11, std::span<double> m22) {
                for (std::size_t i = 0; i < m11.size(); ++i) {
                    m11[i] = std::max(1.0, layer(0.4, eps1(x.y[i]), 1 - x.x[i]));
                    m22[i] = std::max(1.0, layer(0.4, eps2(x.x[i]), 1 - x.y[i]));
                }
            },
            {},
            {.coefficients = pointwise([=](double x, double y) {
                 return TriangleCoefficients{.k1 = std::pow(eps1(y), power),
                                             .k2 = std::pow(eps2(x), power),
                                             .f = std::expm1(x) * std::expm1(y)};
             })}};
}

} // namespace gaspard
