// CPU time to generate the layer-adapted meshes of Hill, Madden (2021), without the solution on them, on one
// thread; the same work as bench/peers/hill_madden_1d_fenics.py and hill_madden_2d_fenics.py.
//
// usage: bench_layers interval|corners|degree-4 EPS N REPEATS
//
// interval: algorithm 2 for one layer; corners, degree-4: algorithm 3 for varying diffusion, with the
// densities sampled there. Prints the seconds of every repetition.
#include "core/base/check.hpp"
#include "core/published/hill_problems.hpp"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>

namespace {

using namespace gaspard;

double process_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A function that makes the mesh once.
std::function<void()> work(const std::string& mesh, double eps, int cells) {
    if (mesh == "interval")
        return [problem = hill_scalar(builtin_catalogue(), eps), cells] {
            GASPARD_CHECK(mesh_pde_interval(*problem.density, {}, cells, problem.options).converged);
        };
    HillSquare problem = hill_varying(eps, Diffusion::squared);
    problem.options.samples = mesh == "corners" ? DensitySamples::corners : DensitySamples::degree_4;
    return [problem, cells] {
        const auto made = mesh_pde_square(problem.densities, cells, problem.options);
        GASPARD_CHECK(inverted_triangles(made.x, cells) == 0);
    };
}

} // namespace

int main(int count, char** words) {
    if (count != 5)
        return std::fprintf(stderr, "usage: bench_layers interval|corners|degree-4 EPS N REPEATS\n"), 2;
    const auto make = work(words[1], std::atof(words[2]), std::atoi(words[3]));
    make();
    for (int k = std::atoi(words[4]); k > 0; --k) {
        const double start = process_seconds();
        make();
        std::printf("%.7g\n", process_seconds() - start);
    }
}
