#include "core/base/error.hpp"
#include "core/tessellate/camera.hpp"
#include "support/messages.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gaspard {
namespace {

constexpr Size size{800, 600};
const Box unit_square{{0, 0, 0}, {1, 1, 0}};
const Box unit_cube{{0, 0, 0}, {1, 1, 1}};

void expect_near(Vec3 a, Vec3 b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

/// Pixels of the box's corners: leftmost, topmost, rightmost, bottommost.
struct PixelExtent {
    double left = 1e300, top = 1e300, right = -1e300, bottom = -1e300;
};
PixelExtent extent(const Camera& camera, const Box& box) {
    PixelExtent e;
    for (const double x : {box.low.x, box.high.x})
        for (const double y : {box.low.y, box.high.y})
            for (const double z : {box.low.z, box.high.z}) {
                const Pixel p = to_pixel(camera, size, {x, y, z});
                e.left = std::min(e.left, p.x), e.right = std::max(e.right, p.x);
                e.top = std::min(e.top, p.y), e.bottom = std::max(e.bottom, p.y);
            }
    return e;
}

TEST(Camera, HomeCentresTheBoxAndFillsTheSmallerSide) {
    const PixelExtent e = extent(planar_home(unit_square, size), unit_square);
    EXPECT_NEAR((e.left + e.right) / 2, 400, 1e-9);
    EXPECT_NEAR((e.top + e.bottom) / 2, 300, 1e-9);
    EXPECT_NEAR(e.right - e.left, e.bottom - e.top, 1e-9);
    EXPECT_NEAR(e.bottom - e.top, 600 * 0.96, 1e-9);
}

TEST(Camera, HomeKeepsClearOfInsets) {
    const Insets insets{.left = 10, .top = 50, .right = 200, .bottom = 30};
    for (const Box& box : {unit_square, unit_cube}) {
        const PixelExtent e = extent(home(box, size, insets), box);
        EXPECT_GT(e.left, 10);
        EXPECT_LT(e.right, 600);
        EXPECT_GT(e.top, 50);
        EXPECT_LT(e.bottom, 570);
        EXPECT_NEAR((e.left + e.right) / 2, (10 + 600) / 2.0, 1e-9);
        EXPECT_NEAR((e.top + e.bottom) / 2, (50 + 570) / 2.0, 1e-9);
    }
}

TEST(Camera, HomeOfAPointOrALineIsUsable) {
    for (const Box& box : {Box{}, Box{{2, 2, 0}, {2, 2, 0}}, Box{{0, 0, 0}, {1, 0, 0}}}) {
        const Camera camera = home(box, size);
        EXPECT_GT(camera.scale, 0);
        EXPECT_TRUE(std::isfinite(camera.scale));
    }
    EXPECT_NEAR(home({{0, 0, 0}, {1, 0, 0}}, size).scale * 800 * 0.96, 1, 1e-12);
}

TEST(Camera, PlanarPicturesHaveXToTheRightAndYUp) {
    const Camera camera = planar_home(unit_square, size);
    const Pixel origin = to_pixel(camera, size, {0, 0, 0});
    EXPECT_GT(to_pixel(camera, size, {1, 0, 0}).x, origin.x);
    EXPECT_LT(to_pixel(camera, size, {0, 1, 0}).y, origin.y);
}

TEST(Camera, SpatialPicturesHaveZUpAndOrthonormalAxes) {
    const Camera camera = home(unit_cube, size);
    EXPECT_LT(to_pixel(camera, size, {0, 0, 1}).y, to_pixel(camera, size, {0, 0, 0}).y);
    EXPECT_NEAR(norm(camera.right), 1, 1e-15);
    EXPECT_NEAR(norm(camera.up), 1, 1e-15);
    EXPECT_NEAR(dot(camera.right, camera.up), 0, 1e-15);
    EXPECT_GT(cross(camera.right, camera.up).z, 0) << "seen from above";
}

TEST(Camera, PixelsAndPointsGoThereAndBack) {
    for (const Box& box : {unit_square, unit_cube}) {
        Camera camera = home(box, size, {.right = 90});
        pan(camera, {13, -57});
        zoom(camera, size, {100, 200}, 3.7, box);
        for (const Pixel pixel : {Pixel{0, 0}, Pixel{799, 3}, Pixel{123.25, 456.5}}) {
            const Pixel back = to_pixel(camera, size, to_world(camera, size, pixel));
            EXPECT_NEAR(back.x, pixel.x, 1e-9);
            EXPECT_NEAR(back.y, pixel.y, 1e-9);
        }
    }
}

TEST(Camera, PanMovesTheWorldWithThePointer) {
    Camera camera = home(unit_cube, size);
    const Vec3 point{0.2, 0.7, 0.4};
    const Pixel before = to_pixel(camera, size, point);
    pan(camera, {31, -12});
    const Pixel after = to_pixel(camera, size, point);
    EXPECT_NEAR(after.x - before.x, 31, 1e-9);
    EXPECT_NEAR(after.y - before.y, -12, 1e-9);
}

TEST(Camera, ZoomKeepsThePointUnderThePointer) {
    for (const double factor : {1.1, 0.9, 25.0, 1 / 25.0}) {
        Camera camera = planar_home(unit_square, size);
        const double before = camera.scale;
        const Pixel pointer{650, 80};
        const Vec3 under = to_world(camera, size, pointer);
        zoom(camera, size, pointer, factor, unit_square);
        expect_near(to_world(camera, size, pointer), under, 1e-12);
        EXPECT_EQ(camera.scale<before, factor> 1);
    }
}

TEST(Camera, ZoomStopsWhereDoublePrecisionDoes) {
    Camera camera = planar_home(unit_square, size);
    for (int i = 0; i < 1000; ++i) zoom(camera, size, {10, 10}, 1.5, unit_square);
    EXPECT_GT(camera.scale, 1e-14);
    for (int i = 0; i < 1000; ++i) zoom(camera, size, {10, 10}, 1 / 1.5, unit_square);
    EXPECT_LT(camera.scale, 1e3);
    EXPECT_TRUE(std::isfinite(camera.centre.x));
}

TEST(Camera, DirectionsLookAlongTheAxes) {
    struct Row {
        const char* name;
        Vec3 towards_viewer, up;
    };
    for (const Row& row : {Row{"front", {0, -1, 0}, {0, 0, 1}}, Row{"back", {0, 1, 0}, {0, 0, 1}},
                           Row{"left", {-1, 0, 0}, {0, 0, 1}}, Row{"right", {1, 0, 0}, {0, 0, 1}},
                           Row{"top", {0, 0, 1}, {0, 1, 0}}, Row{"bottom", {0, 0, -1}, {0, -1, 0}}}) {
        const Camera camera = home(unit_cube, size, {}, row.name);
        EXPECT_EQ(towards_viewer(camera), row.towards_viewer) << row.name;
        EXPECT_EQ(camera.up, row.up) << row.name;
        const PixelExtent e = extent(camera, unit_cube);
        EXPECT_NEAR(e.bottom - e.top, 600 * 0.96, 1e-9) << row.name;
    }
    EXPECT_EQ(home(unit_square, size, {}, "left"), planar_home(unit_square, size)) << "a plane has one side";
}

TEST(Camera, FitsWhatItSeesOfPointsRatherThanTheirBox) {
    Points ball(2000);
    for (std::size_t i = 0; i < ball.size(); ++i) { // a spiral on the unit sphere
        const double z = 1 - 2 * (static_cast<double>(i) + 0.5) / 2000, r = std::sqrt(1 - z * z);
        ball.set(i,
                 {r * std::cos(2.4 * static_cast<double>(i)), r * std::sin(2.4 * static_cast<double>(i)), z});
    }
    Camera camera = home(bounding_box(ball), size);
    const double loose = camera.scale;
    fit_points(camera, {&ball}, size, {});
    EXPECT_LT(camera.scale, 0.8 * loose);
    EXPECT_NEAR(2 / camera.scale, 600 * 0.96, 2);
    const Camera before = camera;
    Points nothing(1);
    nothing.x[0] = std::numeric_limits<double>::quiet_NaN();
    fit_points(camera, {&nothing}, size, {});
    EXPECT_EQ(camera, before);
}

TEST(Camera, TextReadsBackToTheSameTextAndTheSameView) {
    for (const Box& box : {unit_square, unit_cube}) {
        Camera camera = home(box, size, {.right = 77});
        zoom(camera, size, {100, 200}, 1e5 / 3, box);
        rotate(camera, size, {31, -17}, box.centre());
        const std::string text = format_camera(camera, size);
        EXPECT_EQ(text.find('\n'), std::string::npos);
        const Camera back = parse_camera(text, size);
        EXPECT_EQ(format_camera(back, size), text);
        EXPECT_EQ(back.centre, camera.centre);
        EXPECT_EQ(back.right, camera.right);
        EXPECT_EQ(back.up, camera.up);
        EXPECT_NEAR(back.scale / camera.scale, 1, 1e-11);
    }
    EXPECT_EQ(format_camera({{0.5, 0.25, 0}, 0.002}, size), "centre 0.5 0.25 0 height 1.2");
}

TEST(Camera, TextMeansTheSameInAPictureOfAnotherSize) {
    const std::string text = "centre 0.5 0.5 height 1.2";
    const Size larger{1600, 1200};
    const Camera small = parse_camera(text, size), large = parse_camera(text, larger);
    const Pixel in_small = to_pixel(small, size, {0.2, 0.9, 0}),
                in_large = to_pixel(large, larger, {0.2, 0.9, 0});
    EXPECT_NEAR(in_large.x, 2 * in_small.x, 1e-9);
    EXPECT_NEAR(in_large.y, 2 * in_small.y, 1e-9);
}

TEST(Camera, ATextOfAxesAloneMeansAllOfTheMesh) {
    const Camera camera = home({{-1, -1, -1}, {1, 1, 1}}, {800, 600});
    const std::string text = format_axes(camera);
    EXPECT_TRUE(shows_all(text)) << text;
    const Camera read = parse_camera(text, {800, 600});
    EXPECT_EQ(read.right, camera.right);
    EXPECT_EQ(read.up, camera.up);
    EXPECT_EQ(format_axes(read), text);
    EXPECT_FALSE(shows_all(""));
    EXPECT_FALSE(shows_all(format_camera(camera, {800, 600})));
    EXPECT_THROW(parse_camera("right 1 0 0", {800, 600}), InputError);
}

TEST(Camera, ABallFillsWhatIsFreeHoweverItIsTurned) {
    for (const char* direction : {"home", "front", "top"}) {
        Camera camera = spatial_home({{-2, -2, -2}, {2, 2, 2}}, {800, 600}, {}, direction);
        fit_ball(camera, {}, 2, {800, 600}, {.right = 100});
        EXPECT_NEAR(4 / camera.scale, 0.96 * 600, 1e-9);
        EXPECT_NEAR(to_pixel(camera, {800, 600}, {}).x, 350, 1e-9);
        EXPECT_NEAR(to_pixel(camera, {800, 600}, {}).y, 300, 1e-9);
    }
}

TEST(Camera, TextMayBeTypedByHand) {
    const Camera camera = parse_camera("  center 1,2,3\theight 2 up 0 0 5 right 3 0 1e-3 ", {100, 100});
    EXPECT_EQ(camera.centre, (Vec3{1, 2, 3}));
    EXPECT_EQ(camera.scale, 0.02);
    EXPECT_NEAR(norm(camera.right), 1, 1e-15);
    EXPECT_NEAR(norm(camera.up), 1, 1e-15);
    EXPECT_NEAR(dot(camera.right, camera.up), 0, 1e-15);
    EXPECT_GT(camera.up.z, 0.99);
}

TEST(Camera, TextThatIsNoneIsRefusedInASentence) {
    const auto refused = [](const char* text) {
        return message_of<InputError>([&] { parse_camera(text, size); });
    };
    for (const auto& [text, why] : {std::pair{"", "'centre'"},
                                    {"centre 1", "3 numbers after 'centre'"},
                                    {"centre 1 2", "1 number after 'height'"},
                                    {"centre 1 2 height 0", "a height from 10⁻⁵⁰ to 10²⁰"},
                                    {"centre 1 2 height -3", "a height from 10⁻⁵⁰ to 10²⁰"},
                                    {"centre 1 2 height 1e300", "a height from 10⁻⁵⁰ to 10²⁰"},
                                    {"centre 1 2 height 1e-300", "a height from 10⁻⁵⁰ to 10²⁰"},
                                    {"centre 1 1e300 height 1", "coordinates from −10²⁰ to 10²⁰"},
                                    {"right 1e200 0 0 up 0 1 0", "lengths from 10⁻²⁰ to 10²⁰"},
                                    {"right 1 0 0 up 0 1e-200 0", "lengths from 10⁻²⁰ to 10²⁰"},
                                    {"centre 1 2 height nan", "the word 'nan'"},
                                    {"centre 1 2 height 1 2", "1 number after 'height'"},
                                    {"centre 1 2 3 4 height 1", "3 numbers after 'centre'"},
                                    {"middle 1 2 height 1", "the word 'middle'"},
                                    {"centre 1 2 height 1 centre 1 2", "'centre' twice"},
                                    {"centre 1 2 height 1 up 0 1", "3 numbers after 'up'"},
                                    {"centre 1 2 height 1 right 1 0 0 up 2 0 0", "different directions"},
                                    {"centre 1 2 height 1 right 0 0 0", "lengths from 10⁻²⁰ to 10²⁰"},
                                    {"7", "the word '7'"}}) {
        EXPECT_NE(refused(text).find(why), std::string::npos) << text << ": " << refused(text);
        EXPECT_NE(refused(text).find("a camera reads 'centre 0.5 0.5 0 height"), std::string::npos) << text;
    }
}

TEST(Camera, ABallTurnsUnderThePointer) {
    Camera camera = home({{-1, -1, -1}, {1, 1, 1}}, size);
    const Vec3 front = towards_viewer(camera); // of the unit ball
    const double before = to_pixel(camera, size, front).x;
    rotate(camera, size, {10, 0}, {0, 0, 0});
    EXPECT_GT(to_pixel(camera, size, front).x, before) << "what is in front goes with the pointer";
    EXPECT_NEAR(to_pixel(camera, size, front).y, 300, 1e-9);
    rotate(camera, size, {0, 25}, {0, 0, 0});
    EXPECT_GT(to_pixel(camera, size, front).y, 300);
    rotate(camera, size, {0, 0}, {0, 0, 0});
    for (int i = 0; i < 2000; ++i) rotate(camera, size, {static_cast<double>(i % 7 - 3), 2.5}, {0.3, 0, 1});
    EXPECT_NEAR(norm(camera.right), 1, 1e-14);
    EXPECT_NEAR(norm(camera.up), 1, 1e-14);
    EXPECT_NEAR(dot(camera.right, camera.up), 0, 1e-14);
    Camera half = home(unit_cube, size);
    const Camera start = half;
    rotate(half, size, {600, 0}, unit_cube.centre()); // across the smaller side
    expect_near(half.right, -1 * start.right, 1e-12);
    expect_near(half.centre, start.centre, 1e-12);
}

/// Where the ray through a pixel meets the unit ball from the viewer's side.
Vec3 on_ball(const Camera& camera, Pixel pixel) {
    const Vec3 p = to_world(camera, size, pixel), view = towards_viewer(camera);
    const Vec3 across = p - dot(p, view) * view;
    return across + std::sqrt(1 - dot(across, across)) * view;
}

TEST(Camera, ABallFollowsThePointerAtAnyZoom) {
    for (const double closer : {1.0, 7.0, 1000.0}) {
        Camera camera = home({{-1, -1, -1}, {1, 1, 1}}, size);
        zoom(camera, size, {430, 250}, closer, {{-1, -1, -1}, {1, 1, 1}});
        for (const auto& [from, to] :
             {std::pair{Pixel{420, 310}, Pixel{380, 260}}, {{390, 290}, {470, 330}}}) {
            const Vec3 held = on_ball(camera, from);
            const double scale = camera.scale;
            turn_ball(camera, size, from, to, {}, 1);
            const Pixel now = to_pixel(camera, size, held);
            EXPECT_NEAR(now.x, to.x, 1e-6 * closer) << closer;
            EXPECT_NEAR(now.y, to.y, 1e-6 * closer) << closer;
            EXPECT_EQ(camera.scale, scale);
            EXPECT_NEAR(dot(camera.right, camera.up), 0, 1e-14);
        }
    }
}

TEST(Camera, ABallTurnsEvenlyBesideItAndNothingHappensWhereNothingMoves) {
    Camera camera = home({{-1, -1, -1}, {1, 1, 1}}, size);
    const Camera before = camera;
    turn_ball(camera, size, {300, 200}, {300, 200}, {}, 1);
    EXPECT_EQ(camera, before);
    double largest = 0;
    for (int x = 0; x < 799; ++x) { // over the rim and on
        const Camera at = camera;
        turn_ball(camera, size, {x + 0.0, 300}, {x + 1.0, 300}, {}, 1);
        largest = std::max(largest, std::acos(std::min(1.0, dot(at.right, camera.right))));
    }
    EXPECT_LT(largest, 0.02) << "no leap at the rim";
}

TEST(Camera, FromBehindOneSeesTheOtherSideAndTwiceIsNothing) {
    Camera camera = home(unit_cube, size);
    pan(camera, {40, -25});
    zoom(camera, size, {100, 200}, 3, unit_cube);
    const Vec3 pivot{0.1, 0.2, 0.3};
    const Camera behind = from_behind(camera, pivot);
    EXPECT_EQ(behind.scale, camera.scale);
    expect_near(towards_viewer(behind), -1 * towards_viewer(camera), 1e-15);
    EXPECT_EQ(behind.up, camera.up);
    const Camera again = from_behind(behind, pivot);
    expect_near(again.centre, camera.centre, 1e-14);
    expect_near(again.right, camera.right, 1e-15);
    // Mirrored, as one walks around: left is right, up is up.
    const Vec3 point{0.7, -0.2, 0.4};
    const Pixel front = to_pixel(camera, size, point), rear = to_pixel(behind, size, point),
                middle = to_pixel(camera, size, pivot), rear_middle = to_pixel(behind, size, pivot);
    EXPECT_NEAR(front.x - middle.x, rear_middle.x - rear.x, 1e-9);
    EXPECT_NEAR(front.y, rear.y, 1e-9);
}

TEST(Camera, APointComesToTheFrontByTheShortestWay) {
    const Vec3 pivot{1, -2, 0.5};
    for (const Vec3 where : {Vec3{3, 1, 2}, Vec3{1, -2, 9}, Vec3{-4, 0, 0.5}}) {
        Camera camera = home(unit_cube, size);
        bring_to_front(camera, where, pivot);
        const Vec3 direction = (1 / norm(where - pivot)) * (where - pivot);
        expect_near(towards_viewer(camera), direction, 1e-12);
        bring_to_front(camera, pivot - 2 * direction, pivot); // from the very back
        expect_near(towards_viewer(camera), -1 * direction, 1e-12);
    }
}

TEST(Camera, SpinsEastwardAboutTheVerticalAxis) {
    Camera camera = home({{-1, -1, -1}, {1, 1, 1}}, size, {}, "right"); // from +x: east is to the right
    const Vec3 front{1, 0, 0}, pole{0, 0, 1};
    const Pixel before = to_pixel(camera, size, front), top = to_pixel(camera, size, pole);
    spin(camera, 0.1, {});
    EXPECT_GT(to_pixel(camera, size, front).x, before.x);
    EXPECT_NEAR(to_pixel(camera, size, pole).x, top.x, 1e-9);
    EXPECT_NEAR(to_pixel(camera, size, pole).y, top.y, 1e-9);
}

TEST(BoundingBox, LeavesOutWhatIsNotFinite) {
    Points points(3);
    points.set(0, {1, 2, 3});
    points.set(1, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
    points.set(2, {-1, 5, 3});
    EXPECT_EQ(bounding_box(points), (Box{{-1, 2, 3}, {1, 5, 3}}));
    EXPECT_EQ(bounding_box(Points{}), Box{});
}

} // namespace
} // namespace gaspard
