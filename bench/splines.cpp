// CPU time per spline Picard iteration without mesh measurement, for the circle of Example 5.3 on the square
// and for the known solution of Examples 5.2 and 7.2 in the cube (std3, mix3); the same work as
// bench/peers/bahari_numpy/timing.py and timing_solid.py. Prints one line per case: form, degree, cells,
// milliseconds. With the argument "threads": wall time in the cube with one and two threads. With the argument
// "measures", the iteration on other patches, p = 3 in the standard form, for either method.measure: patch,
// cells, milliseconds for parameter and for physical.
#include "core/method/manufactured.hpp"
#include "core/method/patch_form.hpp"
#include "core/spline/patch_file.hpp"
#include "support/built_in.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string_view>
#include <utility>

namespace {

using namespace gaspard;

double process_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The fastest of several rounds of ten iterations, on the square from phi = 0 (which is not the identity map,
/// as in the peer), otherwise from the identity.
double milliseconds(Formulation formulation, int degree, std::size_t cells,
                    const std::shared_ptr<const PatchMap>& map = square_map(),
                    Measure measure = Measure::parameter) {
    const auto domain = std::make_shared<SplineDomain>(degree, cells, map);
    PatchForm patch(domain, formulation, cells);
    patch.set_measure(measure);
    const auto monitor = make_monitor("circle", {});
    const PatchSource source = patch.source(*monitor);
    Bfo bfo(patch.form());
    double best = 1e300;
    for (int round = 0; round < 7; ++round) {
        std::vector<double> phi = patch.form()->identity(), next(phi), increment(phi);
        if (map->is_identity()) std::fill(phi.begin(), phi.end(), 0.0);
        double residual = 0;
        constexpr int iterations = 10;
        const double start = process_seconds();
        for (int k = 0; k < iterations; ++k) {
            bfo.iterate(source, phi, next);
            for (std::size_t i = 0; i < phi.size(); ++i) increment[i] = next[i] - phi[i];
            residual = patch.form()->norm_without_mean(increment);
            phi.swap(next);
        }
        best = std::min(best, (process_seconds() - start) / iterations);
        if (!(residual < 1)) std::printf("no convergence: %g\n", residual);
    }
    return 1e3 * best;
}

/// In the cube; wall time if there is more than one thread.
double solid_milliseconds(Formulation formulation, std::size_t cells, std::size_t threads, bool wall) {
    double best = 1e300;
    for (int round = 0; round < 3; ++round) {
        const ManufacturedResult result = solve_manufactured(
            {.formulation = formulation, .cells = cells, .dimension = 3, .threads = threads});
        best = std::min(best, (wall ? result.seconds : result.cpu_seconds) / result.iterations);
    }
    return 1e3 * best;
}

void print_measures() {
    for (const auto& [name, map] :
         {std::pair{"disk", disk_map()}, std::pair{"annulus", quarter_annulus_map()},
          std::pair{"torus", torus_part_map()}, std::pair{"moebius", moebius_map()},
          std::pair{"nurbs", patch_map(nurbs_disk())}})
        for (const std::size_t cells : {32u, 64u, 128u})
            std::printf("%s %zu %.4f %.4f\n", name, cells,
                        milliseconds(Formulation::standard, 3, cells, map, Measure::parameter),
                        milliseconds(Formulation::standard, 3, cells, map, Measure::physical));
}

} // namespace

int main(int count, char** arguments) {
    const std::string_view what = count > 1 ? arguments[1] : "";
    if (what == "measures") {
        print_measures();
        return 0;
    }
    const std::pair<Formulation, const char*> solid_forms[] = {{Formulation::standard, "std3"},
                                                               {Formulation::mixed, "mix3"}};
    if (what == "threads") {
        for (const auto& [formulation, name] : solid_forms)
            for (const std::size_t threads : {1u, 2u})
                std::printf("%s 32 cells, %zu threads: %.1f ms\n", name, threads,
                            solid_milliseconds(formulation, 32, threads, true));
        return 0;
    }
    for (const auto& [formulation, name] : solid_forms)
        for (const std::size_t cells : {16u, 32u, 64u})
            std::printf("%s 3 %zu %.4f\n", name, cells, solid_milliseconds(formulation, cells, 1, false));
    for (const auto& [formulation, name] :
         {std::pair{Formulation::standard, "std"}, std::pair{Formulation::mixed, "mix"}})
        for (const int degree : {3, 5})
            for (const std::size_t cells : {16u, 32u, 64u, 128u, 256u})
                std::printf("%s %d %zu %.4f\n", name, degree, cells,
                            milliseconds(formulation, degree, cells));
}
