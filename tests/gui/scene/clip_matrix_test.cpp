#include "gui/scene/clip_matrix.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

constexpr Size window{800, 600};
const Box unit_square{{0, 0, 0}, {1, 1, 0}};
const Box unit_cube{{0, 0, 0}, {1, 1, 1}};

TEST(ClipMatrix, AgreesWithPixels) {
    for (const Box& box : {unit_square, unit_cube}) {
        Camera camera = home(box, window);
        pan(camera, {40, 9});
        const Vec3 origin = box.centre(), point{0.9, 0.3, box.high.z};
        const Vec3 local = point - origin;
        const glm::vec4 clip = clip_matrix(camera, window, origin, 2) *
                               glm::vec4(static_cast<float>(local.x), static_cast<float>(local.y),
                                         static_cast<float>(local.z), 1.0F);
        const Pixel pixel = to_pixel(camera, window, point);
        EXPECT_NEAR(static_cast<double>(clip.x), 2 * pixel.x / window.width - 1, 1e-6);
        EXPECT_NEAR(static_cast<double>(clip.y), 1 - 2 * pixel.y / window.height, 1e-6);
        EXPECT_LT(std::abs(clip.z), 1);
        EXPECT_EQ(clip.w, 1);
    }
}

TEST(ClipMatrix, NearerPointsHaveSmallerDepth) {
    const Camera camera = home(unit_cube, window);
    const glm::mat4 clip = clip_matrix(camera, window, {0, 0, 0}, 2);
    const float top = (clip * glm::vec4(0.5F, 0.5F, 1.0F, 1.0F)).z;
    const float bottom = (clip * glm::vec4(0.5F, 0.5F, 0.0F, 1.0F)).z;
    EXPECT_LT(top, bottom) << "seen from above";
}

TEST(ClipMatrix, FarFromTheOriginDigitsSurvive) {
    const Box far{{1e8, 1e8, 0}, {1e8 + 1, 1e8 + 1, 0}};
    const Camera camera = planar_home(far, window);
    const Vec3 origin = far.centre(), corner = far.high;
    const Vec3 local = corner - origin;
    const glm::vec4 clip = clip_matrix(camera, window, origin, 1) *
                           glm::vec4(static_cast<float>(local.x), static_cast<float>(local.y), 0.0F, 1.0F);
    EXPECT_NEAR(static_cast<double>(clip.y), 0.96, 1e-5);
}

} // namespace
} // namespace gaspard
