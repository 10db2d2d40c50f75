#include "core/io/run_files.hpp"
#include "core/io/spline_map_file.hpp"
#include "core/spline/patch_file.hpp"
#include "core/spline/tensor_space.hpp"
#include "support/solved_run.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace gaspard {
namespace {

TEST(SplineMapFile, HoldsTheMapOfThePatchExactly) {
    for (const std::string method : {"picard", "picard-mixed"}) {
        TemporaryFolder folder;
        gaspard::Run run = solved_run("spline-circle", {"domain.cells=8", "method.type=" + method});
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

/// The distance of the written patch from the nodes of the mesh, for n cells.
double patch_error(const std::string& domain, const std::string& method, int degree, int cells) {
    TemporaryFolder folder;
    gaspard::Run run =
        solved_run("spline-circle",
                   {"domain.type=" + domain, "method.type=" + method, "monitor.type=bell",
                    "monitor.amplitude=2", "monitor.sharpness=5", "method.start=identity",
                    "domain.degree=" + std::to_string(degree), "domain.cells=" + std::to_string(cells)});
    write_run_files(folder.path(), run, parse_formats("patch"));
    const SplinePatch patch = read_patch(folder.path() / "adapted-patch.json").patch;
    EXPECT_EQ(read_patch(folder.path() / "adapted-patch.xml").patch, patch);
    const auto snapshot = run.snapshot();
    const int pieces = degree * cells;
    const auto side = static_cast<std::size_t>(pieces + 1);
    Points xi(side * side), x;
    for (std::size_t i = 0; i < xi.size(); ++i)
        xi.set(i, {static_cast<double>(i % side) / pieces, static_cast<double>(i / side) / pieces, 0});
    patch_map(patch)->points(xi, x);
    double largest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, norm(x[i] - snapshot->x[i]));
    return largest;
}

TEST(AdaptedPatch, IsExactForAffinePatchesAndOfOrderPPlus1Otherwise) {
    for (const std::string method : {"picard", "picard-mixed"}) {
        EXPECT_LT(patch_error("spline-square", method, 3, 8), 1e-12) << method;
        // Compare between the nodes: for degree 2 the nodes are the Greville points, where the error
        // vanishes.
        const double coarse = patch_error("spline-annulus", method, 3, 16);
        const double fine = patch_error("spline-annulus", method, 3, 32);
        EXPECT_LT(coarse, 1e-3) << method;
        EXPECT_GT(std::log2(coarse / fine), 3.4) << method << ": " << coarse << ", " << fine;
    }
}

TEST(SplineMapFile, IsNotWrittenForOtherDomains) {
    TemporaryFolder folder;
    gaspard::Run run = solved_run("plane-ring", {"domain.cells=8", "method.max_iterations=2"});
    write_run_files(folder.path(), run, {});
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "summary.json"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "map.json"));
    EXPECT_FALSE(spline_map_json(run.state()).has_value());
}

} // namespace
} // namespace gaspard
