// A monitor that is dragged across the plane, as the window does it with the mouse: values of a centre that
// moves by 0.1 of the domain a second, sixty times a second. The mesh must follow without visible delay and
// stay adapted.
#include "core/base/stopwatch.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/solver_thread.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <gtest/gtest.h>
#include <mutex>
#include <thread>
#include <vector>

namespace gaspard {
namespace {

struct Drag {
    int snapshots = 0;
    double seconds = 0, worst = 0; ///< residual
    double longest = 0;            ///< seconds between two snapshots
    double solved = -1;            ///< seconds after release until the residual is below 1e-8; -1: never
};

/// A value that moves evenly.
struct Motion {
    std::string key = "center_x";
    double from = 0.4, per_second = 0.1;
};

Drag drag(const std::string& scenario_name, const std::string& method, const Motion& motion, double seconds) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, scenario_name);
    apply_settings(*catalogue, scenario, {"method.type=" + method});
    scenario.monitor.values.set(motion.key, motion.from);

    std::mutex mutex;
    bool dragging = false;
    Drag result;
    Stopwatch since_last;
    SolverThread::Options options;
    options.before_publishing = [&](const Snapshot& snapshot) {
        std::lock_guard lock(mutex);
        if (!dragging) return;
        ++result.snapshots;
        result.worst = std::max(result.worst, snapshot.report.residual);
        result.longest = std::max(result.longest, since_last.seconds());
        since_last = {};
    };
    options.recording = std::make_shared<Recording>(std::size_t{256} << 20U); // as in the window
    SolverThread solver(catalogue, scenario, std::move(options));
    const auto converges_within = [&](double seconds_at_most) {
        for (const Stopwatch watch; watch.seconds() < seconds_at_most;
             std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
            solver.drain();
            if (solver.status().run == RunStatus::converged) return true;
        }
        return false;
    };
    EXPECT_TRUE(converges_within(60)) << "before the drag";

    std::uint64_t number = 0;
    const Stopwatch watch;
    {
        std::lock_guard lock(mutex);
        dragging = true;
        since_last = {};
    }
    while (watch.seconds() < seconds) {
        scenario.monitor.values.set(motion.key, motion.from + motion.per_second * watch.seconds());
        solver.post(ChangeCommand{.scenario = scenario, .number = ++number, .same_gesture = true});
        solver.drain();
        std::this_thread::sleep_for(std::chrono::microseconds(16667));
    }
    {
        std::lock_guard lock(mutex);
        dragging = false;
        result.seconds = watch.seconds();
    }
    const Stopwatch released;
    for (; released.seconds() < 10; std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
        solver.drain();
        const SolverStatus status = solver.status();
        if (status.answered == number && status.run == RunStatus::converged) {
            result.solved = released.seconds();
            break;
        }
    }
    std::printf("%s, %s: %.0f snapshots/s, at most %.0f ms apart, residual at most %.1e, 1e-8 after %.3f s\n",
                scenario_name.c_str(), method.c_str(), result.snapshots / result.seconds,
                1000 * result.longest, result.worst, result.solved);
    return result;
}

TEST(Dragging, TheMeshFollowsTheMonitor) {
    for (const auto& [scenario, method] :
         {std::pair("plane-ring", "auto"), std::pair("plane-bell", "auto"), std::pair("walls-ring", "auto"),
          std::pair("plane-ring", "accelerated")}) {
        const Drag result = drag(scenario, method, {}, 1);
        EXPECT_GE(result.snapshots, 30 * result.seconds) << scenario << ", " << method;
        EXPECT_LT(result.worst, 1e-2) << scenario << ", " << method;
        EXPECT_GE(result.solved, 0) << scenario << ", " << method;
        EXPECT_LT(result.solved, 1) << scenario << ", " << method;
    }
}

// Newton's steps cost more than these values need, and the sphere's more than those of the plane.
TEST(Dragging, CostlierStepsFollowAsWellAsTheyCan) {
    const Drag newton = drag("plane-ring", "newton", {}, 1);
    const Drag sphere = drag("sphere-x4", "auto", {"center_longitude", 0, 36}, 1); // a tenth of the way round
    for (const Drag& result : {newton, sphere}) {
        EXPECT_GE(result.snapshots, 5 * result.seconds) << "something moves";
        EXPECT_LT(result.worst, 0.5) << "and is nearly adapted";
        EXPECT_GE(result.solved, 0);
    }
}

} // namespace
} // namespace gaspard
