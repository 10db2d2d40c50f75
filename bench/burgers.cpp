// Errors of Burgers' equation on its own adapted mesh and on the uniform one, against the travelling front
// (docs/sources.md): L2 norms at time 1.
#include "core/flow/burgers.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace {

using namespace gaspard;

double solve(std::size_t cells, double nu, bool adapted) {
    const BurgersData exact = burgers_front(nu, 0.25);
    Burgers equation({.cells = cells, .nu = nu, .adapted = adapted}, exact);
    equation.advance(1);
    return l2_error(equation, exact);
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
