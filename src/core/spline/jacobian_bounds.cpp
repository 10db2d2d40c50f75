#include "core/spline/jacobian_bounds.hpp"

#include "core/base/check.hpp"
#include "core/spline/bernstein.hpp"
#include "core/spline/line_table.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_parts_per_cell = 4096, most_parts = 1 << 17;

/// One of the four derivatives, tabulated at the interpolation points.
class Factor {
  public:
    Factor(SplineFunction of, const BernsteinPoints& at)
        : of_(std::move(of)), size_(at.size), x_(of_.space.directions[0], at.points, 0),
          y_(of_.space.directions[1], at.points, 0) {}

    /// Bounds on cell (i, j): the smallest and the largest of its B-spline coefficients.
    std::pair<double, double> range(std::size_t i, std::size_t j) const {
        double low = infinity, high = -infinity;
        const std::size_t columns = x_.functions();
        const double* first = &of_.coefficients[y_.first(j * size_) * columns + x_.first(i * size_)];
        for (std::size_t l = 0; l < y_.width(); ++l)
            for (std::size_t k = 0; k < x_.width(); ++k) {
                const double value = first[l * columns + k];
                low = value < low || std::isnan(value) ? value : low;
                high = value > high || std::isnan(value) ? value : high;
            }
        return {low, high};
    }

    /// Values at the points of cell (i, j).
    void values(std::size_t i, std::size_t j, RowMajor& out) const {
        using Table = Eigen::Map<const RowMajor>;
        const auto index = [](std::size_t n) { return static_cast<Eigen::Index>(n); };
        const std::size_t columns = x_.functions();
        const Eigen::Map<const RowMajor, 0, Eigen::OuterStride<>> local(
            &of_.coefficients[y_.first(j * size_) * columns + x_.first(i * size_)], index(y_.width()),
            index(x_.width()), Eigen::OuterStride<>(index(columns)));
        const Table along_x(x_.row(0, i * size_), index(size_), index(x_.width()));
        const Table along_y(y_.row(0, j * size_), index(size_), index(y_.width()));
        half_.noalias() = local * along_x.transpose();
        out.noalias() = along_y * half_;
    }

  private:
    SplineFunction of_;
    std::size_t size_;
    LineTable x_, y_;
    mutable RowMajor half_;
};

/// A part of a cell with the Bernstein coefficients of J there.
struct Part {
    RowMajor coefficients;
    double lower = 0;

    explicit Part(RowMajor of) : coefficients(std::move(of)), lower(coefficients.minCoeff()) {}

    /// The smallest value at a corner.
    double corner() const {
        const Eigen::Index n = coefficients.rows() - 1;
        return std::min({coefficients(0, 0), coefficients(0, n), coefficients(n, 0), coefficients(n, n)});
    }
    /// Its halves in the direction in which J varies most, by de Casteljau's algorithm.
    std::pair<Part, Part> halves() const {
        RowMajor first = coefficients, second = coefficients;
        const Eigen::Index n = coefficients.rows();
        const auto& b = coefficients;
        const bool along_x = (b.rightCols(n - 1) - b.leftCols(n - 1)).cwiseAbs().maxCoeff() >=
                             (b.bottomRows(n - 1) - b.topRows(n - 1)).cwiseAbs().maxCoeff();
        for (Eigen::Index k = 1; k < n; ++k) { // in second, those below n - k are of step k
            for (Eigen::Index i = 0; i + k < n; ++i) {
                if (along_x)
                    second.col(i) = 0.5 * (second.col(i) + second.col(i + 1));
                else
                    second.row(i) = 0.5 * (second.row(i) + second.row(i + 1));
            }
            if (along_x)
                first.col(k) = second.col(0);
            else
                first.row(k) = second.row(0);
        }
        return {Part(std::move(first)), Part(std::move(second))};
    }
    friend bool operator<(const Part& a, const Part& b) { return a.lower > b.lower; } // for a heap
};

class Bounding {
  public:
    Bounding(const std::array<SplineFunction, 2>& map, std::size_t cells)
        : cells_(cells),
          interpolation_(degree(map), cells), factors_{Factor(derivative(map[0], 0), interpolation_),
                                                       Factor(derivative(map[1], 1), interpolation_),
                                                       Factor(derivative(map[0], 1), interpolation_),
                                                       Factor(derivative(map[1], 0), interpolation_)} {}

