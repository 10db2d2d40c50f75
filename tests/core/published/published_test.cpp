#include "core/base/error.hpp"
#include "core/published/published.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(Published, CsvLeavesUnprintedNumbersEmptyAndQuotes) {
    const std::string csv =
        published_csv({{"a", "x, y", 1.5, printed(2.0, 1), "say \"so\""}, {"b", "z", 1e-8}});
    EXPECT_EQ(csv, "row,quantity,ours,published,difference,note\n"
                   "a,\"x, y\",1.5,2,-0.5,\"say \"\"so\"\"\"\n"
                   "b,z,1e-08,,,\n");
}

TEST(Published, DifferencesBeyondTheLastDigitHaveANote) {
    // The second of these is 1.1 units of the last digit away, the first 0.9.
    EXPECT_FALSE(differs({"a", "x", 1.8219e-3, printed(1.821e-3, 4)}));
    const PublishedRow beyond{"a", "x", 1.8221e-3, printed(1.821e-3, 4)};
    EXPECT_TRUE(differs(beyond));
    EXPECT_NEAR(*difference(beyond), 1.1e-6, 1e-15);
    EXPECT_EQ(full_note(beyond), "differs beyond the last digit printed (+0.06 %): cause unknown");
    const PublishedRow half{"a", "x", 1, printed(-2, 2), "a note", "a reason"};
    EXPECT_EQ(full_note(half), "differs beyond the last digit printed (+1.5e+02 %): a reason; a note");
    EXPECT_EQ(full_note({"a", "x", 1, std::nullopt, "a note", "a reason"}), "a note");
    EXPECT_FALSE(differs({"a", "iterations", 35, Printed{35, 0}}));
    EXPECT_TRUE(differs({"a", "iterations", 36, Printed{35, 0}})) << "counts are exact";
    EXPECT_EQ(full_note({"a", "tangled cells", 1, Printed{0, 0}}),
              "differs beyond the last digit printed: cause unknown");
}

TEST(Published, AnUnknownIdNamesTheNearest) {
    try {
        find_recipe("mcrae-fig15");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("'mcrae-fig"), std::string::npos);
    }
}

TEST(Published, TablesOfBahariListPublishedNumbers) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    for (int table = 1; table <= 19; ++table)
        EXPECT_NO_THROW(find_recipe("bahari-table" + std::to_string(table)));
    for (int figure = 20; figure <= 23; ++figure)
        EXPECT_NO_THROW(find_recipe("bahari-fig" + std::to_string(figure)));
    EXPECT_TRUE(find_recipe("bahari-table2").full); // in three dimensions some rows take minutes
    EXPECT_FALSE(find_recipe("bahari-table1").full);
    std::stop_source source;
    int solved = 0;
    const auto first_row_only = [&](const std::string&) {
        if (++solved == 2) source.request_stop();
    };
    EXPECT_THROW(find_recipe("bahari-table3").make(catalogue, first_row_only, source.get_token()),
                 Interrupted);
    EXPECT_EQ(solved, 2);
}

TEST(Published, StopsOnRequest) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(find_recipe("mcrae-fig3")
                     .make(
                         catalogue, [](const std::string&) {}, source.get_token()),
                 Interrupted);
}

} // namespace
} // namespace gaspard
