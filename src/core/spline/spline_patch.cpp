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
            const Homogeneous h = at<0>(xi.x[i], xi.y[i])[0];
            x.set(i, (1 / h[3]) * Vec3{h[0], h[1], h[2]});
        }
    }
    void tangents(const Points& xi, Points& first, Points& second) const override {
        first.resize(xi.size());
        second.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const auto place = place_at<1>(xi.x[i], xi.y[i]);
            first.set(i, place[1]);
            second.set(i, place[2]);
        }
    }
    void places(const Points& xi, Points& x, std::span<double> area) const override {
        x.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const auto [f, first, second] = place_at<1>(xi.x[i], xi.y[i]);
            x.set(i, f);
            area[i] = norm(cross(first, second));
        }
    }
    // With N = F_1 x F_2: J = |N|, dJ = N . dN / J.
    void area_gradients(const Points& xi, std::span<double> area, Points& gradient) const override {
        gradient.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const auto [f, f1, f2, f11, f12, f22] = place_at<2>(xi.x[i], xi.y[i]);
            const Vec3 normal = cross(f1, f2);
            area[i] = norm(normal);
            const Vec3 unit = area[i] > 0 ? (1 / area[i]) * normal : Vec3{};
            gradient.set(i, {dot(unit, cross(f11, f2) + cross(f1, f12)),
                             dot(unit, cross(f12, f2) + cross(f1, f22)), 0});
        }
    }

  private:
    using Homogeneous = std::array<double, 4>; ///< (w x, w y, w z, w)

    /// The value, both first derivatives (order 1), and those by 11, 12, 22 (order 2).
    template <int order>
    static constexpr std::size_t parts = (order + 1) * (order + 2) / 2;
    template <int order>
    std::array<Homogeneous, parts<order>> at(double a, double b) const {
        const KnotVector &u = patch_.space.directions[0], &v = patch_.space.directions[1];
        std::array<double, (order + 1) * (highest_degree + 1)> bu, bv;
        const std::size_t su = find_span(u, a), sv = find_span(v, b);
        basis_functions(u, su, a, order, bu);
        basis_functions(v, sv, b, order, bv);
        const auto p = static_cast<std::size_t>(u.degree), q = static_cast<std::size_t>(v.degree);
        std::array<Homogeneous, parts<order>> sum{};
        for (std::size_t l = 0; l <= q; ++l)
            for (std::size_t k = 0; k <= p; ++k) {
                const Homogeneous& c = weighted_[(sv - q + l) * u.size() + su - p + k];
                for (std::size_t d = 0; d < 4; ++d) {
                    sum[0][d] += bu[k] * bv[l] * c[d];
                    if constexpr (order > 0) {
                        sum[1][d] += bu[p + 1 + k] * bv[l] * c[d];
                        sum[2][d] += bu[k] * bv[q + 1 + l] * c[d];
                    }
                    if constexpr (order > 1) {
                        sum[3][d] += bu[2 * (p + 1) + k] * bv[l] * c[d];
                        sum[4][d] += bu[p + 1 + k] * bv[q + 1 + l] * c[d];
                        sum[5][d] += bu[k] * bv[2 * (q + 1) + l] * c[d];
                    }
                }
            }
        return sum;
    }
    /// F and its derivatives, in the same order. Quotient rule for F = A / w:
    ///
    ///   F_i = (A_i - w_i F) / w,   F_ij = (A_ij - w_ij F - w_i F_j - w_j F_i) / w
    template <int order>
    std::array<Vec3, parts<order>> place_at(double a, double b) const {
        const auto h = at<order>(a, b);
        const double w = h[0][3];
        std::array<Vec3, parts<order>> f;
        f[0] = (1 / w) * Vec3{h[0][0], h[0][1], h[0][2]};
        for (std::size_t i = 1; i < parts<order>; ++i) {
            Vec3 sum = Vec3{h[i][0], h[i][1], h[i][2]} - h[i][3] * f[0];
            if (i > 2) { // f_11, f_12, f_22
                const std::size_t first = i == 5 ? 2 : 1, second = i == 3 ? 1 : 2;
                sum = sum - h[first][3] * f[second] - h[second][3] * f[first];
            }
            f[i] = (1 / w) * sum;
        }
        return f;
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
