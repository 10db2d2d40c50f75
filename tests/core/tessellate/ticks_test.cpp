#include "core/tessellate/ticks.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
    std::vector<std::string> found;
    for (const Tick& tick : ticks)
        if (!tick.label.empty()) found.push_back(tick.label);
    return found;
}

using Labels = std::vector<std::string>;

TEST(Ticks, LinearTicksAreRoundAndEquallyLabelled) {
    EXPECT_EQ(labels(linear_ticks(0, 10, 5)), (Labels{"0", "2", "4", "6", "8", "10"}));
    EXPECT_EQ(labels(linear_ticks(0.05, 0.52, 5)), (Labels{"0.1", "0.2", "0.3", "0.4", "0.5"}));
    EXPECT_EQ(labels(linear_ticks(-1, 1, 4)), (Labels{"−1.0", "−0.5", "0", "0.5", "1.0"}));
    EXPECT_EQ(labels(linear_ticks(0, 3e6, 3)), (Labels{"0", "10⁶", "2×10⁶", "3×10⁶"}));
}

TEST(Ticks, LinearTicksLieInTheRangeAndAreFew) {
    for (const double high : {1.0, 1.7, 13.0, 99.0, 123456.0, 3e-9}) {
        const auto ticks = linear_ticks(-high / 3, high, 6);
        EXPECT_GE(ticks.size(), 3U);
        EXPECT_LE(ticks.size(), 9U);
        for (const Tick& tick : ticks) {
            EXPECT_GE(tick.value, -high / 3 * (1 + 1e-9));
            EXPECT_LE(tick.value, high * (1 + 1e-9));
        }
    }
}

TEST(Ticks, LabelsThatDifferOnlyInTheirLastDigitsSayByHowMuch) {
    EXPECT_EQ(labels(linear_ticks(1 - 1e-12, 1, 4)),
              (Labels{"−10⁻¹²", "−8×10⁻¹³", "−6×10⁻¹³", "−4×10⁻¹³", "−2×10⁻¹³", "1"}));
    EXPECT_EQ(labels(linear_ticks(0.25, 0.25 + 2e-10, 2)), (Labels{"0.25", "+10⁻¹⁰", "+2×10⁻¹⁰"}));
    EXPECT_EQ(labels(linear_ticks(0, 1e-12, 2)), (Labels{"0", "5×10⁻¹³", "10⁻¹²"}));
}

TEST(Ticks, EqualEndsGiveOneTick) {
    EXPECT_EQ(labels(linear_ticks(2.5, 2.5, 5)), Labels{"2.5"});
    EXPECT_EQ(linear_ticks(1e8, 1e8 + 1e-8, 5).size(), 1U) << "they differ by rounding only";
}

TEST(Ticks, LogarithmicTicksAreDecadesWithMinorTicks) {
    const auto ticks = log_ticks(1e-2, 1, 5);
    EXPECT_EQ(labels(ticks), (Labels{"10⁻²", "10⁻¹", "10⁰"}));
    EXPECT_EQ(ticks.size(), 3U + 2 * 8);
}

TEST(Ticks, ManyDecadesAreThinnedRelativeToOne) {
    EXPECT_EQ(labels(log_ticks(1e-9, 1, 4)), (Labels{"10⁻⁹", "10⁻⁶", "10⁻³", "10⁰"}));
    EXPECT_EQ(labels(log_ticks(1e-10, 3, 4)), (Labels{"10⁻⁹", "10⁻⁶", "10⁻³", "10⁰"}));
}

TEST(Ticks, LessThanADecadeIsLabelledLinearly) {
    EXPECT_EQ(labels(log_ticks(2, 5, 3)), (Labels{"2", "3", "4", "5"}));
    EXPECT_EQ(labels(log_ticks(0.03, 0.05, 2)), (Labels{"0.03", "0.04", "0.05"}));
}

TEST(Ticks, ADecadeAroundOnePowerOfTenHasRoundValues) {
    EXPECT_EQ(labels(log_ticks(0.0035, 0.06, 4)), (Labels{"0.005", "0.01", "0.02", "0.05"}));
}

TEST(Ticks, LabelsOfLogarithmicTicksKeepTheirDistance) {
    EXPECT_EQ(labels(log_ticks(1, 9.5, 7)), (Labels{"1", "2", "3", "4", "5", "7", "9"}));
    EXPECT_EQ(log_ticks(1, 9.5, 7).size(), 9U) << "ticks without a label stay";
    for (const double low : {1.0, 1.7, 2.0, 0.011, 5e-7})
        for (const double factor : {1.01, 2.0, 5.0, 9.0, 30.0, 1e3, 1e6})
            for (const int count : {1, 2, 4, 7, 20}) {
                double last = -INFINITY;
                for (const Tick& tick : log_ticks(low, factor * low, count)) {
                    if (tick.label.empty()) continue;
                    const double position = std::log10(tick.value / low) / std::log10(factor);
                    EXPECT_GE(position - last, 0.599 / count)
                        << tick.label << " from " << low << " times " << factor;
                    last = position;
                }
            }
}

TEST(ShortNumber, KeepsSignificantDigits) {
    EXPECT_EQ(short_number(0.03667985), "0.03668");
    EXPECT_EQ(short_number(9.8123e-9, 3), "9.81×10⁻⁹");
    EXPECT_EQ(short_number(198), "198");
    EXPECT_EQ(short_number(12345), "12345");
    EXPECT_EQ(short_number(1234567, 3), "1.23×10⁶");
    EXPECT_EQ(short_number(-0.5), "−0.5");
    EXPECT_EQ(short_number(0), "0");
    EXPECT_EQ(short_number(-0.0), "0");
}

TEST(ShortNumber, HandlesNanAndInfinity) {
    EXPECT_EQ(short_number(std::nan("")), "not a number");
    EXPECT_EQ(short_number(INFINITY), "∞");
    EXPECT_EQ(short_number(-INFINITY), "−∞");
}

} // namespace
} // namespace gaspard
