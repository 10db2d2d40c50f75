// A method on a plane, driven by hand.
#pragma once

#include "core/method/relax.hpp"

#include <functional>
#include <gtest/gtest.h>

namespace gaspard {

struct Driven {
    Driven(const MethodType& type, std::size_t cells, bool periodic)
        : plane(std::make_shared<PlaneQ2>(LineGrid{cells, periodic})),
          method(make_plane_method(type, plane, default_values(type))), state(method->initial_state()) {}

    void begin(std::shared_ptr<const Monitor> of) {
        monitor = std::move(of);
        history = {method->evaluate(problem_of(*monitor), state, {})};
    }
    /// Until the residual is below; returns the iterations.
    int solve(double tolerance = 1e-8) {
        while (history.back().residual >= tolerance && history.size() <= 1000) {
            history.push_back(method->step(problem_of(*monitor), state, {}));
            if (each) each();
        }
        EXPECT_LT(history.back().residual, tolerance);
        return static_cast<int>(history.size()) - 1;
    }
    MeshQuality quality() { return QualityMeter(plane->mesh()).measure(method->positions(), *monitor); }
    std::string layout(std::size_t cells) const {
        return std::string(plane->grid().periodic ? "plane periodic" : "plane walls") +
               " Q2 n=" + std::to_string(cells);
    }

    std::shared_ptr<const PlaneQ2> plane;
    std::unique_ptr<Method> method;
    State state;
    std::shared_ptr<const Monitor> monitor;
    std::vector<Evaluation> history;
    std::function<void()> each;
};

inline std::shared_ptr<const Monitor> monitor_of(const std::string& type, bool periodic,
                                                 const Settings& values = {}) {
    return make_monitor(type, periodic ? Space{SpaceKind::periodic_square} : Space{}, values);
}

} // namespace gaspard
