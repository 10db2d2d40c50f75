// The built-in scenarios that move, for a few steps on coarse meshes: no time step has tangled cells.
#include "support/solved_run.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

struct Live {
    const char* name;
    std::vector<std::string> settings;
};

class LiveScenario : public testing::TestWithParam<Live> {};

TEST_P(LiveScenario, HasNoTangledCells) {
    std::vector<std::string> settings = GetParam().settings;
    settings.emplace_back("method.diagnostics_every=1");
    const gaspard::Run run = solved_run(GetParam().name, settings);
    EXPECT_EQ(run.status(), RunStatus::converged);
    int steps = 0;
    double moved = 0;
    for (const StepReport& report : run.history()) {
        const auto speed = report.value("mesh_speed");
        if (!speed) continue; // of the first mesh
        ++steps;
        moved = std::max(moved, *speed);
        ASSERT_TRUE(report.tangled_cells.has_value());
        EXPECT_EQ(*report.tangled_cells, 0) << "time step " << steps;
        EXPECT_EQ(report.note, "");
    }
    EXPECT_EQ(steps, 4);
    EXPECT_GT(moved, 1e-3) << "the mesh moves";
}

INSTANTIATE_TEST_SUITE_P(
    All, LiveScenario,
    testing::Values(Live{"flow-live", {"domain.cells=24", "monitor.cells=48", "time.end=0.2"}},
                    Live{"flow-merging", {"domain.cells=24", "monitor.cells=48", "time.end=0.2"}},
                    Live{"plane-moving-ring", {"domain.cells=24", "time.end=0.2"}},
                    Live{"front-2d", {"domain.cells=24", "monitor.u.nu=0.03", "time.end=0.12"}},
                    Live{"sphere-rotating-cross", {"domain.refinements=3", "time.end=0.08"}},
                    Live{"burgers-1d", {"domain.cells=24", "time.end=0.04"}}),
    [](const auto& tested) {
        std::string name = tested.param.name;
        std::erase(name, '-');
        return name;
    });

} // namespace
} // namespace gaspard
