// Checks the sources against docs/architecture.md: which module may include which, and the limits on sizes of
// files and classes.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Modules = std::set<std::string>;

const fs::path root = GASPARD_SOURCE_DIR;

/// The block "modules" of docs/architecture.md.
struct Structure {
    std::map<std::string, Modules> direct;  ///< the modules on its line
    std::map<std::string, Modules> allowed; ///< transitive closure, including the module itself
};

/// One line per module: its name, "<-", the modules that it uses. Those must be listed above.
Structure read_structure(std::istream& in) {
    Structure structure;
    std::string line;
    while (std::getline(in, line) && line != "```modules") {
    }
    while (std::getline(in, line) && line != "```") {
        std::istringstream words(line);
        std::string module, arrow;
        words >> module >> arrow;
        EXPECT_TRUE(arrow == "<-" || arrow.empty()) << line;
        EXPECT_FALSE(structure.direct.contains(module)) << module << " has two lines";
        Modules& direct = structure.direct[module];
        Modules& all = structure.allowed[module];
        all.insert(module);
        for (std::string used; words >> used; direct.insert(used)) {
            const auto below = structure.allowed.find(used);
            EXPECT_TRUE(below != structure.allowed.end() && used != module)
                << used << " is not above: " << line;
            if (below != structure.allowed.end()) all.insert(below->second.begin(), below->second.end());
        }
    }
    return structure;
}

Structure read_structure() {
    std::ifstream in(root / "docs/architecture.md");
    return read_structure(in);
}

/// "core/mesh" for "core/mesh/space.hpp"; "core/gaspard.hpp" and "main.cpp" are modules themselves.
std::string module_of(const std::string& path) {
    std::vector<std::string> parts;
    for (const auto& part : fs::path(path)) parts.push_back(part.string());
    if (parts.size() > 2) return parts[0] + "/" + parts[1];
    return parts[0] == "core" ? path : parts[0];
}

std::vector<fs::path> sources(const char* folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
        if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp")
            files.push_back(entry.path());
    return files;
}

