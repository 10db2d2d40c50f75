#include "gui/app/frame_pacing.hpp"

#include <gtest/gtest.h>

namespace gaspard {

namespace {

constexpr FrameCauses input{.input = true}, news{.news = true}, image{.image = true}, nothing{};

/// One whose first frames are over, and which began its last one at time 10.
FramePacing resting_window() {
    FramePacing pacing;
    for (int i = 0; i < 5; ++i) {
        pacing.begin(nothing, 10);
        pacing.end(0.04, false);
    }
    return pacing;
}

/// A frame that took an input at time 20 and has changed something.
FramePacing window_in_gesture() {
    FramePacing pacing = resting_window();
    pacing.begin(input, 20);
    pacing.end(0.04, true);
    return pacing;
}

} // namespace

TEST(FramePacing, SleepsUntilSomethingHappens) {
    const FramePacing pacing = resting_window();
    EXPECT_TRUE(pacing.may_sleep(nothing));
    EXPECT_FALSE(pacing.may_sleep(news));
    EXPECT_FALSE(pacing.may_sleep(image));
    EXPECT_FALSE(pacing.may_sleep({.animating = true}));
}

TEST(FramePacing, DrawsTwoMoreFramesAfterAnInput) {
    FramePacing pacing = window_in_gesture();
    for (int frame = 0; frame < 2; ++frame) {
        EXPECT_FALSE(pacing.may_sleep(nothing));
        EXPECT_LE(pacing.rest(nothing, 20.001), 0) << "the reaction is not delayed";
        pacing.begin(nothing, 20.001);
        pacing.end(0.001, true);
    }
    EXPECT_TRUE(pacing.may_sleep(nothing));
}

TEST(FramePacing, TheFirstNewsAfterAnInputAreDrawnAtOnce) {
    FramePacing pacing = window_in_gesture();
    EXPECT_LE(pacing.rest(news, 20.001), 0);
    pacing.begin(news, 20.001);
    pacing.end(0.04, true);
    EXPECT_NEAR(pacing.rest(news, 20.002), 1.0 / 60 - 0.001, 1e-9) << "further ones are paced";
    pacing.begin(input, 20.1);
    pacing.end(0.04, true);
    EXPECT_LE(pacing.rest(news, 20.101), 0) << "the next input is answered as well";
}

TEST(FramePacing, AnImageThatIsThereIsShownAtOnce) {
    EXPECT_LE(window_in_gesture().rest(image, 20.001), 0);
    EXPECT_GT(resting_window().rest(image, 10.001), 0) << "nobody touches the window";
}

TEST(FramePacing, FurtherInputsWaitForTheNextFrame) {
    EXPECT_NEAR(window_in_gesture().rest(input, 20.001), 1.0 / 60 - 0.001, 1e-9);
}

TEST(FramePacing, AnInputThatHasChangedNothingYetIsFollowedAtOnce) {
    FramePacing pacing = resting_window();
    pacing.begin(input, 20);
    pacing.end(0.04, false);
    EXPECT_LE(pacing.rest(input, 20.001), 0);
}

TEST(FramePacing, SlowDrawingLeavesHalfOfTheTimeToTheSolver) {
    const FramePacing pacing = resting_window();
    EXPECT_NEAR(pacing.rest(news, 10.001), 2 * 0.04 - 0.001, 1e-9);
    EXPECT_NEAR(pacing.rest(input, 10.001), 1.0 / 60 - 0.001, 1e-9) << "but not an input";
}

TEST(FramePacing, AGestureEndsHalfASecondAfterTheLastInput) {
    const FramePacing pacing = window_in_gesture();
    EXPECT_TRUE(pacing.in_gesture(20.4));
    EXPECT_FALSE(pacing.in_gesture(20.6));
}

} // namespace gaspard
