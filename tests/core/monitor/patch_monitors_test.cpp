// The monitors of Bahari et al., against their formulas as printed (and corrected), in long double.
#include "support/built_in.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace gaspard {
namespace {

using Real = long double;
using Formula = std::function<Real(Real, Real, Real)>;
constexpr Real real_pi = std::numbers::pi_v<long double>;

Real sech2(Real t) { return 1 / (std::cosh(t) * std::cosh(t)); }
Real circle(Real x, Real y, Real a, Real b, Real square) {
    return std::exp(-100 * std::abs((x - a) * (x - a) + (y - b) * (y - b) - square));
}
Real three(Real x, Real y) {
    return 1 + 5 * circle(x, y, 0.45L, 0.4L, 0.1L) + 5 * circle(x, y, 0, 0, 0.2L) +
           5 * circle(x, y, -0.45L, 0.4L, 0.1L);
}
Real two(Real x, Real y, Real dz) {
    const auto part = [&](Real a) {
        return 5 * sech2(5 * ((x - a) * (x - a) + (y - 0.5L) * (y - 0.5L) + dz * dz - real_pi * real_pi / 4));
    };
    return 1 + part(std::sqrt(3.0L) / 2) + part(-std::sqrt(3.0L) / 2);
}

struct PatchCase {
    const char* name;
    const char* type;
    Settings settings;
    Formula formula;
};
void PrintTo(const PatchCase& one, std::ostream* out) { *out << one.name; }

std::vector<PatchCase> patch_cases() {
    return {{"circle",
             "circle",
             {}, // 5.3
             [](Real x, Real y, Real) {
                 return 1 + 5 * std::exp(-50 *
                                         std::abs((x - 0.5L) * (x - 0.5L) + (y - 0.5L) * (y - 0.5L) - 0.09L));
             }},
            {"spiral",
             "spiral",
             {}, // 5.4, with r^2
             [](Real x, Real y, Real) {
                 const Real r = std::hypot(x - 0.7L, y - 0.5L), angle = std::atan2(y - 0.5L, x - 0.7L);
                 const Real t = 10 * r * std::cos(angle - 20 * r * r);
                 return 1 + 9 / (1 + t * t);
             }},
            {"three_circles", "three-circles", {}, [](Real x, Real y, Real) { return three(x, y); }}, // 5.5
            {"face",
             "three-circles",
             {{"mouth", 7}}, // 7.5
             [](Real x, Real y, Real) { return three(x, y) + 7 * circle(x, y, 0, -1.25L, 0.4L); }},
            {"two_circles", "two-circles", {}, [](Real x, Real y, Real) { return two(x, y, 0); }}, // 5.6
            {"moebius",
             "two-circles",
             {{"center_z", 0.5}}, // 7.9
             [](Real x, Real y, Real z) { return two(x, y, z - 0.5L); }},
            {"cosine_waves",
             "cosine-waves",
             {}, // 7.3
             [](Real x, Real y, Real) {
                 return 1 / (2 + std::cos(8 * real_pi * std::hypot(x - 0.5L, y - 0.5L)));
             }},
            {"torus",
             "cosine-waves",
             {{"center_z", 0.5}}, // 7.8
             [](Real x, Real y, Real z) {
                 return 1 / (2 + std::cos(8 * real_pi * std::hypot(x - 0.5L, y - 0.5L, z - 0.5L)));
             }},
            {"sine_waves",
             "sine-waves",
             {}, // 7.7
             [](Real x, Real y, Real) {
                 const Real s = 0.25L * std::sin(2 * real_pi * x);
                 return 1 + 5 * std::exp(-50 * std::abs(y - 0.5L - s * std::sin(2 * real_pi / 3))) +
                        5 * std::exp(-50 * std::abs(y - 0.25L - s));
             }}};
}

class PatchMonitors : public testing::TestWithParam<PatchCase> {
  protected:
    PatchMonitors() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> number(-1.2, 1.2);
        const bool flat =
            std::string(GetParam().name) != "moebius" && std::string(GetParam().name) != "torus";
        for (std::size_t i = 0; i < x.size(); ++i)
            x.set(i, {number(random), number(random), flat ? 0 : number(random)});
    }
    Points x{1000};
    const std::shared_ptr<const Monitor> monitor = make_monitor(GetParam().type, {}, GetParam().settings);
};
INSTANTIATE_TEST_SUITE_P(All, PatchMonitors, testing::ValuesIn(patch_cases()),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_P(PatchMonitors, HaveTheValuesOfTheirFormulas) {
    std::vector<double> values(x.size());
    monitor->values(x, values);
    for (std::size_t i = 0; i < x.size(); ++i)
        EXPECT_NEAR(values[i], static_cast<double>(GetParam().formula(x.x[i], x.y[i], x.z[i])), 1e-11);
}

TEST_P(PatchMonitors, HaveTheGradientsOfTheirDifferences) {
    Points gradients;
    monitor->gradients(x, gradients);
    const Formula& formula = GetParam().formula;
    std::size_t creases = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = [&](Real step) {
                return formula(x.x[i] + (axis == 0 ? step : 0), x.y[i] + (axis == 1 ? step : 0),
                               x.z[i] + (axis == 2 ? step : 0));
            };
            if (axis == 2 && x.z[i] == 0) continue; // of a flat formula
            constexpr Real h = 1e-8L;
            const Real forward = (at(h) - at(0)) / h, backward = (at(0) - at(-h)) / h;
            if (std::abs(forward - backward) >
                0.01L * std::max(1.0L, std::abs(forward))) { // the crease is within reach
                ++creases;
                continue;
            }
            const double ours = axis == 0 ? gradients.x[i] : axis == 1 ? gradients.y[i] : gradients.z[i];
            EXPECT_NEAR(ours, static_cast<double>((at(h) - at(-h)) / (2 * h)), 1e-6 + 1e-8 * std::abs(ours));
        }
    EXPECT_LT(creases, 5u);
}

} // namespace
} // namespace gaspard
