#include "calib/adjust/bundle_adjustment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "calib/poses/pose_comparison.h"
#include "calib/work/error.h"
#include "tests/calib/adjust/synthetic_capture.h"

namespace lumi {
namespace {

Camera true_camera() { return {1000, 800, LensModel::kSimpleRadial, {900, 500, 400, -0.05}}; }

NamedPoses poses_of(const Capture& capture) {
    NamedPoses poses;
    for (const View& view : capture.views) poses[view.name] = view.cam_from_world;
    return poses;
}

/// Poses and points moved off the truth, as a mapper would leave them.
Capture disturbed(Capture capture, double size, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> gaussian(0.0, size);
    const auto noise = [&] {
        return Eigen::Vector3d(gaussian(random), gaussian(random), gaussian(random));
    };
    for (View& view : capture.views) {
        view.cam_from_world.translation += noise();
        const Eigen::Vector3d turn = 0.3 * noise();
        view.cam_from_world.rotation =
            (Eigen::Quaterniond(1, turn.x(), turn.y(), turn.z()).normalized() *
             view.cam_from_world.rotation)
                .normalized();
    }
    for (ScenePoint& point : capture.points) point.position_in_world += noise();
    return capture;
}

/// Over all observations: distances in the picture between seen and predicted.
double rms_px(const Capture& capture) {
    double sum_px2 = 0;
    for (const ScenePoint& point : capture.points) {
        for (const Observation& seen : point.track) {
            const double error_px = reprojection_error_px(capture, point, seen);
            sum_px2 += error_px * error_px;
        }
    }
    return std::sqrt(sum_px2 / static_cast<double>(count_observations(capture)));
}

TEST(BundleAdjustment, RecoversExactPosesPointsAndLensFromExactPixels) {
    const Capture truth = synthetic_capture(true_camera(), {});
    Capture capture = disturbed(truth, 0.02, 7);
    capture.cameras[0].parameters[0] = 950;
    capture.cameras[0].parameters[3] = 0;
    SilentProgress progress;
    BundleAdjustmentOptions options;
    options.max_reprojection_error_px = 50;  // The start is far off; nothing is an outlier.
    adjust_bundle(capture, options, progress);
    EXPECT_EQ(count_observations(capture), count_observations(truth));
    EXPECT_LT(rms_px(capture), 1e-4);
    EXPECT_NEAR(capture.cameras[0].parameters[0], 900, 1e-2);
    EXPECT_NEAR(capture.cameras[0].parameters[3], -0.05, 1e-5);
    const PoseComparison difference = compare_poses(poses_of(capture), poses_of(truth));
    EXPECT_LT(difference.max_position, 1e-4);
    EXPECT_LT(difference.max_rotation_deg, 1e-3);
}

TEST(BundleAdjustment, RecoversPosesFromNoisyPixels) {
    SyntheticCaptureOptions scene;
    scene.noise_px = 0.5;
    const Capture truth = synthetic_capture(true_camera(), scene);
    Capture capture = disturbed(truth, 0.01, 3);
    SilentProgress progress;
    BundleAdjustmentOptions options;
    options.max_reprojection_error_px = 20;
    adjust_bundle(capture, options, progress);
    // Two coordinates of 0.5 px each make an RMS of 0.5 sqrt(2), less what the unknowns absorb.
    EXPECT_GT(rms_px(capture), 0.55);
    EXPECT_LT(rms_px(capture), 0.71);
    // 0.5 px at 4 units and a focal length of 900 px are 2.2e-3 units for one observation.
    const PoseComparison difference = compare_poses(poses_of(capture), poses_of(truth));
    EXPECT_LT(difference.max_position, 4e-3);
    // The similarity is fitted to the centres, some 2 units around their middle: 0.1 degrees.
    EXPECT_LT(difference.max_rotation_deg, 0.1);
}

TEST(BundleAdjustment, RemovesGrossOutliersAndKeepsTheRest) {
    SyntheticCaptureOptions scene;
    scene.noise_px = 0.3;
    scene.outlier_share = 0.1;
    const Capture truth = synthetic_capture(true_camera(), scene);
    Capture capture = disturbed(truth, 0.002, 3);
    SilentProgress progress;
    adjust_bundle(capture, {}, progress);
    const double total = static_cast<double>(count_observations(truth));
    const double removed = total - static_cast<double>(count_observations(capture));
    EXPECT_GT(removed, 0.08 * total);
    EXPECT_LT(removed, 0.13 * total);
    EXPECT_LT(rms_px(capture), 0.45);
    EXPECT_LT(compare_poses(poses_of(capture), poses_of(truth)).max_position, 4e-3);
    for (const ScenePoint& point : capture.points) {
        for (const Observation& observation : point.track) {
            EXPECT_LE(reprojection_error_px(capture, point, observation), 2.0);
        }
    }
}

TEST(BundleAdjustment, LongTailsCostLessThanUnderLeastSquares) {
    // One observation in ten is five times as far off as the others, and none is a gross error.
    double error_robust = 0;
    double error_plain = 0;
    SilentProgress progress;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        SyntheticCaptureOptions scene;
        scene.points = 150;
        const Capture truth = synthetic_capture(true_camera(), scene);
        Capture capture = truth;
        std::mt19937 random(seed);
        std::normal_distribution<double> noise_px(0.0, 0.15);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        for (ScenePoint& point : capture.points) {
            for (Observation& seen : point.track) {
                const double factor = unit(random) < 0.1 ? 5.0 : 1.0;
                seen.pixel += factor * Eigen::Vector2d(noise_px(random), noise_px(random));
            }
        }
        Capture plain = capture;
        BundleAdjustmentOptions options;
        options.max_reprojection_error_px = 4;
        adjust_bundle(capture, options, progress);
        options.robust_last_pass = false;
        adjust_bundle(plain, options, progress);
        error_robust += compare_poses(poses_of(capture), poses_of(truth)).mean_position;
        error_plain += compare_poses(poses_of(plain), poses_of(truth)).mean_position;
    }
    EXPECT_LT(error_robust, 0.8 * error_plain);
}

TEST(BundleAdjustment, TheScaleOfTheLossFollowsTheNoise) {
    SyntheticCaptureOptions scene;
    scene.noise_px = 0.4;
    EXPECT_NEAR(cauchy_scale_px(synthetic_capture(true_camera(), scene)), 2.385 * 0.4, 0.05);
    EXPECT_EQ(cauchy_scale_px(synthetic_capture(true_camera(), {})), 0.05);
}

TEST(BundleAdjustment, GivesTheSameBytesEveryTime) {
    SyntheticCaptureOptions scene;
    scene.noise_px = 0.5;
    scene.outlier_share = 0.05;
    const Capture start = disturbed(synthetic_capture(true_camera(), scene), 0.002, 3);
    SilentProgress progress;
    Capture first = start;
    Capture second = start;
    adjust_bundle(first, {}, progress);
    adjust_bundle(second, {}, progress);
    for (std::size_t index = 0; index < first.views.size(); ++index) {
        EXPECT_EQ(first.views[index].cam_from_world.translation,
                  second.views[index].cam_from_world.translation);
        EXPECT_EQ(first.views[index].cam_from_world.rotation.coeffs(),
                  second.views[index].cam_from_world.rotation.coeffs());
    }
}

TEST(BundleAdjustment, HoldsAGivenLensAndThePrincipalPoint) {
    SyntheticCaptureOptions scene;
    scene.noise_px = 0.5;
    SilentProgress progress;
    Capture held = synthetic_capture(true_camera(), scene);
    BundleAdjustmentOptions options;
    options.refine_lens = false;
    adjust_bundle(held, options, progress);
    EXPECT_EQ(held.cameras[0], true_camera());

    Capture refined = synthetic_capture(true_camera(), scene);
    adjust_bundle(refined, {}, progress);
    EXPECT_NE(refined.cameras[0].parameters[0], 900);
    EXPECT_EQ(refined.cameras[0].parameters[1], 500);
    EXPECT_EQ(refined.cameras[0].parameters[2], 400);
}

TEST(BundleAdjustment, DropsPointsBehindACameraInsteadOfFailing) {
    Capture capture = synthetic_capture(true_camera(), {});
    capture.points[0].position_in_world = {0, 0, -40};  // Behind every camera.
    SilentProgress progress;
    const std::size_t points = capture.points.size();
    adjust_bundle(capture, {}, progress);
    EXPECT_EQ(capture.points.size(), points - 1);
}

TEST(BundleAdjustment, RefusesACaptureWithoutSharedPoints) {
    Capture capture = synthetic_capture(true_camera(), {});
    for (ScenePoint& point : capture.points) point.track.resize(1);
    SilentProgress progress;
    try {
        adjust_bundle(capture, {}, progress);
        ADD_FAILURE() << "expected a refusal";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-ADJUST-FEW");
        EXPECT_EQ(error.kind(), ErrorKind::kDegenerateCapture);
    }
}

TEST(BundleAdjustment, StopsWhenAsked) {
    Capture capture = synthetic_capture(true_camera(), {});
    SilentProgress progress;
    progress.interrupt();
    EXPECT_THROW(adjust_bundle(capture, {}, progress), Error);
}

}  // namespace
}  // namespace lumi
