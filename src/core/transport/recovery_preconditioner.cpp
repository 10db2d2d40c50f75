#include "core/transport/recovery_preconditioner.hpp"

#include "core/base/check.hpp"
#include "core/base/eigenvalues.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

constexpr double shift = 1e-2;       ///< of S by a multiple of the mass matrix, relative to its smallest mode
constexpr double least_ratio = 1e-2; ///< smallest eigenvalue of the coefficients, relative to the largest

/// cof H with eigenvalues that are positive: xx, xy, yy.
std::array<double, 3> coefficient(double xx, double xy, double yy) {
    auto [low, high] = symmetric_eigenvalues(yy, -xy, xx);
    const double least = least_ratio * std::max(std::abs(high), std::abs(low));
    if (low >= least && least > 0) return {yy, -xy, xx};
    if (!(least > 0)) return {1, 0, 1};
    const double angle = 0.5 * std::atan2(-2 * xy, yy - xx), c = std::cos(angle), s = std::sin(angle);
    high = std::max(high, least), low = std::max(low, least);
    return {high * c * c + low * s * s, (high - low) * c * s, high * s * s + low * c * c};
}

} // namespace

RecoveryPreconditioner::RecoveryPreconditioner(std::shared_ptr<const NonvariationalSpace> space,
                                               const std::stop_token& stop)
    : space_(std::move(space)), ordered_(space_->size()) {
    if (space_->recovery() == Recovery::none) {
        dissection_ = space_->dissection();
        return;
    }
    make_rings();
    if (stop.stop_requested()) throw Interrupted();
    dissection_ = std::make_shared<const Dissection>(dissect(rings_, space_->elements().nodes()));
}

void RecoveryPreconditioner::make_rings() {
    const LagrangeTriangles& elements = space_->elements();
    const std::size_t n = elements.per_cell(), nodes = space_->size();
    std::vector<std::vector<std::int32_t>> lists(nodes);
    for (std::size_t c = 0; c < elements.cell_count(); ++c)
        for (const auto node : elements.cell(c)) {
            auto& list = lists[static_cast<std::size_t>(node)];
            for (const auto other : elements.cell(c))
                if (std::find(list.begin(), list.end(), other) == list.end()) list.push_back(other);
        }
    std::size_t longest = 0;
    for (const auto& list : lists) longest = std::max(longest, list.size());
    rings_ = {.count = nodes, .per_cell = longest, .numbers = {}};
    rings_.numbers.reserve(nodes * longest);
    for (auto& list : lists) {
        list.resize(longest, list[0]); // filled up with entries of weight 0
        rings_.numbers.insert(rings_.numbers.end(), list.begin(), list.end());
    }
    means_.assign(2 * rings_.numbers.size(), 0.0);
    weights_.assign(nodes, 0.0);
    std::vector<double> masses(nodes, 0.0);
    for (std::size_t c = 0; c < elements.cell_count(); ++c) {
        const auto cell = elements.cell(c);
        for (std::size_t a = 0; a < n; ++a) {
            const auto node = static_cast<std::size_t>(cell[a]);
            const auto& list = lists[node];
            for (std::size_t b = 0; b < n; ++b) {
                const auto slot =
                    static_cast<std::size_t>(std::find(list.begin(), list.end(), cell[b]) - list.begin());
                double* to = means_.data() + 2 * (node * longest + slot);
                for (std::size_t q = 0; q < space_->shapes().size(); ++q) {
                    const auto& point = space_->points(c)[q];
                    const TriangleShapes& shapes = space_->shapes()[q];
                    const auto gradient = point.gradient(shapes.slopes[b]);
                    const double v = point.weight * shapes.values[a];
                    to[0] += v * gradient[0], to[1] += v * gradient[1];
                    if (a == b) masses[node] += v * shapes.values[a];
                }
            }
        }
    }
    for (std::size_t i = 0; i < nodes; ++i) weights_[i] = 1 / masses[i];
    masses_ = std::move(masses);
}

