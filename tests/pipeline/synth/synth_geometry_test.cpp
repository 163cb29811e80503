#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "pipeline/synth/body.h"
#include "pipeline/synth/hand_held_path.h"
#include "pipeline/synth/hashed_random.h"

namespace lumi {
namespace {

Eigen::Vector3d random_direction(HashedRandom& random) {
    return Eigen::Vector3d(random.gaussian(), random.gaussian(), random.gaussian()).normalized();
}

Placement turned_placement() {
    const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1, 2, 3).normalized());
    return {{0.1, -0.2, 0.3}, turn.toRotationMatrix()};
}

std::vector<Solid> one_of_each() {
    return {Ellipsoid{turned_placement(), {0.3, 0.5, 0.2}},
            Box{turned_placement(), {0.3, 0.4, 0.2}, 0.0},
            Box{turned_placement(), {0.3, 0.4, 0.2}, 0.05},
            Cylinder{turned_placement(), 0.3, 0.2, 0.04},
            Torus{turned_placement(), 0.4, 0.1},
            TaperedCapsule{{-0.3, 0.1, 0.0}, {0.4, 0.2, 0.3}, 0.25, 0.1}};
}

Body blended_body() {
    return {"blended",
            0,
            {TaperedCapsule{{0, 0, 0}, {0.1, 0, 0.5}, 0.2, 0.12},
             Ellipsoid{{{0.15, 0.05, 0.6}, Eigen::Matrix3d::Identity()}, {0.15, 0.12, 0.1}},
             Torus{{{0.0, 0.0, 0.1}, Eigen::Matrix3d::Identity()}, 0.3, 0.05},
             Box{{{0.0, 0.0, -0.2}, Eigen::Matrix3d::Identity()}, {0.3, 0.3, 0.06}, 0.02}},
            0.06};
}

std::vector<Body> all_bodies() {
    std::vector<Body> bodies{blended_body()};
    for (const Solid& solid : one_of_each()) {
        bodies.emplace_back("single", 0, std::vector{solid}, 0.0);
    }
    return bodies;
}

/// The first change of sign along a ray, by many small steps and bisection.
std::optional<double> first_hit_by_small_steps(const Body& body, const Ray& ray, double far) {
    constexpr int kSteps = 20'000;
    for (int step = 1; step <= kSteps; ++step) {
        double inside = far * step / kSteps;
        if (body.signed_distance(ray.at(inside)) > 0.0) continue;
        double outside = far * (step - 1) / kSteps;
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = 0.5 * (outside + inside);
            (body.signed_distance(ray.at(middle)) > 0.0 ? outside : inside) = middle;
        }
        return 0.5 * (outside + inside);
    }
    return std::nullopt;
}

TEST(Solid, DistanceChangesAtMostByTheWayGoneAndEndsInTheBounds) {
    HashedRandom random(1);
    for (const Solid& solid : one_of_each()) {
        const bool is_exact = !std::holds_alternative<Ellipsoid>(solid);
        const BoundingSphere bounds = bounding_sphere(solid);
        for (int draw = 0; draw < 2000; ++draw) {
            const Eigen::Vector3d a = bounds.centre + 0.8 * random_direction(random);
            const Eigen::Vector3d b = a + 0.1 * random.uniform() * random_direction(random);
            const double change = signed_distance(solid, a) - signed_distance(solid, b);
            if (is_exact) {
                EXPECT_LE(std::abs(change), (a - b).norm() + 1e-12);
            }
            if ((a - bounds.centre).norm() > bounds.radius + 1e-12) {
                EXPECT_GT(signed_distance(solid, a), 0.0) << "shape " << solid.index();
            }
        }
    }
}

