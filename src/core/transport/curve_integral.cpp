#include "core/transport/curve_integral.hpp"

#include "core/fem/gauss.hpp"

#include <Eigen/Eigenvalues>
#include <cstddef>

namespace gaspard {

WeightedPoints points_within(const ConvexCurve& curve) {
    constexpr std::size_t parts = 48, around = 384;
    const LineQuadrature line = gauss_legendre(3);
    WeightedPoints rule{Points(parts * line.points.size() * around), {}};
    std::size_t next = 0;
    for (std::size_t j = 0; j < around; ++j) {
        const double t = (static_cast<double>(j) + 0.5) / around;
        const Vec3 from = curve.point(t) - curve.centre();
        const double across = cross(from, curve.tangent(t)).z / around;
        for (std::size_t i = 0; i < parts; ++i)
            for (std::size_t q = 0; q < line.points.size(); ++q) {
                const double r = (static_cast<double>(i) + line.points[q]) / parts;
                rule.x.set(next++, curve.centre() + r * from);
                rule.weights.push_back(line.weights[q] / parts * r * across);
            }
    }
    return rule;
}

Covariance transport_of_covariances(const Covariance& from, const Covariance& to) {
    const auto matrix = [](const Covariance& m) {
        Eigen::Matrix2d a;
        a << m.xx, m.xy, m.xy, m.yy;
        return a;
    };
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> of_source(matrix(from));
    const Eigen::Matrix2d root = of_source.operatorSqrt(), inverse = of_source.operatorInverseSqrt();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> middle(root * matrix(to) * root);
    const Eigen::Matrix2d a = inverse * middle.operatorSqrt() * inverse;
    return {a(0, 0), (a(0, 1) + a(1, 0)) / 2, a(1, 1)};
}

} // namespace gaspard
