#include "core/linear/tensor_poisson.hpp"

#include "core/linear/transpose.hpp"

namespace gaspard {

TensorPoisson::TensorPoisson(LineSpectrum line) : line_(std::move(line)) {}

TensorPoisson::Room TensorPoisson::make_room() const {
    const std::size_t n = line_.size() * line_.size();
    return {line_.make_room(), std::vector<double>(n), std::vector<double>(n)};
}

void TensorPoisson::solve(const double* b, double* u, Room& room) const {
    const std::size_t n = line_.size();
    const auto& lambda = line_.eigenvalues();
    double* first = room.first.data();
    double* second = room.second.data();
    for (std::size_t r = 0; r < n; ++r) line_.analyse(b + r * n, first + r * n, room.line);
    transpose(first, second, n, n);
    for (std::size_t r = 0; r < n; ++r) {
        double* row = second + r * n;
        line_.analyse(row, row, room.line);
        for (std::size_t c = 0; c < n; ++c) row[c] = r + c == 0 ? 0.0 : row[c] / (lambda[r] + lambda[c]);
        line_.synthesise(row, row, room.line);
    }
    transpose(second, first, n, n);
    for (std::size_t r = 0; r < n; ++r) line_.synthesise(first + r * n, u + r * n, room.line);
}

} // namespace gaspard
