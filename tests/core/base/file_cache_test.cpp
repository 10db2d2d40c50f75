#include "core/base/file_cache.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <vector>

namespace gaspard {
namespace {

/// Counts how often a content is made.
struct Maker {
    FileCache cache{};
    int made = 0;
    std::string get(const std::string& file, const char* purpose = "text") {
        const auto make = [&] {
            ++made;
            std::ifstream in(file);
            return std::make_shared<const std::string>(std::istreambuf_iterator<char>(in),
                                                       std::istreambuf_iterator<char>());
        };
        return *cache.get<std::string>(file, purpose, make,
                                       [](const std::string& text) { return text.size(); });
    }
};

void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

TEST(FileCache, KeepsWhatIsComputedFromNoFile) {
    Maker maker;
    maker.get("", "flow 1"), maker.get("", "flow 2"), maker.get("", "flow 1");
    EXPECT_EQ(maker.made, 2);
}

TEST(FileCache, MakesAContentOncePerFileAndPurpose) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.txt";
    write(file, "one");
    Maker maker;
    EXPECT_EQ(maker.get(file), "one");
    EXPECT_EQ(maker.get(file), "one");
    EXPECT_EQ(maker.made, 1);
    maker.get(file, "other");
    EXPECT_EQ(maker.made, 2);
}

TEST(FileCache, NoticesThatAFileHasChanged) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.txt";
    write(file, "one");
    Maker maker;
    maker.get(file);
    write(file, "longer");
    EXPECT_EQ(maker.get(file), "longer");
    const auto time = std::filesystem::last_write_time(file);
    write(file, "LONGER"); // of the same size
    std::filesystem::last_write_time(file, time + std::chrono::seconds(1));
    EXPECT_EQ(maker.get(file), "LONGER");
    EXPECT_EQ(maker.made, 3);
}

TEST(FileCache, NoticesThatAFileIsReplacedByOneOfTheSameSizeAndTime) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.txt", other = folder.path() / "b.txt";
    write(file, "one"), write(other, "two");
    Maker maker;
    EXPECT_EQ(maker.get(file), "one");
    std::filesystem::last_write_time(other, std::filesystem::last_write_time(file));
    std::filesystem::rename(other, file);
    EXPECT_EQ(maker.get(file), "two");
}

TEST(FileCache, KeepsNoMoreThanItsBudget) {
    const TemporaryFolder folder;
    Maker maker{FileCache(10'000)};
    std::vector<std::string> files;
    for (const char* name : {"a", "b", "c", "d"}) {
        files.push_back((folder.path() / name).string());
        write(files.back(), std::string(*name == 'd' ? 20'000 : 4'000, *name));
    }
    maker.get(files[0]), maker.get(files[1]), maker.get(files[0]), maker.get(files[1]);
    EXPECT_EQ(maker.made, 2);
    maker.get(files[2]); // a goes
    maker.get(files[1]), maker.get(files[2]);
    EXPECT_EQ(maker.made, 3);
    maker.get(files[0]);
    EXPECT_EQ(maker.made, 4);
    maker.get(files[3]), maker.get(files[3]); // larger than the budget: it is kept alone
    EXPECT_EQ(maker.made, 5);
    maker.get(files[0]);
    EXPECT_EQ(maker.made, 6);
}

TEST(FileCache, KeepsTheContentsThatWereUsedLast) {
    Maker maker;
    for (int i = 0; i < 8; ++i) maker.get("data:" + std::to_string(i));
    maker.get("data:0");
    EXPECT_EQ(maker.made, 8);
    maker.get("data:8"); // replaces 1, since 0 was used after it
    maker.get("data:0");
    EXPECT_EQ(maker.made, 9);
    maker.get("data:1");
    EXPECT_EQ(maker.made, 10);
}

TEST(FileCache, KeepsNothingOfAFailure) {
    FileCache cache;
    const auto fail = []() -> std::shared_ptr<const int> { throw std::runtime_error("no"); };
    const auto bytes = [](const int&) { return sizeof(int); };
    EXPECT_THROW(cache.get<int>("x", "number", fail, bytes), std::runtime_error);
    EXPECT_EQ(*cache.get<int>(
                  "x", "number", [] { return std::make_shared<const int>(3); }, bytes),
              3);
}

} // namespace
} // namespace gaspard
