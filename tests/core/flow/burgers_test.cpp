// Burgers' equation on its own moving mesh: exact solutions, orders, what an adapted mesh gains.
#include "core/base/error.hpp"
#include "core/flow/burgers.hpp"
#include "core/flow/burgers_history.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

double front_error(std::size_t cells, double nu, bool adapted) {
    const BurgersData exact = burgers_front(nu, 0.25);
    Burgers equation({.cells = cells, .nu = nu, .adapted = adapted}, exact);
    equation.advance(1);
    return l2_error(equation, exact);
}

TEST(BurgersFront, SolvesTheEquation) {
    const double nu = 0.03, x = 0.47, t = 0.4, h = 1e-4;
    const BurgersData u = burgers_front(nu, 0.2);
    const double ut = (u(x, t + h) - u(x, t - h)) / (2 * h), ux = (u(x + h, t) - u(x - h, t)) / (2 * h),
                 uxx = (u(x + h, t) - 2 * u(x, t) + u(x - h, t)) / (h * h);
    EXPECT_GT(std::abs(ut), 1);
    EXPECT_NEAR(ut + u(x, t) * ux, nu * uxx, 1e-4 * std::abs(ut));
}

TEST(Burgers, HasOrderTwoOnAdaptedAndUniformMeshes) {
    for (const double nu : {1e-2, 1e-3}) {
        const double coarse = front_error(80, nu, true), fine = front_error(160, nu, true);
        EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1) << nu;
    }
    EXPECT_NEAR(std::log2(front_error(80, 1e-2, false) / front_error(160, 1e-2, false)), 2, 0.1);
}

TEST(Burgers, GainsByAdaptation) {
    EXPECT_GT(front_error(80, 1e-2, false), 5 * front_error(80, 1e-2, true));
    EXPECT_GT(front_error(80, 1e-3, false), 300 * front_error(80, 1e-3, true));
}

TEST(Burgers, KeepsAConstantOnAMeshThatMoves) {
    Burgers equation({.cells = 20}, [](double, double) { return 1.0; });
    std::vector<double> graded;
    for (int i = 0; i <= 20; ++i) graded.push_back(std::pow(i / 20.0, 3));
    equation.set_state(graded, std::vector<double>(21, 1.0), 0);
    equation.step(0.01);
    EXPECT_NEAR(equation.x()[10], 0.5, 1e-12) << "of a constant the mesh is uniform";
    for (const double u : equation.u()) EXPECT_NEAR(u, 1, 1e-12);
}

TEST(Burgers, SteepensASineIntoAFrontThatMoves) {
    Burgers equation({.cells = 100, .nu = 2e-3}, burgers_sine());
    const auto steepest = [&] {
        double slope = 0, place = 0;
        for (std::size_t k = 0; k < 100; ++k) {
            const double width = equation.x()[k + 1] - equation.x()[k],
                         fall = (equation.u()[k] - equation.u()[k + 1]) / width;
            EXPECT_GT(width, 0);
            if (fall > slope) slope = fall, place = equation.x()[k];
        }
        return std::pair(slope, place);
    };
    EXPECT_LT(steepest().first, 7);
    equation.advance(0.3);
    const auto [slope, place] = steepest();
    EXPECT_GT(slope, 100);
    equation.advance(0.4);
    EXPECT_GT(steepest().second, place + 0.1);
    const auto [low, high] = std::minmax_element(equation.u().begin(), equation.u().end());
    EXPECT_GT(*low, -0.66);
    EXPECT_LT(*high, 1.37) << "no overshoot";
}

TEST(Burgers, RefusesWhatItCannotSolve) {
    EXPECT_THROW(Burgers({.cells = 2}, burgers_sine()), InputError);
    EXPECT_THROW(Burgers({.nu = 0}, burgers_sine()), InputError);
    Burgers equation({.cells = 20}, burgers_sine());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(equation.advance(1, stop.get_token()), Interrupted);
}

TEST(BurgersHistory, IsTheSolutionAdvancedByHand) {
    const BurgersOptions options{.cells = 50, .nu = 0.01};
    const auto history = burgers_history(options, burgers_sine());
    Burgers equation(options, burgers_sine());
    const double t = 2.5 * history->interval();
    for (int k = 1; k <= 2; ++k) {
        equation.advance(history->interval());
        equation.set_state(std::vector<double>(equation.x()), std::vector<double>(equation.u()),
                           k * history->interval());
    }
    equation.advance(t - 2 * history->interval());
    std::vector<double> expected = equation.x();
    expected.insert(expected.end(), equation.u().begin(), equation.u().end());
    history->at(1);
    EXPECT_EQ(history->at(t), expected);
}

} // namespace
} // namespace gaspard