    JacobianBounds bounds() {
        struct Candidate {
            double lower;
            std::uint32_t cell;
            bool operator<(const Candidate& other) const { return lower > other.lower; }
        };
        std::vector<Candidate> candidates;
        candidates.reserve(cells_ * cells_);
        for (std::size_t c = 0; c < cells_ * cells_; ++c)
            candidates.push_back({lower_bound(c % cells_, c / cells_), static_cast<std::uint32_t>(c)});
        std::make_heap(candidates.begin(), candidates.end());
        while (!candidates.empty()) {
            std::pop_heap(candidates.begin(), candidates.end());
            const Candidate next = candidates.back();
            if (next.lower > 0 && next.lower >= found_.smallest - tolerance()) break;
            candidates.pop_back();
            look_at(next.cell);
        }
        if (!candidates.empty()) found_.bound = std::min(found_.bound, candidates.back().lower);
        std::sort(found_.folded.begin(), found_.folded.end());
        return std::move(found_);
    }

  private:
    static std::size_t degree(const std::array<SplineFunction, 2>& map) {
        const auto of = [&](std::size_t component, std::size_t direction) {
            return map[component].space.directions.at(direction).degree;
        };
        return static_cast<std::size_t>(std::max(of(0, 0) + of(1, 0) - 1, of(0, 1) + of(1, 1) - 1));
    }

    double tolerance() const { return jacobian_tolerance * largest_; }

    /// From the ranges of the four derivatives; minus infinity if one is not finite.
    double lower_bound(std::size_t i, std::size_t j) const {
        const auto product = [&](const Factor& a, const Factor& b) {
            const auto [p, q] = a.range(i, j);
            const auto [r, s] = b.range(i, j);
            return std::minmax({p * r, p * s, q * r, q * s});
        };
        const auto straight = product(factors_[0], factors_[1]), crossed = product(factors_[2], factors_[3]);
        const double lower = straight.first - crossed.second;
        return std::isfinite(lower) ? lower : -infinity;
    }

    RowMajor coefficients(std::uint32_t cell) {
        for (std::size_t f = 0; f < factors_.size(); ++f)
            factors_[f].values(cell % cells_, cell / cells_, values_[f]);
        const RowMajor j = values_[0].cwiseProduct(values_[1]) - values_[2].cwiseProduct(values_[3]);
        const auto n = static_cast<Eigen::Index>(interpolation_.size);
        const Eigen::Map<const RowMajor> to_bernstein(interpolation_.to_bernstein.data(), n, n);
        return to_bernstein * j * to_bernstein.transpose();
    }

    void look_at(std::uint32_t cell) {
        RowMajor whole = coefficients(cell);
        if (!whole.allFinite()) {
            found_.folded.push_back(cell);
            found_.bound = -infinity;
            return;
        }
        largest_ = std::max(largest_, whole.cwiseAbs().maxCoeff());
        std::vector<Part> parts; // a heap: the part with the smallest lower bound first
        double smallest = infinity;
        const auto add = [&](Part part) {
            smallest = std::min(smallest, part.corner());
            parts.push_back(std::move(part));
            std::push_heap(parts.begin(), parts.end());
        };
        add(Part(std::move(whole)));
        const auto certain = [&] {
            const double lower = parts.front().lower;
            const bool sign = lower > 0 || smallest <= 0;
            return sign && lower >= std::min(found_.smallest, smallest) - tolerance();
        };
        for (std::size_t made = 0; !certain() && made < most_parts_per_cell && made_ < most_parts;
             made += 2, made_ += 2) {
            std::pop_heap(parts.begin(), parts.end());
            auto halves = parts.back().halves();
            parts.pop_back();
            add(std::move(halves.first));
            add(std::move(halves.second));
        }
        found_.smallest = std::min(found_.smallest, smallest);
        found_.bound = std::min(found_.bound, parts.front().lower);
        if (smallest <= 0 || parts.front().lower <= 0) found_.folded.push_back(cell);
    }

    std::size_t cells_;
    BernsteinPoints interpolation_;
    std::array<Factor, 4> factors_; ///< psi1,1 psi2,2 psi1,2 psi2,1
    std::array<RowMajor, 4> values_;
    double largest_ = 0; ///< upper bound of |J| on the cells looked at
    std::size_t made_ = 0;
    JacobianBounds found_{infinity, infinity, {}};
};

} // namespace

JacobianBounds bound_jacobian(const std::array<SplineFunction, 2>& map, std::size_t cells) {
    GASPARD_CHECK(cells >= 1);
    for (const SplineFunction& component : map)
        GASPARD_CHECK(component.space.directions.size() == 2 &&
                      component.coefficients.size() == component.space.size());
    return Bounding(map, cells).bounds();
}

} // namespace gaspard
