#include "gui/application_fixture.hpp"
#include "gui/viewport/legend_control.hpp"

namespace gaspard {
namespace {

class LegendTest : public ApplicationTest {
  protected:
    void SetUp() override {
        ASSERT_TRUE(wait_until([&] { return run().ended() && has("legend.high"); }));
    }
    bool has(const std::string& key) { return application.items().contains(key); }
    ItemRectangle item(const std::string& key) { return application.items().find(key)->second; }
    void double_click(ItemRectangle at) {
        ui.click(at, drawing());
        ui.click(at, drawing());
    }
    /// From the middle of an item by so many pixels.
    void drag_by(ItemRectangle from, float down) {
        ui.move(from.center_x(), from.center_y()), frame();
        ui.button(true), frame();
        for (int i = 1; i <= 4; ++i)
            ui.move(from.center_x(), from.center_y() + down * static_cast<float>(i) / 4), frame();
        ui.button(false), frame();
        frame();
    }
    float bar_height() { return item("legend.low").center_y() - item("legend.high").center_y(); }
    void rest() {
        for (int i = 0; i < 60; ++i) frame(); // so that no click is taken for the second of two
    }
};

TEST_F(LegendTest, TheEndsOfTheBarAreDragged) {
    const ColourRange all = shown().scene.colouring->range;
    const std::string camera = look().text("camera");
    drag_by(item("legend.high"), bar_height() / 2);
    EXPECT_EQ(look().text("range"), "fixed");
    EXPECT_NEAR(look().real("high"), (all.low + all.high) / 2, 0.02 * (all.high - all.low));
    EXPECT_EQ(look().real("low"), all.low);
    EXPECT_EQ(look().text("camera"), camera) << "the mesh stays";
    EXPECT_TRUE(look().text("pick").empty());
    rest();
    drag_by(item("legend.high"), -bar_height()); // beyond the end, by the size of the range
    EXPECT_NEAR(look().real("high"), all.high, 0.05 * (all.high - all.low));
    rest();
    const double high = look().real("high");
    drag_by(item("legend.low"), -3 * bar_height());
    EXPECT_LT(look().real("low"), high) << "some of the range is left";
    EXPECT_EQ(look().real("high"), high);
}

TEST_F(LegendTest, OneDragIsOneEdit) {
    const std::size_t before = application.document().edits().undo_count();
    drag_by(item("legend.high"), bar_height() / 2);
    EXPECT_EQ(application.document().edits().undo_count(), before + 1);
    application.press_key("Ctrl+Z");
    EXPECT_EQ(look().text("range"), "automatic");
}

TEST_F(LegendTest, OnALogarithmicScaleSmallValuesAreReached) {
    look().set("range", std::string("fixed"));
    look().set("low", 1e-3), look().set("high", 1e3);
    look().set("log", true);
    frame(), frame();
    drag_by(item("legend.low"), -bar_height() / 6); // by one decade
    EXPECT_NEAR(look().real("low"), 1e-2, 2e-3);
    rest();
    drag_by(item("legend.low"), bar_height() / 5 * 2); // by two decades of the shorter range
    EXPECT_NEAR(std::log10(look().real("low")), -4, 0.15);
}

TEST_F(LegendTest, ADoubleClickShowsAllValues) {
    drag_by(item("legend.high"), bar_height() / 2);
    rest();
    double_click(item("legend"));
    EXPECT_EQ(look().text("range"), "automatic");
    EXPECT_TRUE(look().text("pick").empty());
}

TEST_F(LegendTest, NumbersAreTyped) {
    rest();
    double_click(item("legend.high.value"));
    frame(), frame();
    ui.type("1", drawing());
    ui.key(ImGuiKey_Enter, true), frame();
    ui.key(ImGuiKey_Enter, false), frame();
    EXPECT_EQ(look().text("range"), "automatic") << "1 is not above the low end";
    frame(), frame();
    ui.type("10", drawing());
    ui.key(ImGuiKey_Enter, true), frame();
    ui.key(ImGuiKey_Enter, false), frame();
    EXPECT_EQ(look().text("range"), "fixed");
    EXPECT_EQ(look().real("high"), 10);
}

TEST_F(LegendTest, ARightClickOffersColourMapsAndScales) {
    const ItemRectangle legend = item("legend");
    ui.move(legend.center_x(), legend.center_y()), frame();
    ui.button(true, 1), frame();
    ui.button(false, 1), frame(), frame();
    ASSERT_TRUE(has("legend.menu.ember"));
    ui.click(item("legend.menu.ember"), drawing());
    EXPECT_EQ(look().text("color_map"), "ember");
}

TEST(Legend, ValuesOnTheBarGoOnBeyondIt) {
    EXPECT_EQ(value_on_bar({2, 4}, 0.5), 3);
    EXPECT_EQ(value_on_bar({2, 4}, 2), 6);
    EXPECT_NEAR(value_on_bar({1, 100, true}, 0.5), 10, 1e-12);
    EXPECT_NEAR(value_on_bar({1, 100, true}, -0.5), 0.1, 1e-12);
}

TEST(Legend, HistogramsCountByRootsOrLogarithms) {
    using enum HistogramCounts;
    EXPECT_EQ(histogram_length(0, 100, logarithmic), 0);
    EXPECT_FLOAT_EQ(histogram_length(25, 100, square_root), 0.5F);
    EXPECT_FLOAT_EQ(histogram_length(25, 100, linear), 0.25F);
    EXPECT_GT(histogram_length(1, 10000, logarithmic), 0.07F);
    EXPECT_FLOAT_EQ(histogram_length(100, 100, logarithmic), 1);
    EXPECT_EQ(histogram_counts("logarithmic"), logarithmic);
}

} // namespace
} // namespace gaspard
