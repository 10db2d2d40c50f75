// Triangular solves, which dominate the cost of an iteration on a surface. Border rows are processed four at
// a time, so that each load of the part's own unknowns serves four rows.
#include "core/base/check.hpp"
#include "core/linear/cell_cholesky.hpp"

namespace gaspard {

namespace {

constexpr std::size_t rows_at_once = 4;

/// One row of the right-hand sides, kept in registers.
template <int columns>
struct Row {
    double of[columns];

    void load(const double* from) {
        for (int c = 0; c < columns; ++c) of[c] = from[c];
    }
    void store(double* to) const {
        for (int c = 0; c < columns; ++c) to[c] = of[c];
    }
    void subtract(double factor, const double* __restrict row) {
        for (int c = 0; c < columns; ++c) of[c] -= factor * row[c];
    }
    void scale(double factor) {
        for (int c = 0; c < columns; ++c) of[c] *= factor;
    }
};

/// Forward and backward substitution with one part's block; `x` are the rows of its own unknowns in b.
template <int columns>
struct Block {
    std::size_t own, border;
    const double* values;
    const std::int32_t* places;
    double* b;
    double* x;

    double* row(std::size_t i) const { return b + static_cast<std::size_t>(places[i]) * columns; }
    const double* below() const { return values + own * (own + 1) / 2; }

    void forward() const {
        const double* l = values;
        for (std::size_t i = 0; i < own; ++i) {
            Row<columns> sum;
            sum.load(x + i * columns);
            for (std::size_t j = 0; j < i; ++j) sum.subtract(*l++, x + j * columns);
            sum.scale(*l++);
            sum.store(x + i * columns);
        }
        std::size_t i = 0;
        for (; i + rows_at_once <= border; i += rows_at_once) forward_rows<rows_at_once>(i);
        for (; i < border; ++i) forward_rows<1>(i);
    }

    template <std::size_t rows>
    void forward_rows(std::size_t first) const {
        const double* l = below() + first * own;
        Row<columns> sum[rows];
        for (std::size_t r = 0; r < rows; ++r) sum[r].load(row(first + r));
        for (std::size_t j = 0; j < own; ++j)
            for (std::size_t r = 0; r < rows; ++r) sum[r].subtract(l[r * own + j], x + j * columns);
        for (std::size_t r = 0; r < rows; ++r) sum[r].store(row(first + r));
    }

    void backward() const {
        std::size_t i = 0;
        for (; i + rows_at_once <= border; i += rows_at_once) backward_rows<rows_at_once>(i);
        for (; i < border; ++i) backward_rows<1>(i);
        for (std::size_t j = own; j-- > 0;) { // by columns of L, the rows of its transpose
            const double* l = values + j * (j + 1) / 2;
            Row<columns> sum;
            sum.load(x + j * columns);
            sum.scale(l[j]);
            sum.store(x + j * columns);
            for (std::size_t k = 0; k < j; ++k)
                for (int c = 0; c < columns; ++c)
                    x[k * columns + static_cast<std::size_t>(c)] -= l[k] * sum.of[c];
        }
    }

    template <std::size_t rows>
    void backward_rows(std::size_t first) const {
        const double* l = below() + first * own;
        Row<columns> given[rows];
        for (std::size_t r = 0; r < rows; ++r) given[r].load(row(first + r));
        for (std::size_t j = 0; j < own; ++j) {
            Row<columns> sum;
            sum.load(x + j * columns);
            for (std::size_t r = 0; r < rows; ++r) sum.subtract(l[r * own + j], given[r].of);
            sum.store(x + j * columns);
        }
    }
};

} // namespace

template <int columns>
void CellCholesky::solve(std::span<double> b) const {
    GASPARD_CHECK(b.size() == size_ * columns);
    const auto block = [&](const Part& part) {
        return Block<columns>{static_cast<std::size_t>(part.own),
                              static_cast<std::size_t>(part.border),
                              values_.data() + part.values,
                              indices_.data() + part.indices,
                              b.data(),
                              b.data() + static_cast<std::size_t>(part.begin) * columns};
    };
    for (auto part = parts_.begin(); part != parts_.end(); ++part) block(*part).forward();
    for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) block(*part).backward();
}

template void CellCholesky::solve<1>(std::span<double>) const;
template void CellCholesky::solve<4>(std::span<double>) const;
template void CellCholesky::solve<12>(std::span<double>) const;

} // namespace gaspard
