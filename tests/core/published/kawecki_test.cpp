// Errors of the second experiment of Kawecki, Lakkis, Pryer (2018). The paper plots them without numbers;
// those of degree 1 are by an independent implementation (FEniCS).
#include "core/published/kawecki.hpp"
#include "core/published/published.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "core/transport/ring_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

/// Newton converges, in few steps that are cheap.
KaweckiSolve solved(const KaweckiMesh& mesh) {
    KaweckiSolve solve = solve_kawecki(mesh);
    EXPECT_TRUE(solve.newton.converged);
    EXPECT_LE(solve.newton.inner.size(), 7U);
    EXPECT_LE(*std::max_element(solve.newton.inner.begin(), solve.newton.inner.end()), 30);
    EXPECT_GT(solve.convexity, 1.5) << "the eigenvalues of D^2 u are 2 and 3";
    return solve;
}

double order(double TransportErrors::*error, const KaweckiSolve& coarse, const KaweckiSolve& fine) {
    return std::log(coarse.errors.*error / fine.errors.*error) / std::log(coarse.h / fine.h);
}

TEST(Kawecki, LinearElementsHaveTheErrorsOfAnotherProgram) {
    struct Known {
        int rings;
        double h;
        TransportErrors errors; ///< not of the Hessian
    };
    for (const Known& known :
         {Known{8, .1749, {5.997e-3, .2316, 9.62e-3}}, {16, .0890, {1.471e-3, .1145, 2.95e-3}}}) {
        const KaweckiSolve solve = solved({.rings = known.rings});
        const auto expect = [&](double ours, double theirs, int digits) {
            EXPECT_NEAR(ours, theirs, printed(theirs, digits).last_digit) << known.rings;
        };
        expect(solve.h, known.h, 3);
        expect(solve.errors.value, known.errors.value, 4);
        expect(solve.errors.gradient, known.errors.gradient, 4);
        expect(solve.errors.recovered_gradient, known.errors.recovered_gradient, 3);
    }
}

TEST(Kawecki, StraightEdgesLimitTheOrderToTwo) {
    for (const Recovery recovery : {Recovery::none, Recovery::gradient})
        for (const int degree : {2, 3}) {
            const KaweckiMesh mesh{.rings = 4, .degree = degree, .recovery = recovery};
            KaweckiMesh finer = mesh;
            finer.rings = 8;
            const KaweckiSolve coarse = solved(mesh), fine = solved(finer);
            EXPECT_NEAR(order(&TransportErrors::value, coarse, fine), 2, 0.15);
            EXPECT_NEAR(order(&TransportErrors::gradient, coarse, fine), 2, 0.15);
        }
}

TEST(Kawecki, CurvedEdgesGiveTheOptimalOrder) {
    for (const auto& [degree, least] : {std::pair{2, 2.7}, {3, 3.7}}) {
        const KaweckiSolve coarse = solved({.rings = 8, .degree = degree, .curved = true}),
                           fine = solved({.rings = 16, .degree = degree, .curved = true});
        EXPECT_GE(order(&TransportErrors::value, coarse, fine), least);
        EXPECT_GE(order(&TransportErrors::gradient, coarse, fine), degree - 0.3);
    }
}

TEST(Kawecki, WithoutRecoveryLinearElementsAreNotConvex) {
    const KaweckiSolve solve = solve_kawecki({.rings = 16, .recovery = Recovery::none}),
                       finer = solve_kawecki({.rings = 32, .recovery = Recovery::none});
    EXPECT_LT(solve.convexity, 0);
    EXPECT_LT(finer.convexity, solve.convexity);
    EXPECT_LT(order(&TransportErrors::hessian, solve, finer), 0.6);
}

/// How far the map from a disk to an equal disk moves: the largest displacement of a node, and the norm in L2
/// over the disk.
struct Displacement {
    double largest = 0, mean = 0;
};
Displacement displacement(int rings, int degree) {
    const TransportDomain domain({.source = ellipse({}, 1, 1),
                                  .target = ellipse({}, 1, 1),
                                  .rings = rings,
                                  .degree = degree,
                                  .curved = true,
                                  .source_name = "disk"});
    const auto space = std::make_shared<const NonvariationalSpace>(domain.elements(), Recovery::gradient);
    TransportForm form(space, domain.setup().source, domain.setup().target);
    RecoveryPreconditioner preconditioner(space);
    std::vector<double> u = form.start();
    EXPECT_TRUE(transport_newton(form, preconditioner, {}, u).converged);
    Displacement found;
    const Points& nodes = domain.elements().nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double* d = form.derivatives().data() + derivative_count * i;
        found.largest = std::max(found.largest, norm(Vec3{d[g1], d[g2], 0} - nodes[i]));
    }
    const ExactPotential identity{.value = [](Vec3 x) { return dot(x, x) / 2 - 0.25; },
                                  .gradient = [](Vec3 x) { return x; },
                                  .hessian =
                                      [](Vec3) {
                                          return Covariance{1, 0, 1};
                                      }};
    found.mean = transport_errors(form, identity).recovered_gradient;
    return found;
}

// Not exactly: the recovered gradient of |x|^2 / 2 differs from x, with one order less at the boundary than
// on average.
TEST(Kawecki, EqualDisksGiveTheIdentity) {
    struct Orders {
        int degree;
        double largest, mean;
    };
    for (const Orders& order : {Orders{1, 0.9, 1.6}, {2, 1.95, 2.65}}) {
        const Displacement coarse = displacement(8, order.degree), fine = displacement(16, order.degree);
        EXPECT_LT(coarse.largest, 0.01) << order.degree;
        EXPECT_GE(std::log2(coarse.largest / fine.largest), order.largest) << order.degree;
        EXPECT_GE(std::log2(coarse.mean / fine.mean), order.mean) << order.degree;
    }
}

TEST(Kawecki, ThePortraitIsTheDensityOfItsMesh) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "transport-portrait");
    set_value(*catalogue, scenario, "domain.cells", std::int64_t{40});
    gaspard::Run run(catalogue, scenario);
    EXPECT_LT(density_correlation(*run.snapshot()).of_density, 0.5) << "of the start";
    run.solve();
    const DensityCorrelation found = density_correlation(*run.snapshot());
    EXPECT_GT(found.of_density, 0.9);
    EXPECT_GT(found.of_compression, 0.9);
}

TEST(Kawecki, Figure1StopsOnRequest) {
    std::stop_source source;
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    EXPECT_THROW(find_recipe("kawecki-fig1")
                     .make(
                         catalogue, [&](const std::string&) { source.request_stop(); }, source.get_token()),
                 Interrupted);
}

} // namespace
} // namespace gaspard
