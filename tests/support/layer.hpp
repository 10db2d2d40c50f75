// A layer along x = 1/2, and by how much meshes with cells h(x) reduce its interpolation error.
#pragma once

#include "support/function_of.hpp"

#include <cmath>
#include <functional>

namespace gaspard {

/// tanh((x - 1/2) / width) and the square of its second derivative.
inline FunctionOf layer(double width) {
    return {[=](Vec3 p) { return std::tanh((p.x - 0.5) / width); },
            [=](Vec3 p) {
                const double s = 1 / std::cosh((p.x - 0.5) / width);
                return Vec3{s * s / width, 0, 0};
            }};
}
inline double bend_square(double width, double x) {
    const double t = std::tanh((x - 0.5) / width), bend = -2 * t * (1 - t * t) / (width * width);
    return bend * bend;
}

/// L2 of the uniform mesh over that of cells with h = 1 / (n density), to leading order.
inline double factor_of(double width, const std::function<double(double)>& density) {
    constexpr int count = 100000;
    double uniform = 0, adapted = 0, mass = 0;
    for (int i = 0; i < count; ++i) mass += density((i + 0.5) / count) / count;
    for (int i = 0; i < count; ++i) {
        const double x = (i + 0.5) / count, b = bend_square(width, x);
        uniform += b, adapted += b / std::pow(density(x) / mass, 4);
    }
    return std::sqrt(uniform / adapted);
}

} // namespace gaspard
