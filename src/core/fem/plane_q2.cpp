#include "core/fem/plane_q2.hpp"

#include "core/base/check.hpp"
#include "core/fem/gauss.hpp"
#include "core/linear/transpose.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

PlaneQ2::PlaneQ2(LineGrid grid)
    : grid_(grid), mesh_(std::make_shared<Mesh>(unit_square_mesh(static_cast<int>(grid.cells)))),
      second_(grid, 2, Symmetry::even, {true, true}), first_(grid, 2, Symmetry::odd, {false, true}),
      slope_q1_(grid, 1, Symmetry::odd, {false, true}), value_q1_(grid, 1, Symmetry::even, {false, false}),
      poisson_(LineSpectrum(grid.cells, grid.periodic)), weights_(line_weights()) {
    const LineQuadrature rule = gauss_legendre(static_cast<int>(gauss));
    for (std::size_t q = 0; q < gauss; ++q) {
        const double s = rule.points[q];
        q2_[q] = {(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)};
        q1_[q] = {1 - s, s};
        gauss_weights_[q] = rule.weights[q] * grid.h();
    }
}

std::vector<double> PlaneQ2::line_weights() const {
    std::vector<double> weights(size(), 0.0);
    for (std::size_t cell = 0; cell < grid_.cells; ++cell) {
        weights[2 * cell] += grid_.h() / 6;
        weights[2 * cell + 1] += 4 * grid_.h() / 6;
        weights[(2 * cell + 2) % size()] += grid_.h() / 6;
    }
    return weights;
}

PlaneQ2::Room PlaneQ2::make_room() const {
    const std::size_t n = unknowns();
    return {poisson_.make_room(), std::vector<double>(n), std::vector<double>(n)};
}

void PlaneQ2::positions(std::span<const double> phi, Points& x, Room& room) const {
    GASPARD_CHECK(phi.size() == unknowns());
    const std::size_t n = size(), v = grid_.vertices(), side = grid_.cells + 1;
    x.resize(mesh_->node_count());
    // One derivative per coordinate: along y, then (transposed) along x, then back.
    const auto project = [&](const LineMap& along_x, const LineMap& along_y, const std::vector<double>& xi,
                             std::vector<double>& coordinate) {
        along_y.apply(phi.data(), room.a.data(), n);
        transpose(room.a.data(), room.b.data(), v, n);
        along_x.apply(room.b.data(), room.a.data(), v);
        for (std::size_t j = 0; j < side; ++j)
            for (std::size_t i = 0; i < side; ++i)
                coordinate[j * side + i] = xi[j * side + i] + room.a[(i % v) * v + j % v];
    };
    project(slope_q1_, value_q1_, mesh_->nodes.x, x.x);
    project(value_q1_, slope_q1_, mesh_->nodes.y, x.y);
    std::fill(x.z.begin(), x.z.end(), 0.0);
}

void PlaneQ2::hessian(std::span<const double> phi, WeakHessian& sigma, Room& room) const {
    GASPARD_CHECK(phi.size() == unknowns());
    const std::size_t n = size();
    for (auto* component : {&sigma.xx, &sigma.yy, &sigma.xy}) component->resize(unknowns());
    second_.apply(phi.data(), sigma.yy.data(), n);
    transpose(phi.data(), room.a.data(), n, n);
    second_.apply(room.a.data(), room.b.data(), n);
    transpose(room.b.data(), sigma.xx.data(), n, n);
    first_.apply(room.a.data(), room.b.data(), n);
    transpose(room.b.data(), room.a.data(), n, n);
    first_.apply(room.a.data(), sigma.xy.data(), n);
    for (std::size_t i = 0; i < unknowns(); ++i) sigma.xx[i] = -sigma.xx[i], sigma.yy[i] = -sigma.yy[i];
}

void PlaneQ2::add_cell(std::size_t i, std::size_t j, std::span<const double> monitor,
                       const WeakHessian& sigma, std::span<double> r) const {
    const std::size_t n = size(), side = grid_.cells + 1;
    const std::size_t column[3] = {2 * i, 2 * i + 1, (2 * i + 2) % n};
    const std::size_t row[3] = {2 * j * n, (2 * j + 1) * n, ((2 * j + 2) % n) * n};

    // Values at the Gauss points [y][x], one direction after the other (sum factorisation).
    using Grid = double[gauss][gauss];
    const auto at_gauss = [&](const std::vector<double>& f, Grid& values) {
        double half[3][gauss];
        for (std::size_t b = 0; b < 3; ++b) {
            const double f0 = f[row[b] + column[0]], f1 = f[row[b] + column[1]], f2 = f[row[b] + column[2]];
            for (std::size_t p = 0; p < gauss; ++p)
                half[b][p] = q2_[p][0] * f0 + q2_[p][1] * f1 + q2_[p][2] * f2;
        }
        for (std::size_t q = 0; q < gauss; ++q)
            for (std::size_t p = 0; p < gauss; ++p)
                values[q][p] = q2_[q][0] * half[0][p] + q2_[q][1] * half[1][p] + q2_[q][2] * half[2][p];
    };
    Grid xx, yy, xy, f;
    at_gauss(sigma.xx, xx);
    at_gauss(sigma.yy, yy);
    at_gauss(sigma.xy, xy);
    const double* m = monitor.data() + j * side + i;
    for (std::size_t q = 0; q < gauss; ++q) {
        const double left = q1_[q][0] * m[0] + q1_[q][1] * m[side];
        const double right = q1_[q][0] * m[1] + q1_[q][1] * m[side + 1];
        for (std::size_t p = 0; p < gauss; ++p) {
            const double density = q1_[p][0] * left + q1_[p][1] * right;
            const double determinant = (1 + xx[q][p]) * (1 + yy[q][p]) - xy[q][p] * xy[q][p];
            f[q][p] = gauss_weights_[q] * gauss_weights_[p] * density * determinant;
        }
    }
    for (std::size_t a = 0; a < 3; ++a) {
        double half[gauss];
        for (std::size_t q = 0; q < gauss; ++q) {
            half[q] = 0;
            for (std::size_t p = 0; p < gauss; ++p) half[q] += q2_[p][a] * f[q][p];
        }
        for (std::size_t b = 0; b < 3; ++b) {
            double sum = 0;
            for (std::size_t q = 0; q < gauss; ++q) sum += q2_[q][b] * half[q];
            r[row[b] + column[a]] += sum;
        }
    }
}

