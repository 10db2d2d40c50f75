#include "core/base/error.hpp"
#include "core/linear/batch_fft.hpp"
#include "core/linear/dense.hpp"

#include <complex>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace gaspard {
namespace {

using Complex = std::complex<double>;

std::vector<double> random_batch(std::size_t n) {
    std::mt19937 random(static_cast<unsigned>(n));
    std::uniform_real_distribution<double> distribution(-1, 1);
    std::vector<double> batch(2 * BatchFft::lanes * n);
    for (double& value : batch) value = distribution(random);
    return batch;
}

Complex element(const double* batch, std::size_t k, std::size_t lane) {
    return {batch[2 * k * BatchFft::lanes + lane], batch[(2 * k + 1) * BatchFft::lanes + lane]};
}

class Fourier : public testing::TestWithParam<std::size_t> {};
// Every radix alone, combined and repeated; primes beyond the special butterflies.
INSTANTIATE_TEST_SUITE_P(Lengths, Fourier,
                         testing::Values(1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 12, 16, 25, 30, 49, 60, 77, 120,
                                         127));

TEST_P(Fourier, MatchesItsDefinition) {
    const std::size_t n = GetParam();
    const BatchFft fft(n);
    EXPECT_EQ(fft.length(), n);
    const std::vector<double> start = random_batch(n);
    for (const int sign : {-1, 1}) {
        std::vector<double> data = start, scratch(start.size());
        const double* result =
            sign < 0 ? fft.forward(data.data(), scratch.data()) : fft.backward(data.data(), scratch.data());
        for (std::size_t lane = 0; lane < BatchFft::lanes; ++lane)
            for (std::size_t k = 0; k < n; ++k) {
                Complex sum = 0;
                for (std::size_t j = 0; j < n; ++j)
                    sum += element(start.data(), j, lane) *
                           std::polar(1.0, sign * 2 * std::numbers::pi * static_cast<double>(j * k % n) /
                                               static_cast<double>(n));
                EXPECT_LT(std::abs(element(result, k, lane) - sum), 1e-13 * static_cast<double>(n))
                    << lane << ", " << k << ", sign " << sign;
            }
    }
}

TEST(BatchFft, RejectsLengthZero) { EXPECT_THROW(BatchFft(0), InternalError); }

} // namespace
} // namespace gaspard
