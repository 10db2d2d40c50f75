// Reference: the equation on the sphere with dense matrices and 3 x 3 tensors, point by point, written
// from the formulas alone. SurfaceQ2 is compared with it.
#pragma once

#include "core/fem/slow_plane.hpp"
#include "core/fem/surface_q2.hpp"

namespace gaspard::slow {

class Surface {
  public:
    using Tensor = Eigen::Matrix3d;
    using Point = Eigen::Vector3d;

    /// Quadratic functions on a mesh of order 2 with facets of the given order; every node is an unknown.
    Surface(const SurfaceMesh& surface, int geometry_order, bool flat = false,
            std::vector<std::int32_t> unknowns = {});

    Eigen::Index size() const { return size_; }
    const Eigen::MatrixXd& mass() const { return mass_; }
    const Eigen::MatrixXd& stiffness() const { return stiffness_; }
    const Vector& weights() const { return weights_; }

    /// (4.9): nine functions, by rows.
    Eigen::MatrixXd sigma(const Vector& phi) const;

    /// <v, m det A> for the monitor's values at the nodes of the facets, or at the vertices only.
    Vector determinant_load(const Vector& phi, std::span<const double> monitor, bool at_vertices) const;

    /// (4.10): the projection of grad phi to the facets' space, at its nodes.
    Eigen::MatrixXd projected_gradient(const Vector& phi) const;

    static Point exponential(const Point& xi, const Point& g);

  private:
    struct At { ///< a quadrature point
        std::size_t cell;
        Point xi;
        double area;
        std::vector<Eigen::Index> number;
        std::vector<double> value, facet, corner;
        std::vector<Point> grad;
    };

    template <class Use>
    void each(const Use& use) const;
    Point gradient(const At& at, const Vector& phi) const;
    Point moved(const At& at, const Vector& phi) const;

    Mesh mesh_, facets_;
    bool flat_;
    std::vector<std::int32_t> unknowns_;
    Eigen::Index size_ = 0;
    Eigen::MatrixXd mass_, stiffness_;
    Vector weights_;
};

} // namespace gaspard::slow
