#include "tests/render/analytic_scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "meshing/cameras/camera_mesh_builder.h"

namespace lumi {
namespace {

struct Hit {
    double depth = 0.0;  ///< In units of the direction; 0: infinitely far.
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
};

Eigen::Vector3d smooth_color(double u, double v, double phase) {
    return {128 + 90 * std::sin(3 * u + phase), 128 + 90 * std::sin(3 * v + 2 * phase),
            128 + 60 * std::sin(2 * (u + v) + 3 * phase)};
}

/// `pattern` waves of print in each unit of length; 0: none.
Hit hit_card_or_wall(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                     const Eigen::Vector2d& half_size, double pattern) {
    const double to_card = (3 - from.z()) / direction.z();
    const Eigen::Vector3d on_card = from + to_card * direction;
    if (to_card > 0 && std::abs(on_card.x()) < half_size.x() &&
        std::abs(on_card.y()) < half_size.y())
        return {to_card, smooth_color((1 + pattern) * on_card.x(), (1 + pattern) * on_card.y(), 2)};
    const double to_wall = (6 - from.z()) / direction.z();
    if (to_wall <= 0) return {0, Eigen::Vector3d::Zero()};
    const Eigen::Vector3d on_wall = from + to_wall * direction;
    return {to_wall, smooth_color(on_wall.x(), on_wall.y(), 0)};
}

Hit hit_posts_or_wall(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
    struct Post {
        double z, left, right, phase;
    };
    for (const auto& [z, left, right, phase] : {Post{3, 0.21, 0.33, 2}, Post{4.5, -0.1, 0.1, 1}}) {
        const double to_post = (z - from.z()) / direction.z();
        const Eigen::Vector3d at = from + to_post * direction;
        if (to_post > 0 && at.x() > left && at.x() < right)
            return {to_post, smooth_color(at.x(), at.y(), phase)};
    }
    return hit_card_or_wall(from, direction, {0, 0}, 0);
}

Hit hit_ball_or_sky(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
    const double a = direction.squaredNorm();
    const double b = from.dot(direction);
    const double discriminant = b * b - a * (from.squaredNorm() - 1);
    if (discriminant > 0 && b < 0) {
        const double depth = (-b - std::sqrt(discriminant)) / a;
        const Eigen::Vector3d at = from + depth * direction;
        return {depth, smooth_color(at.x() + at.z(), at.y() - at.z(), 1)};
    }
    const Eigen::Vector3d sky = direction.normalized();
    return {0, smooth_color(sky.x(), sky.y(), 4)};
}

Hit hit(AnalyticScene scene, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
    if (scene == AnalyticScene::kBallInSky) return hit_ball_or_sky(from, direction);
    if (scene == AnalyticScene::kPostBehindPost) return hit_posts_or_wall(from, direction);
    if (scene == AnalyticScene::kBarBeforeWall)
        return hit_card_or_wall(from, direction, {0.023, 0.8}, 0);
    return hit_card_or_wall(from, direction, {0.7, 0.5},
                            scene == AnalyticScene::kPrintedCard ? 9 : 0);
}

Hit hit_at_pixel(AnalyticScene scene, const Eye& eye, int x, int y) {
    return hit(scene, centre_in_world(eye.cam_from_world),
               eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, {x + 0.5, y + 0.5}));
}

DepthMap exact_depth(AnalyticScene scene, const Eye& eye) {
    DepthMap depth{FloatImage(eye.camera.width_px, eye.camera.height_px),
                   GrayImage(eye.camera.width_px, eye.camera.height_px, 255)};
    for (int y = 0; y < eye.camera.height_px; ++y) {
        for (int x = 0; x < eye.camera.width_px; ++x) {
            const double z = hit_at_pixel(scene, eye, x, y).depth;
            depth.inverse_depth(x, y) = z > 0 ? static_cast<float>(1 / z) : 0.0F;
        }
    }
    return depth;
}

/// Scene points as structure from motion would give them: each camera sees a few.
Capture capture_of(AnalyticScene scene, const std::vector<Eye>& cameras) {
    Capture capture;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        capture.cameras.push_back(cameras[i].camera);
        capture.views.push_back(
            {"view" + std::to_string(i), static_cast<int>(i), cameras[i].cam_from_world});
        for (int y = 4; y < cameras[i].camera.height_px; y += 8) {
            for (int x = 4; x < cameras[i].camera.width_px; x += 8) {
                const double z = hit_at_pixel(scene, cameras[i], x, y).depth;
                if (z <= 0) continue;
                const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
                ScenePoint point;
                point.position_in_world =
                    inverse(cameras[i].cam_from_world) * (z * unproject(cameras[i].camera, pixel));
                point.track.push_back({static_cast<int>(i), pixel});
                capture.points.push_back(point);
            }
        }
    }
    return capture;
}

}  // namespace

