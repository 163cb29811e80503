#include "render/rivals/resampled_lumigraph.h"

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "calib/work/median.h"
#include "render/reference/eye_depths.h"

namespace lumi {

Eigen::Vector2d seen_half_size(const Lumigraph& source) {
    std::vector<double> widths;
    std::vector<double> heights;
    for (const LumigraphView& view : source.views) {
        const double half_pixel = 0.5 *
                                  (view.cam_from_world * source.mesh.scene_centre_in_world).norm() /
                                  focal_length_px(view.camera).mean();
        widths.push_back(half_pixel * view.camera.width_px);
        heights.push_back(half_pixel * view.camera.height_px);
    }
    return {median_of(std::move(widths)), median_of(std::move(heights))};
}

Eigen::Matrix3d rotation_with_axis(const Eigen::Vector3d& z, const Eigen::Vector3d& down) {
    const Eigen::Vector3d x = down.cross(z).normalized();
    Eigen::Matrix3d rotation;
    rotation.row(0) = x;
    rotation.row(1) = z.cross(x);
    rotation.row(2) = z;
    return rotation;
}

Lumigraph resampled(const Lumigraph& source, LightFieldLayout layout, const DrawEye& draw) {
    Lumigraph result = without_its_views(source);
    result.mesh = std::move(layout.mesh);
    for (std::size_t i = 0; i < layout.eyes.size(); ++i) {
        const Eye& eye = layout.eyes[i];
        result.views.push_back(
            {"resampled " + std::to_string(i + 1), eye.camera, eye.cam_from_world, 1,
             draw(eye).color,
             source.has_depth() ? depth_map_at(source, eye, kAgreeingDisparity_px) : DepthMap{}});
    }
    return result;
}

}  // namespace lumi
