// Quality of a physical mesh, computed from its cells and the monitor alone.
//
//   M_i = (integral of m over physical cell i) / (measure of computational cell i)         McRae et al. (5.2)
//
//   equidistribution = standard deviation of the M_i / mean of the M_i
//
//   Jacobian = det dx/dxi of the map from computational to physical cell, at sample points, corners included
//
// A cell is tangled if its Jacobian is <= 0 or NaN at any sample point. Points at which the computational
// cell is degenerate (degenerate_measure in mesh/cell_measure.hpp) are left out. Of a computational
// cell without size nothing can be measured: it counts neither for mean and standard deviation nor for the
// Jacobians of the mesh, and gets the mean as M_i and the Jacobian 1. If all cells are such, the
// equidistribution is NaN, which series leave out.
#pragma once

#include "core/base/series.hpp"
#include "core/base/team.hpp"
#include "core/diagnostics/flat_squares.hpp"
#include "core/diagnostics/sphere_cells.hpp"
#include "core/mesh/cell_measure.hpp"
#include "core/mesh/tensor_cell.hpp"
#include "core/monitor/monitor.hpp"

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
    std::vector<double> cell_jacobian; ///< minimum Jacobian over the sample points of each cell
};

/// The series of a run that describe its quality, and their values in the same order.
std::vector<SeriesInfo> quality_series();
SeriesValues values_of(const MeshQuality& quality);

/// Beside these, for a map that is known everywhere: how many cells of the mesh fold.
SeriesInfo folded_drawn_cells_series();

/// Measures a mesh. Holds the reference quadrature, the measures of the computational cells, a workspace and
/// the threads.
///
/// Sign of the Jacobian on lines and surfaces in space: negative where the physical cell faces away from the
/// computational cell; on a sphere, where cells move far, negative where the cell faces inward. Reversed
/// parts contribute negatively to M_i, so that the sum of the M_i is conserved.
class QualityMeter {
  public:
    /// `points`: Gauss points per direction for the integral of m; at least the order of the cells is used.
    /// With 6, the relative error of the ring's equidistribution is 3e-7 at n = 30 and 1e-8 from n = 60 on.
    /// Runs take 4 for solids, whose points are many. `threads` share the cells; the result does not depend
    /// on their number.
    explicit QualityMeter(std::shared_ptr<const Mesh> mesh, int threads = 1, int points = 6,
                          const Space& space = {});
    /// The returned reference is valid until the next call.
    const MeshQuality& measure(const Points& x, const Monitor& monitor) { return measure(x, &monitor); }
    /// Only Jacobians and tangled cells, which are those of measure(); the rest is empty or NaN.
    const MeshQuality& measure_geometry(const Points& x) { return measure(x, nullptr); }
    /// The result of the last measurement.
    const MeshQuality& quality() const { return quality_; }
    /// CPU time of the last measurement on threads other than the caller's.
    double other_cpu_seconds() const { return other_cpu_seconds_; }

  private:
    struct Sample { ///< a point of the reference cell with the shape functions there
        std::vector<double> values;
        std::vector<Vec3> gradients;
        double weight = 0; ///< quadrature weight; 0 at points where only the Jacobian is checked
    };

    void add_sample(Vec3 point, double weight);
    /// The samples of a cell, at xi or at x.
    void find_places(std::span<const Vec3> nodes, std::vector<PlaceInCell>& places,
                     TensorCell::Workspace& workspace) const;
    void gather(std::size_t cell, const Points& x, std::span<Vec3> nodes) const;
    Tangents tangents(std::span<const Vec3> nodes, const Sample& sample) const;
    double signed_measure(const Tangents& of, const Tangents& reference) const;
    /// The workspace and the results of one thread.
    struct Worker {
        std::vector<Vec3> nodes, reference_nodes; ///< x and xi of one cell
        Points points;                            ///< quadrature points of a batch of cells
        std::vector<double> factor, monitor;
        std::vector<PlaceInCell> places, reference_places; ///< of the samples of one cell
        TensorCell::Workspace tensor;
        FlatSquares::Workspace flat;
        SphereCellMeter::Workspace sphere;
        double min_jacobian = 0, max_jacobian = 0;
        std::size_t tangled_cells = 0;
    };
    /// In these functions, `monitor` may be null; then the masses are not computed.
    const MeshQuality& measure(const Points& x, const Monitor* monitor);
    void measure_cells(std::size_t begin, std::size_t end, const Points& x, const Monitor* monitor,
                       Worker& worker);
    /// Measures the cells in batches with a FlatSquares or SphereCellMeter.
    template <class Meter>
    void measure_many(const Meter& meter, typename Meter::Workspace& workspace, std::size_t begin,
                      std::size_t end, const Points& x, const Monitor* monitor, Worker& worker);
    void note_cell(std::size_t cell, double smallest, double largest, Worker& worker);
    void measure_batch(std::size_t begin, std::size_t end, const Points& x, const Monitor* monitor,
                       Worker& worker);

    std::shared_ptr<const Mesh> mesh_;
    int dimension_;
    std::optional<FlatSquares> flat_; ///< if all cells are such
    std::optional<SphereCellMeter> sphere_;
    std::optional<TensorCell> quadrature_cell_,
        node_cell_; ///< of quadrilaterals of high order, and of hexahedra
    std::vector<Sample> samples_;
    std::size_t quadrature_points_ = 0;  ///< number of quadrature points, the first samples
    std::vector<double> cell_measure_;   ///< of the computational cells
    std::vector<std::size_t> pointlike_; ///< cells whose measure is zero
    std::vector<Worker> workers_;
    Team team_;
    MeshQuality quality_;
    double other_cpu_seconds_ = 0;
};

} // namespace gaspard
