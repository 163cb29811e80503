#include "render/transfer/pixels_per_unit.h"

namespace lumi {

double pixels_per_unit(const Camera& camera, const Rigid3& cam_from_world,
                       const Eigen::Vector3d& point_in_world) {
    const double distance = (cam_from_world * point_in_world).norm();
    return distance > 0 ? focal_length_px(camera).maxCoeff() / distance : 0.0;
}

}  // namespace lumi
