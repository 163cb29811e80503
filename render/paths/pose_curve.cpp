#include "render/paths/pose_curve.h"

#include <array>
#include <cmath>

namespace lumi {
namespace {

/// Of a rotation by the shorter way: its axis times its angle.
Eigen::Vector3d rotation_vector_rad(const Eigen::Quaterniond& rotation) {
    const Eigen::AngleAxisd turn(rotation);
    return turn.angle() * turn.axis();
}

Eigen::Quaterniond rotation_by(const Eigen::Vector3d& vector_rad) {
    const double angle_rad = vector_rad.norm();
    if (angle_rad == 0) return Eigen::Quaterniond::Identity();
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, vector_rad / angle_rad));
}

}  // namespace

double pose_distance(const Rigid3& from, const Rigid3& to, double length_per_rad) {
    return std::hypot((centre_in_world(to) - centre_in_world(from)).norm(),
                      length_per_rad * from.rotation.angularDistance(to.rotation));
}

PoseCurve::PoseCurve(const std::vector<Rigid3>& cam_from_world, double length_per_rad) {
    constexpr double kSamePose = 1e-9;
    for (const Rigid3& pose : cam_from_world) {
        if (!poses_.empty()) {
            const double distance = pose_distance(poses_.back(), pose, length_per_rad);
            if (distance <= kSamePose * length_per_rad) continue;
            knots_.push_back(std::sqrt(distance));
        }
        poses_.push_back(pose);
        stations_.push_back({centre_in_world(pose), pose.rotation.conjugate()});
    }
    for (std::size_t i = 0; i < stations_.size(); ++i) velocities_.push_back(velocity_at(i));
}

PoseCurve::Station PoseCurve::between(const Station& from, const Station& to, double share) {
    return {(1 - share) * from.centre + share * to.centre,
            from.world_from_cam.slerp(share, to.world_from_cam)};
}

PoseCurve::Station PoseCurve::moved(const Station& from, const Velocity& velocity, double knots) {
    return {from.centre + knots * velocity.way,
            from.world_from_cam * rotation_by(knots * velocity.turn_rad)};
}

PoseCurve::Velocity PoseCurve::mean_velocity(std::size_t piece) const {
    const Station& from = stations_[piece];
    const Station& to = stations_[piece + 1];
    // The axis of the turn is the same in both cameras.
    const Eigen::Quaterniond turn = from.world_from_cam.conjugate() * to.world_from_cam;
    return {(to.centre - from.centre) / knots_[piece], rotation_vector_rad(turn) / knots_[piece]};
}

PoseCurve::Velocity PoseCurve::velocity_at(std::size_t station) const {
    if (pieces() == 0) return {};
    if (station == 0) return mean_velocity(0);
    const Velocity before = mean_velocity(station - 1);
    if (station == pieces()) return before;
    const Velocity after = mean_velocity(station);
    const double share = knots_[station - 1] / (knots_[station - 1] + knots_[station]);
    return {(1 - share) * before.way + share * after.way,
            (1 - share) * before.turn_rad + share * after.turn_rad};
}

Rigid3 PoseCurve::at(double place) const {
    const auto piece = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(piece);
    if (share == 0) return poses_[piece];
    const double third = knots_[piece] / 3;
    std::array<Station, 4> control{
        stations_[piece], moved(stations_[piece], velocities_[piece], third),
        moved(stations_[piece + 1], velocities_[piece + 1], -third), stations_[piece + 1]};
    for (std::size_t left = control.size() - 1; left > 0; --left)
        for (std::size_t i = 0; i < left; ++i)
            control[i] = between(control[i], control[i + 1], share);
    Rigid3 pose;
    pose.rotation = control[0].world_from_cam.conjugate();
    pose.translation = -(pose.rotation * control[0].centre);
    return pose;
}

}  // namespace lumi
