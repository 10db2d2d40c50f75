#include "core/linear/tridiagonal.hpp"

#include "core/base/check.hpp"

#include <cmath>

namespace gaspard {

namespace {

void subtract(double* __restrict to, const double* from, double factor, std::size_t columns) {
    for (std::size_t c = 0; c < columns; ++c) to[c] -= factor * from[c];
}

} // namespace

TridiagonalSolver::TridiagonalSolver(std::vector<double> diagonal, std::vector<double> off, bool closed)
    : n_(diagonal.size()), open_(closed ? n_ - 1 : n_), off_(std::move(off)) {
    GASPARD_CHECK(closed ? (n_ >= 3 && off_.size() == n_) : (n_ >= 1 && off_.size() + 1 == n_));
    inverse_pivot_.resize(open_);
    lower_.resize(open_);
    for (std::size_t i = 0; i < open_; ++i) {
        lower_[i] = i > 0 ? off_[i - 1] * inverse_pivot_[i - 1] : 0.0;
        const double pivot = diagonal[i] - (i > 0 ? lower_[i] * off_[i - 1] : 0.0);
        GASPARD_CHECK(pivot > 0);
        inverse_pivot_[i] = 1 / pivot;
    }
    if (!closed) return;
    first_ = off_[n_ - 1];
    last_ = off_[n_ - 2];
    const std::size_t open = open_;
    n_ = open; // solve the open part for the border column
    border_.assign(open, 0.0);
    border_.front() += first_;
    border_.back() += last_;
    std::vector<double> column = border_;
    solve(column.data(), 1, 1);
    border_ = column;
    // The solution decays away from the border; entries below rounding error are skipped.
    constexpr double negligible = 1e-19;
    while (front_ < open && std::abs(border_[front_]) > negligible) ++front_;
    for (back_ = open; back_ > front_ && std::abs(border_[back_ - 1]) > negligible;) --back_;
    n_ = open + 1;
    const double pivot = diagonal.back() - first_ * border_.front() - last_ * border_.back();
    GASPARD_CHECK(pivot > 0);
    border_pivot_ = 1 / pivot;
}

void TridiagonalSolver::solve(double* b, std::size_t columns, std::size_t stride) const {
    for (std::size_t i = 1; i < open_; ++i)
        subtract(b + i * stride, b + (i - 1) * stride, lower_[i], columns);
    for (std::size_t i = open_; i-- > 0;) {
        double* __restrict row = b + i * stride;
        const double* next = b + (i + 1) * stride;
        const double own = inverse_pivot_[i], other = i + 1 < open_ ? off_[i] * own : 0.0;
        if (i + 1 < open_)
            for (std::size_t c = 0; c < columns; ++c) row[c] = own * row[c] - other * next[c];
        else
            for (std::size_t c = 0; c < columns; ++c) row[c] *= own;
    }
    if (n_ == open_) return;
    double* bordered = b + open_ * stride;
    const double* front = b;
    const double* back = b + (open_ - 1) * stride;
    for (std::size_t c = 0; c < columns; ++c)
        bordered[c] = (bordered[c] - first_ * front[c] - last_ * back[c]) * border_pivot_;
    for (std::size_t i = 0; i < front_; ++i) subtract(b + i * stride, bordered, border_[i], columns);
    for (std::size_t i = back_; i < open_; ++i) subtract(b + i * stride, bordered, border_[i], columns);
}

} // namespace gaspard
