#include "core/fem/plane_q2.hpp"

#include "core/base/check.hpp"
#include "core/linear/reduce.hpp"
#include "core/linear/transpose.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {

constexpr std::size_t strip = 32; ///< number of lines that an operator processes at once, to stay in cache

} // namespace

PlaneQ2::PlaneQ2(LineGrid grid)
    : grid_(grid), mesh_(std::make_shared<Mesh>(unit_square_mesh(static_cast<int>(grid.cells)))),
      second_(grid, 2, Symmetry::even, {true, true, -1}), first_(grid, 2, Symmetry::odd, {false, true}),
      slope_q1_(grid, 1, Symmetry::odd, {false, true}), value_q1_(grid, 1, Symmetry::even, {false, false}),
      load_(grid), poisson_(LineSpectrum(grid.cells, grid.periodic)), weights_(line_weights()) {}

std::vector<double> PlaneQ2::line_weights() const {
    std::vector<double> weights(size(), 0.0);
    for (std::size_t cell = 0; cell < grid_.cells; ++cell) {
        weights[2 * cell] += grid_.h() / 6;
        weights[2 * cell + 1] += 4 * grid_.h() / 6;
        weights[(2 * cell + 2) % size()] += grid_.h() / 6;
    }
    return weights;
}

PlaneQ2::Workspace PlaneQ2::make_workspace(int threads) const {
    // Below this many rows of cells per thread, waking the thread costs more than it saves.
    constexpr std::size_t rows_per_thread = 120;
    const std::size_t most = std::max<std::size_t>(1, grid_.cells / rows_per_thread);
    const std::size_t workers =
        std::clamp<std::size_t>(static_cast<std::size_t>(std::max(1, threads)), 1, most);
    const std::vector<double> strip_values(strip * size()), plane(unknowns());
    return {.team = std::make_shared<Team>(workers),
            .workers = std::vector<Workspace::Worker>(workers, {strip_values, strip_values}),
            .load = std::vector<DeterminantLoad::Workspace>(workers, load_.make_workspace()),
            .poisson = poisson_.make_workspace(workers),
            .a = plane,
            .b = plane,
            .rows = std::vector<double>(size())};
}

void PlaneQ2::along_y(const LineMap& map, const double* in, double* out, std::size_t lines,
                      Workspace& workspace) const {
    workspace.team->share((lines + strip - 1) / strip, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t x = begin * strip; x < std::min(lines, end * strip); x += strip)
            map.apply(in + x, lines, out + x, lines, std::min(strip, lines - x));
    });
}

void PlaneQ2::along_x(const LineMap& map, const double* in, double* out, std::size_t lines,
                      Workspace& workspace) const {
    const std::size_t n = size(), rows = map.rows();
    workspace.team->share(
        (lines + strip - 1) / strip, [&](std::size_t worker, std::size_t begin, std::size_t end) {
            auto& turned = workspace.workers[worker];
            for (std::size_t y = begin * strip; y < std::min(lines, end * strip); y += strip) {
                const std::size_t width = std::min(strip, lines - y);
                transpose(in + y * n, n, turned.in.data(), strip, width, n);
                map.apply(turned.in.data(), strip, turned.out.data(), strip, width);
                transpose(turned.out.data(), strip, out + y * rows, rows, rows, width);
            }
        });
}

void PlaneQ2::positions(std::span<const double> phi, Points& x, Workspace& workspace) const {
    displacement(phi, x, workspace);
    for (std::size_t i = 0; i < x.size(); ++i) {
        x.x[i] += mesh_->nodes.x[i];
        x.y[i] += mesh_->nodes.y[i];
    }
}

void PlaneQ2::displacement(std::span<const double> phi, Points& d, Workspace& workspace) const {
    GASPARD_CHECK(phi.size() == unknowns());
    const std::size_t v = grid_.vertices(), side = grid_.cells + 1;
    d.resize(mesh_->node_count());
    const auto project = [&](const LineMap& to_x, const LineMap& to_y, std::vector<double>& coordinate) {
        along_y(to_y, phi.data(), workspace.a.data(), size(), workspace);
        along_x(to_x, workspace.a.data(), workspace.b.data(), v, workspace);
        for (std::size_t j = 0; j < side; ++j) {
            const double* shift = workspace.b.data() + j % v * v;
            std::copy_n(shift, v, coordinate.data() + j * side);
            if (v < side) coordinate[j * side + v] = shift[0];
        }
    };
    project(slope_q1_, value_q1_, d.x);
    project(value_q1_, slope_q1_, d.y);
    std::fill(d.z.begin(), d.z.end(), 0.0);
}