TEST(Solid, TaperedCapsuleIsTheHullOfItsSpheres) {
    const TaperedCapsule capsule{{0, 0, 0}, {0, 0, 1}, 0.4, 0.1};
    HashedRandom random(2);
    for (int draw = 0; draw < 200; ++draw) {
        const Eigen::Vector3d point(random.symmetric(), random.symmetric(),
                                    0.5 + 1.2 * random.symmetric());
        double nearest = 1e9;
        for (int i = 0; i <= 20'000; ++i) {
            const double along = i / 20'000.0;
            const double radius = 0.4 - 0.3 * along;
            nearest = std::min(nearest, (point - Eigen::Vector3d(0, 0, along)).norm() - radius);
        }
        EXPECT_NEAR(signed_distance(capsule, point), nearest, 1e-6);
    }
}

TEST(Body, FirstHitAgreesWithSmallSteps) {
    HashedRandom random(3);
    int hits = 0;
    for (const Body& body : all_bodies()) {
        for (int draw = 0; draw < 40; ++draw) {
            const BoundingSphere& bounds = body.bounds();
            const Eigen::Vector3d origin = bounds.centre + 2.0 * random_direction(random);
            const Eigen::Vector3d aim =
                bounds.centre + 0.8 * bounds.radius * random_direction(random);
            const Ray ray{origin, (aim - origin).normalized()};
            const auto expected = first_hit_by_small_steps(body, ray, 4.0);
            const auto found = body.first_hit(ray, {0.0, 1e9});
            ASSERT_EQ(found.has_value(), expected.has_value()) << body.name() << draw;
            if (!found) continue;
            ++hits;
            EXPECT_NEAR(*found, *expected, 1e-7);
            EXPECT_NEAR(body.signed_distance(ray.at(*found)), 0.0, 1e-9);
        }
    }
    EXPECT_GT(hits, 80);
}

TEST(Body, NormalIsTheGradientOfTheDistance) {
    HashedRandom random(4);
    int hits = 0;
    for (const Body& body : all_bodies()) {
        for (int draw = 0; draw < 40; ++draw) {
            const Eigen::Vector3d origin = body.bounds().centre + 2.0 * random_direction(random);
            const Ray ray{origin, (body.bounds().centre - origin).normalized()};
            const auto hit = body.first_hit(ray, {0.0, 1e9});
            if (!hit) continue;
            ++hits;
            const Eigen::Vector3d normal = body.normal_at(ray.at(*hit));
            EXPECT_NEAR(normal.norm(), 1.0, 1e-12);
            constexpr double kStep = 1e-6;
            const double ahead = body.signed_distance(ray.at(*hit) + kStep * normal);
            EXPECT_NEAR(ahead / kStep, 1.0, 1e-2);
            EXPECT_LT(normal.dot(ray.direction), 0.0);
        }
    }
    EXPECT_GT(hits, 80);
}

TEST(Body, ShadowIsFullBehindTheMiddleAndNoneFarAside) {
    const Body ball("ball", 0, {Ellipsoid{{}, {1, 1, 1}}}, 0.0);
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    EXPECT_EQ(ball.uncovered_share({{0, 0, -5}, up}, 0.1), 0.0);
    EXPECT_EQ(ball.uncovered_share({{3, 0, -5}, up}, 0.1), 1.0);
    EXPECT_EQ(ball.uncovered_share({{0, 0, 5}, up}, 0.1), 1.0);
    // The ray that touches the ball has half the lamp.
    EXPECT_NEAR(ball.uncovered_share({{1, 0, -5}, up}, 0.1), 0.5, 0.05);
}

