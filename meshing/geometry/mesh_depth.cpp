#include "meshing/geometry/mesh_depth.h"

#include <utility>

#include "calib/work/median.h"
#include "meshing/geometry/triangle_pixels.h"

namespace lumi {
namespace {

/// A corner as the camera sees it.
struct Corner {
    Eigen::Vector2d pixel;
    double inverse_depth = 0.0;
};

/// The nearest surface counts.
void draw(const Corner& a, const Corner& b, const Corner& c, DepthMap& map) {
    const auto keep_nearest = [&map](int x, int y, double inverse_depth) {
        const auto value = static_cast<float>(inverse_depth);
        if (map.confidence(x, y) != 0 && value <= map.inverse_depth(x, y)) return;
        map.inverse_depth(x, y) = value;
        map.confidence(x, y) = kKnown;
    };
    for_each_pixel_in_triangle(a, b, c, map.inverse_depth.width(), map.inverse_depth.height(),
                               keep_nearest);
}

/// The part of a triangle that lies beyond the near plane, as a polygon of up to four corners.
std::vector<Eigen::Vector3d> clipped(const std::array<Eigen::Vector3d, 3>& triangle, double near) {
    std::vector<Eigen::Vector3d> polygon;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d& a = triangle[i];
        const Eigen::Vector3d& b = triangle[(i + 1) % 3];
        if (a.z() >= near) polygon.push_back(a);
        if ((a.z() >= near) != (b.z() >= near)) {
            polygon.push_back(a + (near - a.z()) / (b.z() - a.z()) * (b - a));
        }
    }
    return polygon;
}

/// Where triangles are cut off before the camera: a millionth of the median depth of the corners
/// ahead, which one stray vertex does not move. 0 where none is ahead.
double near_plane(const std::vector<Eigen::Vector3d>& in_cam, const TriangleMesh& mesh) {
    constexpr double kNearShare = 1e-6;
    std::vector<bool> is_corner(in_cam.size());
    for (const auto& face : mesh.faces) {
        for (const std::uint32_t corner : face) is_corner[corner] = true;
    }
    std::vector<double> depths;
    for (std::size_t i = 0; i < in_cam.size(); ++i) {
        if (is_corner[i] && in_cam[i].z() > 0) depths.push_back(in_cam[i].z());
    }
    return kNearShare * median_of(std::move(depths));
}

}  // namespace

DepthMap mesh_depth(const DepthView& view, const TriangleMesh& mesh) {
    DepthMap map{FloatImage(view.camera.width_px, view.camera.height_px),
                 GrayImage(view.camera.width_px, view.camera.height_px)};
    std::vector<Eigen::Vector3d> in_cam;
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
        in_cam.push_back(view.cam_from_world * vertex);
    }
    const double near = near_plane(in_cam, mesh);
    if (near <= 0) return map;
    for (const auto& face : mesh.faces) {
        const std::vector<Eigen::Vector3d> polygon =
            clipped({in_cam[face[0]], in_cam[face[1]], in_cam[face[2]]}, near);
        std::vector<Corner> corners;
        for (const Eigen::Vector3d& corner : polygon) {
            if (const auto pixel = project(view.camera, corner)) {
                corners.push_back({*pixel, 1 / corner.z()});
            }
        }
        for (std::size_t i = 2; i < corners.size(); ++i) {
            draw(corners[0], corners[i - 1], corners[i], map);
        }
    }
    return map;
}

}  // namespace lumi
