#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"
#include "support/messages.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(ShortNumber, HasSoManyDigitsAndNoZerosAtTheEnd) {
    EXPECT_EQ(short_number(0.25), "0.25");
    EXPECT_EQ(short_number(1.23456e-5, 3), "1.23×10⁻⁵");
    EXPECT_EQ(short_number(-1e9), "−10⁹");
    EXPECT_EQ(power_of_ten(-8), "10⁻⁸");
}

TEST(ShortNumber, AnExactOneHasAllDigitsThatTellItFromOthers) {
    EXPECT_EQ(exact_number(1e-8), "10⁻⁸");
    EXPECT_EQ(exact_number(2e6), "2×10⁶");
    EXPECT_EQ(exact_number(0.1), "0.1");
    EXPECT_EQ(exact_number(0.30000000000000004), "0.30000000000000004");
    EXPECT_EQ(exact_number(-12345678), "−12345678");
    EXPECT_EQ(exact_number(60), "60");
    EXPECT_EQ(exact_number(0), "0");
    EXPECT_EQ(exact_number(1.0 / 0.0), "∞");
}

TEST(ShortNumber, MessagesWriteNumbersAsTheWindowDoes) {
    Values values("method", {{.key = "tolerance", .minimum = 1e-16, .maximum = 1e9, .default_value = 1e-8}});
    EXPECT_EQ(message_of<InputError>([&] { values.set("tolerance", 1e-20); }),
              "method.tolerance = 10⁻²⁰ is out of range: 10⁻¹⁶ to 10⁹");
    EXPECT_EQ(message_of<InputError>([&] { values.parse("tolerance", "1e10"); }),
              "method.tolerance = 10¹⁰ is out of range: 10⁻¹⁶ to 10⁹");
}

} // namespace
} // namespace gaspard
