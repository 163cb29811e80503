#pragma once

#include <cstddef>
#include <vector>

#include "calib/capture/rigid3.h"

namespace lumi {

/// What it takes from one pose to another: a turn by one radian counts as much as a way of
/// `length_per_rad`.
[[nodiscard]] double pose_distance(const Rigid3& from, const Rigid3& to, double length_per_rad);

/// A smooth curve through poses in their order, of one piece between each two; a pose that is the
/// same as the one before it is passed over.
///
/// Centres run on a centripetal Catmull-Rom curve, which makes neither loops nor cusps within a
/// piece (Yuksel, Schaefer, Keyser, Parameterization and Applications of Catmull-Rom Curves, 2011):
/// knots lie apart by the square root of pose_distance, each piece is a cubic Bezier curve with the
/// velocity at a pose of the parabola through it and its two neighbours. Rotations run alike by de
/// Casteljau's construction with slerp for lerp (Shoemake, Animating Rotation with Quaternion
/// Curves, 1985). Direction and turn go on smoothly through the poses.
class PoseCurve {
 public:
    /// Of at least one pose.
    PoseCurve(const std::vector<Rigid3>& cam_from_world, double length_per_rad);

    [[nodiscard]] std::size_t pieces() const { return stations_.size() - 1; }
    /// At a place from 0 to `pieces()`; at whole numbers the pose itself.
    [[nodiscard]] Rigid3 at(double place) const;

 private:
    /// A pose of the curve as a camera's place and orientation.
    struct Station {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        Eigen::Quaterniond world_from_cam = Eigen::Quaterniond::Identity();
    };
    /// Of the centre in the world, and of the camera about its own axes, per unit of knots.
    struct Velocity {
        Eigen::Vector3d way = Eigen::Vector3d::Zero();
        Eigen::Vector3d turn_rad = Eigen::Vector3d::Zero();
    };
    [[nodiscard]] static Station between(const Station& from, const Station& to, double share);
    [[nodiscard]] static Station moved(const Station& from, const Velocity& velocity, double knots);
    [[nodiscard]] Velocity mean_velocity(std::size_t piece) const;
    [[nodiscard]] Velocity velocity_at(std::size_t station) const;

    std::vector<Rigid3> poses_;  ///< As they were given.
    std::vector<Station> stations_;
    std::vector<double> knots_;  ///< The length of each piece.
    std::vector<Velocity> velocities_;
};

}  // namespace lumi
