#include "render/rivals/heigl.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "calib/capture/calibration_matrix.h"
#include "meshing/rivals/heigl_weights.h"
#include "render/rivals/planar_delaunay.h"
#include "render/transfer/polygon_clipping.h"

namespace lumi {

namespace {

/// Of the distance to what is nearest: so close to a camera the eye is there, and so close to its
/// plane the eye is no closer.
constexpr double kAtCamera = 1e-6;

/// All of the picture from one view.
FacePolygon picture_of(int view, const Eye& eye) {
    FacePolygon polygon;
    polygon.face_index = 0;
    polygon.view_indices = {view, view, view};
    polygon.side_lines = {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero(),
                          Eigen::Vector3d::Zero()};
    polygon.corners_px = picture_corners_px(eye.camera);
    return polygon;
}

}  // namespace

std::vector<FacePolygon> heigl_polygons(const Lumigraph& lumigraph, const Eye& eye) {
    const Eigen::Matrix3d pixel_from_eye = calibration_matrix(eye.camera);
    const Eigen::Vector3d eye_axis_in_world = optical_axis_in_world(eye.cam_from_world);
    const double scene_distance = 1 / scene_inverse_depths(lumigraph).near;
    std::vector<Eigen::Vector2d> pixels;
    std::vector<int> view_of_point;
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        const Rigid3& cam_from_world = lumigraph.views[i].cam_from_world;
        if (optical_axis_in_world(cam_from_world).dot(eye_axis_in_world) < kHeiglLeastCosine)
            continue;
        Eigen::Vector3d in_eye = eye.cam_from_world * centre_in_world(cam_from_world);
        const double closest = kAtCamera * scene_distance;
        if (in_eye.norm() < closest) return {picture_of(static_cast<int>(i), eye)};
        // In the eye's plane a centre has no place in the picture. Where all are, as of a planar
        // rig, both sides of it come to the same triangle and weights.
        in_eye.z() = std::copysign(std::max(std::abs(in_eye.z()), closest), in_eye.z());
        // Centres before the eye and behind it: what counts is the line through both.
        pixels.emplace_back((pixel_from_eye * in_eye).hnormalized());
        view_of_point.push_back(static_cast<int>(i));
    }
    std::vector<FacePolygon> polygons;
    for (const auto& triangle : planar_delaunay(pixels)) {
        Eigen::Matrix3d corners;
        FacePolygon polygon;
        polygon.face_index = static_cast<int>(polygons.size());
        for (std::size_t i = 0; i < 3; ++i) {
            const auto point = static_cast<std::size_t>(triangle[i]);
            corners.col(static_cast<Eigen::Index>(i)) = pixels[point].homogeneous();
            polygon.view_indices[i] = view_of_point[point];
        }
        const Eigen::Matrix3d weights_from_pixel = corners.inverse();
        polygon.corners_px = picture_corners_px(eye.camera);
        for (std::size_t i = 0; i < 3; ++i) {
            polygon.side_lines[i] = weights_from_pixel.row(static_cast<Eigen::Index>(i));
            polygon.corners_px = clipped(polygon.corners_px, polygon.side_lines[i]);
        }
        if (polygon.corners_px.size() >= 3) polygons.push_back(std::move(polygon));
    }
    return polygons;
}

bool corrects_depth_of_heigl(const Lumigraph& lumigraph, const RenderOptions& options) {
    return lumigraph.has_depth() && options.focal_plane.depth == 0;
}

Heigl::Heigl(const UploadedLumigraph& uploaded)
    : uploaded_(uploaded), light_field_(uploaded), with_depth_(uploaded) {}

DrawStatistics Heigl::draw(const Eye& eye, const RenderOptions& options, const Viewport&) {
    const std::vector<FacePolygon> polygons = heigl_polygons(uploaded_.layout, eye);
    return corrects_depth_of_heigl(uploaded_.layout, options)
               ? with_depth_.draw_polygons(polygons, eye, options)
               : light_field_.draw_polygons(polygons, eye, options);
}

}  // namespace lumi
