#include "gui/document/runs_csv.hpp"
#include "gui/run_fixtures.hpp"
#include "support/comma_locale.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <sstream>

namespace gaspard {
namespace {

/// A reader of its own: fields by RFC 4180.
std::vector<std::vector<std::string>> parse(const std::string& text) {
    std::vector<std::vector<std::string>> rows(1);
    std::string field;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
            field += text[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && (c == ',' || c == '\n')) {
            rows.back().push_back(std::exchange(field, {}));
            if (c == '\n') rows.emplace_back();
        } else
            field += c;
    }
    rows.pop_back();
    return rows;
}

TEST(RunsCsv, ReadsBackToTheSameNumbers) {
    const CommaLocale locale;
    DocumentRuns runs;
    runs.push_back(made_up_run("Ring, \"sharp\"", 4));
    runs.push_back(made_up_run("hidden", 3));
    runs.push_back(made_up_run("Bell", 2));
    runs[1].hidden = true;
    const auto rows = parse(runs_csv(runs));
    ASSERT_EQ(rows.size(), 1U + 5 + 3);
    EXPECT_EQ(rows[0],
              (std::vector<std::string>{"run", "iteration", "seconds", "residual", "equidistribution",
                                        "min_jacobian", "max_jacobian", "step_size", "tangled_cells"}));
    for (const auto& row : rows) ASSERT_EQ(row.size(), 9U);
    const auto number = [](const std::string& text) {
        std::istringstream stream(text);
        stream.imbue(std::locale::classic());
        double value = 0;
        stream >> value;
        return value;
    };
    for (std::size_t i = 0; i < 5; ++i) {
        const StepReport& report = runs[0].history[i];
        EXPECT_EQ(rows[1 + i][0], "Ring, \"sharp\"");
        EXPECT_EQ(rows[1 + i][1], std::to_string(i));
        EXPECT_EQ(number(rows[1 + i][2]), report.seconds);
        EXPECT_EQ(number(rows[1 + i][3]), report.residual);
        EXPECT_EQ(rows[1 + i][4].empty(), i % 2 == 1) << "not measured";
        if (i % 2 == 0) {
            EXPECT_EQ(number(rows[1 + i][6]), *report.value("max_jacobian"));
            EXPECT_EQ(rows[1 + i][8], "0");
        }
        EXPECT_EQ(number(rows[1 + i][7]), report.step_size);
    }
    EXPECT_EQ(rows[6][0], "Bell");
}

} // namespace
} // namespace gaspard
