#include "core/base/error.hpp"
#include "core/base/read_data_file.hpp"
#include "core/base/read_file.hpp"
#include "core/scenario/data_files.hpp"
#include "core/scenario/toml.hpp"
#include "core/spline/patch_file.hpp"
#include "support/temporary_folder.hpp"

#include <fstream>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

class DataFilesTest : public testing::Test {
  protected:
    Scenario scenario_of(const std::string& file) const {
        Scenario scenario = default_scenario(catalogue);
        scenario.domain = domain_section(catalogue, "spline-patch");
        scenario.domain.values.set("file", file);
        update_rows(catalogue, scenario);
        locate_domain(catalogue, scenario);
        return scenario;
    }
    static std::string file_of(const Scenario& scenario) { return scenario.domain.values.text("file"); }

    Catalogue catalogue = builtin_catalogue();
    TemporaryFolder temporary;
};

TEST_F(DataFilesTest, PathsAreRelativeToTheFolderOfTheScenario) {
    const auto relative = [&](const char* file, const char* folder) {
        const Scenario there = with_relative_paths(scenario_of(file), folder);
        EXPECT_EQ(there.folder, folder);
        return file_of(there);
    };
    EXPECT_EQ(relative("/home/me/meshes/data/p.json", "/home/me/meshes"), "data/p.json");
    EXPECT_EQ(relative("/home/me/data/p.json", "/home/me/meshes"), "../data/p.json");
    EXPECT_EQ(relative("/home/me/meshes/./p.json", "/home/me/meshes"), "p.json");
    EXPECT_EQ(relative("/data/p.json", "/home/me"), "/data/p.json") << "nothing is shared but the root";
    EXPECT_EQ(relative("", "/home/me"), "");
    EXPECT_EQ(relative("{}", "/home/me"), "{}") << "the content itself";
    Scenario moved = scenario_of("p.json");
    moved.folder = "/home/me/old";
    EXPECT_EQ(file_of(with_relative_paths(moved, "/home/me/new")), "../old/p.json");
}

TEST_F(DataFilesTest, PackedDataNeedNoFile) {
    const auto file = temporary.path() / "p.json";
    std::ofstream(file) << patch_json(nurbs_disk());
    const std::string bytes = read_file(file);
    EXPECT_TRUE(has_data_files(scenario_of(file.string())));
    const Scenario packed = with_packed_data(scenario_of(file.string()));
    EXPECT_FALSE(has_data_files(packed));
    EXPECT_TRUE(file_of(packed).starts_with("data:application/json;base64,"));
    std::filesystem::remove(file);
    EXPECT_EQ(read_data_file(file_of(packed)), bytes);
    const Scenario again = parse_scenario(catalogue, to_toml(packed), "elsewhere.toml");
    EXPECT_EQ(again.domain, packed.domain);
}

TEST_F(DataFilesTest, LargeDataAreRefusedWithoutReadingThem) {
    const auto file = temporary.path() / "large.json";
    std::ofstream(file) << "{";
    std::filesystem::resize_file(file, most_packed_data + 1);
    try {
        with_packed_data(scenario_of(file.string()));
        FAIL() << "packed";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("large.json cannot be packed"), std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find("2 MB"), std::string::npos) << error.what();
    }
    std::filesystem::resize_file(file, most_packed_data);
    EXPECT_LT(to_toml(with_packed_data(scenario_of(file.string()))).size(), largest_scenario_file)
        << "what is written can be read";
    EXPECT_THROW(with_packed_data(scenario_of("/none/p.json")), InputError);
}

} // namespace
} // namespace gaspard
