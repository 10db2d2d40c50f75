// How good a physical mesh is, from its cells and the monitor alone, whatever method moved it.
//
//   M_i = (integral of m over physical cell i) / (measure of computational cell i)         McRae et al. (5.2)
//   equidistribution = standard deviation of the M_i / mean of the M_i
//   Jacobian = det dx/dxi of the map from computational to physical cell, at sampled points, corners included
//   A cell is tangled if its Jacobian is <= 0, or not a number, at any sampled point.
#pragma once

#include "core/base/series.hpp"
#include "core/diagnostics/flat_squares.hpp"
#include "core/diagnostics/sphere_cells.hpp"
#include "core/mesh/mesh.hpp"
#include "core/monitor/monitor.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gaspard {

struct MeshQuality {
    double equidistribution = 0;
    double min_jacobian = 0;
    double max_jacobian = 0;
    std::size_t tangled_cells = 0;
    std::vector<double> cell_mass;     ///< M_i
    std::vector<double> cell_jacobian; ///< smallest Jacobian over the sampled points, per cell
};

/// What a run reports of it, and the values in the same order.
std::vector<SeriesInfo> quality_series();
SeriesValues values_of(const MeshQuality& quality);

/// Measures a mesh; holds the reference quadrature and the computational measures, and room to work in.
/// Of a line or surface in space the Jacobian is negative where the physical cell faces away from the
/// computational one; on a sphere, where cells travel far, it is negative where the cell faces inward. What
/// is turned over counts negative in M_i, so that their sum remains.
class QualityMeter {
  public:
    /// `points` Gauss points per direction for the integral of m: with 6 the equidistribution of
    /// the ring is right to 3e-7 of its value at n = 30 and to 1e-8 from n = 60 on.
    /// `threads` share the cells; the result does not depend on how many.
    explicit QualityMeter(std::shared_ptr<const Mesh> mesh, int threads = 1, int points = 6,
                          const Space& space = {});
    /// The reference is valid until the next call.
    const MeshQuality& measure(const Points& x, const Monitor& monitor);
    /// What was measured last.
    const MeshQuality& quality() const { return quality_; }
    /// CPU time of the last measurement on threads other than the caller's.
    double other_cpu_seconds() const { return other_cpu_seconds_; }

  private:
    struct Sample { ///< a point of the reference cell, with the shape functions there
        std::vector<double> values;
        std::vector<Vec3> gradients;
        double weight = 0; ///< of the quadrature; 0 at points that only look at the sign of the Jacobian
    };
    using Tangents = std::array<Vec3, 3>;

    void add_sample(Vec3 point, double weight);
    void gather(std::size_t cell, const Points& x, std::span<Vec3> nodes) const;
    Tangents tangents(std::span<const Vec3> nodes, const Sample& sample) const;
    double signed_measure(const Tangents& of, const Tangents& reference) const;
    /// What one thread works in, and what it finds.
    struct Worker {
        std::vector<Vec3> nodes, reference_nodes; ///< of one cell: x and xi
        Points points;                            ///< quadrature points of a batch of cells
        std::vector<double> factor, monitor;
        FlatSquares::Workspace flat;
        SphereCellMeter::Workspace sphere;
        double min_jacobian = 0, max_jacobian = 0;
        std::size_t tangled_cells = 0;
    };
    void measure_cells(std::size_t begin, std::size_t end, const Points& x, const Monitor& monitor,
                       Worker& worker);
    /// By a meter that takes many cells at once, of one kind.
    template <class Meter>
    void measure_many(const Meter& meter, typename Meter::Workspace& workspace, std::size_t begin,
                      std::size_t end, const Points& x, const Monitor& monitor, Worker& worker);
    void note_cell(std::size_t cell, double smallest, double largest, Worker& worker);
    void measure_batch(std::size_t begin, std::size_t end, const Points& x, const Monitor& monitor,
                       Worker& worker);

    std::shared_ptr<const Mesh> mesh_;
    int dimension_;
    std::optional<FlatSquares> flat_; ///< where all cells are such
    std::optional<SphereCellMeter> sphere_;
    std::vector<Sample> samples_;
    std::size_t quadrature_points_ = 0; ///< the first samples are those of the quadrature
    std::vector<double> cell_measure_;  ///< of the computational cells
    std::vector<Worker> workers_;
    MeshQuality quality_;
    double other_cpu_seconds_ = 0;
};

} // namespace gaspard
