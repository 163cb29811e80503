#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/modes/blend_triangles.h"
#include "render/modes/face_polygons.h"

namespace lumi {

/// A photograph as a plane shows it: its homogeneous pixel from the eye's (x, y, 1).
struct PlaneView {
    Eigen::Matrix3d view_from_eye = Eigen::Matrix3d::Identity();
    double width_px = 0.0;
    double height_px = 0.0;
};

struct AffinePieceOptions {
    double max_error_px = 0.06;       ///< Of where a photograph is looked up, times its weight.
    double max_weight_error = 0.004;  ///< Of the weights: one step of 8 bits.
    double border_px = 8.0;  ///< A photograph fades in over this many pixels (shaders/face.glsl).
    double min_size_px = 24.0;  ///< Pieces in which a border lies are not cut further.
};

/// A face polygon, cut into pieces that are drawn faster than pixel by pixel.
///
/// A homography is affine on a piece that is small enough: with homogeneous third coordinates
/// between W and W' and pixels within a diameter d, linear interpolation is wrong by at most
/// d / 2 * (W' - W) / (W' + W). `affine` gets the pieces for which that is little and on which each
/// photograph is either fully in or out; `exact` those through which a border runs: polygons as
/// they were, with fewer corners. Cuts run along rows and columns, so that no crack opens.
void cut_into_affine_pieces(const FacePolygon& polygon, const std::vector<PlaneView>& views,
                            const Eigen::Vector3d& plane_inverse_depth,
                            const AffinePieceOptions& options, BlendTriangles& affine,
                            std::vector<FacePolygon>& exact);

}  // namespace lumi
