#include "core/base/error.hpp"
#include "core/io/run_folder.hpp"
#include "core/scenario/own_names.hpp"
#include "core/scenario/toml.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

#include <fstream>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

class RunFolderTest : public testing::Test {
  protected:
    void put(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
    void check() const { check_replaceable(folder, {"a.csv", "record.json"}, "record.json", "mine"); }

    TemporaryFolder temporary;
    const std::filesystem::path folder = temporary.path();
};

TEST_F(RunFolderTest, FilesOfTheSameScenarioMayBeReplacedAndNoOthers) {
    EXPECT_NO_THROW(check());
    put("other.csv", "of no interest");
    std::filesystem::create_directory(folder / "a.csv"); // no file
    EXPECT_NO_THROW(check());
    std::filesystem::remove(folder / "a.csv");
    put("a.csv", "");
    EXPECT_NE(message_of<InputError>([&] { check(); }).find("a.csv would be replaced"), std::string::npos);
    for (const char* broken : {"", "{", "[]", "3", "{\"scenario\": 3}", "{\"scenario\": \"his\"}"}) {
        put("record.json", broken);
        EXPECT_THROW(check(), InputError) << broken;
    }
    put("record.json", "{\"scenario\": \"mine\"}");
    EXPECT_NO_THROW(check());
    Scenario scenario;
    scenario.name = "mine";
    put("record.json", record_json(scenario));
    EXPECT_NO_THROW(check());
}

TEST_F(RunFolderTest, FilesOfSomethingElseAreNamedAndStay) {
    const auto left = [&] {
        return left_over(folder, {"a.csv", "b.png", "c.svg", "record.json"}, {"a.csv", "record.json"});
    };
    EXPECT_TRUE(left().empty());
    for (const char* name : {"a.csv", "b.png", "other.png", "record.json"}) put(name, "");
    EXPECT_EQ(left(), std::vector<std::string>{"b.png"});
    EXPECT_TRUE(std::filesystem::exists(folder / "b.png"));
}

TEST_F(RunFolderTest, AFreeFolderHasNoneOfTheNames) {
    const auto base = folder / "ring";
    EXPECT_EQ(free_folder(base, {"a.csv"}), base);
    std::filesystem::create_directory(base);
    EXPECT_EQ(free_folder(base, {"a.csv"}), base);
    put("ring/a.csv", "");
    EXPECT_EQ(free_folder(base, {"a.csv"}), folder / "ring-2");
    put("ring-2", "a file where a folder is needed");
    EXPECT_EQ(free_folder(base, {"a.csv"}), folder / "ring-3");
}

TEST(ScenarioNames, SayWhatWasModified) {
    const Catalogue catalogue = builtin_catalogue();
    const Scenario named = find_scenario(catalogue, "plane-ring");
    Scenario changed = named;
    EXPECT_TRUE(modified_keys(named, changed).empty());
    EXPECT_EQ(scenario_stem(changed), "plane-ring");
    apply_settings(catalogue, changed, {"monitor.amplitude=3", "view.color=area", "output.formats=vtu"});
    changed.modified = modified_keys(named, changed);
    EXPECT_EQ(changed.modified, std::vector<std::string>{"monitor.amplitude"});
    EXPECT_EQ(scenario_title(changed), named.title + " (modified)");
    EXPECT_EQ(scenario_stem(changed), "plane-ring-modified");
    const std::string stem = scenario_stem(changed);
    changed = with_own_names(std::move(changed)); // saved
    EXPECT_TRUE(changed.modified.empty());
    EXPECT_EQ(changed.title, named.title + " (modified)");
    EXPECT_EQ(changed.description, named.description + " (modified)");
    changed.name = stem;
    changed.modified = {"monitor.amplitude"}; // and modified again
    EXPECT_EQ(with_own_names(changed).title, named.title + " (modified)");
    EXPECT_EQ(with_own_names(changed).description, named.description + " (modified)");
    EXPECT_EQ(with_own_names(named), named);
    EXPECT_EQ(scenario_title(changed), named.title + " (modified)");
    EXPECT_EQ(scenario_stem(changed), "plane-ring-modified");
    changed.title.clear();
    EXPECT_EQ(scenario_title(changed), "plane-ring-modified (modified)");
    apply_settings(catalogue, changed, {"monitor.type=bell", "method.type=newton"});
    EXPECT_EQ(modified_keys(named, changed), (std::vector<std::string>{"monitor.type", "method.type"}));
}

} // namespace
} // namespace gaspard
