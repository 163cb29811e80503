#pragma once

#include <Eigen/Core>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace lumi {

/// The only file where Eigen's types become GLM's. Pixels count downwards from the top, GL's clip
/// and window coordinates upwards.

[[nodiscard]] inline glm::mat4 to_glm(const Eigen::Matrix4d& matrix) {
    glm::mat4 result;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            result[column][row] = static_cast<float>(matrix(row, column));
    return result;
}

[[nodiscard]] inline glm::vec2 to_glm(const Eigen::Vector2d& vector) {
    return {static_cast<float>(vector.x()), static_cast<float>(vector.y())};
}

[[nodiscard]] inline glm::vec4 to_glm(const Eigen::Vector4d& vector) {
    return {static_cast<float>(vector.x()), static_cast<float>(vector.y()),
            static_cast<float>(vector.z()), static_cast<float>(vector.w())};
}

/// Clip coordinates of the homogeneous pixel (X, Y, W) of a picture with inverse depth q / W, given
/// as (X, Y, W, q). The GL depth is affine in inverse depth: 0 at `max_inverse_depth`, 1 at
/// infinity.
[[nodiscard]] inline Eigen::Matrix4d clip_from_pixel(int width_px, int height_px,
                                                     double max_inverse_depth) {
    Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
    clip.row(0) << 2.0 / width_px, 0, -1, 0;
    clip.row(1) << 0, -2.0 / height_px, 1, 0;
    clip.row(2) << 0, 0, 1, -2 / max_inverse_depth;
    clip.row(3) << 0, 0, 1, 0;
    return clip;
}

/// The homogeneous pixel of a picture from its window coordinates (x, y, 1).
[[nodiscard]] inline Eigen::Matrix3d pixel_from_window(int height_px) {
    Eigen::Matrix3d pixel = Eigen::Matrix3d::Identity();
    pixel.row(1) << 0, -1, height_px;
    return pixel;
}

/// The row of a framebuffer, counted from the bottom, that holds row `y` of the picture.
[[nodiscard]] inline int framebuffer_row(int y, int height_px) { return height_px - 1 - y; }

}  // namespace lumi
