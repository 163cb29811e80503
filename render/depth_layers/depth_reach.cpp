#include "render/depth_layers/depth_reach.h"

#include <algorithm>
#include <limits>

#include "calib/capture/inverse_depth_warp.h"

namespace lumi {

Eigen::AlignedBox3d box_of(const DepthMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3f& vertex : mesh.vertices) box.extend(vertex.cast<double>());
    return box;
}

double depth_reach(const LumigraphView& view, const Eigen::AlignedBox3d& box, const Eye& eye) {
    if (box.isEmpty()) return 0;
    const InverseDepthWarp eye_from_view = warp_from(view).to(eye);
    // Inverse depth in the eye is a ratio of two linear functions of pixel and inverse depth in the
    // view: where the lower one is positive, it is largest at a corner.
    double largest = 0;
    bool is_any_before = false;
    bool is_any_behind = false;
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
        const auto in_eye = eye_from_view.at(corner.head<2>(), corner.z());
        if (in_eye) {
            is_any_before = true;
            largest = std::max(largest, in_eye->inverse_depth);
        } else {
            is_any_behind = true;
        }
    }
    if (!is_any_before) return 0;
    return is_any_behind ? std::numeric_limits<double>::infinity() : largest;
}

}  // namespace lumi
