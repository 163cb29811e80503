#include "tests/meshing/cameras/arrangements.h"

#include <Eigen/Geometry>
#include <cmath>

#include "calib/capture/degrees.h"
#include "calib/capture/rigid3.h"

namespace lumi {
namespace {

Points shaken(Points centres, double amount, unsigned seed) {
    std::mt19937 random(seed);
    for (Eigen::Vector3d& centre : centres) {
        const double length = amount * centre.norm();
        centre += length * random_direction(random);
    }
    return centres;
}

Points arc(int count, double span_deg, double height) {
    Points centres;
    for (int i = 0; i < count; ++i) {
        const double azimuth =
            span_deg * (static_cast<double>(i) / (count - 1) - 0.5) * kRadiansPerDegree;
        centres.emplace_back(3 * std::cos(azimuth), 3 * std::sin(azimuth), height);
    }
    return centres;
}

Points grid(int columns, int rows, double spacing) {
    Points centres;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            centres.emplace_back(3, spacing * (column - 0.5 * (columns - 1)),
                                 spacing * (row - 0.5 * (rows - 1)));
        }
    }
    return centres;
}

Points row(int count, double spacing) { return grid(count, 1, spacing); }

Points walk_towards_scene(int count, double sway) {
    Points centres;
    for (int i = 0; i < count; ++i) {
        const double phase = 1.7 * i;
        centres.emplace_back(3 + 0.4 * i, sway * std::cos(phase), sway * std::sin(phase));
    }
    return centres;
}

Points two_clusters() {
    Points centres;
    for (const double y : {-2.2, 2.2}) {
        for (const Eigen::Vector3d& place : grid(3, 3, 0.3)) {
            centres.push_back(place + Eigen::Vector3d(-0.6, y, 0));
        }
    }
    return centres;
}

Points far_and_close() {
    Points centres;
    for (const Eigen::Vector3d& direction : sphere_directions(40, -1)) {
        centres.push_back(3 * direction);
    }
    for (int i = 0; i < 6; ++i) {
        const Eigen::Vector3d offset(1.1, 0.25 * std::cos(i * 60 * kRadiansPerDegree + 0.3),
                                     0.25 * std::sin(i * 60 * kRadiansPerDegree + 0.3));
        centres.push_back(offset);
    }
    return centres;
}

ArrangedCapture around_the_origin(const std::string& name, const Points& centres,
                                  MeshConstruction construction, int kept,
                                  const Eigen::Vector3d& side, double spread_deg,
                                  double scene_radius = 0.5) {
    std::mt19937 random(11);
    ArrangedCapture arranged;
    arranged.name = name;
    arranged.capture =
        capture_of(centres, Eigen::Vector3d::Zero(),
                   points_in_ball(400, Eigen::Vector3d::Zero(), scene_radius, random));
    arranged.scene = points_in_ball(60, Eigen::Vector3d::Zero(), 0.9 * scene_radius, random);
    arranged.side = side.normalized();
    arranged.spread_deg = spread_deg;
    arranged.construction = construction;
    arranged.cameras_kept = kept;
    return arranged;
}

/// From the middle of a room, looking outwards.
ArrangedCapture room() {
    std::mt19937 random(12);
    ArrangedCapture arranged;
    arranged.name = "inside-out room";
    Points walls;
    for (int i = 0; i < 400; ++i) walls.push_back(6 * random_direction(random));
    arranged.capture = capture_of(sphere_directions(36, -1), Eigen::Vector3d::Zero(), walls);
    for (View& view : arranged.capture.views) {
        const Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
        view.cam_from_world.rotation = turn_between(centre, Eigen::Vector3d::UnitZ());
        view.cam_from_world.translation = -(view.cam_from_world.rotation * centre);
    }
    arranged.scene = Points(walls.begin(), walls.begin() + 60);
    arranged.construction = MeshConstruction::kClosed;
    arranged.cameras_kept = 36;
    return arranged;
}

}  // namespace

std::vector<ArrangedCapture> arranged_captures() {
    using enum MeshConstruction;
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    Points all_around = sphere_directions(60, -1);
    Points hemisphere = sphere_directions(90, 0.02);
    for (Points* points : {&all_around, &hemisphere}) {
        for (Eigen::Vector3d& direction : *points) direction *= 3;
    }
    Points patch;
    for (const Eigen::Vector3d& direction : sphere_directions(300, 0.85)) {
        patch.emplace_back(3 * direction.z(), 3 * direction.x(), 3 * direction.y());
    }
    const Points coincident(5, Eigen::Vector3d(3, 0, 0));
    ArrangedCapture close_ups =
        around_the_origin("close-ups among far views", far_and_close(), kClosed, 46, x, 180, 0.6);
    close_ups.least_targets = 50;
    const auto patch_size = static_cast<int>(patch.size());
    const auto hemisphere_size = static_cast<int>(hemisphere.size());
    return {
        around_the_origin("all around", shaken(all_around, 0.1, 1), kClosed, 60, x, 180),
        around_the_origin("hemisphere", shaken(hemisphere, 0.05, 2), kOpen, hemisphere_size, z, 80),
        around_the_origin("open patch", shaken(patch, 0.03, 3), kOpen, patch_size, x, 60),
        around_the_origin("wall grid 5x4", grid(5, 4, 0.5), kOpen, 20, x, 60),
        around_the_origin("wall grid 3x3", grid(3, 3, 0.5), kOpen, 9, x, 60),
        around_the_origin("hand-held wall 4x4", shaken(grid(4, 4, 0.4), 0.02, 4), kOpen, 16, x, 60),
        around_the_origin("single row", shaken(row(9, 0.3), 0.01, 5), kLine, 9, x, 50),
        around_the_origin("arc", shaken(arc(11, 120, 0.0), 0.01, 6), kLine, 11, x, 70),
        around_the_origin("straight line", row(8, 0.35), kLine, 8, x, 50),
        around_the_origin("forward walk", walk_towards_scene(8, 0.12), kNearest, 8, x, 40, 0.2),
        around_the_origin("straight forward walk", walk_towards_scene(6, 0.0), kNearest, 6, x, 60),
        around_the_origin("swaying walk", walk_towards_scene(8, 0.5), kOpen, 8, x, 40, 0.2),
        around_the_origin("two cameras", row(2, 1.0), kPair, 2, x, 50),
        around_the_origin("one camera", row(1, 1.0), kSingle, 1, x, 60),
        around_the_origin("coincident cameras", coincident, kSingle, 1, x, 60),
        room(),
        around_the_origin("two clusters", two_clusters(), kOpen, 18, x, 50),
        close_ups,
    };
}

}  // namespace lumi
