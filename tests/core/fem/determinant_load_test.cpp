// Independence of the number of threads. The values are tested in plane_q2_test.cpp.
#include "core/base/error.hpp"
#include "core/fem/determinant_load.hpp"
#include "support/polynomials.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(DeterminantLoad, DoesNotDependOnTheNumberOfThreads) {
    for (const bool periodic : {true, false})
        for (const std::size_t n : {4, 13}) {
            const LineGrid grid{n, periodic};
            const std::size_t all = grid.size(2) * grid.size(2);
            const auto monitor = slow::random_values((n + 1) * (n + 1), 0.5, 4, 1);
            const WeakHessian sigma{slow::random_values(all, -0.5, 2, 2),
                                    slow::random_values(all, -0.5, 2, 3),
                                    slow::random_values(all, -0.7, 0.7, 4)};
            const DeterminantLoad load(grid);
            std::vector<double> first;
            for (const std::size_t workers : {1, 2, 3, 5, 20}) {
                Team team(workers);
                std::vector<DeterminantLoad::Workspace> workspaces(workers, load.make_workspace());
                std::vector<double> r(all, 7.0);
                load.integrate(monitor, sigma, r, workspaces, team);
                if (workers == 1) first = r;
                EXPECT_EQ(r, first) << workers;
            }
        }
}

TEST(DeterminantLoad, NeedsAWorkspacePerWorker) {
    const DeterminantLoad load({4, true});
    std::vector<double> r(64), monitor(25);
    std::vector<DeterminantLoad::Workspace> workspaces(1, load.make_workspace());
    Team team(2);
    EXPECT_THROW(load.integrate(monitor, {r, r, r}, r, workspaces, team), InternalError);
}

} // namespace
} // namespace gaspard
