#include "gui/plot_pane.hpp"
#include "gui/run_list.hpp"
#include "headless_ui.hpp"
#include "run_fixtures.hpp"

#include <gtest/gtest.h>
#include <random>

namespace gaspard {
namespace {

class PlotPaneTest : public testing::Test {
  protected:
    PlotPaneTest() {
        for (const char* name : {"Ring", "Ring, amplitude 20"}) {
            document.runs().push_back(made_up_run(name, 200));
            document.runs().back().number = document.runs().back().colour = document.runs().size();
        }
    }
    void draw() {
        items.clear();
        if (auto wanted = pane.frame(document, first, second, {theme, 1, items})) wish = wanted;
    }
    std::function<void()> drawing() {
        return [this] { draw(); };
    }
    void frame() { ui.frame(drawing()); }
    ItemRectangle item(const std::string& key) {
        const auto found = items.find(key);
        EXPECT_NE(found, items.end()) << key;
        return found == items.end() ? ItemRectangle{} : found->second;
    }
    void click(const std::string& key) {
        ui.click(item(key), drawing());
        frame();
    }

    Theme theme = dark_theme();
    HeadlessUi ui{900, 900, &theme};
    Document document{std::make_shared<Catalogue>(builtin_catalogue()), {}};
    ItemRectangle first{400, 0, 900, 450}, second{400, 450, 900, 900};
    ItemRectangles items;
    PlotPane pane;
    std::optional<PlotWish> wish;
};

TEST_F(PlotPaneTest, EveryPlotChoosesWhatItShows) {
    frame(), frame();
    EXPECT_EQ(pane.choices()[0].quantity, Quantity::residual);
    EXPECT_EQ(pane.choices()[1].quantity, Quantity::equidistribution);
    click("plot.first.quantity");
    click("plot.first.quantity=jacobian");
    EXPECT_EQ(pane.choices()[0].quantity, Quantity::jacobian);
    click("plot.second.abscissa");
    click("plot.second.abscissa=seconds");
    EXPECT_EQ(pane.choices()[1].abscissa, Abscissa::seconds);
    click("plot.first.log");
    EXPECT_FALSE(pane.choices()[0].log_y);
    EXPECT_TRUE(pane.choices()[1].log_y);
    click("plot.second.menu");
    click("plot.second.menu.log-x");
    EXPECT_TRUE(pane.choices()[1].log_x);
    EXPECT_EQ(pane.choices()[1].quantity, Quantity::equidistribution);
}

TEST_F(PlotPaneTest, AnotherAxisForgetsItsZoomOnly) {
    frame(), frame();
    const ItemRectangle curves = item("plot.first.curves");
    ui.move(curves.center_x(), curves.center_y());
    frame(), ui.wheel(2), frame(), ui.wheel(0), frame();
    ASSERT_TRUE(pane.zoom(0).x && pane.zoom(0).y);
    EXPECT_EQ(pane.zoom(1), PlotZoom{}) << "each has its own";
    click("plot.first.log");
    EXPECT_TRUE(pane.zoom(0).x && !pane.zoom(0).y);
    click("plot.first.menu");
    click("plot.first.menu.seconds");
    EXPECT_EQ(pane.zoom(0), PlotZoom{});
}

TEST_F(PlotPaneTest, TheMenuWishesForFiles) {
    frame(), frame();
    for (const auto& [key, kind] :
         {std::pair{"csv", PlotWish::Kind::copy_csv}, {"png", PlotWish::Kind::save_png}}) {
        wish.reset();
        click("plot.second.menu");
        click("plot.second.menu." + std::string(key));
        ASSERT_TRUE(wish) << key;
        EXPECT_EQ(wish->kind, kind);
        EXPECT_EQ(wish->choice.quantity, Quantity::equidistribution);
    }
}

TEST_F(PlotPaneTest, ARightClickOpensTheMenuThatShowsEverythingAgain) {
    frame(), frame();
    const ItemRectangle curves = item("plot.first.curves");
    ui.move(curves.center_x(), curves.center_y());
    frame(), ui.wheel(2), frame(), ui.wheel(0), frame();
    ASSERT_NE(pane.zoom(0), PlotZoom{});
    ui.button(true, 1), frame(), ui.button(false, 1), frame(), frame();
    click("plot.first.menu.everything");
    EXPECT_EQ(pane.zoom(0), PlotZoom{});
}

TEST_F(PlotPaneTest, HasAHeaderAtAnyWidth) {
    for (float width = 1; width < 400; width += 13) {
        second.left = second.right - width;
        frame(), frame();
        const ItemRectangle curves = item("plot.second.curves");
        EXPECT_LE(item("plot.second.menu").right, 901 + std::max(0.0F, 100 - width)) << width;
        EXPECT_GE(curves.width(), 0) << width;
    }
}

TEST_F(PlotPaneTest, RandomInputOnPlotsAndRunListBreaksNothing) {
    std::mt19937 random(11); // the same input every time
    const auto draw_int = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
    const auto draw_float = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    RunList list;
    int kept = 0, wishes = 0, zoomed = 0, removed = 0;
    for (int i = 0; i < 10000; ++i) {
        ImGuiIO& io = ImGui::GetIO();
        if (draw_int(0, 2) == 0) ui.move(draw_float(-20, 920), draw_float(-20, 920));
        if (draw_int(0, 99) == 0) ui.move_away();
        if (draw_int(0, 2) == 0) ui.button(draw_int(0, 1) == 1, draw_int(0, 2));
        if (draw_int(0, 4) == 0) ui.wheel(draw_float(-5, 5));
        if (draw_int(0, 9) == 0) io.KeyCtrl = !io.KeyCtrl;
        if (draw_int(0, 9) == 0) io.KeyShift = !io.KeyShift;
        if (draw_int(0, 4) == 0) io.AddInputCharacter(static_cast<unsigned>(draw_int(32, 0x3000)));
        if (draw_int(0, 99) == 0) {
            first.right = first.left + draw_float(-10, 600);
            second.bottom = second.top + draw_float(-10, 600);
        }
        // Runs grow, with values of every kind.
        if (DocumentRun* run = document.runs().empty() ? nullptr : &document.runs().front()) {
            static constexpr double values[] = {
                0,     -1,  1e-320, 1e300, std::numeric_limits<double>::infinity(),
                1e-12, 0.5, 3,      -1e9,  std::numeric_limits<double>::quiet_NaN()};
            const auto value = [&] { return values[draw_int(0, 9)]; };
            run->curves.append({.iteration = 201 + i / 3,
                                .residual = value(),
                                .step_size = value(),
                                .equidistribution = value(),
                                .min_jacobian = value(),
                                .max_jacobian = value(),
                                .seconds = 2 + 0.01 * i});
        }
        const std::size_t before = document.runs().size();
        ui.frame([&] {
            draw();
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({390, 900});
            ImGui::Begin("runs", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
            if (list.draw(document, {theme, 1, items}) && document.runs().size() < 30) {
                document.runs().push_back(made_up_run("Run " + std::to_string(kept), draw_int(0, 3) * 100));
                document.runs().back().number = document.runs().back().colour =
                    static_cast<std::size_t>(100 + ++kept);
            }
            ImGui::End();
        });
        removed += document.runs().size() < before ? 1 : 0;
        wishes += std::exchange(wish, std::nullopt) ? 1 : 0;
        zoomed += pane.zoom(0) != PlotZoom{} ? 1 : 0;
        for (const std::size_t plot : {0U, 1U})
            for (const auto& range : {pane.zoom(plot).x, pane.zoom(plot).y})
                if (range) {
                    ASSERT_LT(range->low, range->high) << i;
                }
    }
    EXPECT_GT(wishes, 0) << "the input reached too little";
    EXPECT_GT(zoomed, 100);
    EXPECT_GT(removed, 0);
    EXPECT_GT(kept, 0);
}

} // namespace
} // namespace gaspard
