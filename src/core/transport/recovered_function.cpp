#include "core/transport/recovered_function.hpp"

#include "core/base/box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

/// Finds triangles by the squares of a grid that they touch.
class TriangleGrid {
  public:
    explicit TriangleGrid(const LagrangeTriangles& elements)
        : elements_(elements), box_(bounding_box(elements.nodes())) {
        side_ = std::max<std::size_t>(
            1, static_cast<std::size_t>(std::sqrt(static_cast<double>(elements.cell_count()) / 2)));
        squares_.resize(side_ * side_);
        for (std::size_t c = 0; c < elements_.cell_count(); ++c) {
            std::array<std::size_t, 2> low{side_, side_}, high{0, 0};
            for (std::size_t i = 0; i < 3; ++i) {
                const auto at = square_of(corner(c, i));
                for (std::size_t k = 0; k < 2; ++k)
                    low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
            }
            for (std::size_t j = low[1]; j <= high[1]; ++j)
                for (std::size_t i = low[0]; i <= high[0]; ++i) squares_[j * side_ + i].push_back(c);
        }
    }

    struct Found {
        std::size_t cell = 0;
        std::array<double, 3> l{}; ///< barycentric coordinates
    };
    /// The triangle that contains x, or the one nearest to doing so.
    Found find(Vec3 x) const {
        Found best;
        double least = -std::numeric_limits<double>::infinity();
        const auto at = square_of(x);
        for (std::size_t reach = 0; reach <= side_; ++reach) { // squares around, until one has triangles
            visit(at, reach, [&](std::size_t c) {
                const auto l = coordinates(c, x);
                const double smallest = std::min({l[0], l[1], l[2]});
                if (smallest > least) least = smallest, best = {c, l};
            });
            if (least >= -1e-12 || (reach > 0 && std::isfinite(least))) break;
        }
        return best;
    }
    Vec3 corner(std::size_t cell, std::size_t i) const {
        return elements_.nodes()[static_cast<std::size_t>(elements_.cell(cell)[i])];
    }

  private:
    template <class Visit>
    void visit(std::array<std::size_t, 2> at, std::size_t reach, const Visit& visit_cell) const {
        const auto from = [&](std::size_t k) { return at[k] > reach ? at[k] - reach : 0; };
        for (std::size_t j = from(1); j <= std::min(side_ - 1, at[1] + reach); ++j)
            for (std::size_t i = from(0); i <= std::min(side_ - 1, at[0] + reach); ++i)
                for (const std::size_t c : squares_[j * side_ + i]) visit_cell(c);
    }
    std::array<std::size_t, 2> square_of(Vec3 x) const {
        const auto along = [&](double value, double low, double high) {
            const double part = (value - low) / (high - low) * static_cast<double>(side_);
            return static_cast<std::size_t>(std::clamp(part, 0.0, static_cast<double>(side_ - 1)));
        };
        return {along(x.x, box_.low.x, box_.high.x), along(x.y, box_.low.y, box_.high.y)};
    }
    std::array<double, 3> coordinates(std::size_t cell, Vec3 x) const {
        const Vec3 a = corner(cell, 0), b = corner(cell, 1), c = corner(cell, 2);
        const double area = cross(b - a, c - a).z, s = cross(x - a, c - a).z / area,
                     t = cross(b - a, x - a).z / area;
        return {1 - s - t, s, t};
    }

    const LagrangeTriangles& elements_;
    Box box_;
    std::size_t side_;
    std::vector<std::vector<std::size_t>> squares_;
};

} // namespace

std::vector<double> recovered_values(const NonvariationalSpace& space, std::span<const double> u,
                                     const Points& x) {
    const TriangleGrid grid(space.elements());
    std::vector<double> derivatives, values(x.size(), 0.0);
    space.differentiate(u, derivatives);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const auto [cell, l] = grid.find(x[i]);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto node = static_cast<std::size_t>(space.elements().cell(cell)[k]);
            const Vec3 d = x[i] - grid.corner(cell, k);
            const double* by = derivatives.data() + derivative_count * node;
            values[i] += l[k] * (u[node] + by[g1] * d.x + by[g2] * d.y +
                                 0.5 * (by[h11] * d.x * d.x + 2 * by[h12] * d.x * d.y + by[h22] * d.y * d.y));
        }
    }
    return values;
}

} // namespace gaspard
