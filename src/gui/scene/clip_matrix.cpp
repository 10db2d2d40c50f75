#include "gui/scene/clip_matrix.hpp"

#include <cmath>

namespace gaspard {

double view_depth(const Camera& camera, const Box& box) {
    const double offset = std::abs(dot(towards_viewer(camera), box.centre() - camera.centre));
    return 1.01 * (offset + box.size() / 2) + 1e-300;
}

glm::mat4 clip_matrix(const Camera& camera, Size size, Vec3 origin, double depth) {
    const Vec3 shift = origin - camera.centre;
    const struct {
        Vec3 axis;
        double factor;
    } rows[3] = {{camera.right, 2 / (camera.scale * size.width)},
                 {camera.up, 2 / (camera.scale * size.height)},
                 {towards_viewer(camera), -1 / depth}};
    glm::mat4 matrix(1.0F);
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = rows[i].factor * rows[i].axis;
        matrix[0][i] = static_cast<float>(axis.x);
        matrix[1][i] = static_cast<float>(axis.y);
        matrix[2][i] = static_cast<float>(axis.z);
        matrix[3][i] = static_cast<float>(dot(axis, shift));
    }
    return matrix;
}

} // namespace gaspard
