#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/depth_search/occlusion.h"
#include "render/faces/face_polygons.h"
#include "render/subdivision/blend_triangles.h"

namespace lumi {

/// A photograph seen by way of a plane: maps the eye's (x, y, 1) to its homogeneous pixel.
struct PlaneView {
    Eigen::Matrix3d view_from_eye = Eigen::Matrix3d::Identity();
    double width_px = 0.0;
    double height_px = 0.0;
};

struct AffinePieceOptions {
    double max_error_px = 0.04;  ///< Error of a place in a photograph, times the most it may count.
    double max_weight_error = 0.02;
    /// How far inside of its border a photograph surely counts (photograph_lod.h).
    double unsure_border_px = kFinestBorder_px;
};

/// A face polygon, cut into pieces that are drawn faster than pixel by pixel.
///
/// A homography is affine on a piece that is small enough: with homogeneous third coordinates
/// between W and W' and pixels within a diameter d, linear interpolation is wrong by at most
/// d / 2 * (W' - W) / (W' + W), always to one side; moved by half of that, by half as much. The
/// mean of the photographs' W, weighted as they count, is left to the rasteriser's perspective
/// division; only what differs from it must be affine, so that pieces can be large. `affine` gets
/// them. `exact` gets, as polygons, the few small pieces that are not affine even so, and those
/// crossed by the border of a photograph that has nearly all the weight: beyond it only tiny
/// weights remain, which must not be interpolated across the piece. What lies beyond the borders of
/// all three photographs is left out.
void cut_into_affine_pieces(const FacePolygon& polygon, const std::vector<PlaneView>& views,
                            const Eigen::Vector3d& plane_inverse_depth,
                            const AffinePieceOptions& options, BlendTriangles& affine,
                            std::vector<FacePolygon>& exact);

}  // namespace lumi
