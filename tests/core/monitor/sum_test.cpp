#include "core/base/error.hpp"
#include "core/monitor/sum.hpp"
#include "support/built_in.hpp"
#include "support/monitor_values.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

struct Place {
    const char* name;
    Space space;
};
const Place places[] = {
    {"periodic", {SpaceKind::periodic_square}}, {"walls", {}}, {"sphere", {SpaceKind::sphere}}};

TEST(RingAndBell, IsTheSumOfBoth) {
    for (const auto& [name, space] : places) {
        const bool sphere = space.kind == SpaceKind::sphere;
        const std::string place = sphere ? "center_latitude" : "center_x";
        const double where = sphere ? -20 : 0.2;
        const auto both =
            make_monitor("ring-and-bell", space,
                         {{"ring_amplitude", 7}, {"bell_" + place, where}, {"bell_sharpness", 30}});
        const Points x = points_of(space);
        const auto ring = values_of(*make_monitor("ring", space, {{"amplitude", 7}}), x);
        const auto bell = values_of(*make_monitor("bell", space, {{place, where}, {"sharpness", 30}}), x);
        const auto sum = values_of(*both, x);
        for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(sum[i], ring[i] + bell[i] - 1, 1e-12) << name;
        EXPECT_NO_THROW(both->check());
    }
}

TEST(RingAndBell, StaysPositiveAsItsRowsAllowNoHollows) {
    for (const char* key : {"ring_amplitude", "bell_amplitude"})
        EXPECT_THROW(make_monitor("ring-and-bell", {}, {{key, -0.5}}), InputError);
}

TEST(RandomBells, AreTheSameForTheSameSeedAndOthersForAnother) {
    for (const auto& [name, space] : places) {
        const Points x = points_of(space);
        const auto one = values_of(*make_monitor("random-bells", space, {{"seed", 3}}), x);
        EXPECT_EQ(one, values_of(*make_monitor("random-bells", space, {{"seed", 3}}), x));
        EXPECT_NE(one, values_of(*make_monitor("random-bells", space, {{"seed", 4}}), x));
        // More of them leave those that are there where they are.
        const auto more = values_of(*make_monitor("random-bells", space, {{"seed", 3}, {"count", 12}}), x);
        for (std::size_t i = 0; i < x.size(); ++i) {
            EXPECT_GE(one[i], 1);
            EXPECT_LE(one[i], 1 + 8 * 50);
            EXPECT_GE(more[i], one[i] - 1e-12);
        }
    }
}

TEST(RandomBells, AreThoseOfTheFirstDay) { // the numbers of MT19937-64, from another program
    Points x(1);
    x.set(0, {0.5, 0.5, 0});
    const auto values = values_of(*make_monitor("random-bells", {}, {{"sharpness", 2}}), x);
    EXPECT_NEAR(values[0], 208.5201017, 1e-6);
}

TEST(RandomWaves, HaveTheContrastAskedForAndFitThePeriodicSquare) {
    for (const auto& [name, space] : places) {
        SCOPED_TRACE(name);
        const auto monitor = make_monitor("random-waves", space, {{"seed", 5}, {"contrast", 300}});
        const Points x = points_of(space);
        const auto m = values_of(*monitor, x);
        EXPECT_NE(m, values_of(*make_monitor("random-waves", space, {{"seed", 6}, {"contrast", 300}}), x));
        const auto [least, largest] = std::minmax_element(m.begin(), m.end());
        EXPECT_GT(*least, 0.8);
        EXPECT_LT(*largest, 300 * 1.3);
        EXPECT_GT(*largest / *least, 10);
        if (space.kind == SpaceKind::sphere) continue;
        Points moved = x;
        for (std::size_t i = 0; i < x.size(); ++i) moved.set(i, x[i] + Vec3{1, -2, 0});
        const auto same = values_of(*monitor, moved);
        for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(same[i], m[i], 1e-10 * m[i]);
    }
}

TEST(Sums, HaveTheGradientsOfTheirValues) {
    for (const auto& [name, space] : places)
        for (const char* type : {"ring-and-bell", "random-bells", "random-waves"}) {
            const auto monitor = make_monitor(type, space);
            const Points x = points_of(space);
            SCOPED_TRACE(name + std::string(" ") + type);
            expect_gradients_of_values(*monitor, space, x, 1e-5);
        }
}

} // namespace
} // namespace gaspard
