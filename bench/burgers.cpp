// Errors of Burgers' equation on its own adapted mesh and on the uniform one, against the travelling front
// (docs/sources.md): L2 norms at time 1.
#include "core/flow/burgers.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace {

using namespace gaspard;

/// By a Gauss rule on every cell.
double error_of(const Burgers& equation, const BurgersData& exact) {
    const double third = std::sqrt(0.6);
    const std::array places{(1 - third) / 2, 0.5, (1 + third) / 2}, weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
    double sum = 0;
    for (std::size_t k = 0; k + 1 < equation.x().size(); ++k)
        for (std::size_t q = 0; q < 3; ++q) {
            const double left = equation.x()[k], width = equation.x()[k + 1] - left, s = places[q];
            const double u = (1 - s) * equation.u()[k] + s * equation.u()[k + 1];
            const double e = u - exact(left + s * width, equation.time());
            sum += weights[q] * width * e * e;
        }
    return std::sqrt(sum);
}

double solve(std::size_t cells, double nu, bool adapted) {
    const BurgersData exact = burgers_front(nu, 0.25);
    Burgers equation({.cells = cells, .nu = nu, .adapted = adapted}, exact);
    equation.advance(1);
    return error_of(equation, exact);
}

} // namespace

int main() {
    std::puts("| ν | N | adapted | order | uniform | order | ratio |\n"
              "| --- | --- | --- | --- | --- | --- | --- |");
    for (const double nu : {1e-2, 1e-3}) {
        double adapted_before = 0, uniform_before = 0;
        for (const std::size_t cells : {20u, 40u, 80u, 160u, 320u}) {
            const double adapted = solve(cells, nu, true), uniform = solve(cells, nu, false);
            char first[16] = "", second[16] = "";
            if (adapted_before > 0) {
                std::snprintf(first, sizeof first, "%.2f", std::log2(adapted_before / adapted));
                std::snprintf(second, sizeof second, "%.2f", std::log2(uniform_before / uniform));
            }
            std::printf("| %g | %zu | %.2e | %s | %.2e | %s | %.0f |\n", nu, cells, adapted, first, uniform,
                        second, uniform / adapted);
            adapted_before = adapted, uniform_before = uniform;
        }
    }
}
