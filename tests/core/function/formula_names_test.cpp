// The table of names in docs/monitors.md is that of the program.
#include "core/base/join.hpp"
#include "core/base/read_file.hpp"
#include "core/function/formula.hpp"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

namespace gaspard {
namespace {

/// As in docs/monitors.md, with the domains on which a name has its meaning.
std::string names_table() {
    const std::vector<std::pair<std::string, Space>> domains = {
        {"periodic plane", {SpaceKind::periodic_square}},
        {"walls", {SpaceKind::euclidean}},
        {"patches", {.kind = SpaceKind::euclidean, .dimension = 3, .patch = true}},
        {"sphere", {SpaceKind::sphere}}};
    std::vector<std::pair<FormulaName, std::vector<std::string>>> rows;
    for (const auto& [domain, space] : domains)
        for (const FormulaName& name : formula_names(space)) {
            auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& one) {
                return one.first.name == name.name && one.first.help == name.help;
            });
            if (row == rows.end()) row = rows.insert(rows.end(), {name, {}});
            row->second.push_back(domain);
        }
    std::string table = "| name | meaning | on |\n| --- | --- | --- |\n";
    for (const auto& [name, on] : rows)
        table += "| `" + name.name + "` | " + name.help + " | " +
                 (on.size() == domains.size() ? "every domain" : join(on, ", ")) + " |\n";
    return table;
}

TEST(FormulaNames, AreThoseOfTheDocumentation) {
    const auto page = std::filesystem::path(GASPARD_SOURCE_DIR) / "docs" / "monitors.md";
    EXPECT_NE(read_file(page).find(names_table()), std::string::npos)
        << "docs/monitors.md needs this table:\n"
        << names_table();
}

} // namespace
} // namespace gaspard
