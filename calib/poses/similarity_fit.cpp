#include "calib/poses/similarity_fit.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace lumi {
namespace {

using Svd = Eigen::JacobiSVD<Eigen::Matrix3d>;

/// The centres of one world around their middle.
struct CentredCentres {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    Eigen::Matrix3Xd offsets;
    bool are_at_one_place = false;  ///< Up to rounding.
};

CentredCentres centred(const std::vector<PosePair>& pairs, Rigid3 PosePair::*cam_from_world) {
    CentredCentres result;
    result.offsets.resize(3, static_cast<Eigen::Index>(pairs.size()));
    double farthest = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Eigen::Vector3d centre = centre_in_world(pairs[i].*cam_from_world);
        result.offsets.col(static_cast<Eigen::Index>(i)) = centre;
        farthest = std::max(farthest, centre.norm());
    }
    result.middle = result.offsets.rowwise().mean();
    result.offsets.colwise() -= result.middle;
    constexpr double kRounding = 1e-9;
    const double spread =
        std::sqrt(result.offsets.squaredNorm() / static_cast<double>(pairs.size()));
    result.are_at_one_place = spread <= kRounding * farthest;
    return result;
}

Eigen::Matrix3d sum_of_rotations(const std::vector<PosePair>& pairs) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const PosePair& pair : pairs) {
        sum += (pair.cam_from_b.rotation.conjugate() * pair.cam_from_a.rotation).toRotationMatrix();
    }
    return sum;
}

/// The singular vectors from A, the last one flipped where the two sets would else be mirrored.
Eigen::Matrix3d unmirrored_v(const Svd& svd) {
    Eigen::Matrix3d v = svd.matrixV();
    if ((svd.matrixU() * v.transpose()).determinant() < 0) v.col(2) *= -1;
    return v;
}

Eigen::Quaterniond nearest_rotation(const Eigen::Matrix3d& b_from_a) {
    const Svd svd(b_from_a, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return Eigen::Quaterniond(svd.matrixU() * unmirrored_v(svd).transpose());
}

Eigen::Quaterniond rotation_of_centres(const Svd& svd, const std::vector<PosePair>& pairs) {
    // Of extents across and along the line; singular values are their squares.
    constexpr double kLineShare = 0.05;
    const Eigen::Matrix3d v = unmirrored_v(svd);
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    if (svd.singularValues()(1) <= kLineShare * kLineShare * svd.singularValues()(0)) {
        const Eigen::Matrix3d in_axes = svd.matrixU().transpose() * sum_of_rotations(pairs) * v;
        turn = Eigen::AngleAxisd(
                   std::atan2(in_axes(2, 1) - in_axes(1, 2), in_axes(1, 1) + in_axes(2, 2)),
                   Eigen::Vector3d::UnitX())
                   .toRotationMatrix();
    }
    return Eigen::Quaterniond(svd.matrixU() * turn * v.transpose());
}

}  // namespace

Eigen::Quaterniond mean_rotation(const std::vector<PosePair>& pairs) {
    return nearest_rotation(sum_of_rotations(pairs));
}

Similarity3 fit_with_rotation(const std::vector<PosePair>& pairs,
                              const Eigen::Quaterniond& rotation) {
    const CentredCentres a = centred(pairs, &PosePair::cam_from_a);
    const CentredCentres b = centred(pairs, &PosePair::cam_from_b);
    Similarity3 similarity;
    similarity.rotation = rotation;
    if (!a.are_at_one_place && !b.are_at_one_place) {
        const Eigen::Matrix3Xd turned = rotation.toRotationMatrix() * a.offsets;
        similarity.scale = turned.cwiseProduct(b.offsets).sum() / turned.squaredNorm();
    }
    similarity.translation = b.middle - similarity.scale * (rotation * a.middle);
    return similarity;
}

Similarity3 fit_centres(const std::vector<PosePair>& pairs) {
    const CentredCentres a = centred(pairs, &PosePair::cam_from_a);
    const CentredCentres b = centred(pairs, &PosePair::cam_from_b);
    if (a.are_at_one_place || b.are_at_one_place) {
        return fit_with_rotation(pairs, mean_rotation(pairs));
    }
    const Svd svd(b.offsets * a.offsets.transpose(), Eigen::ComputeFullU | Eigen::ComputeFullV);
    return fit_with_rotation(pairs, rotation_of_centres(svd, pairs));
}

}  // namespace lumi
