// 200 captures of known truth, each through the whole refinement: ctest label "slow".
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <random>

#include "calib/adjust/adjustment_covariance.h"
#include "calib/poses/refinement.h"
#include "tests/calib/adjust/aligned_steps.h"
#include "tests/calib/adjust/synthetic_capture.h"

namespace lumi {
namespace {

constexpr double kTwoSided95 = 1.959964;

/// A lens as photographers have them, another in each draw.
Camera drawn_lens(int draw, std::mt19937& random) {
    std::uniform_real_distribution<double> sign_and_size(-1.0, 1.0);
    const double focal_px = 700 + 150 * sign_and_size(random);
    switch (draw % 4) {
        case 0:
            return {1000, 800, LensModel::kSimplePinhole, {focal_px, 500, 400}};
        case 1:
            return {1000,
                    800,
                    LensModel::kSimpleRadial,
                    {focal_px, 500, 400, 0.15 * sign_and_size(random)}};
        case 2:
            return {1000, 800, LensModel::kRadial, {focal_px, 500, 400, -0.15, 0.1}};
        default:
            return {1000,
                    800,
                    LensModel::kSimpleRadial,
                    {focal_px, 500 + 20 * sign_and_size(random), 380, -0.1}};
    }
}

Capture drawn_scene(const Camera& lens, double noise_px, unsigned seed) {
    SyntheticCaptureOptions scene;
    scene.views = 7;
    scene.points = 70;
    scene.noise_px = noise_px;
    scene.arc_deg = 90;
    scene.arc_radius = 2.2;
    scene.seed = seed;
    return synthetic_capture(lens, scene);
}

/// How many intervals held the truth.
struct Coverage {
    int contained = 0;
    int total = 0;
    void count(bool contains) {
        contained += contains ? 1 : 0;
        ++total;
    }
    [[nodiscard]] double share() const { return static_cast<double>(contained) / total; }
};

TEST(StatedIntervals, ContainTheTruthInNinetyFiveOfAHundredCaptures) {
    constexpr int kDraws = 200;
    std::mt19937 random(2024);
    Coverage focal;
    Coverage poses;
    std::map<std::string, int> chosen;
    SilentProgress progress;
    for (int draw = 0; draw < kDraws; ++draw) {
        const Camera lens = drawn_lens(draw, random);
        const Capture truth = drawn_scene(lens, 0.0, 1000U + static_cast<unsigned>(draw));
        Capture capture = truth;
        std::normal_distribution<double> noise_px(0.0, 0.2 + 0.1 * (draw % 5));
        for (ScenePoint& point : capture.points) {
            for (Observation& seen : point.track) {
                seen.pixel += Eigen::Vector2d(noise_px(random), noise_px(random));
            }
        }
        // As mapping leaves it: the usual model, a focal length that is a bit off.
        capture.cameras[0] = {
            1000, 800, LensModel::kSimpleRadial, {1.01 * lens.parameters[0], 500, 400, 0}};
        PoseEvidence evidence;
        PoseOptions options;
        options.max_reprojection_error_px = 6;  // Noise is all there is.
        refine(capture, LensPolicy::kAuto, options, 1, evidence, progress);
        ASSERT_EQ(capture.views.size(), truth.views.size());
        ASSERT_FALSE(evidence.lenses[0].sigma.empty());
        ++chosen[text_of(evidence.lenses[0].form)];
        focal.count(std::abs(capture.cameras[0].parameters[0] - lens.parameters[0]) <=
                    kTwoSided95 * evidence.lenses[0].sigma[0]);

        BundleAdjustmentOptions adjustment;
        adjustment.held_lens_parameters = {evidence.lenses[0].form.held};
        const auto covariance = adjustment_covariance(capture, adjustment, progress);
        ASSERT_TRUE(covariance.has_value());
        const std::vector<Vector6> steps = aligned_pose_steps(truth, capture);
        for (std::size_t view = 0; view < steps.size(); ++view) {
            for (Eigen::Index row = 0; row < 6; ++row) {
                poses.count(std::abs(steps[view][row]) <=
                            kTwoSided95 * std::sqrt(covariance->poses[view](row, row)));
            }
        }
    }
    std::string forms;
    for (const auto& [form, count] : chosen) forms += form + ": " + std::to_string(count) + "\n";
    RecordProperty("focal_length_contained", focal.contained);
    RecordProperty("pose_coordinates_contained_per_mille", static_cast<int>(1000 * poses.share()));
    std::printf("focal length: %d of %d; pose coordinates: %d of %d (%.1f %%)\n%s", focal.contained,
                focal.total, poses.contained, poses.total, 100 * poses.share(), forms.c_str());
    EXPECT_GE(focal.share(), 0.92) << forms;
    EXPECT_LE(focal.share(), 0.98) << forms;
    EXPECT_GE(poses.share(), 0.92) << forms;
    EXPECT_LE(poses.share(), 0.98) << forms;
}

}  // namespace
}  // namespace lumi
