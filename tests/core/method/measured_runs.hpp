// Runs on patches with a chosen method.measure, for curved monitors that 16 cells per side resolve.
#pragma once

#include "support/solved_run.hpp"

#include <cmath>
#include <ostream>

namespace gaspard {

struct MeasuredPatch {
    const char* name; ///< of the test
    std::vector<std::string> settings;
};
inline void PrintTo(const MeasuredPatch& patch, std::ostream* out) { *out << patch.name; }

/// All shipped patches whose area element is not constant, and one of a file.
inline std::vector<MeasuredPatch> measured_patches() {
    return {
        {"disk",
         {"domain.type=spline-disk", "monitor.type=ring", "monitor.amplitude=5", "monitor.sharpness=8",
          "monitor.radius=0.4", "monitor.center_x=0.2", "monitor.center_y=-0.1"}},
        {"annulus",
         {"domain.type=spline-annulus", "monitor.type=ring", "monitor.amplitude=5", "monitor.sharpness=20",
          "monitor.radius=0.2", "monitor.center_x=0.45", "monitor.center_y=0.45"}},
        {"torus",
         {"domain.type=spline-torus", "monitor.type=bell", "monitor.amplitude=5", "monitor.sharpness=1",
          "monitor.center_x=0", "monitor.center_y=3", "monitor.center_z=1"}},
        {"moebius",
         {"domain.type=spline-moebius", "monitor.type=bell", "monitor.amplitude=5", "monitor.sharpness=4",
          "monitor.center_x=-1", "monitor.center_y=0", "monitor.center_z=0"}},
        {"nurbs",
         {"domain.type=spline-patch", "monitor.type=ring", "monitor.amplitude=5", "monitor.sharpness=8",
          "monitor.radius=0.4", "monitor.center_x=0.2", "monitor.center_y=-0.1"}},
        {"triangle", // an edge is a point
         {"domain.type=spline-patch",
          R"(domain.file={"degrees":[2,1],"knots":[[0,0,0,1,1,1],[0,0,1,1]],)"
          R"("control_points":[[0,0],[1,0],[2,0],[0.3,1.1],[0.3,1.1],[0.3,1.1]]})",
          "monitor.type=bell", "monitor.amplitude=3"}}};
}

inline gaspard::Run measured_run(const MeasuredPatch& patch, const std::string& method, int cells,
                                 const std::string& measure, std::vector<std::string> further = {}) {
    std::vector<std::string> settings = patch.settings;
    settings.insert(settings.end(), {"method.type=" + method, "domain.cells=" + std::to_string(cells),
                                     "method.measure=" + measure, "method.diagnostics_every=1000"});
    settings.insert(settings.end(), further.begin(), further.end());
    return solved_run("spline-circle", settings);
}

inline double last_value(const gaspard::Run& run, const std::string& name) {
    return run.history().back().value(name).value();
}

} // namespace gaspard
