#include "render/transfer/pixel_transfer.h"

#include <Eigen/LU>

namespace lumi {

Eigen::Matrix3d pinhole_matrix(const Camera& camera) {
    const Eigen::Vector2d focal = focal_length_px(camera);
    const Eigen::Vector2d centre = principal_point_px(camera);
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    matrix(0, 0) = focal.x();
    matrix(1, 1) = focal.y();
    matrix.block<2, 1>(0, 2) = centre;
    return matrix;
}

PixelTransfer pixel_transfer(const Camera& target, const Rigid3& target_from_world,
                             const Camera& source, const Rigid3& source_from_world) {
    const Rigid3 target_from_source = target_from_world * inverse(source_from_world);
    const Eigen::Matrix3d target_matrix = pinhole_matrix(target);
    return {target_matrix * target_from_source.rotation.toRotationMatrix() *
                pinhole_matrix(source).inverse(),
            target_matrix * target_from_source.translation};
}

}  // namespace lumi