TEST(HandHeldPath, CamerasStandAtTheDistanceAndLookAtTheTarget) {
    for (const PathKind kind : {PathKind::kArc, PathKind::kRing, PathKind::kHemisphere}) {
        HandHeldPath path;
        path.kind = kind;
        path.count = 12;
        path.rows = 2;
        path.distance = 2.5;
        path.target_in_world = {0.3, -0.2, 0.5};
        path.top_elevation_deg = 40;
        for (const Rigid3& cam_from_world : poses_along(path, 1)) {
            const Eigen::Vector3d eye = centre_in_world(cam_from_world);
            EXPECT_NEAR((eye - path.target_in_world).norm(), 2.5, 1e-12);
            const Eigen::Vector3d target_in_cam = cam_from_world * path.target_in_world;
            EXPECT_LT((target_in_cam - Eigen::Vector3d(0, 0, 2.5)).norm(), 1e-12);
            // Upright: the world's up is in the plane of the camera's -y and z axes.
            const Eigen::Vector3d up = cam_from_world.rotation * Eigen::Vector3d::UnitZ();
            EXPECT_NEAR(up.x(), 0.0, 1e-12);
            EXPECT_LT(up.y(), 0.0);
        }
    }
}

TEST(HandHeldPath, GridIsEvenAndWalkedToAndFro) {
    HandHeldPath path;
    path.kind = PathKind::kGrid;
    path.count = 6;
    path.rows = 2;
    path.length_share = 0.8;
    path.elevation_deg = 0;
    const auto poses = poses_along(path, 1);
    const auto centre = [&](std::size_t i) { return centre_in_world(poses[i]); };
    EXPECT_LT((centre(0) - Eigen::Vector3d(-0.4, -1, -0.2)).norm(), 1e-12);
    EXPECT_LT((centre(2) - Eigen::Vector3d(0.4, -1, -0.2)).norm(), 1e-12);
    EXPECT_LT((centre(3) - Eigen::Vector3d(0.4, -1, 0.2)).norm(), 1e-12);
    EXPECT_LT((centre(5) - Eigen::Vector3d(-0.4, -1, 0.2)).norm(), 1e-12);
}

TEST(HandHeldPath, ForwardStaysOnTheLineOfSightAndLineIsSquareToIt) {
    HandHeldPath path;
    path.count = 5;
    path.elevation_deg = 0;
    path.length_share = 0.5;
    path.kind = PathKind::kForward;
    const auto ahead = poses_along(path, 1);
    EXPECT_LT((centre_in_world(ahead.front()) - Eigen::Vector3d(0, -1, 0)).norm(), 1e-12);
    EXPECT_LT((centre_in_world(ahead.back()) - Eigen::Vector3d(0, -0.5, 0)).norm(), 1e-12);
    path.kind = PathKind::kLine;
    const auto aside = poses_along(path, 1);
    EXPECT_LT((centre_in_world(aside.front()) - Eigen::Vector3d(-0.25, -1, 0)).norm(), 1e-12);
    EXPECT_LT((centre_in_world(aside.back()) - Eigen::Vector3d(0.25, -1, 0)).norm(), 1e-12);
}

TEST(HandHeldPath, RotationKeepsItsPlaceAndTurnsBySpan) {
    HandHeldPath path;
    path.kind = PathKind::kRotation;
    path.count = 7;
    path.span_deg = 90;
    path.position_jitter_share = 0.3;
    const auto poses = poses_along(path, 1);
    for (const Rigid3& pose : poses) {
        EXPECT_LT((centre_in_world(pose) - centre_in_world(poses[0])).norm(), 1e-12);
    }
    const double turned = poses.front().rotation.angularDistance(poses.back().rotation);
    EXPECT_NEAR(turned, std::numbers::pi / 2, 1e-9);
    // It turns to the right.
    EXPECT_GT(optical_axis_in_world(poses.back()).x(), optical_axis_in_world(poses.front()).x());
}

TEST(HandHeldPath, StartAtShiftsTheOrderAndNothingElse) {
    HandHeldPath path;
    path.count = 8;
    path.position_jitter_share = 0.05;
    path.aim_jitter_deg = 2;
    const auto from_first = poses_along(path, 9);
    path.start_at = 3;
    const auto from_third = poses_along(path, 9);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(from_third[i].translation, from_first[(i + 3) % 8].translation);
    }
}

}  // namespace
}  // namespace lumi
