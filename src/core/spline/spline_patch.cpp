#include "core/spline/spline_patch.hpp"

#include "core/base/check.hpp"
#include "core/spline/map_place.hpp"

#include <algorithm>
#include <array>

namespace gaspard {

namespace {

/// The sum of B-spline products times coefficients, with derivatives of total order `order` at most: the
/// value, the first derivatives, and the second ones of the upper triangle by rows.
template <std::size_t D, int order>
inline constexpr std::size_t parts = order == 0   ? 1
                                     : order == 1 ? 1 + D
                                                  : 1 + D + D*(D + 1) / 2;

template <std::size_t D>
class Map final : public TensorMap<D> {
  public:
    explicit Map(SplinePatch patch) : patch_(std::move(patch)) {
        const std::size_t n = patch_.space.size();
        GASPARD_CHECK(patch_.space.directions.size() == D);
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
            const Homogeneous h = at<0>(xi[i])[0];
            x.set(i, (1 / h[3]) * Vec3{h[0], h[1], h[2]});
        }
    }
    void tangents(const Points& xi, std::array<Points, D>& tangents) const override {
        for (Points& one : tangents) one.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const Place<D> place = place_at<1>(xi[i]);
            for (std::size_t d = 0; d < D; ++d) tangents[d].set(i, place.first[d]);
        }
    }
    void places(const Points& xi, Points& x, std::span<double> element) const override {
        x.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const Place<D> place = place_at<1>(xi[i]);
            x.set(i, place.x);
            element[i] = element_of(place);
        }
    }
    void element_gradients(const Points& xi, std::span<double> element, Points& gradient) const override {
        gradient.resize(xi.size());
        for (std::size_t i = 0; i < xi.size(); ++i) {
            const Element of = element_with_gradient(place_at<2>(xi[i]));
            element[i] = of.value;
            gradient.set(i, of.gradient);
        }
    }

  private:
    using Homogeneous = std::array<double, 4>; ///< (w x, w y, w z, w)
    /// Basis functions of one direction, derivative after derivative.
    struct Line {
        std::array<double, 3 * (highest_degree + 1)> values;
        std::size_t first = 0, count = 0;
        const double* of(std::size_t derivative) const { return &values[derivative * count]; }
    };

    template <int order>
    std::array<Homogeneous, parts<D, order>> at(Vec3 xi) const {
        const std::array<double, 3> coordinates{xi.x, xi.y, xi.z};
        std::array<Line, D> lines;
        for (std::size_t d = 0; d < D; ++d) {
            const KnotVector& space = patch_.space.directions[d];
            const std::size_t span = find_span(space, coordinates[d]);
            lines[d].count = static_cast<std::size_t>(space.degree) + 1;
            lines[d].first = span + 1 - lines[d].count;
            basis_functions(space, span, coordinates[d], order, lines[d].values);
        }
        std::array<Homogeneous, parts<D, order>> sum{};
        const std::size_t columns = patch_.space.directions[0].size(),
                          rows = patch_.space.directions[1].size();
        const std::size_t layers = D == 3 ? lines[D - 1].count : 1;
        for (std::size_t m = 0; m < layers; ++m)
            for (std::size_t l = 0; l < lines[1].count; ++l)
                for (std::size_t k = 0; k < lines[0].count; ++k) {
                    std::size_t row = lines[1].first + l;
                    if constexpr (D == 3) row += (lines[2].first + m) * rows;
                    const Homogeneous& c = weighted_[row * columns + lines[0].first + k];
                    add<order>(lines, {k, l, m}, c, sum);
                }
        return sum;
    }
    /// Adds c times the derivatives of one product of basis functions.
    template <int order>
    static void add(const std::array<Line, D>& lines, const std::array<std::size_t, 3>& which,
                    const Homogeneous& c, std::array<Homogeneous, parts<D, order>>& sum) {
        const auto product = [&](std::array<std::size_t, D> derivatives) {
            double all = 1;
            for (std::size_t d = 0; d < D; ++d) all *= lines[d].of(derivatives[d])[which[d]];
            return all;
        };
        std::size_t part = 0;
        const auto put = [&](double factor) {
            for (std::size_t e = 0; e < 4; ++e) sum[part][e] += factor * c[e];
            ++part;
        };
        put(product({}));
        if constexpr (order > 0)
            for (std::size_t d = 0; d < D; ++d) {
                std::array<std::size_t, D> once{};
                once[d] = 1;
                put(product(once));
            }
        if constexpr (order > 1)
            for (std::size_t d = 0; d < D; ++d)
                for (std::size_t e = d; e < D; ++e) {
                    std::array<std::size_t, D> twice{};
                    ++twice[d], ++twice[e];
                    put(product(twice));
                }
    }
    /// Quotient rule for F = A / w:
    ///
    ///   F_i = (A_i - w_i F) / w,   F_ij = (A_ij - w_ij F - w_i F_j - w_j F_i) / w
    template <int order>
    Place<D> place_at(Vec3 xi) const {
        const auto h = at<order>(xi);
        const double w = h[0][3];
        const auto vector = [&](std::size_t part) { return Vec3{h[part][0], h[part][1], h[part][2]}; };
        Place<D> f{(1 / w) * vector(0), {}, {}};
        for (std::size_t d = 0; d < D; ++d) f.first[d] = (1 / w) * (vector(1 + d) - h[1 + d][3] * f.x);
        if constexpr (order > 1)
            for (std::size_t d = 0, part = 1 + D; d < D; ++d)
                for (std::size_t e = d; e < D; ++e, ++part)
                    f.second[part - 1 - D] = (1 / w) * (vector(part) - h[part][3] * f.x -
                                                        h[1 + d][3] * f.first[e] - h[1 + e][3] * f.first[d]);
        return f;
    }

    SplinePatch patch_;
    std::vector<Homogeneous> weighted_;
    int dimension_ = D == 3 ? 3 : 2;
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
    GASPARD_CHECK(x.size() == space.size());
    SplinePatch patch{space, x, std::vector<double>(x.size(), 1.0)};
    std::size_t step = 1; // between neighbours along a direction
    for (const KnotVector& line : space.directions) {
        const LineMatrix along = interpolation(line);
        const std::size_t n = line.size();
        std::vector<Vec3> values(n);
        for (std::size_t first = 0; first < x.size(); ++first) {
            if (first / step % n != 0) continue; // not the start of a line
            for (std::size_t i = 0; i < n; ++i) values[i] = patch.control[first + i * step];
            for (std::size_t i = 0; i < n; ++i) {
                Vec3 sum;
                for (std::size_t k = 0; k < n; ++k) sum = sum + along(i, k) * values[k];
                patch.control.set(first + i * step, sum);
            }
        }
        step *= n;
    }
    return patch;
}

std::shared_ptr<const PatchMap> patch_map(SplinePatch patch) {
    return std::make_shared<Map<2>>(std::move(patch));
}
std::shared_ptr<const SolidMap> solid_map(SplinePatch patch) {
    return std::make_shared<Map<3>>(std::move(patch));
}

} // namespace gaspard
