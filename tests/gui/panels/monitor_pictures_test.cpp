// The pictures of monitors in the list of types.
#include "gui/application_fixture.hpp"
#include "gui/panels/monitor_pictures.hpp"
#include "support/monitor_defaults.hpp"

#include <chrono>
#include <gtest/gtest.h>
#include <optional>
#include <utility>

namespace gaspard {
namespace {

const Box unit{{0, 0, 0}, {1, 1, 0}};

MonitorSubject subject_of(const std::string& name, const Space& space, const Box& region = unit) {
    return {name, default_values(monitor_type(name), space), space, region};
}

std::array<int, 4> pixel(const Image& image, int x, int y) {
    const auto at = static_cast<std::size_t>(4 * (y * image.width + x));
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

TEST(MonitorPictures, ABellIsBrightInItsMiddleAndSquare) {
    const Space space{.kind = SpaceKind::periodic_square};
    const auto image = picture_of_monitor(monitor_type("bell"), subject_of("bell", space));
    ASSERT_TRUE(image);
    EXPECT_EQ(image->width, monitor_picture_width);
    EXPECT_EQ(image->height, monitor_picture_height);
    const auto& map = colour_map("viridis");
    const auto lowest = colour_at(map, 0);
    const auto corner = pixel(*image, 10, 2), middle = pixel(*image, 32, 24), outside = pixel(*image, 2, 24);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(corner[c], lowest[c], 2);
    EXPECT_GT(middle[0] + middle[1], 300) << "yellow";
    EXPECT_EQ(middle[3], 255);
    EXPECT_EQ(outside[3], 0) << "beside the square";
}

TEST(MonitorPictures, OnASphereItIsAMapTwiceAsWideAsHigh) {
    const Space space{.kind = SpaceKind::sphere};
    MonitorSubject subject = subject_of("bell", space);
    subject.values.set("center_latitude", 0.0);
    subject.values.set("center_longitude", 90.0);
    const auto image = picture_of_monitor(monitor_type("bell"), subject);
    ASSERT_TRUE(image);
    EXPECT_EQ(pixel(*image, 32, 4)[3], 0);
    EXPECT_EQ(pixel(*image, 32, 24)[3], 255);
    const auto brightness = [&](int x) { return pixel(*image, x, 24)[0] + pixel(*image, x, 24)[1]; };
    EXPECT_GT(brightness(48), brightness(32)) << "90 degrees east";
    EXPECT_GT(brightness(48), brightness(16));
}

TEST(MonitorPictures, ThoseThatNeedDataHaveNone) {
    const Space space{.kind = SpaceKind::periodic_square};
    for (const char* name : {"image", "field", "derived", "combine"})
        EXPECT_FALSE(picture_of_monitor(monitor_type(name), subject_of(name, space))) << name;
    EXPECT_TRUE(picture_of_monitor(monitor_type("formula"), subject_of("formula", space)));
    MonitorSubject wrong = subject_of("formula", space);
    wrong.values.set("expression", std::string("1 +"));
    EXPECT_FALSE(picture_of_monitor(monitor_type("formula"), wrong));
}

TEST(MonitorPictures, EachIsComputedOnceAFewPerFrame) {
    const Space space{.kind = SpaceKind::periodic_square};
    const MonitorType ring = monitor_type("ring");
    std::vector<MonitorSubject> subjects;
    for (int i = 0; i < 7; ++i) {
        subjects.push_back(subject_of("ring", space));
        subjects.back().values.set("amplitude", 2.0 + i);
    }
    MonitorPictures pictures;
    int frames = 0;
    for (bool waiting = true; waiting && frames < 50; ++frames) {
        pictures.begin_frame();
        int found = 0;
        for (const auto& one : subjects) found += pictures.find(ring, one) ? 1 : 0;
        EXPECT_LE(found, 3 * (frames + 1));
        waiting = pictures.waiting();
    }
    EXPECT_EQ(frames, 3);
    pictures.begin_frame();
    const auto first = pictures.find(ring, subjects[0]), again = pictures.find(ring, subjects[0]);
    ASSERT_TRUE(first && again);
    EXPECT_EQ(first->low.x, again->low.x);
    const auto with_amplitude = [&](double amplitude) {
        MonitorSubject other = subjects[0];
        other.values.set("amplitude", amplitude);
        return other;
    };
    const auto is_before = [](const PicturePlace& a, const PicturePlace& b) {
        return std::pair(a.low.y, a.low.x) < std::pair(b.low.y, b.low.x);
    };
    std::optional<PicturePlace> last;
    int sheets_begun = 0;           // by places, as a new sheet may have the address of the old one
    for (int i = 0; i < 200; ++i) { // more than there is room for
        pictures.begin_frame();
        const auto before = pictures.find(ring, subjects[0]); // drawn before the others of this frame
        const auto found = pictures.find(ring, with_amplitude(20.0 + 0.1 * i));
        if (!before || !found) {
            EXPECT_TRUE(pictures.waiting()) << "it comes in the next frame";
            continue;
        }
        EXPECT_EQ(before->sheet, found->sheet) << "a sheet stays until the frame is drawn";
        if (last && is_before(*found, *last)) ++sheets_begun;
        last = found;
    }
    EXPECT_EQ(sheets_begun, 2);
}

class MonitorListTest : public ApplicationTest {};

TEST_F(MonitorListTest, EveryFormulaFitsIntoTheList) {
    const Theme theme = dark_theme();
    apply_theme(theme, 1);
    load_font(*ImGui::GetIO().Fonts, theme, 1);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    ui.frame([&] {
        const ImVec2 room = MonitorList::formula_room();
        for (const MonitorType& type : catalogue->monitors) {
            const auto listed = listed_formula(type, room);
            const bool phrase = type.equation.find("the formula") != std::string::npos;
            EXPECT_TRUE(listed || phrase) << type.name << ": " << type.equation;
        }
    });
}

TEST_F(MonitorListTest, TheListHasPicturesAndChooses) {
    ASSERT_TRUE(wait_until([&] { return run().snapshot != nullptr; }));
    frame();
    ui.click(application.items().find("monitor.type")->second, drawing());
    int frames = 0;
    for (frame(); application.window_state().animating && frames < 40; ++frames) frame();
    EXPECT_LT(frames, 20);
    const auto place = [&](const char* name) { return application.items().find(name)->second; };
    EXPECT_GT(place("monitor.type=ring").height(), 40) << "with a picture";
    EXPECT_GT(place("monitor.type=cross").top, place("monitor.type=combine").top)
        << "what does not fit comes last";
    ui.click(place("monitor.type=bell"), drawing());
    ASSERT_TRUE(wait_until([&] { return run().scenario.monitor.type == "bell"; }));
}

} // namespace
} // namespace gaspard
