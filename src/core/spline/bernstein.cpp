#include "core/spline/bernstein.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace gaspard {

BernsteinPoints::BernsteinPoints(std::size_t degree, std::size_t cells) : size(degree + 1) {
    std::vector<double> place(size);
    for (std::size_t k = 0; k < size; ++k)
        place[k] = (1 - std::cos(std::numbers::pi * (2.0 * static_cast<double>(k) + 1) /
                                 (2.0 * static_cast<double>(size)))) /
                   2;
    for (std::size_t c = 0; c < cells; ++c)
        for (const double t : place)
            points.push_back((static_cast<double>(c) + t) / static_cast<double>(cells));
    const auto n = static_cast<Eigen::Index>(size);
    Eigen::MatrixXd bernstein = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const double t = place[static_cast<std::size_t>(k)];
        bernstein(k, 0) = 1; // raised from degree 0, one degree at a time
        for (Eigen::Index q = 1; q < n; ++q)
            for (Eigen::Index i = q; i >= 0; --i)
                bernstein(k, i) =
                    (i < q ? (1 - t) * bernstein(k, i) : 0) + (i > 0 ? t * bernstein(k, i - 1) : 0);
    }
    to_bernstein.resize(size * size);
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
        to_bernstein.data(), n, n) = bernstein.partialPivLu().inverse();
}

} // namespace gaspard
