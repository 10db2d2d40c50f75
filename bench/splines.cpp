// CPU time per spline Picard iteration without mesh measurement, for the circle of Example 5.3 on the square;
// the same work as bench/peers/bahari_numpy/timing.py. Prints one line per case: form, degree, cells,
// milliseconds. With the argument "measures", the iteration on other patches, p = 3 in the standard form, for
// either method.measure: patch, cells, milliseconds for parameter and for physical.
#include "core/method/patch_form.hpp"
#include "core/spline/patch_file.hpp"
#include "support/built_in.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>

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

int main(int argc, char** argv) {
    if (argc > 1 && std::strcmp(argv[1], "measures") == 0) {
        print_measures();
        return 0;
    }
    for (const auto& [formulation, name] :
         {std::pair{Formulation::standard, "std"}, std::pair{Formulation::mixed, "mix"}})
        for (const int degree : {3, 5})
            for (const std::size_t cells : {16u, 32u, 64u, 128u, 256u})
                std::printf("%s %d %zu %.4f\n", name, degree, cells,
                            milliseconds(formulation, degree, cells));
}
