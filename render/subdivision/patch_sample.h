#pragma once

#include <Eigen/Core>
#include <array>

#include "render/faces/face_polygons.h"
#include "render/subdivision/blend_triangles.h"

namespace lumi {

/// What is known of the scene at one pixel of a face polygon.
struct PatchSample {
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    bool hits = false;  ///< The ray meets the scene; without, the scene plane stands in for it.
    double inverse_depth = 0.0;

    double confidence = 0.0;              ///< As in the confidence picture.
    double occluded = 0.0;                ///< Share of the ray's weight that is not seen.
    std::array<double, 3> ray_weights{};  ///< Barycentric: from the ray alone.
    std::array<double, 3> weights{};      ///< After occlusion correction; sum 1 or all 0.
    /// Zero where the point does not lie before the view.
    std::array<Eigen::Vector2d, 3> view_pixels{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(),
                                               Eigen::Vector2d::Zero()};
    std::array<double, 3> depth_ratios{};  ///< Depth in each view over depth in the eye.
    /// The depth that makes interpolation in the picture nearly right: one over the mean of these
    /// ratios, weighted as on the ray (VertexDepth::kAffine).
    double affine_depth = 1.0;
    double depth = 1.0;    ///< One over the inverse depth, not infinite.
    double opacity = 1.0;  ///< What is behind shows through the rest.
};

/// Which depth vertices are drawn with.
enum class VertexDepth {
    kAffine,  ///< Where photographs are looked up is interpolated right, but for how ratios differ.
    kTrue,    ///< Vertices lie at their places in space, for projective textures.
};

/// The sample as a corner of triangles.
[[nodiscard]] BlendVertex blend_vertex(const PatchSample& sample, const FacePolygon& polygon,
                                       VertexDepth depth);

}  // namespace lumi
