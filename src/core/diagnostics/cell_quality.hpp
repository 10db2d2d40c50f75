// The shape of physical cells, from the positions of their nodes, and how it follows the monitor.
//
// The Jacobian matrix A of a cell is taken relative to the ideal cell, as Knupp (Algebraic mesh quality
// metrics, SIAM J. Sci. Comput. 23, 2001) does: A = [dx/ds, dx/dt, dx/du] W^-1, where the columns of W are
// the edges of the equilateral triangle, of the unit square or of the unit cube.
//
//   aspect ratio    largest / smallest singular value of A: 1 is ideal. A rectangle with sides a > b has
//                   a / b (Verdict's max_edge_ratio; its aspect_ratio is (a + b) / (2 b)), a square that is
//                   sheared by the angle p has sqrt((1 + sin p) / (1 - sin p)). No more than aspect_limit
//   skewness        max((largest - ideal) / (180° - ideal), (ideal - smallest) / ideal) of the angles between
//                   the edges at corners; ideal: 60° in triangles, 90° in quadrilaterals and in the faces of
//                   hexahedra. In [0, 1], 0 is ideal (Verdict's equiangle_skew)
//   orthogonality   non-orthogonality angle in degrees, as finite volume methods have it: between the line
//                   that joins the centres of two neighbours and the normal of their common side, the largest
//                   of the sides of the cell. In [0, 90], 0 is ideal; sides without a neighbour do not count
//   alignment       (p - q) / (p + q) with q = n·A Aᵀn, n = grad m / |grad m|, p = (tr(A Aᵀ) - q) / (d - 1):
//                   the squares of the sizes of the cell along grad m (q) and across it (p), each the mean
//                   over the cell with weight |grad m|². 1: thin along grad m, as a layer needs it;
//                   0: equally large along and across; -1: thin across it. 0 where m is constant. m is
//                   interpolated from the nodes
//
// Where they are taken: aspect ratio at the corners and at two Gauss points per direction, the largest;
// skewness between the tangents at the corners; alignment at the Gauss points; orthogonality from corners
// alone, with their mean as centre and straight sides. Corners and points at which the computational cell is
// degenerate (degenerate_measure in mesh/cell_measure.hpp) are left out.
//
// Triangles, quadrilaterals and hexahedra of any order, in the plane or in space. Cells that are lines have
// no shape.
#pragma once

#include "core/base/series.hpp"
#include "core/mesh/cell_measure.hpp"
#include "core/mesh/mesh.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace gaspard {

inline constexpr double aspect_limit = 1e6; ///< of flat and degenerate cells

/// One value per cell.
struct CellQuality {
    std::vector<double> aspect_ratio, skewness;
    std::vector<double> orthogonality; ///< degrees
    std::vector<double> alignment;     ///< empty without a monitor
};

struct QualityMeasureInfo {
    std::string_view name;  ///< "aspect_ratio"
    std::string_view label; ///< "Aspect ratio"
    std::string_view worst; ///< "max" or "min": which value is the worst
    std::vector<double> CellQuality::*values;
};
std::span<const QualityMeasureInfo> quality_measures();

/// Whether cells of this kind have a shape that can be measured.
bool has_quality(CellKind kind);

/// Measures meshes that have the same cells; knows their neighbours. The cells must have a shape.
class CellQualityMeter {
  public:
    explicit CellQualityMeter(std::shared_ptr<const Mesh> mesh);
    /// `monitor`: m at the nodes, in any unit; may be empty.
    CellQuality measure(const Points& x, std::span<const double> monitor) const;
    const std::shared_ptr<const Mesh>& mesh() const { return mesh_; }

  private:
    struct Sample { ///< a point of the reference cell with the gradients of the shape functions there
        Vec3 point;
        std::vector<Vec3> gradients;
        bool corner = false;
    };
    struct Side { ///< between two cells; seen from the first
        std::array<std::int32_t, 4> corners{};
        std::array<std::int32_t, 2> cells{};
    };

    void add_sample(Vec3 point, bool corner);
    void find_degenerate();
    void find_sides();
    void measure_shape(std::size_t cell, std::span<const Tangents> tangents, CellQuality& quality) const;
    double alignment(std::span<const Tangents> tangents, std::span<const double> monitor) const;
    void measure_sides(const Points& x, std::vector<double>& orthogonality) const;
    double angle(const Side& side, Vec3 between, const Points& x) const;

    std::shared_ptr<const Mesh> mesh_;
    int dimension_;
    std::vector<Sample> samples_;
    std::vector<std::uint32_t> degenerate_; ///< of every cell, one bit per sample
    std::vector<Side> sides_;
};

/// Worst and mean of every measure, as series of a run, and their values in the same order.
std::vector<SeriesInfo> cell_quality_series();
SeriesValues values_of(const CellQuality& quality);

} // namespace gaspard