void PlaneQ2::hessian(std::span<const double> phi, WeakHessian& sigma, Workspace& workspace) const {
    GASPARD_CHECK(phi.size() == unknowns());
    const std::size_t n = size();
    for (auto* component : {&sigma.xx, &sigma.yy, &sigma.xy}) component->resize(unknowns());
    along_y(second_, phi.data(), sigma.yy.data(), n, workspace);
    along_x(second_, phi.data(), sigma.xx.data(), n, workspace);
    along_y(first_, phi.data(), workspace.a.data(), n, workspace);
    along_x(first_, workspace.a.data(), sigma.xy.data(), n, workspace);
}

PlaneQ2::Residual PlaneQ2::residual(std::span<const double> monitor, const WeakHessian& sigma,
                                    std::span<double> r, Workspace& workspace) const {
    GASPARD_CHECK(monitor.size() == mesh_->node_count() && r.size() == unknowns());
    load_.integrate(monitor, sigma, r, workspace.load, *workspace.team);
    return take_mean(r, workspace);
}

void PlaneQ2::residual_derivative(std::span<const double> monitor, const WeakHessian& sigma,
                                  std::span<const double> d_monitor, const WeakHessian& d_sigma,
                                  std::span<double> dr, Workspace& workspace) const {
    load_.differentiate(monitor, sigma, d_monitor, d_sigma, dr, workspace.load, *workspace.team);
    take_mean(dr, workspace);
}

// Turns r_v = <v, f> into <v, f - theta> with theta the mean of f. The order of summation does not depend on
// the number of workers.
PlaneQ2::Residual PlaneQ2::take_mean(std::span<double> r, Workspace& workspace) const {
    const auto row = [&](std::size_t j) { return r.subspan(j * size(), size()); };
    const auto sum_rows = [&](const auto& sum_row) {
        workspace.team->share(size(), [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t j = begin; j < end; ++j) workspace.rows[j] = sum_row(j);
        });
        return sum(workspace.rows);
    };
    // The functions v sum to 1, and the area is 1.
    const double theta = sum_rows([&](std::size_t j) { return sum(row(j)); });
    const double norm = sum_rows([&](std::size_t j) {
        double* __restrict values = row(j).data();
        const double factor = theta * weights_[j];
        for (std::size_t i = 0; i < size(); ++i) values[i] -= factor * weights_[i];
        return dot(row(j), row(j));
    });
    const double scale = std::abs(theta) * dot(weights_, weights_);
    return {theta, std::sqrt(norm) / scale};
}

void PlaneQ2::poisson(std::span<const double> r, std::span<double> u, Workspace& workspace) const {
    GASPARD_CHECK(r.size() == unknowns() && u.size() == unknowns());
    poisson_.solve(r.data(), u.data(), workspace.poisson, *workspace.team);
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

std::vector<double> PlaneQ2::transfer(const LineGrid& from, std::span<const double> phi,
                                      Workspace& workspace) const {
    const PlaneQ2 coarse(from);
    Workspace coarse_workspace = coarse.make_workspace();
    return transfer(coarse, phi, coarse_workspace, workspace);
}

std::vector<double> PlaneQ2::transfer(const PlaneQ2& coarse, std::span<const double> phi,
                                      Workspace& coarse_workspace, Workspace& workspace) const {
    const LineGrid& from = coarse.grid();
    GASPARD_CHECK(from.periodic == grid_.periodic);
    WeakHessian sigma;
    coarse.hessian(phi, sigma, coarse_workspace);

    // Interpolate the Laplacian of phi to the Q2 nodes of this grid, integrate it against v, solve (3.7).
    const std::size_t n = size(), other = coarse.size();
    std::vector<double> values(unknowns()), load(unknowns());
    const auto locate = [&](std::size_t i) { // cell and local coordinate of node i in the other grid
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
        transpose(load.data(), n, values.data(), n, n, n);
    }
    std::vector<double> result(unknowns());
    poisson(values, result, workspace);
    return result;
}

} // namespace gaspard
