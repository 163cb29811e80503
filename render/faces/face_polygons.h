#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "meshing/surface/camera_mesh.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// How far polygons reach beyond their edges. GL snaps corners to 1/256 of a pixel, so this closes
/// every crack, and is too little to cover a pixel's centre that belongs to a neighbour visibly.
inline constexpr double kOverlap_px = 0.01;
/// For what is laid over the picture with blending, which must not happen twice.
inline constexpr double kNoOverlap_px = 0.0;

/// The part of the picture in which one face of the camera mesh is looked through.
///
/// The side products of a face (camera_mesh.h) are linear in the ray's direction, and a pinhole's
/// direction is affine in the pixel. So the pixels whose rays enter through the face form a convex
/// polygon, wherever the eye stands: outside the mesh, inside, on a face, or at a camera.
struct FacePolygon {
    int face_index = -1;  ///< -1: no face, but a strip with the weights of the eye.
    std::array<int, 3> view_indices{};
    /// 1 for corners beyond the border of the mesh, 0 for cameras.
    std::array<float, 3> beyond_border{};
    /// Side product i at pixel (x, y) is `side_lines[i]` . (x, y, 1); its largest value on the
    /// polygon is about 1. Their ratios are the blending weights.
    std::array<Eigen::Vector3d, 3> side_lines;
    /// Along the eye's ray through (x, y), in units of its depth, the face is crossed at
    /// `crossing_numerator` / (sum of side products).
    double crossing_numerator = 0.0;
    std::vector<Eigen::Vector2d> corners_px;  ///< Convex, without a fixed sense of rotation.
};

/// The polygons of all faces that are seen in the picture: at each pixel that of the face that
/// weights_of_ray chooses. Neighbours overlap by about a hundredth of a pixel, so that no crack
/// opens. A face can come in several pieces (paint_order.h). Of a mesh without faces they are the
/// strips of the eye's blends (blend_strips.h), which meet at whole columns and overlap nowhere.
[[nodiscard]] std::vector<FacePolygon> face_polygons(const CameraMesh& mesh, const Eye& eye,
                                                     double overlap_px = kOverlap_px);

/// Blending weights at a pixel of the polygon: side products, clamped at zero, over their sum;
/// where that is zero, as at the tip of a thin polygon that was widened, the largest product has
/// all.
[[nodiscard]] std::array<double, 3> weights_at(const FacePolygon& polygon,
                                               const Eigen::Vector2d& pixel);

}  // namespace lumi
