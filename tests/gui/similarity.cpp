#include "similarity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gaspard {

namespace {

/// Means of blocks of pixels, per channel.
struct Blocks {
    int columns = 0, rows = 0;
    std::vector<std::array<double, 3>> colours;
    double brightness(int column, int row) const {
        const auto& c = colours[static_cast<std::size_t>(row * columns + column)];
        return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2];
    }
};

Blocks blocks(const Image& image, int side) {
    Blocks result{image.width / side, image.height / side, {}};
    for (int row = 0; row < result.rows; ++row)
        for (int column = 0; column < result.columns; ++column) {
            std::array<double, 3> sum{};
            for (int y = row * side; y < (row + 1) * side; ++y)
                for (int x = column * side; x < (column + 1) * side; ++x)
                    for (std::size_t c = 0; c < 3; ++c)
                        sum[c] += image.rgba[static_cast<std::size_t>(y * image.width + x) * 4 + c];
            for (double& value : sum) value /= side * side;
            result.colours.push_back(sum);
        }
    return result;
}

/// Structural similarity of one window of blocks (Wang, Bovik, Sheikh, Simoncelli 2004).
double structure(const Blocks& a, const Blocks& b, int left, int top, int width, int height) {
    double mean_a = 0, mean_b = 0, square_a = 0, square_b = 0, product = 0;
    for (int row = top; row < top + height; ++row)
        for (int column = left; column < left + width; ++column) {
            const double p = a.brightness(column, row), q = b.brightness(column, row);
            mean_a += p, mean_b += q, square_a += p * p, square_b += q * q, product += p * q;
        }
    const double n = width * height;
    mean_a /= n, mean_b /= n;
    const double variance_a = square_a / n - mean_a * mean_a, variance_b = square_b / n - mean_b * mean_b;
    const double covariance = product / n - mean_a * mean_b;
    constexpr double c1 = 6.5025, c2 = 58.5225; // (0.01 * 255)^2, (0.03 * 255)^2
    return (2 * mean_a * mean_b + c1) * (2 * covariance + c2) /
           ((mean_a * mean_a + mean_b * mean_b + c1) * (variance_a + variance_b + c2));
}

} // namespace

Similarity compare(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height || a.rgba.size() != b.rgba.size()) return {};
    Similarity result;
    const Blocks coarse_a = blocks(a, 4), coarse_b = blocks(b, 4);
    double sum = 0;
    for (std::size_t i = 0; i < coarse_a.colours.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) sum += std::abs(coarse_a.colours[i][c] - coarse_b.colours[i][c]);
    result.mean_difference = sum / (3 * static_cast<double>(coarse_a.colours.size()));

    const Blocks fine_a = blocks(a, 2), fine_b = blocks(b, 2);
    constexpr int parts = 10;
    const int width = fine_a.columns / parts, height = fine_a.rows / parts;
    result.worst_structure = 1;
    result.mean_structure = 0;
    for (int row = 0; row < parts; ++row)
        for (int column = 0; column < parts; ++column) {
            const double here = structure(fine_a, fine_b, column * width, row * height, width, height);
            result.worst_structure = std::min(result.worst_structure, here);
            result.mean_structure += here / (parts * parts);
        }
    return result;
}

std::string difference(const Image& a, const Image& b) {
    const Similarity s = compare(a, b);
    if (s.mean_difference <= 0.5 && s.mean_structure >= 0.99 && s.worst_structure >= 0.9) return {};
    return "mean difference " + std::to_string(s.mean_difference) + " of 255, structure " +
           std::to_string(s.mean_structure) + ", in the worst part " + std::to_string(s.worst_structure);
}

} // namespace gaspard
