#include "pipeline/bench/synthetic_captures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calib/capture/degrees.h"
#include "pipeline/synth/hand_held_path.h"

namespace lumi {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr int kScenePoints = 500;

Eigen::Vector3d random_in_ball(HashedRandom& random, double radius) {
    const double distance = radius * std::cbrt(random.uniform());
    return distance * random_direction(random);
}

Points shaken(Points places, double unsteady, HashedRandom& random) {
    for (Eigen::Vector3d& place : places) place += unsteady * random_in_ball(random, 1.0);
    return places;
}

/// Even directions (Fibonacci) within `cap_deg` of +x.
Points cap(int count, double cap_deg) {
    const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
    const double least_x = std::cos(cap_deg * kRadiansPerDegree);
    Points places;
    for (int i = 0; i < count; ++i) {
        const double x = 1 - (1 - least_x) * (i + 0.5) / count;
        const double radius = std::sqrt(std::max(0.0, 1 - x * x));
        places.emplace_back(x, radius * std::cos(golden_angle * i),
                            radius * std::sin(golden_angle * i));
    }
    return places;
}

/// Rows and columns on the plane x = 1.
Points wall(int count, double size) {
    const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
    Points places;
    for (int i = 0; i < count; ++i) {
        const double step = size / std::max(1, columns - 1);
        places.emplace_back(1, step * (i % columns) - size / 2, step * (i / columns) - size / 2);
    }
    return places;
}

Points arc(int count, double span_deg) {
    Points places;
    for (int i = 0; i < count; ++i) {
        const double angle = span_deg * kRadiansPerDegree * ((i + 0.5) / count - 0.5);
        places.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    return places;
}

Points straight_line(int count) {
    Points places;
    for (int i = 0; i < count; ++i) places.emplace_back(1, 1.6 * ((i + 0.5) / count - 0.5), 0);
    return places;
}

Points walk_forward(int count) {
    Points places;
    for (int i = 0; i < count; ++i) {
        const double phase = 1.7 * i;
        places.emplace_back(1 + 1.0 * i / count, 0.05 * std::cos(phase), 0.05 * std::sin(phase));
    }
    return places;
}

Points two_clusters(int count) {
    Points places;
    for (const double y : {-0.8, 0.8}) {
        for (const Eigen::Vector3d& place : wall(std::max(1, count / 2), 0.25)) {
            places.push_back(place + Eigen::Vector3d(-0.3, y, 0));
        }
    }
    return places;
}

/// Nine tenths far, the others near one side of the scene.
Points close_ups_among_far(int count) {
    Points places = cap(std::max(1, count - count / 10), 180);
    for (const Eigen::Vector3d& place : wall(count / 10, 0.08)) {
        places.emplace_back(place - Eigen::Vector3d(0.6, 0, 0));
    }
    return places;
}

Capture looking_outwards(const Points& centres, HashedRandom& random) {
    Capture capture = capture_around(centres, 1.0, random);
    for (View& view : capture.views) {
        const Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
        view.cam_from_world = looking_at(centre, 2 * centre);
    }
    for (ScenePoint& point : capture.points) point.position_in_world.normalize();
    for (ScenePoint& point : capture.points) point.position_in_world *= 3.0;
    return capture;
}

}  // namespace

Eigen::Vector3d random_direction(HashedRandom& random) {
    const double x = random.gaussian();
    const double y = random.gaussian();
    return Eigen::Vector3d(x, y, random.gaussian()).normalized();
}

Points hand_held_centres(int count, double roughness, HashedRandom& random) {
    const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
    const double spacing = std::sqrt(4 * std::numbers::pi / count);
    Points centres;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - 2 * (i + 0.5) / count;
        const double radius = std::sqrt(1 - z * z);
        const Eigen::Vector3d even(radius * std::cos(golden_angle * i),
                                   radius * std::sin(golden_angle * i), z);
        const Eigen::Vector3d direction =
            (even + spacing / 3 * random.uniform() * random_direction(random)).normalized();
        centres.emplace_back((1 + roughness * random.symmetric()) * direction);
    }
    return centres;
}

Capture capture_around(const Points& centres, double scene_radius, HashedRandom& random) {
    Capture capture;
    capture.cameras.push_back({640, 480, LensModel::kPinhole, {600, 600, 320, 240}});
    for (const Eigen::Vector3d& centre : centres) {
        View view;
        view.name = std::to_string(capture.views.size());
        view.cam_from_world = looking_at(centre, Eigen::Vector3d::Zero());
        capture.views.push_back(view);
    }
    for (int i = 0; i < kScenePoints; ++i) {
        ScenePoint point;
        point.position_in_world = random_in_ball(random, scene_radius);
        for (int seen = 0; seen < 4; ++seen) {
            const auto view = static_cast<int>(random.below(centres.size()));
            point.track.push_back({view, Eigen::Vector2d::Zero()});
        }
        capture.points.push_back(point);
    }
    return capture;
}

Eigen::Vector3d random_target(const Capture& capture, HashedRandom& random) {
    const double share = random.uniform();
    const auto& a = capture.points[random.below(capture.points.size())].position_in_world;
    const auto& b = capture.points[random.below(capture.points.size())].position_in_world;
    return share * a + (1 - share) * b;
}

std::vector<ArrangedCapture> arranged_captures(int cameras, std::uint64_t seed, double unsteady) {
    HashedRandom random(seed, 7'000'000);
    std::vector<ArrangedCapture> arranged;
    const auto add = [&](const std::string& name, const Points& centres, double spread_deg,
                         double scene_radius) {
        arranged.push_back({name,
                            capture_around(shaken(centres, unsteady, random), scene_radius, random),
                            Eigen::Vector3d::UnitX(), spread_deg, false});
    };
    add("all around", cap(cameras, 180), 180, 0.25);
    add("hemisphere", cap(cameras, 90), 80, 0.25);
    add("open patch", cap(cameras, 35), 30, 0.25);
    add("wall grid", wall(cameras, 0.8), 20, 0.25);
    add("single row", straight_line(cameras), 25, 0.25);
    add("arc", arc(cameras, 150), 40, 0.25);
    arranged.push_back({"straight line", capture_around(straight_line(cameras), 0.25, random),
                        Eigen::Vector3d::UnitX(), 25, false});
    add("forward walk", walk_forward(cameras), 10, 0.1);
    add("two cameras", straight_line(2), 25, 0.25);
    add("one camera", straight_line(1), 25, 0.25);
    arranged.push_back(
        {"coincident cameras",
         capture_around(Points(static_cast<std::size_t>(cameras), {1, 0, 0}), 0.25, random),
         Eigen::Vector3d::UnitX(), 25, false});
    arranged.push_back({"inside-out room", looking_outwards(cap(cameras, 180), random),
                        Eigen::Vector3d::UnitX(), 180, true});
    add("two clusters", two_clusters(cameras), 15, 0.25);
    add("close-ups among far views", close_ups_among_far(cameras), 180, 0.25);
    return arranged;
}

}  // namespace lumi
