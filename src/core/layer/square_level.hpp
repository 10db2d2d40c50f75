// One resolution of a mesh PDE on quadrilaterals (square_mesh_pde.hpp): the iterate, the mean densities of
// the four triangles of every quadrilateral, and the systems of the two coordinates.
#pragma once

#include "core/layer/density_samples.hpp"
#include "core/layer/square_mesh_pde.hpp"
#include "core/linear/cell_lu.hpp"
#include "core/linear/nine_point.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>

namespace gaspard {

class SquareLevel {
  public:
    using Index = std::size_t;

    SquareLevel(int n, MeshPdeForm form, DensitySamples samples, const std::array<Vec3, 4>& corners);

    int n() const { return n_; }
    const Points& nodes() const { return nodes_; }
    const Points& centres() const { return centres_; }
    void set_positions(Points nodes, Points centres);

    /// Whether a coordinate of a node (axis 0: x) stays as it is.
    bool is_fixed(Index axis, int i, int j) const;
    /// Takes away the rounding of coordinates that stay. Throws InputError if they are others.
    void restore_fixed(Points& nodes) const;

    /// A mesh of twice as many cells with the same iterate, which is linear on its triangles.
    SquareLevel refined() const;
    SquareMeshSolve solve(const LayerDensities& densities);
    SquareMeshSolve solve(TriangleDensities means);
    SquareMeshNewton newton(const LayerDensities& densities, const std::stop_token& stop);

  private:
    struct Residual; // square_newton.cpp
    Residual residual() const;
    double move(const Points& nodes, const Points& centres, const std::vector<double>& step, double factor);
    void newton_matrix(Index quad, const Residual& r, const DensitySampler::Derivatives& derivatives,
                       const std::vector<double>& shift, std::span<double> matrix) const;
    std::vector<double> newton_direction(const Residual& r, const DensitySampler::Derivatives& derivatives,
                                         const std::vector<double>& shift, const std::stop_token& stop);
    struct Elimination {
        CellUnknowns unknowns;
        Dissection dissection;
    };
    const Elimination& elimination();
    std::vector<double> areas() const;
    std::vector<double> distances_to_inversion(const std::vector<double>& areas) const;
    double rounding(const std::vector<double>& distances) const;
    bool falls_below(double norm, const LayerDensities& densities);
    Index unknown(Index axis, Index point) const;
    std::array<Index, 5> quad_points(Index quad) const;
    std::array<Index, 3> triangle_points(Index triangle) const;
    double quads_at(Index point) const;
    /// Stiffness matrices of the triangles of a quadrilateral, for a density of 1.
    using QuadStiffness = std::array<std::array<std::array<double, 3>, 3>, 4>;
    QuadStiffness stiffness(int i, int j) const;
    std::vector<Index> axes() const;
    double coordinate(Index axis, Index point) const;
    bool is_fixed_point(Index axis, Index point) const;

    Index node(int i, int j) const {
        return static_cast<Index>(j) * static_cast<Index>(n_ + 1) + static_cast<Index>(i);
    }
    Index quad(int i, int j) const {
        return static_cast<Index>(j) * static_cast<Index>(n_) + static_cast<Index>(i);
    }
    Index node_count() const { return static_cast<Index>(n_ + 1) * static_cast<Index>(n_ + 1); }
    Index quad_count() const { return static_cast<Index>(n_) * static_cast<Index>(n_); }
    /// The point (s, t) of the unit square in the computational domain.
    Vec3 computational(double s, double t) const;
    std::array<Vec3, 5> computational_corners(int i, int j) const;
    std::array<Vec3, 5> corners_of(int i, int j) const;
    /// The iterate at a point of the computational quadrilateral (i, j), linear on each triangle.
    Vec3 at(int i, int j, Vec3 xi) const;
    std::vector<std::uint8_t> fixed_nodes(Index axis) const;
    SquareMeshSolve solve(); ///< with means_

    static std::array<std::array<double, 5>, 5> matrix(const QuadStiffness& stiffness, const double* means);
    void eliminate_centres(Index axis, std::span<CornerMatrix> matrices);
    /// The largest change.
    double restore_centres(const std::vector<double>& u, std::vector<double>& c) const;

    int n_;
    MeshPdeForm form_;
    DensitySamples samples_;
    std::array<Vec3, 4> domain_; ///< corners of the computational domain
    Points nodes_, centres_;
    DensitySampler sampler_;
    TriangleDensities means_;
    std::vector<std::array<double, 4>> centre_weights_; ///< of the last axis
    NinePointSolver solver_;     ///< of both axes, one after the other: memory costs time
    std::vector<double> before_; ///< a coordinate before the last solve; kept for the same reason
    std::shared_ptr<const Elimination> elimination_; ///< of newton(); null before
    static constexpr double newtons_time_step = 1e8; ///< from where steps are Newton's
    double time_step_ = newtons_time_step;           ///< of the next newton()
};

} // namespace gaspard
