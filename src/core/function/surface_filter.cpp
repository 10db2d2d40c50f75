#include "core/function/surface_filter.hpp"

#include "core/base/error.hpp"
#include "core/linear/batch_fft.hpp"
#include "core/linear/cell_cholesky.hpp"
#include "core/linear/tridiagonal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace gaspard {

namespace {

constexpr std::size_t fft_lanes = BatchFft::lanes;

class SphereFilter final : public SurfaceFilter {
  public:
    SphereFilter(const Grid& grid, double length)
        : longitudes_(grid.directions[0].count), latitudes_(grid.directions[1].count),
          waves_(longitudes_ / 2 + 1), fft_(longitudes_) {
        std::array<Points, 3> tangents;
        Points one(1);
        grid.chart->tangents(one, tangents);
        const double radius = norm(tangents[1][0]) * 180 / std::numbers::pi;
        const double strength = (length / radius) * (length / radius);
        for (std::size_t m = 0; m < waves_; ++m) solvers_.push_back(system(m, strength));
    }

    void apply(std::span<double> values, const std::stop_token& stop) override {
        std::vector<double> data(2 * longitudes_ * fft_lanes), scratch(data.size());
        std::vector<double> waves(latitudes_ * waves_ *
                                  2); // by latitude, wave number, real and imaginary part
        for (std::size_t j = 0; j < latitudes_; j += fft_lanes)
            transform(values, waves, j, true, data, scratch);
        for (std::size_t m = 0; m < waves_; ++m) {
            if (stop.stop_requested()) throw Interrupted();
            solve(waves, m);
        }
        for (std::size_t j = 0; j < latitudes_; j += fft_lanes)
            transform(values, waves, j, false, data, scratch);
    }

  private:
    double step() const { return std::numbers::pi / static_cast<double>(latitudes_ - 1); }
    double latitude(double j) const { return j * step() - std::numbers::pi / 2; }
    double area(std::size_t j) const { // of the volume, for a radian of longitude on the unit sphere
        const double at = static_cast<double>(j), last = static_cast<double>(latitudes_ - 1);
        return std::sin(latitude(std::min(at + 0.5, last))) - std::sin(latitude(std::max(at - 0.5, 0.0)));
    }
    /// Wave 0: all rows; other waves are zero at the poles.
    TridiagonalSolver system(std::size_t m, double strength) const {
        const double turn = 2 * std::numbers::pi / static_cast<double>(longitudes_);
        const double square = (2 - 2 * std::cos(static_cast<double>(m) * turn)) / (turn * turn);
        std::vector<double> diagonal(latitudes_), off(latitudes_ - 1);
        for (std::size_t j = 0; j < latitudes_; ++j) {
            diagonal[j] = area(j);
            if (m > 0 && j > 0 && j + 1 < latitudes_)
                diagonal[j] += strength * square * step() / std::cos(latitude(static_cast<double>(j)));
        }
        for (std::size_t j = 0; j + 1 < latitudes_; ++j) {
            const double flux = strength * std::cos(latitude(static_cast<double>(j) + 0.5)) / step();
            diagonal[j] += flux, diagonal[j + 1] += flux, off[j] = -flux;
        }
        if (m > 0) {
            diagonal = {diagonal.begin() + 1, diagonal.end() - 1};
            off = {off.begin() + 1, off.end() - 1};
        }
        return {std::move(diagonal), std::move(off), false};
    }
    void solve(std::vector<double>& waves, std::size_t m) const {
        const std::size_t stride = 2 * waves_, first = m > 0 ? 1 : 0;
        for (std::size_t j = 0; j < latitudes_; ++j) {
            double* at = waves.data() + j * stride + 2 * m;
            const bool none = m > 0 && (j == 0 || j + 1 == latitudes_);
            for (int part = 0; part < 2; ++part) at[part] *= none ? 0.0 : area(j);
        }
        solvers_[m].solve(waves.data() + first * stride + 2 * m, 2, stride);
    }
    /// Eight latitudes from j on.
    void transform(std::span<double> values, std::vector<double>& waves, std::size_t j, bool forward,
                   std::vector<double>& data, std::vector<double>& scratch) const {
        const std::size_t rows = std::min(fft_lanes, latitudes_ - j);
        std::fill(data.begin(), data.end(), 0.0);
        const auto wave = [&](std::size_t l, std::size_t m) {
            return waves.data() + ((j + l) * waves_ + m) * 2;
        };
        if (forward)
            for (std::size_t i = 0; i < longitudes_; ++i)
                for (std::size_t l = 0; l < rows; ++l)
                    data[2 * i * fft_lanes + l] = values[(j + l) * longitudes_ + i];
        else
            for (std::size_t i = 0; i < longitudes_; ++i)
                for (std::size_t l = 0; l < rows; ++l) {
                    const bool conjugate = i >= waves_;
                    const double* from = wave(l, conjugate ? longitudes_ - i : i);
                    data[2 * i * fft_lanes + l] = from[0];
                    data[(2 * i + 1) * fft_lanes + l] = conjugate ? -from[1] : from[1];
                }
        const double* y =
            forward ? fft_.forward(data.data(), scratch.data()) : fft_.backward(data.data(), scratch.data());
        for (std::size_t l = 0; l < rows; ++l)
            if (forward)
                for (std::size_t m = 0; m < waves_; ++m) {
                    wave(l, m)[0] = y[2 * m * fft_lanes + l];
                    wave(l, m)[1] = y[(2 * m + 1) * fft_lanes + l];
                }
            else
                for (std::size_t i = 0; i < longitudes_; ++i)
                    values[(j + l) * longitudes_ + i] =
                        y[2 * i * fft_lanes + l] / static_cast<double>(longitudes_);
    }

