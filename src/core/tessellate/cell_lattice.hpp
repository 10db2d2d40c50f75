// Shown points in the cells of a solid: every cell is divided into m^3 parts, whose corners are the points
// (i, j, k), 0 <= i, j, k <= m, of its lattice. Cells that share a corner, an edge or a face share its
// points. Further points divide the line between two of them.
#pragma once

#include "core/tessellate/key_table.hpp"
#include "core/tessellate/solid_faces.hpp"
#include "core/tessellate/tessellation.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace gaspard {

using LatticePlace = std::array<int, 3>;

/// What depends on the kind of cells and m alone.
class LatticeTable {
  public:
    LatticeTable() = default;
    LatticeTable(CellKind kind, int pieces);

    struct Weight {
        std::uint32_t local = 0; ///< node of the cell
        double weight = 0;
    };
    CellKind kind() const { return kind_; }
    int pieces() const { return pieces_; }
    std::size_t size() const { return weights_.size(); }
    std::size_t index(const LatticePlace& p) const {
        const int row = pieces_ + 1;
        return static_cast<std::size_t>((p[2] * row + p[1]) * row + p[0]);
    }
    const std::vector<Weight>& weights(std::size_t index) const { return weights_[index]; }
    /// A place on face `face` of the cell, s along its first side and t along its last.
    LatticePlace on_face(int face, int s, int t) const;
    /// The reverse.
    std::array<int, 2> in_face(int face, const LatticePlace& p) const;
    /// `step` of m from local corner a to local corner b.
    LatticePlace on_edge(int a, int b, int step) const;
    /// Bit f is set if the place lies on face f.
    std::uint32_t faces_of(const LatticePlace& p) const;

  private:
    struct Frame {
        LatticePlace origin{}, along{}, across{}; ///< in units of the cell
    };
    CellKind kind_;
    int pieces_ = 0;
    std::vector<std::vector<Weight>> weights_;
    std::array<Frame, 6> frames_{};
};

/// The points of one section, made on first use.
class LatticePoints {
  public:
    /// Cells are shrunk towards the mean of their corners by the part `shrink` of their size; if it is not 0
    /// they share no points. The arguments must outlive it.
    LatticePoints(const Mesh& mesh, const SolidFaces& faces, const LatticeTable& table, const Points& x,
                  double shrink);

    void begin_cell(std::uint32_t cell);
    std::uint32_t at(const LatticePlace& place); ///< of that cell
    /// (1 - t) a + t b, the same point whenever it is asked for with this label (below 16).
    std::uint32_t between(std::uint32_t a, std::uint32_t b, double t, std::uint32_t label);
    Vec3 place(std::uint32_t point) const { return places_[point]; }
    /// Of a point of the lattice: an order of all of them that depends on the mesh and m alone.
    std::uint64_t rank(std::uint32_t point) const { return ranks_[point]; }
    std::size_t size() const { return places_.size(); }
    const LatticeTable& table() const { return table_; }
    /// Moves the points into a tessellation; nothing can be asked for afterwards.
    void move_into(Tessellation& out);

  private:
    std::uint32_t make(const LatticePlace& place, std::uint64_t rank);
    std::uint64_t key_of(const LatticePlace& place) const;
    std::uint64_t edge_key(const LatticePlace& place) const;
    std::uint64_t face_key(const LatticePlace& place) const;
    std::uint32_t node(std::uint32_t local) const {
        return static_cast<std::uint32_t>(mesh_.cells[cell_ * nodes_each_ + local]);
    }

    const Mesh& mesh_;
    const SolidFaces& faces_;
    const LatticeTable& table_;
    const Points& x_;
    double shrink_;
    std::size_t nodes_each_;
    std::size_t cell_ = 0xffffffff;
    std::vector<std::uint32_t> own_;     ///< points of the present cell
    std::vector<std::uint32_t> corners_; ///< points of nodes that are corners
    KeyTable inner_, cuts_;              ///< on edges and faces; between points
    std::vector<Vec3> places_;
    std::vector<std::uint64_t> ranks_;
    std::vector<std::uint32_t> starts_{0}, nodes_;
    std::vector<double> weights_;
};

} // namespace gaspard
