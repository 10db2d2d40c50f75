#include "core/diagnostics/flat_squares.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {

constexpr std::size_t batch = FlatSquares::batch;
using SquareLane = FlatSquares::Lane;

/// The corners of a batch of cells, in order around the cell.
struct Corners {
    std::array<SquareLane, 4> x, y;
};

// A short batch is filled up with its last cell.
Corners gather(const Mesh& mesh, std::size_t begin, std::size_t end, const Points& from) {
    Corners corners;
    for (std::size_t c = 0; c < batch; ++c) {
        const auto cell = mesh.cell(std::min(begin + c, end - 1));
        for (std::size_t k = 0; k < 4; ++k) {
            const auto node = static_cast<std::size_t>(cell[k]);
            corners.x[k][c] = from.x[node];
            corners.y[k][c] = from.y[node];
        }
    }
    return corners;
}

/// The Jacobian of every cell at corner k.
SquareLane jacobian(const Corners& at, std::size_t k) {
    const SquareLane &x = at.x[k], &y = at.y[k];
    const SquareLane &next_x = at.x[(k + 1) % 4], &next_y = at.y[(k + 1) % 4];
    const SquareLane &last_x = at.x[(k + 3) % 4], &last_y = at.y[(k + 3) % 4];
    SquareLane result;
    for (std::size_t c = 0; c < batch; ++c)
        result[c] = (next_x[c] - x[c]) * (last_y[c] - y[c]) - (next_y[c] - y[c]) * (last_x[c] - x[c]);
    return result;
}

// Minimum and maximum that return NaN if b is NaN.
double smaller(double a, double b) { return b < a || b != b ? b : a; }
double larger(double a, double b) { return b > a || b != b ? b : a; }

/// The coefficients of one coordinate of x = x0 + s a + t b + s t d.
struct Bilinear {
    SquareLane start, a, b, d;

    explicit Bilinear(const std::array<SquareLane, 4>& x) : start(x[0]), a(), b(), d() {
        for (std::size_t c = 0; c < batch; ++c) {
            a[c] = x[1][c] - x[0][c];
            b[c] = x[3][c] - x[0][c];
            d[c] = (x[2][c] - x[3][c]) - a[c];
        }
    }
    void at(double s, double t, double* __restrict out) const {
        for (std::size_t c = 0; c < batch; ++c) out[c] = start[c] + s * a[c] + t * (b[c] + s * d[c]);
    }
};

} // namespace

FlatSquares::Measured FlatSquares::measure(const Mesh& mesh, std::size_t begin, std::size_t end,
                                           const Points& x, const Monitor* monitor,
                                           Workspace& workspace) const {
    GASPARD_CHECK(begin < end && end - begin <= batch);
    const Corners physical = gather(mesh, begin, end, x), reference = gather(mesh, begin, end, mesh.nodes);
    Measured measured{};
    for (std::size_t k = 0; k < 4; ++k) {
        const SquareLane above = jacobian(physical, k), below = jacobian(reference, k);
        for (std::size_t c = 0; c < batch; ++c) {
            const double ratio = above[c] / below[c];
            measured.smallest[c] = k == 0 ? ratio : smaller(measured.smallest[c], ratio);
            measured.largest[c] = k == 0 ? ratio : larger(measured.largest[c], ratio);
        }
    }

    if (!monitor) return measured;
    const std::size_t n = rule_.points.size();
    workspace.points.resize(n * n * batch);
    workspace.monitor.resize(n * n * batch);
    const Bilinear px(physical.x), py(physical.y);
    for (std::size_t q = 0; q < n * n; ++q) {
        const double s = rule_.points[q % n], t = rule_.points[q / n];
        px.at(s, t, workspace.points.x.data() + q * batch);
        py.at(s, t, workspace.points.y.data() + q * batch);
    }
    monitor->values(workspace.points, workspace.monitor);
    SquareLane j0, js, jt;
    for (std::size_t c = 0; c < batch; ++c) {
        j0[c] = px.a[c] * py.b[c] - py.a[c] * px.b[c];
        js[c] = px.a[c] * py.d[c] - py.a[c] * px.d[c];
        jt[c] = px.d[c] * py.b[c] - py.d[c] * px.b[c];
    }
    for (std::size_t q = 0; q < n * n; ++q) {
        const double s = rule_.points[q % n], t = rule_.points[q / n];
        const double weight = rule_.weights[q % n] * rule_.weights[q / n];
        const double* m = workspace.monitor.data() + q * batch;
        for (std::size_t c = 0; c < batch; ++c)
            measured.mass[c] += weight * (j0[c] + s * js[c] + t * jt[c]) * m[c];
    }
    return measured;
}

} // namespace gaspard
