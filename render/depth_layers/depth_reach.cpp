#include "render/depth_layers/depth_reach.h"

#include <algorithm>
#include <limits>

#include "render/transfer/pixel_transfer.h"

namespace lumi {

Eigen::AlignedBox3d box_of(const DepthMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3f& vertex : mesh.vertices) box.extend(vertex.cast<double>());
    return box;
}

double depth_reach(const LumigraphView& view, const Eigen::AlignedBox3d& box, const Eye& eye) {
    if (box.isEmpty()) return 0;
    const PixelTransfer eye_from_view =
        pixel_transfer(eye.camera, eye.cam_from_world, view.camera, view.cam_from_world);
    // Inverse depth in the eye is a ratio of two linear functions of pixel and inverse depth in the
    // view: where the lower one is positive, it is largest at a corner.
    double largest = 0;
    bool is_any_before = false;
    bool is_any_behind = false;
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
        const double depth_ratio = eye_from_view.at(corner.head<2>(), corner.z()).z();
        if (depth_ratio > 0) {
            is_any_before = true;
            largest = std::max(largest, corner.z() / depth_ratio);
        } else {
            is_any_behind = true;
        }
    }
    if (!is_any_before) return 0;
    return is_any_behind ? std::numeric_limits<double>::infinity() : largest;
}

}  // namespace lumi