ColorImage ideal_photograph(AnalyticScene scene, const Eye& eye) {
    ColorImage photograph(eye.camera.width_px, eye.camera.height_px);
    for (int y = 0; y < photograph.height(); ++y) {
        for (int x = 0; x < photograph.width(); ++x) {
            const Eigen::Vector3d color = hit_at_pixel(scene, eye, x, y).color;
            photograph(x, y) = {static_cast<std::uint8_t>(color.x()),
                                static_cast<std::uint8_t>(color.y()),
                                static_cast<std::uint8_t>(color.z())};
        }
    }
    return photograph;
}

Lumigraph photographed(AnalyticScene scene, const std::vector<Eye>& cameras) {
    Lumigraph lumigraph;
    std::vector<int> indices;
    for (const Eye& camera : cameras) {
        indices.push_back(static_cast<int>(indices.size()));
        lumigraph.views.push_back({"view" + std::to_string(indices.back()), camera.camera,
                                   camera.cam_from_world, 1, ideal_photograph(scene, camera),
                                   exact_depth(scene, camera)});
    }
    lumigraph.mesh = build_camera_mesh(capture_of(scene, cameras), indices, {}).mesh;
    lumigraph.near_depth = scene == AnalyticScene::kBallInSky ? 1.5 : 2.5;
    lumigraph.far_depth = scene == AnalyticScene::kBallInSky ? 5.0 : 6.5;
    return lumigraph;
}

Eye eye_at(const Eigen::Vector3d& position, const Eigen::Vector3d& target, const Camera& camera) {
    const Eigen::Vector3d forward = (target - position).normalized();
    const Eigen::Vector3d down =
        std::abs(forward.y()) < 0.99 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
    Eigen::Matrix3d cam_from_world;
    cam_from_world.row(0) = down.cross(forward).normalized();
    cam_from_world.row(1) = forward.cross(down.cross(forward).normalized());
    cam_from_world.row(2) = forward;
    const Eigen::Quaterniond rotation(cam_from_world);
    return {camera, {rotation, -(rotation * position)}};
}

namespace {

std::vector<Eye> cameras_before_wall() {
    std::vector<Eye> cameras{eye_at({0.05, -0.04, -0.06}, {0, 0, 4}, pinhole_camera(64, 48, 60))};
    for (int i = 0; i < 8; ++i) {
        const double angle = 0.25 * 3.14159265 * i;
        cameras.push_back(eye_at({0.6 * std::cos(angle), 0.45 * std::sin(angle), 0.02 * (i % 3)},
                                 {0.1 * std::cos(angle), 0, 4}, pinhole_camera(64, 48, 60)));
    }
    return cameras;
}

}  // namespace

Lumigraph card_before_wall() {
    return photographed(AnalyticScene::kCardBeforeWall, cameras_before_wall());
}

Lumigraph card_without_surface() {
    Lumigraph lumigraph = card_before_wall();
    CameraMesh cameras;
    cameras.construction = MeshConstruction::kNearest;
    cameras.scene_centre_in_world = lumigraph.mesh.scene_centre_in_world;
    for (std::size_t view = 0; view < lumigraph.views.size(); ++view)
        cameras.vertices.push_back({centre_in_world(lumigraph.views[view].cam_from_world),
                                    static_cast<int>(view), false,
                                    optical_axis_in_world(lumigraph.views[view].cam_from_world)});
    lumigraph.mesh = cameras;
    return lumigraph;
}

Lumigraph card_with_close_ups() {
    std::vector<Eye> cameras = cameras_before_wall();
    for (const Eigen::Vector3d& place :
         {Eigen::Vector3d(0.15, 0.05, 2.2), Eigen::Vector3d(-0.15, 0, 2.2),
          Eigen::Vector3d(0, 0.15, 2.1)})
        cameras.push_back(eye_at(place, {0.5 * place.x(), 0, 3}, pinhole_camera(64, 48, 60)));
    Lumigraph lumigraph = photographed(AnalyticScene::kPrintedCard, cameras);
    lumigraph.near_depth = 0.7;
    return lumigraph;
}

Lumigraph post_behind_post() {
    std::vector<Eye> cameras;
    for (const Eigen::Vector3d& place : {Eigen::Vector3d(-0.5, 0, 0), Eigen::Vector3d(0.8, -0.3, 0),
                                         Eigen::Vector3d(0.85, 0.35, 0)})
        cameras.push_back(eye_at(place, {0, 0, 4.5}, pinhole_camera(128, 96, 120)));
    return photographed(AnalyticScene::kPostBehindPost, cameras);
}

Lumigraph ball_in_sky() {
    const double golden = (1 + std::sqrt(5.0)) / 2;
    std::vector<Eye> cameras;
    for (int i = 0; i < 12; ++i) {
        const double a = i % 2 == 0 ? 1 : -1;
        const double b = (i / 2) % 2 == 0 ? golden : -golden;
        Eigen::Vector3d direction(0, 0, 0);
        direction[(i / 4 + 1) % 3] = a;
        direction[(i / 4 + 2) % 3] = b;
        const double distance = 3.2 + 0.4 * ((5 * i) % 4);
        cameras.push_back(
            eye_at(distance * direction.normalized(), {0, 0, 0}, pinhole_camera(64, 48, 48)));
    }
    return photographed(AnalyticScene::kBallInSky, cameras);
}

}  // namespace lumi
