// What is hidden of a mesh of solid cells, so that one can look inside; as the section "view" says it.
//
//   cut, cut_cells   planes (core/tessellate/cut_planes.hpp); cells are cut, or shown as a whole where their
//                    middle is on the side that stays
//   peel             so many layers of cells, counted from the boundary, face by face
//   layers           of a mesh whose cells are a lattice, the only layers shown: "i 4 to 11; k 0". Cell
//                    (i, j, k) of n_i n_j n_k cells has the number (k n_j + j) n_i + i
//   only             cells with these values: "jacobian < 0.5", "monitor > 2 and area < 1e-3"
//   explode          cells are shrunk towards their middles by this part of their size
#pragma once

#include "core/base/parameter.hpp"
#include "core/tessellate/cut_planes.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct Mesh;

/// The first and the last layer of one direction.
struct LayerRange {
    std::uint32_t first = 0, last = 0xffffffff;
    friend bool operator==(const LayerRange&, const LayerRange&) = default;
};

enum class Relation { below, at_most, above, at_least };

/// A condition on a cell's value; of values at nodes the mean over its corners counts.
struct CellCondition {
    std::string of; ///< as in view.color; "value" is what the colours show
    Relation relation = Relation::below;
    double bound = 0;
    /// False for what is not a number.
    bool holds(double value) const;
    friend bool operator==(const CellCondition&, const CellCondition&) = default;
};

struct InsideChoice {
    std::vector<CutWedge> cut{};
    bool whole_cells = false;
    std::uint32_t peel = 0;
    std::array<LayerRange, 3> layers{};
    std::vector<CellCondition> only{}; ///< all of them
    double explode = 0;

    /// Whether anything differs from the mesh as it is seen from outside.
    bool looks_inside() const { return *this != InsideChoice{.whole_cells = whole_cells}; }
    friend bool operator==(const InsideChoice&, const InsideChoice&) = default;
};

/// The keys of the section "view" that it is read from.
const std::vector<std::string>& inside_keys();

/// `view`: values of view_rows(). Throws InputError with one sentence if a text cannot be read.
InsideChoice inside_choice(const Values& view);
/// Throws InputError if the mesh has not the layers that the choice names.
void check_layers(const InsideChoice& choice, const Mesh& mesh);

} // namespace gaspard
