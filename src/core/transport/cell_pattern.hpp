// Sparse matrices whose entries couple the unknowns of a cell, several with the same pattern side by side:
//
//   y_i = sum_j sum_c A^c_ij x^c_j,    y^c_i = sum_j A^c_ij x_j
//
// so that one pass over the rows applies all of them.
#pragma once

#include "core/linear/dissection.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gaspard {

class CellPattern {
  public:
    explicit CellPattern(const CellUnknowns& unknowns);

    std::size_t rows() const { return starts_.size() - 1; }
    std::size_t entries() const { return columns_.size(); }
    /// The places of a cell's matrix, by rows.
    std::span<const std::uint32_t> slots(std::size_t cell) const {
        return {slots_.data() + cell * per_cell_ * per_cell_, per_cell_ * per_cell_};
    }

    /// y = sum_c A^c x^c. `values`: `count` numbers per entry; `x`: `count` numbers per unknown.
    template <std::size_t count>
    void sum(std::span<const double> values, std::span<const double> x, std::span<double> y) const;
    /// y^c = A^c x. `values`: `count` numbers per entry; `y`: `count` numbers per unknown.
    template <std::size_t count>
    void each(std::span<const double> values, std::span<const double> x, std::span<double> y) const;

  private:
    std::size_t per_cell_;
    std::vector<std::uint32_t> starts_;
    std::vector<std::int32_t> columns_;
    std::vector<std::uint32_t> slots_;
};

template <std::size_t count>
void CellPattern::sum(std::span<const double> values, std::span<const double> x, std::span<double> y) const {
    for (std::size_t i = 0; i < rows(); ++i) {
        double sum = 0;
        for (std::size_t e = starts_[i]; e < starts_[i + 1]; ++e) {
            const double* a = values.data() + count * e;
            const double* of = x.data() + count * static_cast<std::size_t>(columns_[e]);
            for (std::size_t c = 0; c < count; ++c) sum += a[c] * of[c];
        }
        y[i] = sum;
    }
}

template <std::size_t count>
void CellPattern::each(std::span<const double> values, std::span<const double> x, std::span<double> y) const {
    for (std::size_t i = 0; i < rows(); ++i) {
        std::array<double, count> sum{};
        for (std::size_t e = starts_[i]; e < starts_[i + 1]; ++e) {
            const double* a = values.data() + count * e;
            const double of = x[static_cast<std::size_t>(columns_[e])];
            for (std::size_t c = 0; c < count; ++c) sum[c] += a[c] * of;
        }
        for (std::size_t c = 0; c < count; ++c) y[count * i + c] = sum[c];
    }
}

} // namespace gaspard
