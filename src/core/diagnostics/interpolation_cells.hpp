// The cells of one mesh, as interpolation_error.cpp integrates over them: places in parts of a cell, with Iu
// and the Jacobian there, and sums over such parts. Equations are in interpolation_error.hpp.
#pragma once

#include "core/fem/cell_quadrature.hpp"
#include "core/function/scalar_function.hpp"
#include "core/mesh/cell_measure.hpp"
#include "core/mesh/space.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gaspard {

/// The points origin + size p of a reference cell, p a point of the reference cell; `size` is negative for
/// the middle quarter of a triangle.
struct CellPart {
    std::uint32_t cell = 0; ///< in the batch
    int halvings = 0;
    std::size_t known = 0; ///< 1 + its place among the halves of a whole cell; 0: the whole cell
    Vec3 origin{};
    double size = 1;
};

/// Sums over a part.
struct ErrorSums {
    double square = 0; ///< integral of e^2
    double slope = 0;  ///< integral of |grad e|^2
    double measure = 0;
    double maximum = 0; ///< of |e| over the points

    void add(const ErrorSums& other);
};

class InterpolationCells {
  public:
    InterpolationCells(const Mesh& mesh, const Points& x, const Space& space, const ScalarFunction& u);

    /// A batch of cells, and the arrays of one thread.
    struct Batch {
        std::size_t begin = 0, end = 0;
        std::vector<Vec3> nodes;      ///< of the geometry, per cell
        std::vector<double> corners;  ///< u at the corners of each cell
        std::vector<Tangents> facing; ///< at the middle of each cell
        std::vector<double> sign;     ///< of the Jacobian where the cell is not reversed
        std::vector<char> tangled;    ///< per cell
        Points points, gradients;     ///< of many parts
        std::vector<double> values, interpolated, weight;
        std::vector<Tangents> tangents;
        std::vector<Vec3> slopes; ///< d(Iu)/d(s, t, u)
    };
    void begin(std::size_t from, std::size_t to, Batch& batch) const;
    /// One entry of `sums` per part. Marks cells that fold.
    void integrate(std::span<const CellPart> parts, Batch& batch, std::vector<ErrorSums>& sums) const;
    struct Peak {
        double whole = 0, half = 0; ///< with the grid, with every other of its points
    };
    /// The largest |e| of each cell on a grid of its points. Marks cells that fold at a corner.
    void peaks(Batch& batch, std::span<Peak> peaks) const;
    /// Appends the halves of a part.
    void halve(const CellPart& part, std::vector<CellPart>& halves) const;
    int dimension() const { return dimension_; }

  private:
    /// The shape functions at a point of the reference cell.
    struct Shape {
        std::vector<double> values, corner_values;
        std::vector<Vec3> gradients, corner_gradients;
    };
    struct Place {
        Vec3 x;
        Tangents tangents{};
        double jacobian = 0;
    };
    Shape shape_at(Vec3 point) const;
    void set_shape(Vec3 point, Shape& shape) const;
    Place place(const Batch& batch, std::size_t cell, const Shape& shape) const;
    Place flat_or_curved(std::span<const Vec3> nodes, const Shape& shape) const;
    double signed_jacobian(const Batch& batch, std::size_t cell, const Place& place) const;
    void note(Batch& batch, std::size_t slot, std::size_t cell, const Shape& shape, const Place& place,
              double weight) const;
    ErrorSums sum(const Batch& batch, std::size_t begin, std::size_t end) const;
    double peak(const Batch& batch, std::size_t cell, int stride) const;
    void evaluate(const Points& points, std::vector<double>& values) const;

    const Mesh& mesh_;
    const Points& x_;
    const ScalarFunction& u_;
    CellKind straight_, kind_; ///< kind_: of the geometry
    int dimension_;
    bool flat_;         ///< the cells are as many-dimensional as the space
    double radius_ = 0; ///< of the sphere; 0: there is none
    std::vector<CellPoint> rule_;
    std::vector<CellPart> halves_;           ///< of the whole cell
    std::vector<std::vector<Shape>> shapes_; ///< at the points of the whole cell, and of its halves
    std::vector<Shape> grid_, corner_;
    std::vector<std::array<int, 3>> grid_places_;
    std::vector<int> grid_of_; ///< the place of a grid point in grid_, by its indices; -1: there is none
    Shape middle_;
};

} // namespace gaspard
