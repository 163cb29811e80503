#include "render/viewer/controls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/paths/photograph_eye.h"
#include "render/reference/eye_depths.h"
#include "render/transfer/view_geometry.h"

namespace lumi {
namespace {

constexpr double kZoomPerStep = 0.9;
/// How near to straight up or down the gaze may come.
constexpr double kPoleMargin_rad = std::numbers::pi / 180;

Eigen::Vector3d right_in_world(const Eye& eye) {
    return eye.cam_from_world.rotation.conjugate() * Eigen::Vector3d::UnitX();
}

/// The turn of the world about a point that stays where it is.
Rigid3 turn_about(const Eigen::Vector3d& point, const Eigen::Vector3d& axis, double angle_rad) {
    const Eigen::Quaterniond rotation(Eigen::AngleAxisd(angle_rad, axis));
    return {rotation, point - rotation * point};
}

/// The part of a pitch that keeps the eye from tipping over: up in the picture stays up in the
/// world. Pitching lowers the angle of the gaze above the horizon, measured in the plane in which
/// it turns; an eye that is rolled far onto its side, or upside down already, pitches freely.
double bounded_pitch_rad(const Eye& eye, const Eigen::Vector3d& up_in_world, double pitch_rad) {
    constexpr double kHighest_rad = std::numbers::pi / 2 - kPoleMargin_rad;
    constexpr double kRolledShare = 0.5;
    const Eigen::Vector3d up_in_cam = eye.cam_from_world.rotation * up_in_world;
    const double gaze_rad = std::atan2(up_in_cam.z(), -up_in_cam.y());
    const bool is_upside_down = up_in_cam.y() > 0;
    if (is_upside_down || up_in_cam.tail<2>().norm() < kRolledShare) return pitch_rad;
    return std::clamp(pitch_rad, std::min(0.0, gaze_rad - kHighest_rad),
                      std::max(0.0, gaze_rad + kHighest_rad));
}

Eye turned_about(const Navigation& from, const Eigen::Vector3d& point, double yaw_rad,
                 double pitch_rad) {
    Eye eye = from.eye;
    eye.cam_from_world = eye.cam_from_world * turn_about(point, from.up_in_world, yaw_rad);
    const double bounded_rad = bounded_pitch_rad(eye, from.up_in_world, pitch_rad);
    eye.cam_from_world = eye.cam_from_world * turn_about(point, right_in_world(eye), bounded_rad);
    return eye;
}

double depth_of_pivot(const Navigation& from) {
    const Eigen::Vector3d pivot_in_cam = from.eye.cam_from_world * from.pivot_in_world;
    return pivot_in_cam.z() > 0 ? pivot_in_cam.z() : pivot_in_cam.norm();
}

/// The eye, and the pivot with it, moved by a vector in the eye's own axes.
Navigation moved(const Navigation& from, const Eigen::Vector3d& move_in_cam) {
    Navigation to = from;
    to.eye.cam_from_world.translation -= move_in_cam;
    to.pivot_in_world += from.eye.cam_from_world.rotation.conjugate() * move_in_cam;
    return to;
}

/// The smallest angle between the optical axis and the sides of the picture.
double smallest_half_angle_rad(const Camera& camera) {
    const Eigen::Vector2d focal = focal_length_px(camera);
    const Eigen::Vector2d centre = principal_point_px(camera);
    const double x_px = std::min(centre.x(), camera.width_px - centre.x());
    const double y_px = std::min(centre.y(), camera.height_px - centre.y());
    return std::min(std::atan2(x_px, focal.x()), std::atan2(y_px, focal.y()));
}

}  // namespace

Navigation orbit(const Navigation& from, const Eigen::Vector2d& drag_px) {
    const double rad_per_px = std::numbers::pi / from.eye.camera.height_px;
    Navigation to = from;
    to.eye =
        turned_about(from, from.pivot_in_world, drag_px.x() * rad_per_px, drag_px.y() * rad_per_px);
    return to;
}

Navigation look(const Navigation& from, const Eigen::Vector2d& drag_px) {
    const Eigen::Vector2d focal = focal_length_px(from.eye.camera);
    const Eigen::Vector3d eye_in_world = centre_in_world(from.eye.cam_from_world);
    // Opposite to orbit: there the near side of the scene follows the cursor, here the far side.
    return carried_to(from, turned_about(from, eye_in_world, -std::atan2(drag_px.x(), focal.x()),
                                         -std::atan2(drag_px.y(), focal.y())));
}

Navigation pan(const Navigation& from, const Eigen::Vector2d& drag_px) {
    const Eigen::Vector2d in_plane =
        depth_of_pivot(from) * drag_px.cwiseQuotient(focal_length_px(from.eye.camera));
    return moved(from, {-in_plane.x(), -in_plane.y(), 0.0});
}

Navigation zoom(const Navigation& from, double steps) {
    const Eigen::Vector3d pivot_in_cam = from.eye.cam_from_world * from.pivot_in_world;
    const double distance = pivot_in_cam.norm();
    const double nearest = std::min(distance, from.least_distance);
    const double coming =
        steps <= 0 || nearest <= 0
            ? steps
            : std::min(steps, std::log(nearest / distance) / std::log(kZoomPerStep));
    const double passing = (steps - coming) * (1 - kZoomPerStep) * from.least_distance;
    Navigation to = from;
    to.eye.cam_from_world.translation -= (1 - std::pow(kZoomPerStep, coming)) * pivot_in_cam;
    if (passing <= 0) return to;
    return moved(to, passing / distance * pivot_in_cam);
}

Navigation fly(const Navigation& from, const Eigen::Vector3d& move_in_cam) {
    const double distance = (centre_in_world(from.eye.cam_from_world) - from.pivot_in_world).norm();
    return moved(from, std::max(distance, from.least_distance) * move_in_cam);
}

double least_distance(const Lumigraph& lumigraph) {
    constexpr double kShareOfNearEnd = 1.0 / 3;
    return kShareOfNearEnd / scene_inverse_depths(lumigraph).near;
}

Navigation carried_to(const Navigation& from, const Eye& eye) {
    const double distance = (from.pivot_in_world - centre_in_world(from.eye.cam_from_world)).norm();
    Navigation to = from;
    to.eye = eye;
    to.pivot_in_world =
        centre_in_world(eye.cam_from_world) + distance * optical_axis_in_world(eye.cam_from_world);
    return to;
}

Navigation snap_to(const Navigation& from, const Lumigraph& lumigraph, int view_index) {
    const LumigraphView& view = lumigraph.views.at(static_cast<std::size_t>(view_index));
    Navigation to = from;
    to.eye = eye_at(view);
    to.pivot_in_world = point_in_the_middle(lumigraph, view);
    return to;
}

Navigation turning_about(const Navigation& from, const Lumigraph& lumigraph,
                         const Eigen::Vector2d& place_px) {
    if (!lumigraph.has_depth()) return from;
    // An eye whose whole picture is the pixel.
    const Eigen::Vector2d focal = focal_length_px(from.eye.camera);
    const Eigen::Vector2d centre =
        principal_point_px(from.eye.camera) - place_px + Eigen::Vector2d(0.5, 0.5);
    const Eye through_place{
        {1, 1, LensModel::kPinhole, {focal.x(), focal.y(), centre.x(), centre.y()}},
        from.eye.cam_from_world};
    const ConsensusDepth depth =
        eye_depths(lumigraph, through_place, kAgreeingDisparity_px).depths(0, 0);
    if (depth.support == 0 || depth.inverse_depth <= 0) return from;
    Navigation to = from;
    to.pivot_in_world = point_in_world(through_place, 0, 0, depth.inverse_depth);
    return to;
}

Navigation frame_all(const Navigation& from, const SceneBounds& bounds) {
    const double distance = bounds.radius / std::sin(smallest_half_angle_rad(from.eye.camera));
    Navigation to = from;
    to.pivot_in_world = bounds.centre_in_world;
    to.eye.cam_from_world.translation =
        Eigen::Vector3d(0, 0, distance) - from.eye.cam_from_world.rotation * bounds.centre_in_world;
    return to;
}

int nearest_view(const Lumigraph& lumigraph, const Eye& eye) {
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    const auto squared_distance = [&](const LumigraphView& view) {
        return (centre_in_world(view.cam_from_world) - eye_in_world).squaredNorm();
    };
    const auto nearest = std::min_element(
        lumigraph.views.begin(), lumigraph.views.end(),
        [&](const auto& a, const auto& b) { return squared_distance(a) < squared_distance(b); });
    return static_cast<int>(nearest - lumigraph.views.begin());
}

}  // namespace lumi
