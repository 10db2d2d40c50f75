#include "core/transport/transport_errors.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace gaspard {

namespace {

/// U and its derivatives at a point of the rule.
struct PotentialAt {
    double u = 0;
    std::array<double, 2> slope{};                   ///< grad U
    std::array<double, derivative_count> of_nodes{}; ///< H U and G U
};

PotentialAt potential_at(const TransportForm& form, std::size_t c, std::size_t q) {
    const NonvariationalSpace& space = form.space();
    const auto cell = space.elements().cell(c);
    const TriangleShapes& shapes = space.shapes()[q];
    PotentialAt at;
    for (std::size_t a = 0; a < cell.size(); ++a) {
        const auto node = static_cast<std::size_t>(cell[a]);
        const double u = form.unknowns()[node];
        const auto slope = space.points(c)[q].gradient(shapes.slopes[a]);
        at.u += shapes.values[a] * u;
        at.slope[0] += slope[0] * u, at.slope[1] += slope[1] * u;
        for (std::size_t i = 0; i < derivative_count; ++i)
            at.of_nodes[i] += shapes.values[a] * form.derivatives()[derivative_count * node + i];
    }
    return at;
}

} // namespace

TransportErrors transport_errors(const TransportForm& form, const ExactPotential& exact) {
    const NonvariationalSpace& space = form.space();
    TransportErrors squares;
    const auto square = [](double number) { return number * number; };
    for (std::size_t c = 0; c < space.elements().cell_count(); ++c)
        for (std::size_t q = 0; q < space.shapes().size(); ++q) {
            const Vec3 x = space.elements().place(c, space.shapes()[q]).x;
            const double weight = space.points(c)[q].weight;
            const auto& [u, slope, of_nodes] = potential_at(form, c, q);
            const Vec3 gradient = exact.gradient(x);
            const Covariance hessian = exact.hessian(x);
            squares.value += weight * square(u - exact.value(x));
            squares.gradient += weight * (square(slope[0] - gradient.x) + square(slope[1] - gradient.y));
            squares.recovered_gradient +=
                weight * (square(of_nodes[g1] - gradient.x) + square(of_nodes[g2] - gradient.y));
            squares.hessian +=
                weight * (square(of_nodes[h11] - hessian.xx) + 2 * square(of_nodes[h12] - hessian.xy) +
                          square(of_nodes[h22] - hessian.yy));
        }
    return {std::sqrt(squares.value), std::sqrt(squares.gradient), std::sqrt(squares.recovered_gradient),
            std::sqrt(squares.hessian)};
}

} // namespace gaspard
