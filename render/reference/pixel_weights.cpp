#include "render/reference/pixel_weights.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "meshing/surface/camera_mesh.h"

namespace lumi {
namespace {

/// Those of the polygon that the pixel lies in.
std::optional<RayWeights> weights_within(const std::vector<FacePolygon>& polygons,
                                         const Eigen::Vector2d& pixel) {
    for (const FacePolygon& polygon : polygons) {
        const bool is_within = std::all_of(
            polygon.side_lines.begin(), polygon.side_lines.end(),
            [&](const Eigen::Vector3d& line) { return line.dot(pixel.homogeneous()) >= 0; });
        if (is_within)
            return RayWeights{polygon.face_index, polygon.view_indices, weights_at(polygon, pixel),
                              0.0};
    }
    return std::nullopt;
}

}  // namespace

PixelWeights::PixelWeights(const CameraMesh& mesh, const Eye& eye,
                           const std::optional<std::vector<FacePolygon>>& polygons)
    : mesh_(mesh), polygons_(polygons), eye_in_world_(centre_in_world(eye.cam_from_world)) {
    if (!mesh.faces.empty()) return;
    blends_ = blends_of_eye(mesh, eye_in_world_, optical_axis_in_world(eye.cam_from_world));
    strip_ends_ = blend_strip_ends(blends_, eye.camera.width_px);
}

std::optional<RayWeights> PixelWeights::at(const Eigen::Vector2d& pixel,
                                           const Eigen::Vector3d& direction_in_world) const {
    if (polygons_) return weights_within(*polygons_, pixel);
    if (blends_.empty()) return weights_of_ray(mesh_, eye_in_world_, direction_in_world);
    return blends_[strip_at(strip_ends_, pixel.x())].weights;
}

std::optional<std::array<double, 3>> of_those_that_show(std::array<double, 3> weights,
                                                        const std::array<double, 3>& shown) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += weights[i] *= shown[i];
    if (!(sum > 0)) return std::nullopt;
    for (double& weight : weights) weight /= sum;
    return weights;
}

}  // namespace lumi
