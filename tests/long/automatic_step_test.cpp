// The step that the relaxation chooses against the best of a dozen fixed ones, over mild and harsh monitors.
#include "core/method/relax.hpp"

#include <algorithm>
#include <cstdio>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

constexpr int none = 1 << 20;

/// Iterations to 1e-8; none where there are more than `most`, or none that help.
int iterations(const std::shared_ptr<const PlaneQ2>& plane, const Monitor& monitor, const Value& step_size,
               int most) {
    Values values = default_values(relaxation_method());
    values.set("step_size", step_size);
    const auto method = make_plane_method(relaxation_method(), plane, values);
    State state = method->initial_state();
    Evaluation now = method->evaluate(problem_of(monitor), state, {});
    for (int i = 0; i <= most; ++i) {
        if (now.residual < 1e-8) return i;
        if (!(now.residual < 1e4)) return none;
        now = method->step(problem_of(monitor), state, {});
    }
    return none;
}

TEST(AutomaticStep, TakesAtMostHalfAsManyIterationsAgainAsTheBestOfTwelve) {
    const auto plane = std::make_shared<PlaneQ2>(LineGrid{60, true});
    for (const char* type : {"ring", "bell"})
        for (const double amplitude : {1, 5, 20, 60, 200})
            for (const double sharpness : {20, 60, 150, 400}) {
                const auto monitor = make_monitor(type, {SpaceKind::periodic_square},
                                                  {{"amplitude", amplitude}, {"sharpness", sharpness}});
                const int ours = iterations(plane, *monitor, std::string("auto"), 5000);
                ASSERT_LT(ours, none);
                int best = none;
                double best_step = 0;
                for (int k = 0; k < 12; ++k) {
                    const double step = 0.005 * std::pow(200.0, k / 11.0); // 0.005 to 1
                    const int others = iterations(plane, *monitor, step, std::min(best, ours));
                    if (others < best) best = others, best_step = step;
                }
                std::printf("%s, amplitude %3g, sharpness %3g: auto %4d, ", type, amplitude, sharpness, ours);
                best < none ? std::printf("best of twelve %4d (step %.4f)\n", best, best_step)
                            : std::printf("none of twelve takes as few\n");
                EXPECT_LE(ours, 1.5 * best) << type << " " << amplitude << " " << sharpness;
            }
}

} // namespace
} // namespace gaspard
