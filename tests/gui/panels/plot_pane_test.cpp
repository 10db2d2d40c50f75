#include "gui/headless_ui.hpp"
#include "gui/panels/plot_pane.hpp"
#include "gui/panels/run_list.hpp"
#include "gui/run_fixtures.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace gaspard {
namespace {

class PlotPaneTest : public testing::Test {
  protected:
    PlotPaneTest() {
        for (const char* name : {"Ring", "Ring, amplitude 20"})
            add_made_up_run(document, name, 200).colour = document.runs().size() + 1;
    }
    void draw() {
        items.clear();
        if (auto wanted = pane.frame(document, first, second, {theme, 1, items}, document.active()))
            wish = wanted;
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

TEST_F(PlotPaneTest, APlotThatNoRunHasBecomesAnotherOne) {
    pane.choose(0, {.plot = "mesh-speed", .abscissa = "time"}); // of a scenario with time
    pane.choose(1, {.plot = "step-iterations"});
    frame();
    EXPECT_EQ(pane.choices()[0], PlotChoice{});
    EXPECT_EQ(pane.choices()[1].plot, "equidistribution");
}

TEST(PlotPaneInTime, APlotOfZerosOnALogarithmicAxisBecomesAnotherOnce) {
    Theme theme = dark_theme();
    HeadlessUi ui{900, 900, &theme};
    Document document{std::make_shared<Catalogue>(builtin_catalogue()), {}};
    document.show({.scenario = {}, .history = made_up_time_steps(2), .snapshot = nullptr});
    PlotPane pane;
    ItemRectangles items;
    const auto frame = [&] {
        ui.frame([&] {
            pane.frame(document, {400, 0, 900, 450}, {400, 450, 900, 900}, {theme, 1, items},
                       document.active());
        });
        return pane.choices()[0].plot;
    };
    EXPECT_EQ(frame(), "residual") << "too early to say";
    DocumentRun& run = document.active();
    const StepReport next = made_up_time_steps(3).back();
    run.history.push_back(next), run.curves.append(next);
    EXPECT_TRUE(is_blank(document.runs(), pane.choices()[0]));
    EXPECT_EQ(frame(), "mesh-speed");
    EXPECT_FALSE(is_blank(document.runs(), pane.choices()[0]));
    pane.choose(0, {.plot = "residual", .abscissa = "time"});
    EXPECT_EQ(frame(), "residual") << "whoever wants to see it does";
}

TEST_F(PlotPaneTest, EveryPlotChoosesWhatItShows) {
    frame(), frame();
    EXPECT_EQ(pane.choices()[0].plot, "residual");
    EXPECT_EQ(pane.choices()[1].plot, "equidistribution");
    click("plot.first.quantity");
    click("plot.first.quantity=jacobian");
    EXPECT_EQ(pane.choices()[0].plot, "jacobian");
    click("plot.second.abscissa");
    click("plot.second.abscissa=seconds");
    EXPECT_EQ(pane.choices()[1].abscissa, "seconds");
    click("plot.first.log");
    EXPECT_FALSE(pane.choices()[0].log_y);
    EXPECT_TRUE(pane.choices()[1].log_y);
    click("plot.second.menu");
    click("plot.second.menu.log-x");
    EXPECT_TRUE(pane.choices()[1].log_x);
    EXPECT_EQ(pane.choices()[1].plot, "equidistribution");
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
    for (const auto& [key, kind] : {std::pair{"csv", PlotWish::Kind::copy_csv},
                                    {"png", PlotWish::Kind::save_png},
                                    {"svg", PlotWish::Kind::save_svg}}) {
        wish.reset();
        click("plot.second.menu");
        click("plot.second.menu." + std::string(key));
        ASSERT_TRUE(wish) << key;
        EXPECT_EQ(wish->kind, kind);
        EXPECT_EQ(wish->choice.plot, "equidistribution");
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

/// Mouse and keys at random; the same input every time.
class RandomInput {
  public:
    int whole(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
    float real(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }
    bool once_in(int times) { return whole(1, times) == 1; }

    void stir(HeadlessUi& ui) {
        ImGuiIO& io = ImGui::GetIO();
        if (once_in(6)) ui.move(real(-20, 920), real(-20, 920));
        if (once_in(100)) ui.move_away();
        if (once_in(3)) ui.button(once_in(2), whole(0, 2));
        if (once_in(5)) ui.wheel(real(-5, 5));
        if (once_in(10)) ui.control(!io.KeyCtrl);
        if (once_in(10)) ui.shift(!io.KeyShift);
        if (once_in(5)) io.AddInputCharacter(static_cast<unsigned>(whole(32, 0x3000)));
    }
    /// One of the items there are, most of all of an open menu or list.
    ItemRectangle choose(const ItemRectangles& items) {
        std::vector<ItemRectangle> all, offered;
        for (const auto& [key, item] : items) {
            all.push_back(item);
            if (key.find(".menu.") != std::string::npos || key.find('=') != std::string::npos)
                offered.push_back(item);
        }
        const auto& from = offered.empty() || once_in(4) ? all : offered;
        return from[static_cast<std::size_t>(whole(0, static_cast<int>(from.size()) - 1))];
    }
    /// Of every kind that a double can be.
    double value() {
        static constexpr double values[] = {
            0,     -1,  1e-320, 1e300, std::numeric_limits<double>::infinity(),
            1e-12, 0.5, 3,      -1e9,  std::numeric_limits<double>::quiet_NaN()};
        return values[whole(0, 9)];
    }

  private:
    std::mt19937 random_{11};
};

TEST_F(PlotPaneTest, RandomInputOnPlotsAndRunListBreaksNothing) {
    RandomInput random;
    RunList list;
    const Action keep_action{.name = "keep", .label = "Keep", .help = "Keep this run."};
    int frames = 0, kept = 0, wishes = 0, zoomed = 0, removed = 0;
    const auto draw_both = [&] {
        const std::size_t before = document.runs().size();
        draw();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({390, 900});
        ImGui::Begin("runs", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        const bool keep = list.draw(document, keep_action, {theme, 1, items});
        ImGui::End();
        removed += document.runs().size() < before ? 1 : 0;
        if (keep && document.runs().size() < 30) {
            const std::string name = "Run " + std::to_string(++kept);
            add_made_up_run(document, name, 100 * random.whole(0, 3)).colour = static_cast<std::size_t>(kept);
        }
        ++frames;
    };
    while (frames < 10000) {
        random.stir(ui);
        if (random.once_in(100)) first.right = first.left + random.real(-10, 600);
        if (random.once_in(100)) second.bottom = second.top + random.real(-10, 600);
        if (!document.runs().empty()) {
            StepReport report{.iteration = 201 + frames / 3,
                              .residual = random.value(),
                              .step_size = random.value(),
                              .seconds = 2 + 0.01 * frames};
            for (const char* name : {"equidistribution", "min_jacobian", "max_jacobian"})
                report.set(name, random.value());
            document.active().curves.append(report);
        }
        if (random.once_in(5) && !items.empty()) {
            for (const int button : {0, 1, 2}) ui.button(false, button);
            ui.click(random.choose(items), draw_both);
        } else {
            ui.frame(draw_both);
        }
        wishes += std::exchange(wish, std::nullopt) ? 1 : 0;
        zoomed += pane.zoom(0) != PlotZoom{} ? 1 : 0;
        for (const std::size_t plot : {0U, 1U})
            for (const auto& range : {pane.zoom(plot).x, pane.zoom(plot).y})
                ASSERT_TRUE(!range || range->low < range->high) << frames;
    }
    EXPECT_GT(wishes, 5) << "the input reached too little";
    EXPECT_GT(zoomed, 100);
    EXPECT_GT(removed, 1);
    EXPECT_GT(kept, 5);
    EXPECT_NE(pane.choices()[0], PlotChoice{});
}

} // namespace
} // namespace gaspard
