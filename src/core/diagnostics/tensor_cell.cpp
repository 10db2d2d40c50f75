#include "core/diagnostics/tensor_cell.hpp"

#include "core/base/check.hpp"

#include <cmath>

namespace gaspard {

TensorCell::TensorCell(int order, std::span<const double> at)
    : width_(static_cast<std::size_t>(order) + 1), points_(at.size()) {
    for (const Vec3 node : reference_nodes({CellShape::quadrilateral, order}))
        place_.push_back(static_cast<std::size_t>(std::lround(order * node.y)) * width_ +
                         static_cast<std::size_t>(std::lround(order * node.x)));
    const CellKind line{CellShape::line, order};
    std::vector<double> values(width_);
    std::vector<Vec3> gradients(width_);
    values_.resize(points_ * width_);
    slopes_.resize(points_ * width_);
    for (std::size_t p = 0; p < points_; ++p) {
        shape_functions(line, {at[p], 0, 0}, values, gradients);
        for (std::size_t k = 0; k < width_; ++k) { // both ends first
            const std::size_t i = k == 0 ? 0 : k == 1 ? width_ - 1 : k - 1;
            values_[p * width_ + i] = values[k];
            slopes_[p * width_ + i] = gradients[k].x;
        }
    }
}

void TensorCell::evaluate(std::span<const Vec3> nodes, std::span<PlaceInCell> out,
                          Workspace& workspace) const {
    GASPARD_CHECK(nodes.size() == width_ * width_ && out.size() == points_ * points_);
    workspace.sorted.resize(nodes.size());
    workspace.values.resize(width_ * points_);
    workspace.slopes.resize(width_ * points_);
    const Vec3 origin = nodes[0]; // sums of differences keep digits far from the origin
    for (std::size_t k = 0; k < nodes.size(); ++k) workspace.sorted[place_[k]] = nodes[k] - origin;
    for (std::size_t j = 0; j < width_; ++j)
        for (std::size_t p = 0; p < points_; ++p) {
            Vec3 value, slope;
            for (std::size_t i = 0; i < width_; ++i) {
                const Vec3 node = workspace.sorted[j * width_ + i];
                value = value + values_[p * width_ + i] * node;
                slope = slope + slopes_[p * width_ + i] * node;
            }
            workspace.values[j * points_ + p] = value;
            workspace.slopes[j * points_ + p] = slope;
        }
    for (std::size_t q = 0; q < points_; ++q)
        for (std::size_t p = 0; p < points_; ++p) {
            Vec3 x, first, second;
            for (std::size_t j = 0; j < width_; ++j) {
                const Vec3 value = workspace.values[j * points_ + p];
                x = x + values_[q * width_ + j] * value;
                first = first + values_[q * width_ + j] * workspace.slopes[j * points_ + p];
                second = second + slopes_[q * width_ + j] * value;
            }
            out[q * points_ + p] = {x + origin, {first, second, {}}};
        }
}

} // namespace gaspard
