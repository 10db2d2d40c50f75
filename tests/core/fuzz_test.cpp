// The fuzz targets on the seeds, which are valid input, and on inputs that were findings (scripts/fuzz.sh).
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "fuzz/targets.hpp"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

namespace gaspard {
namespace {

const std::filesystem::path fuzz_folder = std::filesystem::path(GASPARD_SOURCE_DIR) / "fuzz";

std::vector<std::filesystem::path> inputs(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    if (!exists(folder)) return files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

class Fuzz : public testing::TestWithParam<FuzzTarget> {};

TEST_P(Fuzz, SeedsAreValid) {
    const auto files = inputs(fuzz_folder / "seeds" / GetParam().name);
    EXPECT_FALSE(files.empty()) << "no seeds";
    for (const auto& file : files) EXPECT_NO_THROW(GetParam().read(read_file(file))) << file;
}

TEST_P(Fuzz, FindingsStayMended) {
    for (const auto& file : inputs(fuzz_folder / "regressions" / GetParam().name))
        EXPECT_NO_THROW(run_target(GetParam(), read_file(file))) << file;
}

INSTANTIATE_TEST_SUITE_P(Targets, Fuzz, testing::ValuesIn(fuzz_targets().begin(), fuzz_targets().end()),
                         [](const auto& parameter) {
                             std::string name(parameter.param.name);
                             std::erase(name, '-');
                             return name;
                         });

TEST(FuzzFolders, AreNamedAfterTargets) {
    std::set<std::string> targets;
    for (const FuzzTarget& target : fuzz_targets()) targets.emplace(target.name);
    for (const char* kind : {"seeds", "regressions"})
        for (const auto& folder : inputs(fuzz_folder / kind))
            EXPECT_TRUE(targets.contains(folder.filename().string())) << folder;
}

/// A target whose reader lets another exception out is found.
TEST(FuzzFolders, AnExceptionOfALibraryIsAFinding) {
    const FuzzTarget careless{"careless", [](std::string_view bytes) { static_cast<void>(bytes.at(9)); }};
    EXPECT_THROW(run_target(careless, "short"), std::out_of_range);
    const FuzzTarget careful{"careful", [](std::string_view) { throw InputError("no"); }};
    EXPECT_NO_THROW(run_target(careful, "short"));
}

} // namespace
} // namespace gaspard
