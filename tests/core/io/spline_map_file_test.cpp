#include "core/io/run_files.hpp"
#include "core/io/spline_map_file.hpp"
#include "core/scenario/toml.hpp"
#include "core/spline/tensor_space.hpp"
#include "support/temporary_folder.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace gaspard {
namespace {

gaspard::Run short_run(const std::string& name, const std::vector<std::string>& settings) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, name);
    apply_settings(*catalogue, scenario, settings);
    gaspard::Run run(catalogue, scenario);
    run.solve();
    return run;
}

TEST(SplineMapFile, HoldsTheMapOfThePatchExactly) {
    for (const std::string method : {"picard", "picard-mixed"}) {
        TemporaryFolder folder;
        gaspard::Run run = short_run("spline-circle", {"domain.cells=8", "method.type=" + method});
        write_run_files(folder.path(), run, {});
        std::ifstream in(folder.path() / "map.json");
        const auto json = nlohmann::json::parse(in);
        ASSERT_EQ(json["components"].size(), 2u);
        const auto snapshot = run.snapshot();
        for (std::size_t c = 0; c < 2; ++c) {
            const auto& component = json["components"][c];
            TensorSpace space;
            for (std::size_t d = 0; d < 2; ++d)
                space.directions.push_back(
                    {component["degrees"][d].get<int>(), component["knots"][d].get<std::vector<double>>()});
            const auto coefficients = component["coefficients"].get<std::vector<double>>();
            ASSERT_EQ(coefficients.size(), space.size());
            for (std::size_t i = 0; i < snapshot->x.size(); ++i)
                EXPECT_NEAR(evaluate(space, coefficients, snapshot->mesh->nodes[i]),
                            c == 0 ? snapshot->x.x[i] : snapshot->x.y[i], 1e-13);
        }
        std::ifstream summary(folder.path() / "summary.json");
        const auto numbers = nlohmann::json::parse(summary)["measures"];
        for (const char* name : {"err", "err_absolute", "qual", "qual_f", "min_jacobian_psi", "border_error"})
            EXPECT_TRUE(numbers[name].is_number()) << name;
    }
}

TEST(SplineMapFile, IsNotWrittenForOtherDomains) {
    TemporaryFolder folder;
    gaspard::Run run = short_run("plane-ring", {"domain.cells=8", "method.max_iterations=2"});
    write_run_files(folder.path(), run, {});
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "summary.json"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "map.json"));
    EXPECT_FALSE(spline_map_json(run.state()).has_value());
}

} // namespace
} // namespace gaspard
