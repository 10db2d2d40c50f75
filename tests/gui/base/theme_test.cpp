// The glyphs of the font: the embedded one, and fonts of the system for what it lacks.
#include "core/scenario/catalogue.hpp"
#include "core/scenario/toml.hpp"
#include "gui/base/font_finder.hpp"
#include "gui/base/system_fonts.hpp"
#include "gui/base/theme.hpp"

#include <chrono>
#include <future>
#include <gtest/gtest.h>
#include <string>
#include <thread>

namespace gaspard {
namespace {

TEST(Font, HasLatinGreekAndCyrillic) {
    ImFontAtlas atlas;
    load_font(atlas, dark_theme(), 1);
    EXPECT_FALSE(lacks_glyphs(atlas, "Möbius strip, Ångström, Łódź, Ωμέγα, Сетка, Ґ ξ ≤ x²"));
    EXPECT_LE(atlas.TexWidth * atlas.TexHeight, 1 << 19) << "of bytes";
}

TEST(Font, HasEveryCharacterOfTheParameters) {
    ImFontAtlas atlas;
    load_font(atlas, dark_theme(), 1);
    const Catalogue catalogue = builtin_catalogue();
    std::string texts = "Mᵢ rad⁻¹ rad⁻² ×10⁻⁹ ‖r‖ … – −";
    for (const BuiltinScenario& one : builtin_scenarios()) {
        const Scenario scenario = find_scenario(catalogue, std::string(one.name));
        texts += scenario.title + scenario.description;
        for (const Values* values :
             {&scenario.domain.values, &scenario.monitor.values, &scenario.method.values,
              &scenario.source.values, &scenario.pde.values, &scenario.view})
            for (const ParameterRow& row : values->rows())
                texts += row.label + row.symbol + row.unit + row.help;
    }
    EXPECT_EQ(missing_characters(atlas, texts), std::vector<char32_t>{});
}

TEST(Font, FormulasHaveLettersOfEqualWidth) {
    ImFontAtlas atlas;
    load_font(atlas, dark_theme(), 1);
    ASSERT_EQ(atlas.Fonts.Size, 2);
    const ImFont& font = *atlas.Fonts[1];
    for (const char c : std::string("iW+(^2"))
        EXPECT_EQ(font.GetCharAdvance(c), font.GetCharAdvance('0')) << c;
    EXPECT_NE(atlas.Fonts[0]->GetCharAdvance('i'), atlas.Fonts[0]->GetCharAdvance('W'));
}

TEST(Font, TakesOtherCharactersOfATextFromTheSystem) {
    ImFontAtlas atlas;
    load_font(atlas, dark_theme(), 1);
    EXPECT_TRUE(lacks_glyphs(atlas, "網")) << "only when asked for, because such fonts are large";
    load_font(atlas, dark_theme(), 2, "Ω Ж é 網格");
    EXPECT_FALSE(lacks_glyphs(atlas, "Ω Ж é 網格"));
    EXPECT_TRUE(lacks_glyphs(atlas, "자"));
    EXPECT_EQ(atlas.Fonts.Size, 2) << "one for texts, one for formulas";
}

TEST(Font, ACharacterThatNoFontHasIsLeftOut) {
    EXPECT_TRUE(system_fonts({U'\uFDD0'}).empty());
    const auto fonts = system_fonts({U'網', U'\uFDD0'});
    ASSERT_EQ(fonts.size(), 1u);
    EXPECT_EQ(fonts[0].characters, std::vector<char32_t>{U'網'});
}

TEST(Font, IsFoundOnAnotherThreadAndThenUsed) {
    std::promise<std::thread::id> first, second;
    int woken = 0;
    FontFinder finder([&] { (++woken == 1 ? first : second).set_value(std::this_thread::get_id()); });
    ImFontAtlas atlas;
    const auto load = [&] { load_font(atlas, dark_theme(), 1, "網格", finder.fonts()); };
    load();
    finder.look_for(missing_characters(atlas, "網"));
    auto found = first.get_future();
    ASSERT_EQ(found.wait_for(std::chrono::seconds(60)), std::future_status::ready);
    EXPECT_NE(found.get(), std::this_thread::get_id());
    EXPECT_TRUE(finder.collect());
    EXPECT_FALSE(finder.collect()) << "nothing new";
    load();
    EXPECT_EQ(missing_characters(atlas, "網格"), std::vector<char32_t>{U'格'});
    finder.look_for({U'網', U'格'});
    ASSERT_EQ(second.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
    EXPECT_TRUE(finder.collect());
    load();
    EXPECT_FALSE(lacks_glyphs(atlas, "網格"));
    ASSERT_EQ(finder.fonts().size(), 1U) << "one font has both";
    EXPECT_EQ(finder.fonts()[0].characters, (std::vector<char32_t>{U'網', U'格'})) << "asked for once";
}

TEST(Font, ReadsUtf8) {
    EXPECT_EQ(characters_of("aé網\xF0\x9F\x98\x80"),
              (std::vector<char32_t>{U'a', U'\u00e9', U'網', U'\U0001F600'}));
    EXPECT_EQ(characters_of("a\xFF\x80z\xE7\xB6"), (std::vector<char32_t>{U'a', U'z'})) << "cut off";
}

} // namespace
} // namespace gaspard
