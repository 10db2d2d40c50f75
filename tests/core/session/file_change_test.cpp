// Data of files that change while a run shows them.
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "support/temporary_folder.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <string>

namespace gaspard {
namespace {

void write_slope(const std::filesystem::path& file, const char* along) {
    std::ofstream out(file);
    out << "x,y,v\n";
    for (int j = 0; j <= 10; ++j)
        for (int i = 0; i <= 10; ++i) out << i << ',' << j << ',' << (*along == 'x' ? i : j) << '\n';
}

TEST(FileChange, IsNoticedWhenTheMonitorIsMadeAnew) {
    const TemporaryFolder folder;
    const auto file = folder / "v.csv";
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "walls-ring");
    apply_settings(*catalogue, scenario,
                   {"monitor.type=field", "domain.cells=16", "monitor.file=" + file.string()});
    const auto monitor_at = [](gaspard::Run& run, Vec3 x) {
        const auto snapshot = run.snapshot();
        const auto& nodes = snapshot->mesh->nodes;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (norm(nodes[i] - x) < 0.05) return snapshot->field("monitor")->values[i];
        return 0.0;
    };
    write_slope(file, "x");
    gaspard::Run run(catalogue, scenario);
    EXPECT_GT(monitor_at(run, {1, 0, 0}), 5 * monitor_at(run, {0, 1, 0}));
    write_slope(file, "y"); // of the same size
    apply_settings(*catalogue, scenario, {"monitor.contrast=21"});
    run.change(scenario);
    run.reset();
    EXPECT_GT(monitor_at(run, {0, 1, 0}), 5 * monitor_at(run, {1, 0, 0}));
    gaspard::Run anew(catalogue, scenario);
    EXPECT_GT(monitor_at(anew, {0, 1, 0}), 5);
}

} // namespace
} // namespace gaspard
