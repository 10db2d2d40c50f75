// Convergence order of the equidistribution measure (5.2) under refinement, for quadrilaterals and triangles
// on the plane and on the sphere. McRae, Cotter, Budd (section 5.4) observe second order for squares on the
// plane and first order for triangles on the sphere and leave the cause open. The rings have the same
// smoothness and the meshes the same number of cells.
#include "core/diagnostics/quality.hpp"
#include "core/method/surface_equation.hpp"
#include "support/built_in.hpp"
#include "support/periodic_surface.hpp"

#include <cmath>
#include <cstdio>
#include <functional>

namespace {

using namespace gaspard;

struct Sequence {
    const char* name;
    std::function<SurfaceSetup(int)> setup; ///< argument: resolution, doubled in each refinement
    std::vector<int> sizes;
    Space space;
    Settings ring;
};

/// The measure on the converged mesh.
double equidistribution(const Sequence& sequence, int size) {
    const auto surface = std::make_shared<const SurfaceQ2>(sequence.setup(size));
    const auto monitor = make_monitor("ring", sequence.space, sequence.ring);
    const MethodType type = accelerated_method();
    const auto method = type.make(
        {.discretisation = surface, .problem = [&] { return std::make_unique<SurfaceEquation>(surface); }},
        default_values(type));
    State state = method->initial_state();
    Evaluation now = method->evaluate(ProblemData{monitor}, state, {});
    for (int i = 0; i < 1000 && now.residual > 1e-8; ++i) now = method->step(ProblemData{monitor}, state, {});
    if (!(now.residual <= 1e-8)) std::printf("    not converged: %g\n", now.residual);
    return QualityMeter(surface->mesh(), 1, 6, sequence.space)
        .measure(method->positions(), *monitor)
        .equidistribution;
}

} // namespace

int main() {
    // Unit of length: the side of the unit square, or a quarter of a great circle.
    const Settings plane = {{"amplitude", 10}, {"sharpness", 40}, {"radius", 0.25}};
    const Settings sphere = {{"amplitude", 10}, {"sharpness", 4}, {"radius", 0.785}};
    const Space torus{SpaceKind::periodic_square}, globe{SpaceKind::sphere};
    const auto flat = [](CellShape shape, int order) {
        return [=](int n) { return periodic_surface(n, shape, order); };
    };
    const auto cubed = [](int order) {
        return [=](int k) { return sphere_setup({SphereCells::cubed, k}, order, 1, order == 1); };
    };
    const auto triangles = [](int r) { return sphere_setup({SphereCells::icosahedral, r}); };
    const std::vector<int> squares = {20, 40, 80, 160}, halved = {14, 28, 56, 112};
    for (const Sequence& sequence : std::vector<Sequence>{
             {"plane, squares, x and m in Q1 (the paper's)", flat(CellShape::quadrilateral, 1), squares,
              torus, plane},
             {"plane, squares, x and m in Q2", flat(CellShape::quadrilateral, 2), squares, torus, plane},
             {"plane, triangles, x and m in P1", flat(CellShape::triangle, 1), halved, torus, plane},
             {"plane, triangles, x and m in P2", flat(CellShape::triangle, 2), halved, torus, plane},
             {"sphere, squares, x and m in Q2", cubed(2), {8, 16, 32, 64}, globe, sphere},
             {"sphere, triangles, x and m in P2 (the paper's)", triangles, {2, 3, 4, 5, 6}, globe, sphere}}) {
        std::printf("%s\n", sequence.name);
        double last = 0;
        for (const int size : sequence.sizes) {
            const double measure = equidistribution(sequence, size);
            std::printf("  %4d  %.6e", size, measure);
            if (last > 0) std::printf("  order %.2f", std::log2(last / measure));
            std::printf("\n");
            std::fflush(stdout);
            last = measure;
        }
    }
}