void RecoveryPreconditioner::factorise(std::span<const double> hessians, std::stop_token stop) {
    const auto coefficient_at = [&](std::size_t node) {
        const double* h = hessians.data() + derivative_count * node;
        return coefficient(h[h11], h[h12], h[h22]);
    };
    double mean = 0;
    for (std::size_t i = 0; i < space_->size(); ++i) {
        const auto [xx, xy, yy] = coefficient_at(i);
        mean += (xx + yy) / 2 / static_cast<double>(space_->size());
    }
    const double lifted = shift * mean / space_->area(); // the smallest mode is about 10 mean / area
    if (space_->recovery() == Recovery::gradient) {
        const std::size_t n = rings_.per_cell;
        factor_.emplace(
            rings_, dissection_,
            [&](std::size_t node, std::span<double> matrix) {
                const auto [xx, xy, yy] = coefficient_at(node);
                const double weight = weights_[node];
                const double* d = means_.data() + 2 * node * n;
                for (std::size_t a = 0; a < n; ++a) {
                    const double ax = weight * (xx * d[2 * a] + xy * d[2 * a + 1]),
                                 ay = weight * (xy * d[2 * a] + yy * d[2 * a + 1]);
                    for (std::size_t b = 0; b < n; ++b) matrix[a * n + b] = ax * d[2 * b] + ay * d[2 * b + 1];
                }
                const auto ring = rings_.of(node);
                const auto self = static_cast<std::size_t>(
                    std::find(ring.begin(), ring.end(), static_cast<std::int32_t>(node)) - ring.begin());
                matrix[self * n + self] += lifted * masses_[node];
            },
            CellCholesky::Advance{}, std::move(stop));
        return;
    }
    const LagrangeTriangles& elements = space_->elements();
    const std::size_t n = elements.per_cell();
    std::vector<std::array<double, 2>> gradients(n);
    factor_.emplace(
        space_->unknowns(), dissection_,
        [&](std::size_t c, std::span<double> matrix) {
            std::fill(matrix.begin(), matrix.end(), 0.0);
            std::array<double, 3> of_cell{};
            for (const auto node : elements.cell(c)) {
                const auto at = coefficient_at(static_cast<std::size_t>(node));
                for (std::size_t i = 0; i < 3; ++i) of_cell[i] += at[i] / static_cast<double>(n);
            }
            const auto& [xx, xy, yy] = of_cell;
            for (std::size_t q = 0; q < space_->shapes().size(); ++q) {
                const auto& point = space_->points(c)[q];
                const TriangleShapes& shapes = space_->shapes()[q];
                for (std::size_t a = 0; a < n; ++a) gradients[a] = point.gradient(shapes.slopes[a]);
                for (std::size_t a = 0; a < n; ++a)
                    for (std::size_t b = 0; b < n; ++b)
                        matrix[a * n + b] +=
                            point.weight *
                            (xx * gradients[a][0] * gradients[b][0] + yy * gradients[a][1] * gradients[b][1] +
                             xy * (gradients[a][0] * gradients[b][1] + gradients[a][1] * gradients[b][0]) +
                             lifted * shapes.values[a] * shapes.values[b]);
            }
        },
        CellCholesky::Advance{}, std::move(stop));
}

void RecoveryPreconditioner::solve(std::span<const double> r, std::span<double> w) {
    GASPARD_CHECK(factor_.has_value());
    const auto& place = dissection_->permutation;
    const std::size_t n = space_->size();
    const auto loads = space_->loads();
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += r[i];
    const double c = -sum / space_->area();
    for (std::size_t i = 0; i < n; ++i) ordered_[static_cast<std::size_t>(place[i])] = r[i] + c * loads[i];
    factor_->solve<1>(ordered_);
    double mean = r[n];
    for (std::size_t i = 0; i < n; ++i) {
        w[i] = ordered_[static_cast<std::size_t>(place[i])];
        mean += w[i] * loads[i];
    }
    mean /= space_->area();
    for (std::size_t i = 0; i < n; ++i) w[i] -= mean;
    w[n] = c;
}

} // namespace gaspard
