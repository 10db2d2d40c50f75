// Nested dissection of finite elements by the places of their cells: an order of elimination with little
// fill.
//
// The cells are cut in halves of equal size, again and again. The unknowns on a cut are eliminated after all
// others of both halves; George (1973). A tree follows: every part of it eliminates some unknowns, which are
// then coupled with the part's `border`, unknowns of the parts above it.
#pragma once

#include "core/base/points.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace gaspard {

/// Which unknowns belong to which cell: `per_cell` numbers for every cell.
struct CellUnknowns {
    std::size_t count = 0; ///< of all unknowns
    std::size_t per_cell = 0;
    std::vector<std::int32_t> numbers;

    std::size_t cells() const { return numbers.size() / per_cell; }
    std::span<const std::int32_t> of(std::size_t cell) const {
        return {numbers.data() + cell * per_cell, per_cell};
    }
};

struct Dissection {
    struct Part {
        std::int32_t begin = 0, end = 0;     ///< the unknowns that it eliminates, in order of elimination
        std::int32_t children[2] = {-1, -1}; ///< parts; -1 where there is none
        std::int32_t cells_begin = 0, cells_end = 0; ///< of `cells`; of parts without children
        std::vector<std::int32_t> border;            ///< in order of elimination, ascending
    };
    std::vector<std::int32_t> place; ///< of every unknown: when it is eliminated
    std::vector<std::int32_t> cells; ///< an order of the cells in which neighbours stand together
    std::vector<Part> parts;         ///< children before parents
};

/// `middles`: a place for every cell. Deterministic.
Dissection dissect(const CellUnknowns& unknowns, const Points& middles);

} // namespace gaspard
