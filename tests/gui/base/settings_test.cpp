#include "gui/base/settings.hpp"
#include "support/comma_locale.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

TEST(Settings, ComeBackAsTheyWereWritten) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "new" / "window.toml";
    Settings settings;
    settings.window.set("theme", std::string("light"));
    settings.window.set("text_size", 1.0 / 3 + 1);
    settings.window.set("plots", false);
    settings.window.set("left", std::int64_t{-40});
    settings.window.set("camera", std::string("centre 0.5 'quoted' \"twice\""));
    remember_recent(settings, "/home/me/a file.toml");
    remember_folder(settings, "/home/me");
    write_settings(file, settings);
    std::vector<std::string> complaints;
    EXPECT_EQ(read_settings(file, complaints), settings);
    EXPECT_TRUE(complaints.empty());
}

TEST(Settings, AreDefaultsWhereThereIsNoFile) {
    const TemporaryFolder folder;
    std::vector<std::string> complaints;
    EXPECT_EQ(read_settings(folder.path() / "none.toml", complaints), Settings{});
    EXPECT_EQ(read_settings({}, complaints), Settings{});
    EXPECT_TRUE(complaints.empty());
}

TEST(Settings, WhatIsWrongIsLeftOutAndSaid) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "window.toml";
    write(file, "recent = ['/a.toml', 3]\n[window]\ntheme = 'pink'\nplots = false\ncolour = 1\n"
                "text_size = 99.0\nlog = [1]\n");
    std::vector<std::string> complaints;
    const Settings settings = read_settings(file, complaints);
    EXPECT_EQ(complaints.size(), 4U);
    EXPECT_EQ(settings.window.text("theme"), "dark");
    EXPECT_FALSE(settings.window.boolean("plots"));
    EXPECT_EQ(settings.recent, std::vector<std::string>{"/a.toml"});
    for (const char* broken : {"[window", "\xff\xfe", "= = ="}) {
        write(file, broken);
        complaints.clear();
        EXPECT_EQ(read_settings(file, complaints), Settings{});
        EXPECT_EQ(complaints.size(), 1U) << broken;
    }
    complaints.clear();
    read_settings(folder.path(), complaints); // a folder
    EXPECT_EQ(complaints.size(), 1U);
}

TEST(Settings, RecentFilesAreFewAndTheNewestComesFirst) {
    Settings settings;
    for (int i = 0; i < 12; ++i) remember_recent(settings, "/s/" + std::to_string(i) + ".toml");
    EXPECT_EQ(settings.recent.size(), recent_limit);
    EXPECT_EQ(settings.recent.front(), "/s/11.toml");
    remember_recent(settings, "/s/9.toml");
    EXPECT_EQ(settings.recent.front(), "/s/9.toml");
    EXPECT_EQ(std::count(settings.recent.begin(), settings.recent.end(), "/s/9.toml"), 1);
    forget_recent(settings, "/s/9.toml");
    EXPECT_EQ(std::count(settings.recent.begin(), settings.recent.end(), "/s/9.toml"), 0);
}

TEST(Settings, NumbersAreWrittenWithAPointInAnyLocale) {
    const CommaLocale locale;
    Settings settings;
    settings.window.set("text_size", 1.5);
    EXPECT_NE(settings_toml(settings).find("text_size = 1.5"), std::string::npos) << settings_toml(settings);
}

TEST(Settings, StayWithinTheirRows) {
    const Settings settings;
    EXPECT_EQ(within(settings.window, "text_size", 100), 3);
    EXPECT_EQ(within(settings.window, "text_size", 0), 0.6);
    EXPECT_EQ(within(settings.window, "text_size", 2), 2);
}

} // namespace
} // namespace gaspard