PlaneQ2::Residual PlaneQ2::residual(std::span<const double> monitor, const WeakHessian& sigma,
                                    std::span<double> r) const {
    GASPARD_CHECK(monitor.size() == mesh_->node_count() && r.size() == unknowns());
    std::fill(r.begin(), r.end(), 0.0);
    for (std::size_t j = 0; j < grid_.cells; ++j)
        for (std::size_t i = 0; i < grid_.cells; ++i) add_cell(i, j, monitor, sigma, r);

    double theta = 0; // the functions v add up to 1 and the area is 1
    for (const double value : r) theta += value;
    double norm = 0, scale = 0;
    const std::size_t n = size();
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            const double weight = weights_[j] * weights_[i];
            double& entry = r[j * n + i];
            entry -= theta * weight;
            norm += entry * entry;
            scale += theta * weight * theta * weight;
        }
    return {theta, std::sqrt(norm / scale)};
}

void PlaneQ2::poisson(std::span<const double> r, std::span<double> u, Room& room) const {
    GASPARD_CHECK(r.size() == unknowns() && u.size() == unknowns());
    poisson_.solve(r.data(), u.data(), room.poisson);
}

void PlaneQ2::apply_mass(const double* f, double* b) const {
    const std::size_t n = size();
    const double unit = grid_.h() / 30;
    std::fill(b, b + unknowns(), 0.0);
    for (std::size_t cell = 0; cell < grid_.cells; ++cell) {
        const std::size_t left = 2 * cell * n, middle = left + n, right = (2 * cell + 2) % n * n;
        for (std::size_t c = 0; c < n; ++c) {
            const double f0 = f[left + c], f1 = f[middle + c], f2 = f[right + c];
            b[left + c] += unit * (4 * f0 + 2 * f1 - f2);
            b[middle + c] += unit * (2 * f0 + 16 * f1 + 2 * f2);
            b[right + c] += unit * (-f0 + 2 * f1 + 4 * f2);
        }
    }
}

std::vector<double> PlaneQ2::transfer(const LineGrid& from, std::span<const double> phi, Room& room) const {
    GASPARD_CHECK(from.periodic == grid_.periodic);
    const PlaneQ2 coarse(from);
    Room coarse_room = coarse.make_room();
    WeakHessian sigma;
    coarse.hessian(phi, sigma, coarse_room);

    // The Laplacian of phi, interpolated to this grid's Q2 nodes; its integrals against v are a load.
    const std::size_t n = size(), other = coarse.size();
    std::vector<double> values(unknowns()), load(unknowns());
    const auto locate = [&](std::size_t i) { // node i of this grid in the other's cells
        const double position = static_cast<double>(i) / (2.0 * static_cast<double>(grid_.cells)) *
                                static_cast<double>(from.cells);
        const double cell = std::min(std::floor(position), static_cast<double>(from.cells) - 1);
        return std::pair(static_cast<std::size_t>(cell), position - cell);
    };
    const auto shape = [](double s) {
        return std::array<double, 3>{(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)};
    };
    for (std::size_t j = 0; j < n; ++j) {
        const auto [cell_y, t] = locate(j);
        const auto weight_y = shape(t);
        for (std::size_t i = 0; i < n; ++i) {
            const auto [cell_x, s] = locate(i);
            const auto weight_x = shape(s);
            double laplacian = 0;
            for (std::size_t b = 0; b < 3; ++b)
                for (std::size_t a = 0; a < 3; ++a) {
                    const std::size_t k = (2 * cell_y + b) % other * other + (2 * cell_x + a) % other;
                    laplacian += weight_y[b] * weight_x[a] * (sigma.xx[k] + sigma.yy[k]);
                }
            values[j * n + i] = -laplacian;
        }
    }
    for (int direction = 0; direction < 2; ++direction) {
        apply_mass(values.data(), load.data());
        transpose(load.data(), values.data(), n, n);
    }
    std::vector<double> result(unknowns());
    poisson(values, result, room);
    return result;
}

} // namespace gaspard
