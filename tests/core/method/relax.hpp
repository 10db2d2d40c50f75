// The relaxation method on the plane, driven by hand, with what the tests want to know of a mesh.
#pragma once

#include "core/diagnostics/quality.hpp"
#include "core/fem/plane_q2.hpp"
#include "core/method/plane_equation.hpp"
#include "support/built_in.hpp"

#include <algorithm>

namespace gaspard {

inline std::unique_ptr<Method> make_plane_method(const MethodType& type, std::shared_ptr<const PlaneQ2> plane,
                                                 const Values& values) {
    return type.make(
        {.discretisation = plane, .problem = [plane] { return std::make_unique<PlaneEquation>(plane); }},
        values);
}

inline std::unique_ptr<Method> make_relaxation(std::shared_ptr<const PlaneQ2> plane, double step_size) {
    const MethodType type = relaxation_method();
    Values values = default_values(type);
    values.set("step_size", step_size);
    return make_plane_method(type, std::move(plane), values);
}

/// One problem: from the identity map, step by step.
struct Relaxing {
    Relaxing(int cells, bool periodic, std::shared_ptr<const Monitor> of, double step_size)
        : plane(std::make_shared<PlaneQ2>(LineGrid{static_cast<std::size_t>(cells), periodic})),
          monitor(std::move(of)), method(make_relaxation(plane, step_size)),
          state(method->initial_state()), history{method->evaluate(problem_of(*monitor), state, {})} {}

    const Evaluation& step() { return history.emplace_back(method->step(problem_of(*monitor), state, {})); }
    /// Steps until the residual is below 1e-8, or 5000.
    void solve() {
        while (history.back().residual >= 1e-8 && iterations() < 5000) step();
    }
    int iterations() const { return static_cast<int>(history.size()) - 1; }
    const Points& x() const { return method->positions(); }
    MeshQuality quality() const { return QualityMeter(plane->mesh()).measure(x(), *monitor); }

    std::shared_ptr<const PlaneQ2> plane;
    std::shared_ptr<const Monitor> monitor;
    std::unique_ptr<Method> method;
    State state;
    std::vector<Evaluation> history;
};

/// The ring and the bell of the paper, on the periodic square.
inline Relaxing ring(int cells) {
    return {cells, true, make_monitor("ring", {SpaceKind::periodic_square}), 0.1};
}
inline Relaxing bell(int cells) {
    return {cells, true, make_monitor("bell", {SpaceKind::periodic_square}), 0.04};
}

/// Of the straight-edged physical cells.
inline std::vector<double> cell_areas(const Mesh& mesh, const Points& x) {
    std::vector<double> areas;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        double twice = 0; // the shoelace formula
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec3 a = x[static_cast<std::size_t>(mesh.cell(c)[k])];
            const Vec3 b = x[static_cast<std::size_t>(mesh.cell(c)[(k + 1) % 4])];
            twice += a.x * b.y - a.y * b.x;
        }
        areas.push_back(twice / 2);
    }
    return areas;
}

} // namespace gaspard
