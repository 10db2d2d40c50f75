// Geometric nested dissection of finite element unknowns (George, 1973): an elimination order with little
// fill-in.
//
// The cells are bisected recursively into halves of equal size. The unknowns shared by both halves form the
// separator and are eliminated after all others of the two halves. This gives a binary tree of parts; each
// eliminates its own unknowns, which are then coupled with its `border`: unknowns of separators above it.
#pragma once

#include "core/base/points.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace gaspard {

/// The unknowns of each cell: `per_cell` indices per cell.
struct CellUnknowns {
    std::size_t count = 0; ///< number of unknowns
    std::size_t per_cell = 0;
    std::vector<std::int32_t> numbers;

    std::size_t cells() const { return numbers.size() / per_cell; }
    std::span<const std::int32_t> of(std::size_t cell) const {
        return {numbers.data() + cell * per_cell, per_cell};
    }
};

struct Dissection {
    struct Part {
        std::int32_t begin = 0, end = 0;             ///< its unknowns, as a range of the elimination order
        std::int32_t children[2] = {-1, -1};         ///< indices of parts; -1 if none
        std::int32_t cells_begin = 0, cells_end = 0; ///< range of `cells`; leaves only
        std::vector<std::int32_t> border;            ///< positions in the elimination order, ascending
    };
    std::vector<std::int32_t> permutation; ///< position of each unknown in the elimination order
    std::vector<std::int32_t> cells;       ///< the cells, ordered so that those of a part are contiguous
    std::vector<Part> parts;               ///< children before parents
};

/// `middles`: a point in each cell. Deterministic.
Dissection dissect(const CellUnknowns& unknowns, const Points& middles);

} // namespace gaspard
