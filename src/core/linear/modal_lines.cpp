#include "core/linear/modal_lines.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

/// A range of columns of the right-hand side, with its workspace.
struct ModalLines::Block {
    double* b; ///< first row, first column
    std::size_t stride, begin, columns;
    double *sum, *power;

    double* vertex(std::size_t c) const { return b + 2 * c * stride; }
    double* middle(std::size_t c) const { return b + (2 * c + 1) * stride; }
};

ModalLines::ModalLines(std::size_t cells, bool periodic, const std::vector<double>& lambdas)
    : cells_(cells), periodic_(periodic) {
    GASPARD_CHECK(cells >= 2);
    const double h = 1.0 / static_cast<double>(cells);
    const double ring = static_cast<double>(periodic ? cells : 2 * cells);
    for (const double lambda : lambdas) {
        // Cell matrices: stiffness [7 -8 1; -8 16 -8; 1 -8 7] / (3 h), mass [4 2 -1; 2 16 2; -1 2 4] h / 30.
        const double k = 1 / (3 * h), m = lambda * h / 30;
        const double vertex = 7 * k + 4 * m, other = k - m, between = -8 * k + 2 * m, middle = 16 * (k + m);
        const double off = other - between * between / middle;
        const double diagonal = 2 * (vertex - between * between / middle);
        // diagonal + 2 off, without the cancellation of the stiffness terms.
        const double sum = 2 * m * (8 * k * 30 + m * (3 * 16 - 2 * 4)) / middle;
        const double root = std::sqrt(sum * (diagonal - 2 * off));
        const double g = (diagonal + root) / 2;
        const double rho = lambda > 0 ? -off / g : 0.0;
        coupling_.push_back(between / middle);
        middle_.push_back(1 / middle);
        scale_.push_back(1 / g);
        rho_.push_back(rho);
        closure_.push_back(1 / (1 - std::pow(rho, ring)));
        end_.push_back(1 / (1 - rho * rho));
    }
}

// Right-hand side of the Schur complement for the vertices, divided by g.
void ModalLines::eliminate_middles(const Block& block) const {
    const double* coupling = coupling_.data() + block.begin;
    const double* scale = scale_.data() + block.begin;
    for (std::size_t c = 0; c <= cells_ - (periodic_ ? 1 : 0); ++c) {
        const bool first = !periodic_ && c == 0, last = !periodic_ && c == cells_;
        const double* left = block.middle(last || c > 0 ? c - 1 : cells_ - 1);
        const double* right = block.middle(last ? c - 1 : c);
        if (first) left = right;
        // At an end, the even extension doubles the vertex and mirrors the midpoint.
        const double whole = first || last ? 2.0 : 1.0;
        double* __restrict v = block.vertex(c);
        for (std::size_t l = 0; l < block.columns; ++l)
            v[l] = (whole * v[l] - coupling[l] * (left[l] + right[l])) * scale[l];
    }
}

void ModalLines::restore_middles(const Block& block) const {
    const double* coupling = coupling_.data() + block.begin;
    const double* own = middle_.data() + block.begin;
    for (std::size_t c = 0; c < cells_; ++c) {
        double* __restrict m = block.middle(c);
        const double* left = block.vertex(c);
        const double* right = block.vertex(periodic_ && c + 1 == cells_ ? 0 : c + 1);
        for (std::size_t l = 0; l < block.columns; ++l)
            m[l] = m[l] * own[l] - coupling[l] * (left[l] + right[l]);
    }
}

void ModalLines::solve_ring(const Block& block) const {
    const double* rho = rho_.data() + block.begin;
    const double* closure = closure_.data() + block.begin;
    double* __restrict sum = block.sum;
    double* __restrict power = block.power;
    const std::size_t columns = block.columns;
    // y_(n-1): geometric sum over the whole ring.
    std::fill(sum, sum + columns, 0.0);
    for (std::size_t c = 0; c < cells_; ++c) {
        const double* v = block.vertex(c);
        for (std::size_t l = 0; l < columns; ++l) sum[l] = sum[l] * rho[l] + v[l];
    }
    for (std::size_t l = 0; l < columns; ++l) power[l] = sum[l] * closure[l];
    // y_c = b_c + rho y_(c-1), and the sum of rho^c y_c
    {
        double* __restrict v = block.vertex(0);
        for (std::size_t l = 0; l < columns; ++l) {
            v[l] += rho[l] * power[l];
            sum[l] = v[l];
            power[l] = rho[l];
        }
    }
    for (std::size_t c = 1; c < cells_; ++c) {
        const double* before = block.vertex(c - 1);
        double* __restrict v = block.vertex(c);
        for (std::size_t l = 0; l < columns; ++l) {
            v[l] += rho[l] * before[l];
            sum[l] += power[l] * v[l];
            power[l] *= rho[l];
        }
    }
    // u_(n-1) in the same manner, then u_c = y_c + rho u_(c+1)
    double* __restrict last = block.vertex(cells_ - 1);
    for (std::size_t l = 0; l < columns; ++l) last[l] += rho[l] * sum[l] * closure[l];
    for (std::size_t c = cells_ - 1; c-- > 0;) {
        const double* after = block.vertex(c + 1);
        double* __restrict v = block.vertex(c);
        for (std::size_t l = 0; l < columns; ++l) v[l] += rho[l] * after[l];
    }
}

void ModalLines::solve_line(const Block& block) const {
    const double* rho = rho_.data() + block.begin;
    const double* closure = closure_.data() + block.begin;
    const double* end = end_.data() + block.begin;
    double* __restrict sum = block.sum;
    const std::size_t columns = block.columns;
    // y_0: geometric sum over the ring of 2 n cells of which this line is half, from the far end backward.
    std::fill(sum, sum + columns, 0.0);
    for (std::size_t k = 1; k < 2 * cells_; ++k) {
        const double* v = block.vertex(k <= cells_ ? k : 2 * cells_ - k);
        for (std::size_t l = 0; l < columns; ++l) sum[l] = sum[l] * rho[l] + v[l];
    }
    {
        double* __restrict v = block.vertex(0);
        for (std::size_t l = 0; l < columns; ++l) v[l] = (sum[l] * rho[l] + v[l]) * closure[l];
    }
    for (std::size_t c = 1; c <= cells_; ++c) {
        const double* before = block.vertex(c - 1);
        double* __restrict v = block.vertex(c);
        for (std::size_t l = 0; l < columns; ++l) v[l] += rho[l] * before[l];
    }
    // u is even about vertex n: (1 - rho^2) u_n = y_n + rho y_(n-1)
    {
        const double* before = block.vertex(cells_ - 1);
        double* __restrict v = block.vertex(cells_);
        for (std::size_t l = 0; l < columns; ++l) v[l] = (v[l] + rho[l] * before[l]) * end[l];
    }
    for (std::size_t c = cells_; c-- > 0;) {
        const double* after = block.vertex(c + 1);
        double* __restrict v = block.vertex(c);
        for (std::size_t l = 0; l < columns; ++l) v[l] += rho[l] * after[l];
    }
}

void ModalLines::solve(double* b, std::size_t stride, std::size_t begin, std::size_t end,
                       Workspace& workspace) const {
    GASPARD_CHECK(begin <= end && end <= rho_.size());
    for (; begin < end; begin += width) {
        const Block block{b + begin,
                          stride,
                          begin,
                          std::min(width, end - begin),
                          workspace.sum.data(),
                          workspace.power.data()};
        eliminate_middles(block);
        periodic_ ? solve_ring(block) : solve_line(block);
        restore_middles(block);
    }
}

} // namespace gaspard
