#include "pipeline/evaluate/moved_eye.h"

#include "render/transfer/scene_plane.h"

namespace lumi {

Eye moved_ahead(const Lumigraph& lumigraph, Eye eye, double share_of_distance) {
    const Eigen::Vector3d middle_px(0.5 * eye.camera.width_px, 0.5 * eye.camera.height_px, 1);
    const double inverse_depth = scene_plane_inverse_depth(lumigraph, eye).dot(middle_px);
    if (inverse_depth > 0) eye.cam_from_world.translation.z() -= share_of_distance / inverse_depth;
    return eye;
}

}  // namespace lumi