    std::size_t longitudes_, latitudes_, waves_;
    BatchFft fft_;
    std::vector<TridiagonalSolver> solvers_;
};

/// The cells between the points of a grid in two directions; numbers of their corners 00, 10, 01, 11.
struct GridCells {
    std::size_t across, up;
    CellUnknowns corners;
    Points middles; ///< coordinates

    explicit GridCells(const Grid& grid)
        : across(cells(grid.directions[0])),
          up(cells(grid.directions[1])), corners{.count = grid.size(), .per_cell = 4, .numbers = {}},
          middles(across * up) {
        const std::size_t nx = grid.directions[0].count, ny = grid.directions[1].count;
        for (std::size_t j = 0; j < up; ++j)
            for (std::size_t i = 0; i < across; ++i) {
                for (const auto& [di, dj] : {std::pair{0u, 0u}, {1u, 0u}, {0u, 1u}, {1u, 1u}})
                    corners.numbers.push_back(static_cast<std::int32_t>((j + dj) % ny * nx + (i + di) % nx));
                middles.set(j * across + i, {grid.coordinate(0, i) + grid.spacing(0) / 2,
                                             grid.coordinate(1, j) + grid.spacing(1) / 2, 0});
            }
    }

  private:
    static std::size_t cells(const GridDirection& direction) {
        return direction.ends == GridEnds::periodic ? direction.count : direction.count - 1;
    }
};

class PatchFilter final : public SurfaceFilter {
  public:
    PatchFilter(const Grid& grid, double length, const Progress& progress, const std::stop_token& stop)
        : measures_(measures(grid)) {
        const GridCells cells(grid);
        std::vector<double> shares(grid.size(), 0.0); // of a point's measure, for each of its cells
        for (const std::int32_t corner : cells.corners.numbers) shares[static_cast<std::size_t>(corner)] += 1;
        for (std::size_t i = 0; i < shares.size(); ++i) shares[i] = measures_[i] / shares[i];
        std::array<Points, 3> t;
        grid.chart->tangents(cells.middles, t);
        const double strength = length * length, du = grid.spacing(0), dv = grid.spacing(1);
        const auto dissection = std::make_shared<const Dissection>(dissect(cells.corners, cells.middles));
        permutation_ = dissection->permutation;
        const auto matrix = [&](std::size_t cell, std::span<double> a) {
            fill(t[0][cell], t[1][cell], strength, du, dv, a);
            for (std::size_t k = 0; k < 4; ++k)
                a[5 * k] += shares[static_cast<std::size_t>(cells.corners.of(cell)[k])];
        };
        const auto advance = [&](double done) {
            if (progress) progress(done, "Factorising the filter");
        };
        cholesky_ = std::make_unique<CellCholesky>(cells.corners, dissection, matrix, advance, stop);
    }

    void apply(std::span<double> values, const std::stop_token& stop) override {
        if (stop.stop_requested()) throw Interrupted();
        std::vector<double> b(values.size());
        for (std::size_t i = 0; i < b.size(); ++i)
            b[static_cast<std::size_t>(permutation_[i])] = measures_[i] * values[i];
        cholesky_->solve<1>(b);
        for (std::size_t i = 0; i < b.size(); ++i) values[i] = b[static_cast<std::size_t>(permutation_[i])];
    }

  private:
    /// strength times the integral of grad phi . grad psi over a cell with these tangents.
    static void fill(Vec3 u, Vec3 v, double strength, double du, double dv, std::span<double> a) {
        const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
        const double root = std::max(norm(cross(u, v)), std::numeric_limits<double>::min());
        const double along = strength * vv / root * dv / du / 2, up = strength * uu / root * du / dv / 2;
        const double mixed = -strength * uv / root / 4;
        std::fill(a.begin(), a.end(), 0.0);
        const auto edge = [&](std::size_t p, std::size_t q, double weight) {
            a[5 * p] += weight, a[5 * q] += weight, a[4 * p + q] -= weight, a[4 * q + p] -= weight;
        };
        edge(0, 1, along), edge(2, 3, along), edge(0, 2, up), edge(1, 3, up);
        constexpr double by_u[4] = {-1, 1, -1, 1}, by_v[4] = {-1, -1, 1, 1};
        for (std::size_t p = 0; p < 4; ++p)
            for (std::size_t q = 0; q < 4; ++q)
                a[4 * p + q] += mixed * (by_u[p] * by_v[q] + by_v[p] * by_u[q]);
    }

    std::vector<double> measures_;
    std::vector<std::int32_t> permutation_;
    std::unique_ptr<CellCholesky> cholesky_;
};

} // namespace

std::unique_ptr<SurfaceFilter> sphere_filter(const Grid& grid, double length) {
    return std::make_unique<SphereFilter>(grid, length);
}

std::unique_ptr<SurfaceFilter> patch_filter(const Grid& grid, double length, const Progress& progress,
                                            const std::stop_token& stop) {
    return std::make_unique<PatchFilter>(grid, length, progress, stop);
}

} // namespace gaspard
