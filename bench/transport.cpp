// CPU time of the transport from the unit disk to an ellipse (Kawecki, Lakkis, Pryer, 2018, second experiment)
// with degree 1 and recovery, on one thread: mesh, operators and Newton's method; the same work as
// bench/peers/kawecki_nvfem_fenics.py.
//
// usage: bench_transport N REPEATS
//
// Prints the seconds of every repetition, its Newton steps, the most inner iterations of a step, and the L2 error.
#include "core/base/check.hpp"
#include "core/published/kawecki.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

double process_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace

int main(int count, char** words) {
    if (count != 3) return std::fprintf(stderr, "usage: bench_transport N REPEATS\n"), 2;
    for (int k = std::atoi(words[2]); k > 0; --k) {
        const double start = process_seconds();
        const auto solve = gaspard::solve_kawecki({.rings = std::atoi(words[1])});
        const double seconds = process_seconds() - start;
        const auto& inner = solve.newton.inner;
        GASPARD_CHECK(solve.newton.converged);
        std::printf("%.7g %zu %d %.4g\n", seconds, inner.size(),
                    *std::max_element(inner.begin(), inner.end()), solve.errors.value);
    }
}
