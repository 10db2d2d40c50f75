// The rooms of the house: who may use whom, and how large a file may be.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;
using Rooms = std::set<std::string>;

const std::map<std::string, Rooms>& allowed() {
    static const std::map<std::string, Rooms> table = [] {
        std::map<std::string, Rooms> t;
        const auto room = [&t](const std::string& name, const std::vector<std::string>& users_of,
                               Rooms own = {}) {
            Rooms all = {name};
            for (const auto& other : users_of) all.insert(t.at(other).begin(), t.at(other).end());
            all.insert(own.begin(), own.end());
            t[name] = all;
        };
        room("base", {});
        room("mesh", {"base"});
        room("linear", {"base"});
        room("monitor", {"mesh", "linear"});
        room("fem", {"mesh", "linear"});
        room("spline", {"fem"});
        room("diagnostics", {"monitor", "fem"});
        room("method", {"monitor", "spline", "diagnostics"});
        room("scenario", {"method"});
        room("session", {"scenario"});
        room("tessellate", {"session"});
        room("io", {"session", "tessellate"});
        room("published", {"session", "tessellate"});
        room("gaspard.hpp", {"io"}); // the library's door
        room("gui", {"io"});         // everything but what is published
        room("cli", {"gui", "published"});
        return t;
    }();
    return table;
}

std::string room_of(const fs::path& file) { // src/core/ROOM/..., src/ROOM/...
    const auto relative = fs::relative(file, fs::path(GASPARD_SOURCE_DIR) / "src");
    auto part = relative.begin();
    return *part == "core" ? (++part)->string() : part->string();
}

std::vector<fs::path> sources(const char* folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(GASPARD_SOURCE_DIR) / folder))
        if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp")
            files.push_back(entry.path());
    return files;
}

TEST(Structure, RoomsUseOnlyTheRoomsBelowThem) {
    const std::regex include(R"re(#include "(?:core/)?(\w+)/[^"]*")re");
    const std::regex graphics(R"re(#include <(GL|GLFW|EGL|imgui|glm|backends)[/.])re");
    std::size_t arrows = 0;
    for (const auto& file : sources("src")) {
        const std::string room = room_of(file);
        if (room == "main.cpp") continue;
        ASSERT_TRUE(allowed().contains(room)) << "no rule for the room of " << file;
        const bool core = file.string().find("/src/core/") != std::string::npos;
        std::ifstream in(file);
        for (std::string line; std::getline(in, line);) {
            std::smatch match;
            if (std::regex_search(line, match, include)) {
                ++arrows;
                EXPECT_TRUE(allowed().at(room).contains(match[1])) << file << ": " << line;
            }
            if (core) {
                EXPECT_FALSE(std::regex_search(line, graphics)) << file << ": " << line;
            }
        }
    }
    EXPECT_GT(arrows, 100u) << "the pattern finds nothing any more";
}

TEST(Structure, FilesStayReadable) {
    for (const char* folder : {"src", "tests"})
        for (const auto& file : sources(folder)) {
            std::ifstream in(file);
            std::size_t lines = 0;
            for (std::string line; std::getline(in, line);) ++lines;
            EXPECT_LE(lines, 600u) << file;
        }
}

} // namespace
