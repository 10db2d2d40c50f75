#include "core/fem/slow_surface.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace gaspard::slow {

template <class Use>
void Surface::each(const Use& use) const {
    const auto shapes = [](CellKind kind, Vec3 at, std::vector<double>& values, std::vector<Vec3>& slopes) {
        values.resize(static_cast<std::size_t>(nodes_per_cell(kind)));
        slopes.resize(values.size());
        shape_functions(kind, at, values, slopes);
    };
    std::vector<Vec3> slopes, facet_slopes, corner_slopes;
    At at;
    for (at.cell = 0; at.cell < mesh_.cell_count(); ++at.cell)
        for (const auto& [point, weight] : quadrature_of_degree_8(mesh_.kind.shape)) {
            shapes(mesh_.kind, point, at.value, slopes);
            shapes(facets_.kind, point, at.facet, facet_slopes);
            shapes({mesh_.kind.shape, 1}, point, at.corner, corner_slopes);
            Eigen::Matrix<double, 3, 2> tangents = Eigen::Matrix<double, 3, 2>::Zero();
            at.xi.setZero();
            for (std::size_t n = 0; n < at.facet.size(); ++n) {
                const Vec3 p = facets_.nodes[static_cast<std::size_t>(facets_.cell(at.cell)[n])];
                const Point node(p.x, p.y, p.z);
                at.xi += at.facet[n] * node;
                tangents.col(0) += facet_slopes[n].x * node;
                tangents.col(1) += facet_slopes[n].y * node;
            }
            const Eigen::Matrix2d metric = tangents.transpose() * tangents;
            at.area = weight * std::sqrt(metric.determinant());
            const Eigen::Matrix<double, 3, 2> dual = tangents * metric.inverse();
            at.grad.clear();
            at.number.clear();
            for (std::size_t n = 0; n < at.value.size(); ++n) {
                at.grad.push_back(dual * Eigen::Vector2d(slopes[n].x, slopes[n].y));
                at.number.push_back(unknowns_[static_cast<std::size_t>(mesh_.cell(at.cell)[n])]);
            }
            use(at);
        }
}

Surface::Surface(const SurfaceMesh& surface, int geometry_order, bool flat,
                 std::vector<std::int32_t> unknowns)
    : mesh_(surface.quadratic), facets_(geometry_order == 2 ? surface.quadratic : straightened(surface)),
      flat_(flat), unknowns_(std::move(unknowns)) {
    if (unknowns_.empty())
        for (std::size_t i = 0; i < mesh_.node_count(); ++i)
            unknowns_.push_back(static_cast<std::int32_t>(i));
    size_ = 1 + *std::max_element(unknowns_.begin(), unknowns_.end());
    mass_ = Eigen::MatrixXd::Zero(size_, size_);
    stiffness_ = mass_;
    weights_ = Vector::Zero(size_);
    each([&](const At& at) {
        for (std::size_t a = 0; a < at.value.size(); ++a)
            for (std::size_t b = 0; b < at.value.size(); ++b) {
                mass_(at.number[a], at.number[b]) += at.area * at.value[a] * at.value[b];
                stiffness_(at.number[a], at.number[b]) += at.area * at.grad[a].dot(at.grad[b]);
            }
        for (std::size_t a = 0; a < at.value.size(); ++a) weights_[at.number[a]] += at.area * at.value[a];
    });
}

Eigen::MatrixXd Surface::sigma(const Vector& phi) const {
    Eigen::MatrixXd load = Eigen::MatrixXd::Zero(size_, 9);
    each([&](const At& at) {
        const Point e = moved(at, phi);
        for (std::size_t a = 0; a < at.value.size(); ++a)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) load(at.number[a], 3 * i + j) -= at.area * at.grad[a][j] * e[i];
    });
    return slow::solve(mass_, load);
}

Vector Surface::determinant_load(const Vector& phi, std::span<const double> monitor, bool at_vertices) const {
    const Eigen::MatrixXd s = sigma(phi);
    Vector r = Vector::Zero(size_);
    each([&](const At& at) {
        Tensor a = Tensor::Zero();
        for (std::size_t n = 0; n < at.value.size(); ++n)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) a(i, j) += at.value[n] * s(at.number[n], 3 * i + j);
        if (flat_) {
            a += Tensor::Identity();
        } else {
            const Point k = at.xi.normalized();
            a = (a * (Tensor::Identity() - k * k.transpose()) + moved(at, phi) * k.transpose()).eval();
        }
        const auto& shapes = at_vertices ? at.corner : at.facet;
        double m = 0;
        for (std::size_t n = 0; n < shapes.size(); ++n)
            m += shapes[n] * monitor[static_cast<std::size_t>(facets_.cell(at.cell)[n])];
        for (std::size_t n = 0; n < at.value.size(); ++n)
            r[at.number[n]] += at.area * at.value[n] * m * a.determinant();
    });
    return r;
}

Eigen::MatrixXd Surface::projected_gradient(const Vector& phi) const {
    Eigen::Index size = 0;
    for (std::size_t i = 0; i < facets_.node_count(); ++i)
        size = std::max<Eigen::Index>(size, unknowns_[i] + 1);
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(size, size), load = Eigen::MatrixXd::Zero(size, 3);
    each([&](const At& at) {
        const auto number = [&](std::size_t n) {
            return unknowns_[static_cast<std::size_t>(facets_.cell(at.cell)[n])];
        };
        const Point g = gradient(at, phi);
        for (std::size_t a = 0; a < at.facet.size(); ++a) {
            for (std::size_t b = 0; b < at.facet.size(); ++b)
                mass(number(a), number(b)) += at.area * at.facet[a] * at.facet[b];
            load.row(number(a)) += at.area * at.facet[a] * g.transpose();
        }
    });
    const Eigen::MatrixXd w = slow::solve(mass, load);
    Eigen::MatrixXd at_nodes(facets_.node_count(), 3);
    for (std::size_t i = 0; i < facets_.node_count(); ++i)
        at_nodes.row(static_cast<Eigen::Index>(i)) = w.row(unknowns_[i]);
    return at_nodes;
}

Surface::Point Surface::exponential(const Point& xi, const Point& g) {
    const double length = g.norm();
    if (length == 0) return xi;
    return std::cos(length) * xi + std::sin(length) / length * g;
}

Surface::Point Surface::gradient(const At& at, const Vector& phi) const {
    Point g = Point::Zero();
    for (std::size_t n = 0; n < at.grad.size(); ++n) g += phi[at.number[n]] * at.grad[n];
    return g;
}

Surface::Point Surface::moved(const At& at, const Vector& phi) const {
    const Point g = gradient(at, phi);
    return flat_ ? g : exponential(at.xi, g);
}

} // namespace gaspard::slow
