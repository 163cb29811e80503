#include "pipeline/bench/weights_measurement.h"

#include <gtest/gtest.h>

#include <numeric>

#include "meshing/rivals/view_dependent_weights.h"
#include "pipeline/bench/mesh_benchmark.h"

namespace lumi {
namespace {

const Eigen::Vector3d kTarget(0.1, 0.2, -0.3);

/// Weights of two cameras by how far the eye is from the target.
WayOfWeighing by_distance(double (*second_weight)(double distance)) {
    return [=](const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
        const double second = second_weight((eye - target).norm());
        return std::vector<double>{1 - second, second};
    };
}

TEST(WeightsMeasurement, SortsRaysByHowUnlikeTwoEyesWeighThem) {
    WeightsMeasurement measurement("some");
    const WayOfWeighing weigh = by_distance([](double distance) { return distance; });
    const auto add = [&](double one, double other) {
        measurement.add_ray(weigh, kTarget + one * Eigen::Vector3d::UnitX(),
                            kTarget + other * Eigen::Vector3d::UnitX(), kTarget);
    };
    add(0.25, 0.25);  // The same.
    add(0.25, 0.45);  // 0.2: up to 0.3.
    add(0.0, 0.7);    // Above 0.3.
    add(0.0, 1.0);
    const WeightsFigures figures = measurement.figures();
    EXPECT_NEAR(figures.mean_inconsistency, (0.2 + 0.7 + 1.0) / 4, 1e-12);
    EXPECT_NEAR(figures.largest_inconsistency, 1.0, 1e-12);
    EXPECT_EQ(figures.inconsistency_shares,
              (std::array<double, kInconsistencyBinEnds.size()>{0.25, 0, 0, 0, 0, 0.25, 0.5}));
}

TEST(WeightsMeasurement, CountsNoRayForSteadyThatNothingIsKnownOf) {
    WeightsMeasurement measurement("far ones alone");
    // Of eyes nearer than 1 nothing is known, of farther ones the first camera is all.
    const WayOfWeighing weigh = [](const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
        return std::vector<double>{(eye - target).norm() < 1 ? 0.0 : 1.0, 0.0};
    };
    const auto add = [&](double one, double other) {
        measurement.add_ray(weigh, kTarget + one * Eigen::Vector3d::UnitX(),
                            kTarget + other * Eigen::Vector3d::UnitX(), kTarget);
    };
    add(0.25, 0.5);
    EXPECT_EQ(measurement.figures().covered_share, 0.0);
    EXPECT_EQ(measurement.figures().inconsistency_shares[0], 0.0);
    add(0.5, 2);
    add(2, 3);
    add(3, 4);
    const WeightsFigures figures = measurement.figures();
    EXPECT_EQ(figures.covered_share, 0.75);
    EXPECT_NEAR(figures.mean_inconsistency, 0.5 / 3, 1e-12);
    EXPECT_NEAR(figures.inconsistency_shares[0], 2.0 / 3, 1e-12);
}

TEST(WeightsMeasurement, StepsFromNothingToNothingDoNotMakeAPathContinuous) {
    WeightsMeasurement measurement("last step");
    // The eye goes from 1.2 to 2.2; up to 2.199 nothing is known.
    measurement.add_path(
        [](const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
            return std::vector<double>{(eye - target).norm() < 2.199 ? 0.0 : 1.0};
        },
        Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), kTarget);
    EXPECT_GT(measurement.figures().continuity_p99, 100)
        << "one step shows anything, and is the jump";
}

TEST(WeightsMeasurement, ContinuityOfAnEvenChangeIsItsRateEverywhere) {
    WeightsMeasurement measurement("even");
    // The eye goes from 1.2 to 2.2: one weight falls from 1 to 0, the other rises.
    measurement.add_path(by_distance([](double distance) { return distance - 1.2; }),
                         Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), kTarget);
    EXPECT_NEAR(measurement.figures().continuity_p99, 2.0, 1e-9);
    EXPECT_NEAR(measurement.figures().continuity_max, 2.0, 1e-9);
    EXPECT_LT(measurement.figures().largest_jump, 1e-9);
}

TEST(WeightsMeasurement, OneJumpIsTheMostAndNotThe99thOfAHundredSteps) {
    WeightsMeasurement measurement("jump");
    measurement.add_path(by_distance([](double distance) { return distance < 1.65 ? 0.0 : 1.0; }),
                         Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), kTarget);
    const WeightsFigures figures = measurement.figures();
    EXPECT_EQ(figures.continuity_p99, 0.0);
    EXPECT_NEAR(figures.continuity_max, 2.0 * 300, 1e-9) << "over a step of 1/300";
    EXPECT_NEAR(figures.largest_jump, 2.0, 1e-12);
    EXPECT_EQ(figures.jumps_per_path, 1.0);
}

TEST(MeshBenchmark, RaysOfTheCameraMeshAreConsistentAndThoseOfItsRivalsAreNot) {
    SilentProgress progress;
    const MeshBenchmark result =
        benchmark_mesh({.captures = 4, .rays = 2000, .most_cameras_timed = 100}, progress);
    ASSERT_EQ(result.weights.size(), 4U);
    EXPECT_EQ(result.weights[0].inconsistency_shares[0], 1.0) << "every ray, up to rounding";
    EXPECT_GT(result.weights[1].covered_share, 0.5) << "rays that Heigl draws";
    EXPECT_LT(result.weights[1].covered_share, 1.0);
    for (const WeightsFigures& way : result.weights) {
        if (&way != &result.weights[1]) {
            EXPECT_EQ(way.covered_share, 1.0) << way.name;
        }
        EXPECT_NEAR(
            std::accumulate(way.inconsistency_shares.begin(), way.inconsistency_shares.end(), 0.0),
            1.0, 1e-12)
            << way.name;
        EXPECT_LE(way.continuity_p99, way.continuity_max) << way.name;
    }
    for (std::size_t i = 1; i < result.weights.size(); ++i)
        EXPECT_LT(result.weights[i].inconsistency_shares[0], 0.9) << result.weights[i].name;
    // Weights of polygons jump; 2 is the most that weights can.
    EXPECT_GT(result.weights[3].largest_jump, 0.01);
    EXPECT_LE(result.weights[3].largest_jump, 2.0);
}

}  // namespace
}  // namespace lumi
