// A method on a sphere (or another surface), driven by hand, with what the tests want to know of a mesh.
#pragma once

#include "core/diagnostics/exact_map.hpp"
#include "core/diagnostics/quality.hpp"
#include "core/fem/surface_q2.hpp"
#include "core/method/surface_equation.hpp"
#include "support/built_in.hpp"

#include <string>

namespace gaspard {

/// The method with its step size, or with "auto".
inline std::unique_ptr<Method> make_method(const std::string& name, std::shared_ptr<const SurfaceQ2> of,
                                           std::optional<double> step_size) {
    for (const MethodType& type :
         {relaxation_method(), accelerated_method(), newton_method(), automatic_method()}) {
        if (type.name != name) continue;
        Values values = default_values(type);
        if (step_size && values.has("step_size")) values.set("step_size", *step_size);
        return type.make(
            {.discretisation = of, .problem = [of] { return std::make_unique<SurfaceEquation>(of); }},
            values);
    }
    return nullptr;
}

struct OnSurface {
    OnSurface(std::shared_ptr<const SurfaceQ2> of, std::shared_ptr<const Monitor> with,
              std::optional<double> step_size, const std::string& name = "relaxation")
        : surface(std::move(of)), monitor(std::move(with)), method(make_method(name, surface, step_size)),
          state(method->initial_state()), history{method->evaluate(problem_of(*monitor), state, {})} {}
    OnSurface(SurfaceSetup setup, std::shared_ptr<const Monitor> with, std::optional<double> step_size,
              const std::string& name = "relaxation")
        : OnSurface(std::make_shared<SurfaceQ2>(std::move(setup)), std::move(with), step_size, name) {}

    const Evaluation& step() { return history.emplace_back(method->step(problem_of(*monitor), state, {})); }
    /// Steps until the residual is below, or beyond all bounds, or so many.
    void solve(double tolerance = 1e-8, int most = 2000) {
        while (history.back().residual >= tolerance && history.back().residual < 1e3 && iterations() < most)
            step();
    }
    int iterations() const { return static_cast<int>(history.size()) - 1; }
    const Points& x() const { return method->positions(); }
    MeshQuality quality() const {
        return QualityMeter(surface->mesh(), 1, 6, {SpaceKind::sphere}).measure(x(), *monitor);
    }
    ExactDeviation deviation() const {
        return exact_deviation(*surface->mesh(), x(), ExactMap::of(*monitor)->apply(surface->mesh()->nodes));
    }

    std::shared_ptr<const SurfaceQ2> surface;
    std::shared_ptr<const Monitor> monitor;
    std::unique_ptr<Method> method;
    State state;
    std::vector<Evaluation> history;
};

inline const SphereGrid small_cubed{SphereCells::cubed, 6}, small_icosahedral{SphereCells::icosahedral, 2};

inline std::shared_ptr<const Monitor> on_sphere(const std::string& type, const Settings& settings = {}) {
    return make_monitor(type, {SpaceKind::sphere}, settings);
}

} // namespace gaspard
