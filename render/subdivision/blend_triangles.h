#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lumi {

/// A place in a picture, as vertices hold it.
[[nodiscard]] inline Eigen::Vector2d vector_of(const std::array<float, 2>& pixel) {
    return {static_cast<double>(pixel[0]), static_cast<double>(pixel[1])};
}

/// A corner of a triangle of the eye's picture on which three photographs are blended; all floats,
/// as the vertex buffer holds them.
struct BlendVertex {
    std::array<float, 2> pixel{};  ///< Of the eye.
    /// Homogeneous coordinate of the vertex: all that varies is interpolated linearly in space as
    /// if it were the depth, so that perspective is right where it is.
    float depth = 1.0F;
    std::array<std::array<float, 2>, 3> view_pixels{};  ///< Where the photographs are looked up.
    std::array<float, 3> weights{};                     ///< Of the photographs; sum 1, or all 0.
    float inverse_depth = 0.0F;
    float confidence = 0.0F;             ///< 0 to 1, of the depth; 0 for a guess.
    float occluded = 0.0F;               ///< Share of the ray's weight that occlusion takes.
    std::array<float, 3> view_layers{};  ///< Indices of the views; the same on a triangle.
    float face_index = -1.0F;
    std::array<float, 3> depth_ratios{};  ///< Depth in each view over depth in the eye.
    float opacity = 1.0F;                 ///< What is behind shows through the rest.
    /// What lies there where no photograph shows anything (triangle_surroundings.h): red, green,
    /// blue, 0 to 255; below 0 where it was not asked for.
    std::array<float, 3> surroundings{-1.0F, -1.0F, -1.0F};
};

/// How much photograph k counts at a corner; where a face names a camera twice, both together.
[[nodiscard]] inline float weight_of_photograph(std::size_t k, const BlendVertex& corner) {
    float sum = 0;
    for (std::size_t other = 0; other < corner.weights.size(); ++other)
        if (corner.view_layers[other] == corner.view_layers[k]) sum += corner.weights[other];
    return sum;
}

/// The scale of confidence in drawn depth, from 1, where two views agree, down to 0 for a guess:
/// what one view alone has seen, what was filled, and what is stretched over a tear or lies behind
/// what is. As in shaders/per_pixel.glsl.
inline constexpr float kSeenByOne = 0.5F;
inline constexpr float kFilledConfidence = 0.25F;
inline constexpr float kStretchedConfidence = 0.125F;

/// Half of what a fill is worth: what is less sure than this is more of a guess.
inline constexpr float kLeastConfidence = 0.5F * kFilledConfidence;

/// Triangles that are drawn by the blend of shaders/blend.glsl, in this order.
struct BlendTriangles {
    std::vector<BlendVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< Three a triangle.

    [[nodiscard]] std::size_t count() const { return indices.size() / 3; }
    void clear() {
        vertices.clear();
        indices.clear();
    }
};

}  // namespace lumi
