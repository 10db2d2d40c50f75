// Recovered gradients and Hessians, and functions on other meshes.
#include "core/base/eigenvalues.hpp"
#include "core/transport/nonvariational_space.hpp"
#include "core/transport/recovered_function.hpp"
#include "support/transport_spaces.hpp"

#include <functional>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

std::vector<double> nodal(const Points& x, const std::function<double(Vec3)>& f) {
    std::vector<double> values(x.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = f(x[i]);
    return values;
}

double quadratic(Vec3 p) { return 1 + 2 * p.x - p.y + 1.5 * p.x * p.x + 0.7 * p.x * p.y + p.y * p.y; }

TEST(NonvariationalSpace, QuadraticPolynomialsHaveTheirDerivatives) {
    for (const Recovery recovery : {Recovery::none, Recovery::gradient})
        for (int degree = 2; degree <= highest_triangle_degree; ++degree) {
            const NonvariationalSpace space(disk_elements(4, degree, false), recovery);
            std::vector<double> d;
            space.differentiate(nodal(space.elements().nodes(), quadratic), d);
            for (std::size_t i = 0; i < space.size(); ++i) {
                const Vec3 x = space.elements().nodes()[i];
                const double* at = d.data() + derivative_count * i;
                EXPECT_NEAR(at[g1], 2 + 3 * x.x + 0.7 * x.y, 1e-11);
                EXPECT_NEAR(at[g2], -1 + 0.7 * x.x + 2 * x.y, 1e-11);
                EXPECT_NEAR(at[h11], 3, 1e-9);
                EXPECT_NEAR(at[h12], 0.7, 1e-9);
                EXPECT_NEAR(at[h22], 2, 1e-9);
            }
        }
}

TEST(NonvariationalSpace, TheHessianIsTheProjectionOfTheDerivativesOfTheRecoveredGradient) {
    const NonvariationalSpace space(disk_elements(5, 1, false), Recovery::gradient);
    const auto u = nodal(space.elements().nodes(), [](Vec3 p) { return std::sin(2 * p.x) * std::exp(p.y); });
    std::vector<double> d, of_first, of_second, first(space.size()), second(space.size());
    space.differentiate(u, d);
    for (std::size_t i = 0; i < space.size(); ++i) {
        first[i] = d[derivative_count * i + g1];
        second[i] = d[derivative_count * i + g2];
    }
    space.differentiate(first, of_first);
    space.differentiate(second, of_second);
    for (std::size_t i = 0; i < space.size(); ++i) {
        const std::size_t at = derivative_count * i;
        EXPECT_NEAR(d[at + h11], of_first[at + g1], 1e-12);
        EXPECT_NEAR(d[at + h12], (of_first[at + g2] + of_second[at + g1]) / 2, 1e-12);
        EXPECT_NEAR(d[at + h22], of_second[at + g2], 1e-12);
    }
}

TEST(NonvariationalSpace, CubicPolynomialsHaveTheirHessian) {
    for (const Recovery recovery : {Recovery::none, Recovery::gradient}) {
        const NonvariationalSpace space(disk_elements(4, 3, false), recovery);
        std::vector<double> d;
        space.differentiate(nodal(space.elements().nodes(), [](Vec3 p) { return p.x * p.x * p.y; }), d);
        for (std::size_t i = 0; i < space.size(); ++i) {
            const Vec3 x = space.elements().nodes()[i];
            EXPECT_NEAR(d[derivative_count * i + h11], 2 * x.y, 1e-10);
            EXPECT_NEAR(d[derivative_count * i + h12], 2 * x.x, 1e-10);
            EXPECT_NEAR(d[derivative_count * i + h22], 0, 1e-10);
        }
    }
}

TEST(NonvariationalSpace, FunctionsGoToOtherMeshesWithoutKinks) {
    const NonvariationalSpace coarse(disk_elements(6, 1, false), Recovery::gradient),
        fine(disk_elements(12, 1, false), Recovery::gradient);
    const auto smooth = [](Vec3 p) { return p.x * p.x + 1.5 * p.y * p.y + 0.1 * std::sin(3 * p.x); };
    const auto moved =
        recovered_values(coarse, nodal(coarse.elements().nodes(), smooth), fine.elements().nodes());
    std::vector<double> d;
    fine.differentiate(moved, d);
    for (std::size_t i = 0; i < fine.size(); ++i) {
        const Vec3 x = fine.elements().nodes()[i];
        EXPECT_NEAR(moved[i], smooth(x), 0.02);
        if (norm(x) > 0.8) continue; // one-sided means at the boundary
        EXPECT_NEAR(d[derivative_count * i + h11], 2 - 0.9 * std::sin(3 * x.x), 1) << "of the order of h";
        EXPECT_NEAR(d[derivative_count * i + h22], 3, 1);
        EXPECT_GT(symmetric_eigenvalues(d[derivative_count * i + h11], d[derivative_count * i + h12],
                                        d[derivative_count * i + h22])
                      .smallest,
                  0.3)
            << "it stays convex";
    }
    const NonvariationalSpace second(disk_elements(6, 2, true), Recovery::gradient);
    const auto exact =
        recovered_values(second, nodal(second.elements().nodes(), quadratic), fine.elements().nodes());
    for (std::size_t i = 0; i < fine.size(); ++i)
        EXPECT_NEAR(exact[i], quadratic(fine.elements().nodes()[i]), 1e-3) << "to the geometry's order";
}

} // namespace
} // namespace gaspard
