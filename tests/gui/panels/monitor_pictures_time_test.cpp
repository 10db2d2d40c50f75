// How long a picture of a monitor takes, which a frame of the window waits for.
#include "gui/panels/monitor_pictures.hpp"
#include "support/monitor_defaults.hpp"

#include <algorithm>
#include <chrono>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(MonitorPictureTime, IsBelowTwoMilliseconds) {
    for (const SpaceKind kind : {SpaceKind::periodic_square, SpaceKind::sphere})
        for (const char* name :
             {"ring", "bell", "ring-and-bell", "random-bells", "random-waves", "formula"}) {
            const Space space{.kind = kind};
            const MonitorType type = monitor_type(name);
            const MonitorSubject subject{name, default_values(type, space), space, {{0, 0, 0}, {1, 1, 0}}};
            double best = 1;
            for (int i = 0; i < 5; ++i) {
                const auto begin = std::chrono::steady_clock::now();
                ASSERT_TRUE(picture_of_monitor(type, subject)) << name;
                best = std::min(
                    best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
            }
            RecordProperty(name, std::to_string(1e3 * best));
            EXPECT_LT(best, 2e-3) << name;
        }
}

} // namespace
} // namespace gaspard
