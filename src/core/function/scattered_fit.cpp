#include "core/function/scattered_fit.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nanoflann.hpp>
#include <numbers>

namespace gaspard {

namespace {

/// The points, as nanoflann reads them.
struct TreePoints {
    Points points;
    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t d) const {
        return d == 0 ? points.x[i] : d == 1 ? points.y[i] : points.z[i];
    }
    template <class Bounds>
    bool kdtree_get_bbox(Bounds&) const {
        return false;
    }
};

using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, TreePoints>,
                                                  TreePoints, 3, std::uint32_t>;

/// Solves the symmetric positive definite system M s = b in place of b (Cholesky); n <= 4.
void solve(std::array<std::array<double, 4>, 4>& m, std::array<double, 4>& b, std::size_t n) {
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t k = 0; k < j; ++k) m[j][j] -= m[j][k] * m[j][k];
        m[j][j] = std::sqrt(std::max(m[j][j], 1e-300));
        for (std::size_t i = j + 1; i < n; ++i) {
            for (std::size_t k = 0; k < j; ++k) m[i][j] -= m[i][k] * m[j][k];
            m[i][j] /= m[j][j];
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < i; ++k) b[i] -= m[i][k] * b[k];
        b[i] /= m[i][i];
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k) b[i] -= m[k][i] * b[k];
        b[i] /= m[i][i];
    }
}

} // namespace

struct ScatteredFit::Tree {
    Tree(Points points, std::vector<double> all, int space)
        : cloud{std::move(points)}, values(std::move(all)), dimension(space),
          index(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(16)) {
        index.buildIndex();
    }
    TreePoints cloud;
    std::vector<double> values;
    int dimension;
    Index index;
};

ScatteredFit::ScatteredFit(Points points, std::vector<double> values, int dimension) {
    GASPARD_CHECK(points.size() > 0 && points.size() == values.size());
    tree_ = std::make_unique<Tree>(std::move(points), std::move(values), dimension);
}
ScatteredFit::~ScatteredFit() = default;
ScatteredFit::ScatteredFit(ScatteredFit&&) noexcept = default;

ScatteredFit::Value ScatteredFit::at(Vec3 x) const {
    const Tree& tree = *tree_;
    std::array<std::uint32_t, neighbours> found{};
    std::array<double, neighbours> squares{};
    const std::array<double, 3> place = {x.x, x.y, x.z};
    const std::size_t count = tree.index.knnSearch(place.data(), neighbours, found.data(), squares.data());
    const double nearest = std::sqrt(squares[0]), far = squares[count - 1];
    if (!(far > 0)) return {tree.values[found[0]], nearest};
    const std::size_t n = count < 3 ? 1 : static_cast<std::size_t>(tree.dimension) + 1;
    std::array<std::array<double, 4>, 4> m{};
    std::array<double, 4> b{};
    const double least = std::exp(-4.0), scale = 1 / std::sqrt(far);
    double low = tree.values[found[0]], high = low, total = 0;
    for (std::size_t k = 0; k < count; ++k) {
        // Fewer points than wanted all count.
        const double w = std::exp(-4 * squares[k] / far) - (count == neighbours ? least : 0);
        const Vec3 d = scale * (tree.cloud.points[found[k]] - x);
        const std::array<double, 4> basis = {1, d.x, d.y, d.z};
        const double v = tree.values[found[k]];
        low = std::min(low, v), high = std::max(high, v), total += w;
        for (std::size_t i = 0; i < n; ++i) {
            b[i] += w * basis[i] * v;
            for (std::size_t j = 0; j <= i; ++j) m[i][j] += w * basis[i] * basis[j];
        }
    }
    if (!(total > 0)) return {tree.values[found[0]], nearest};
    for (std::size_t i = 1; i < n; ++i) m[i][i] += 1e-9 * total;
    solve(m, b, n);
    return {std::clamp(b[0], low, high), nearest};
}

double ScatteredFit::spacing() const {
    const Tree& tree = *tree_;
    constexpr std::size_t samples = 500, near = 5; // the point itself and four neighbours
    const std::size_t size = tree.values.size(), step = std::max<std::size_t>(size / samples, 1);
    std::vector<double> distances;
    for (std::size_t i = 0; i < size; i += step) {
        std::array<std::uint32_t, near> found{};
        std::array<double, near> squares{};
        const Vec3 x = tree.cloud.points[i];
        const std::array<double, 3> place = {x.x, x.y, x.z};
        const std::size_t count = tree.index.knnSearch(place.data(), near, found.data(), squares.data());
        distances.push_back(std::sqrt(squares[count - 1]));
    }
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle * std::sqrt(std::numbers::pi) / 2;
}

} // namespace gaspard
