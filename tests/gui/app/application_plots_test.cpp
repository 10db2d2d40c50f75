#include "core/base/error.hpp"
#include "gui/application_fixture.hpp"

#include <algorithm>
#include <fstream>

namespace gaspard {
namespace {

TEST_F(ApplicationTest, AClickInAPlotShowsThatIterateAndADoubleClickDoesNot) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && application.items().count("plot.first.curves"); }));
    const ItemRectangle curves = application.items().find("plot.first.curves")->second;
    ui.click(curves, drawing());
    frame();
    const int last = run().history.back().iteration, shown = std::stoi(application.status()[1].value);
    EXPECT_GT(shown, 0.3 * last);
    EXPECT_LT(shown, 0.7 * last);
    for (int i = 0; i < 40; ++i) frame();
    application.press_key("End");
    frame();
    ui.click(curves, drawing());
    ui.click(curves, drawing());
    frame();
    EXPECT_EQ(application.status()[1].value, std::to_string(last)) << "it shows the whole plot, no more";
}

TEST_F(ApplicationTest, AKeptRunStaysInThePlotsWhenTheLiveOneStartsOver) {
    EXPECT_FALSE(application.press_key("K")) << "there is nothing to keep yet";
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    EXPECT_TRUE(application.press_key("K"));
    ASSERT_EQ(application.document().runs().size(), 2U);
    EXPECT_EQ(application.messages().last().text, "Kept as Ring");
    EXPECT_TRUE(application.press_key("R"));
    ASSERT_TRUE(wait_until([&] { return run().history.size() == 1; }));
    EXPECT_GT(application.document().runs()[1].history.size(), 100U);
    frame();
    EXPECT_TRUE(application.items().count("runs.1.name"));
}

TEST_F(ApplicationTest, APlotIsCopiedAsNumbers) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    application.press_key("K");
    frame();
    ui.click(application.items().find("plot.first.menu")->second, drawing());
    frame();
    ui.click(application.items().find("plot.first.menu.csv")->second, drawing());
    const std::string copied = ImGui::GetClipboardText();
    EXPECT_TRUE(copied.starts_with("run,iteration,seconds,residual,")) << copied.substr(0, 80);
    EXPECT_EQ(std::count(copied.begin(), copied.end(), '\n'),
              static_cast<std::ptrdiff_t>(1 + 2 * run().history.size()));
    EXPECT_TRUE(application.messages().last().text.starts_with("Copied"))
        << application.messages().last().text;
}

TEST_F(ApplicationTest, APlotIsSavedAsAPicture) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto ask = [&] {
        ui.click(application.items().find("plot.second.menu")->second, drawing());
        frame();
        ui.click(application.items().find("plot.second.menu.png")->second, drawing());
    };
    std::string title;
    const auto draw = [&](const Plot& plot) {
        title = plot.title;
        return Image{2, 2, std::vector<std::uint8_t>(16, 200)};
    };
    application.save_plot(draw);
    EXPECT_EQ(title, "") << "nobody has asked";
    for (const char* name : {"equidistribution.png", "equidistribution-2.png"}) {
        ask();
        application.save_plot(draw);
        const auto file = folder / "plane-ring" / name;
        ASSERT_TRUE(wait_until([&] {
            return application.messages().last().text == "Saved " + file.string();
        })) << application.messages().last().text;
        EXPECT_EQ(read_image(file).width, 2);
    }
    EXPECT_EQ(title, "Equidistribution");
    ask();
    application.save_plot([](const Plot&) -> Image { throw MachineError("no picture today"); });
    EXPECT_TRUE(application.messages().last().error);
    EXPECT_EQ(application.messages().last().text, "no picture today");
}

TEST_F(ApplicationTest, APlotIsSavedAsVectorGraphics) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    ui.click(application.items().find("plot.first.menu")->second, drawing());
    frame();
    ui.click(application.items().find("plot.first.menu.svg")->second, drawing());
    const auto file = folder / "plane-ring" / "residual.svg";
    ASSERT_TRUE(wait_until([&] { return application.messages().last().text == "Saved " + file.string(); }))
        << application.messages().last().text;
    std::ifstream stream(file);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    EXPECT_NE(text.find("<svg"), std::string::npos);
    EXPECT_NE(text.find("Residual"), std::string::npos);
}

TEST_F(ApplicationTest, WhatThePlotsShowIsRemembered) {
    frame(), frame();
    ui.click(application.items().find("plot.first.log")->second, drawing());
    EXPECT_EQ(application.settings().window.text("first_plot"), "residual,iterations,linear,linear");
    Settings settings;
    settings.window.set("second_plot", std::string("step-size,seconds,log,log"));
    settings.window.set("first_plot", std::string("nonsense"));
    Application other(catalogue, small_ring(), {.output = {folder}, .settings = settings});
    ui.frame([&] { other.frame(); });
    EXPECT_EQ(other.settings().window.text("second_plot"), "step-size,seconds,log,log");
    EXPECT_EQ(other.settings().window.text("first_plot"), "residual,iterations,linear,log");
}

} // namespace
} // namespace gaspard
