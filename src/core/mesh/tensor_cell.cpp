#include "core/mesh/tensor_cell.hpp"

#include "core/base/check.hpp"

#include <cmath>

namespace gaspard {

TensorCell::TensorCell(CellKind kind, std::span<const double> at)
    : cube_(kind.shape == CellShape::hexahedron), width_(static_cast<std::size_t>(kind.order) + 1),
      points_(at.size()) {
    GASPARD_CHECK(cube_ || kind.shape == CellShape::quadrilateral);
    const auto index = [&](double s) { return static_cast<std::size_t>(std::lround(kind.order * s)); };
    for (const Vec3 node : reference_nodes(kind))
        place_.push_back((index(node.z) * width_ + index(node.y)) * width_ + index(node.x));
    const CellKind line{CellShape::line, kind.order};
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
    GASPARD_CHECK(nodes.size() == place_.size());
    GASPARD_CHECK(out.size() == points_ * points_ * (cube_ ? points_ : 1));
    sum_along_s(nodes, workspace);
    if (cube_)
        evaluate_cube(nodes[0], out, workspace);
    else
        evaluate_square(nodes[0], out, workspace);
}

void TensorCell::sum_along_s(std::span<const Vec3> nodes, Workspace& workspace) const {
    const std::size_t rows = nodes.size() / width_;
    workspace.sorted.resize(nodes.size());
    workspace.values.resize(rows * points_);
    workspace.slopes.resize(rows * points_);
    const Vec3 origin = nodes[0]; // sums of differences keep digits far from the origin
    for (std::size_t k = 0; k < nodes.size(); ++k) workspace.sorted[place_[k]] = nodes[k] - origin;
    for (std::size_t j = 0; j < rows; ++j)
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
}

void TensorCell::evaluate_square(Vec3 origin, std::span<PlaceInCell> out, const Workspace& workspace) const {
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

void TensorCell::evaluate_cube(Vec3 origin, std::span<PlaceInCell> out, Workspace& workspace) const {
    const std::size_t plane = points_ * points_;
    for (auto& one : workspace.planes) one.resize(width_ * plane);
    for (std::size_t k = 0; k < width_; ++k)
        for (std::size_t q = 0; q < points_; ++q)
            for (std::size_t p = 0; p < points_; ++p) {
                Vec3 x, first, second;
                for (std::size_t j = 0; j < width_; ++j) {
                    const std::size_t at = (k * width_ + j) * points_ + p;
                    x = x + values_[q * width_ + j] * workspace.values[at];
                    first = first + values_[q * width_ + j] * workspace.slopes[at];
                    second = second + slopes_[q * width_ + j] * workspace.values[at];
                }
                const std::size_t to = k * plane + q * points_ + p;
                workspace.planes[0][to] = x, workspace.planes[1][to] = first,
                workspace.planes[2][to] = second;
            }
    for (std::size_t r = 0; r < points_; ++r)
        for (std::size_t i = 0; i < plane; ++i) {
            Vec3 x, first, second, third;
            for (std::size_t k = 0; k < width_; ++k) {
                const double value = values_[r * width_ + k];
                x = x + value * workspace.planes[0][k * plane + i];
                first = first + value * workspace.planes[1][k * plane + i];
                second = second + value * workspace.planes[2][k * plane + i];
                third = third + slopes_[r * width_ + k] * workspace.planes[0][k * plane + i];
            }
            out[r * plane + i] = {x + origin, {first, second, third}};
        }
}

} // namespace gaspard
