#include "core/spline/spline_patch.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>

namespace gaspard {

namespace {

class Map final : public PatchMap {
  public:
    explicit Map(SplinePatch patch) : patch_(std::move(patch)) {
        const std::size_t n = patch_.space.size();
        GASPARD_CHECK(patch_.space.directions.size() == 2);
        GASPARD_CHECK(patch_.control.size() == n && patch_.weights.size() == n);
        weighted_.reserve(n);
        for (std::size_t i = 0; i < n; ++i) {
            const double w = patch_.weights[i];
            GASPARD_CHECK(w > 0);
            const Vec3 c = patch_.control[i];
            weighted_.push_back({w * c.x, w * c.y, w * c.z, w});
            if (c.z != 0) dimension_ = 3;
        }
    }

    int space_dimension() const override { return dimension_; }
    void points(const Points& xi, Points& x) const override {
        x.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const Homogeneous h = at(xi.x[i], xi.y[i], 0)[0];
            x.set(i, (1 / h[3]) * Vec3{h[0], h[1], h[2]});
        }
    }
    // Quotient rule: F' = (A' - w' F) / w.
    void tangents(const Points& xi, Points& first, Points& second) const override {
        first.resize(xi.size());
        second.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const auto h = at(xi.x[i], xi.y[i], 1);
            const double w = h[0][3];
            const Vec3 f = (1 / w) * Vec3{h[0][0], h[0][1], h[0][2]};
            first.set(i, (1 / w) * (Vec3{h[1][0], h[1][1], h[1][2]} - h[1][3] * f));
            second.set(i, (1 / w) * (Vec3{h[2][0], h[2][1], h[2][2]} - h[2][3] * f));
        }
    }

  private:
    using Homogeneous = std::array<double, 4>; ///< (w x, w y, w z, w)

    /// The value and, for order 1, both derivatives.
    std::array<Homogeneous, 3> at(double a, double b, int order) const {
        const KnotVector &u = patch_.space.directions[0], &v = patch_.space.directions[1];
        std::array<double, 2 * (highest_degree + 1)> bu, bv;
        const std::size_t su = find_span(u, a), sv = find_span(v, b);
        basis_functions(u, su, a, order, bu);
        basis_functions(v, sv, b, order, bv);
        const auto p = static_cast<std::size_t>(u.degree), q = static_cast<std::size_t>(v.degree);
        std::array<Homogeneous, 3> sum{};
        for (std::size_t l = 0; l <= q; ++l)
            for (std::size_t k = 0; k <= p; ++k) {
                const Homogeneous& c = weighted_[(sv - q + l) * u.size() + su - p + k];
                for (std::size_t d = 0; d < 4; ++d) {
                    sum[0][d] += bu[k] * bv[l] * c[d];
                    if (order == 0) continue;
                    sum[1][d] += bu[p + 1 + k] * bv[l] * c[d];
                    sum[2][d] += bu[k] * bv[q + 1 + l] * c[d];
                }
            }
        return sum;
    }

    SplinePatch patch_;
    std::vector<Homogeneous> weighted_;
    int dimension_ = 2;
};

} // namespace

SplinePatch insert_knots(const SplinePatch& patch, const TensorSpace& fine) {
    const std::size_t n = patch.space.size();
    std::array<std::vector<double>, 3> weighted;
    for (std::size_t i = 0; i < n; ++i) {
        weighted[0].push_back(patch.weights[i] * patch.control.x[i]);
        weighted[1].push_back(patch.weights[i] * patch.control.y[i]);
        weighted[2].push_back(patch.weights[i] * patch.control.z[i]);
    }
    SplinePatch result{fine, Points(fine.size()), insert_knots(patch.space, patch.weights, fine)};
    for (auto& one : weighted) one = insert_knots(patch.space, one, fine);
    for (std::size_t i = 0; i < fine.size(); ++i)
        result.control.set(i, (1 / result.weights[i]) * Vec3{weighted[0][i], weighted[1][i], weighted[2][i]});
    return result;
}

SplinePatch patch_through(const TensorSpace& space, const Points& x) {
    GASPARD_CHECK(space.directions.size() == 2 && x.size() == space.size());
    const std::size_t m = space.directions[0].size(), n = space.directions[1].size();
    const LineMatrix along = interpolation(space.directions[0]), across = interpolation(space.directions[1]);
    SplinePatch patch{space, Points(m * n), std::vector<double>(m * n, 1.0)};
    Points half(m * n);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < m; ++i) {
            Vec3 sum;
            for (std::size_t k = 0; k < m; ++k) sum = sum + along(i, k) * x[j * m + k];
            half.set(j * m + i, sum);
        }
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < m; ++i) {
            Vec3 sum;
            for (std::size_t k = 0; k < n; ++k) sum = sum + across(j, k) * half[k * m + i];
            patch.control.set(j * m + i, sum);
        }
    return patch;
}

std::shared_ptr<const PatchMap> patch_map(SplinePatch patch) {
    return std::make_shared<Map>(std::move(patch));
}

} // namespace gaspard