TEST(Structure, ModulesIncludeExactlyWhatTheArchitectureStates) {
    const Structure structure = read_structure();
    ASSERT_GT(structure.direct.size(), 20u) << "docs/architecture.md has no block 'modules'";
    const std::regex include(R"re(#include "((core|gui|cli)/[^"]*)")re");
    std::map<std::string, Modules> used;
    for (const auto& file : sources("src")) {
        const std::string module = module_of(fs::relative(file, root / "src").generic_string());
        ASSERT_TRUE(structure.allowed.contains(module)) << "the drawing lacks the module of " << file;
        used[module];
        std::ifstream in(file);
        for (std::string line; std::getline(in, line);) {
            std::smatch match;
            if (!std::regex_search(line, match, include)) continue;
            const std::string other = module_of(match[1]);
            used[module].insert(other);
            EXPECT_TRUE(structure.allowed.at(module).contains(other)) << file << ": " << line;
        }
    }
    for (const auto& [module, direct] : structure.direct) {
        EXPECT_TRUE(used.contains(module)) << "the drawing has a module that is not there: " << module;
        for (const auto& other : direct)
            EXPECT_TRUE(used[module].contains(other))
                << "the drawing has an arrow that is not there: " << module << " <- " << other;
    }
}

TEST(Structure, ReadsTransitiveDependencies) {
    std::istringstream text("```modules\nlow\nhigh <- low\ntop <- high\n```\n");
    const Structure structure = read_structure(text);
    EXPECT_TRUE(structure.allowed.at("top").contains("low"));
    EXPECT_FALSE(structure.allowed.at("low").contains("high"));
    EXPECT_EQ(module_of("gui/plot/plot_view.hpp"), "gui/plot");
    EXPECT_EQ(module_of("core/gaspard.hpp"), "core/gaspard.hpp");
    EXPECT_EQ(module_of("cli/commands.hpp"), "cli");
}

TEST(Structure, TheCoreSeesNoGraphicsAndTheDocumentNoImGui) {
    const std::regex graphics(R"re(#include <(GL|GLFW|EGL|imgui|glm|backends)[/.])re");
    const std::regex imgui(R"re(#include <imgui)re");
    std::size_t seen = 0;
    for (const auto& file : sources("src")) {
        const std::string path = fs::relative(file, root / "src").generic_string();
        const bool core = path.starts_with("core/"), document = path.starts_with("gui/document/");
        std::ifstream in(file);
        for (std::string line; std::getline(in, line);) {
            seen += std::regex_search(line, graphics) ? 1 : 0;
            EXPECT_FALSE(core && std::regex_search(line, graphics)) << path << ": " << line;
            EXPECT_FALSE(document && std::regex_search(line, imgui)) << path << ": " << line;
        }
    }
    EXPECT_GT(seen, 10u) << "the pattern finds nothing any more";
}

TEST(Structure, FilesAreBelowTheSizeLimit) {
    for (const char* folder : {"src", "tests"})
        for (const auto& file : sources(folder)) {
            std::ifstream in(file);
            std::size_t lines = 0;
            for (std::string line; std::getline(in, line);) ++lines;
            EXPECT_LE(lines, 600u) << file;
        }
}

/// The public members of each class of a header, by its name: functions, types and variables that it declares
/// itself. The text has no comments.
std::map<std::string, int> public_members(const std::string& text) {
    static const std::regex head(R"re((^|\n) *class (\w+)( final)?( :[^{;]*)? \{)re");
    std::map<std::string, int> found;
    for (std::sregex_iterator at(text.begin(), text.end(), head), end; at != end; ++at) {
        int& count = found[(*at)[2]];
        bool is_public = false;
        std::string declaration;
        int depth = 1;
        for (auto i = static_cast<std::size_t>(at->position() + at->length()); depth > 0; ++i) {
            const char c = text.at(i);
            depth += c == '{' ? 1 : c == '}' ? -1 : 0;
            if (depth != 1 || c == '\n') continue;
            const bool body_ends = c == '}' && declaration.find('(') != declaration.npos;
            if (c == ';' || body_ends) {
                if (is_public && declaration.find_first_not_of(' ') != declaration.npos) ++count;
                declaration.clear();
            } else if (c == ':' && (declaration.ends_with("public") || declaration.ends_with("private") ||
                                    declaration.ends_with("protected"))) {
                is_public = declaration.ends_with("public");
                declaration.clear();
            } else if (c != '}') {
                declaration += c;
            }
        }
    }
    return found;
}

TEST(Structure, ClassesWithManyPublicMembersAreListedWithAReason) {
    const auto example = public_members(R"(
class Example final : public Base {
  public:
    explicit Example(int n) : n_(n) { check(n); }
    enum class Kind { one, two };
    int size() const { return n_; }
    std::function<void()> notify{};

  private:
    int n_ = 0;
};
class Other {
    int hidden();
};
)");
    EXPECT_EQ(example, (std::map<std::string, int>{{"Example", 4}, {"Other", 0}}));

    std::map<std::string, int> many;
    const std::regex comment("//.*");
    for (const auto& file : sources("src")) {
        if (file.extension() != ".hpp") continue;
        std::ifstream in(file);
        std::string text;
        for (std::string line; std::getline(in, line);) text += std::regex_replace(line, comment, "") + "\n";
        for (const auto& [name, count] : public_members(text))
            if (count > 22) many[name] = count;
    }
    std::ifstream in(root / "docs/architecture.md");
    std::stringstream page;
    page << in.rdbuf();
    for (const auto& [name, count] : many)
        EXPECT_NE(page.str().find("\n| `" + name + "` | "), std::string::npos)
            << name << " has " << count << " public members";
    EXPECT_EQ(many.size(), 6U) << "the table of docs/architecture.md has as many";
}

/// clang-format leaves comments as they are (ReflowComments), and counts as it likes in what follows them.
TEST(Structure, CommentsAreNotTooWide) {
    constexpr std::size_t widest = 110; // characters; in UTF-8 a character has one byte that is not 10xxxxxx
    for (const char* folder : {"src", "tests"})
        for (const auto& file : sources(folder)) {
            std::ifstream in(file);
            for (std::string line; std::getline(in, line);) {
                if (line.find("//") == line.npos) continue;
                const auto characters = std::count_if(
                    line.begin(), line.end(), [](unsigned char byte) { return (byte & 0xc0) != 0x80; });
                EXPECT_LE(static_cast<std::size_t>(characters), widest) << file << ": " << line;
            }
        }
}

} // namespace
