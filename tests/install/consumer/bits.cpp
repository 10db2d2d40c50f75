// Prints the bits of an adapted spline patch. With FOREIGN_EIGEN the program has its own instances of the
// templates that the library is made with, compiled with other options: they must not replace the library's.
#include <cstdint>
#include <cstring>
#include <gaspard/gaspard.hpp>
#include <iostream>

#ifdef FOREIGN_EIGEN
#include <Eigen/Dense>
#endif

using namespace gaspard;

int main() {
    double sum = 0;
#ifdef FOREIGN_EIGEN
    const Eigen::MatrixXd a = Eigen::MatrixXd::Random(40, 40),
                          spd = a * a.transpose() + Eigen::MatrixXd::Identity(40, 40);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(a + a.transpose(), spd);
    sum += solver.eigenvectors().sum() + spd.partialPivLu().solve(a).sum();
    Eigen::MatrixXd b = a;
    Eigen::LLT<Eigen::MatrixXd>(spd).matrixL().transpose().solveInPlace<Eigen::OnTheRight>(b);
    sum += (a.transpose() * b * a).sum();
#endif
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = default_scenario(*catalogue);
    apply_settings(*catalogue, scenario,
                   {"domain.type=spline-disk", "domain.cells=16", "monitor.type=circle", "method.type=newton",
                    "method.max_iterations=6"});
    Run run(catalogue, scenario);
    run.solve();
    const Points x = run.snapshot()->x;
    for (const auto* coordinate : {&x.x, &x.y, &x.z})
        for (const double value : *coordinate) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            std::cout << std::hex << bits << '\n';
        }
    return sum == 1; // never: keeps the sums
}
