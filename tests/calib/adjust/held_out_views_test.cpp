#include "calib/adjust/held_out_views.h"

#include <gtest/gtest.h>

#include <cmath>

#include "calib/adjust/lens_selection.h"
#include "tests/calib/adjust/synthetic_capture.h"

namespace lumi {
namespace {

constexpr double kNoise_px = 0.4;

Capture noisy_scene() {
    SyntheticCaptureOptions scene;
    scene.views = 10;
    scene.points = 400;
    scene.noise_px = kNoise_px;
    return synthetic_capture({1000, 800, LensModel::kSimplePinhole, {900, 500, 400}}, scene);
}

double rms_of(const std::vector<HeldOutFold>& folds) {
    double sum = 0;
    double residuals = 0;
    for (const HeldOutFold& fold : folds) {
        sum += fold.squared_error_px2;
        residuals += fold.residuals;
    }
    return std::sqrt(sum / residuals);
}

TEST(HeldOutViews, PredictNoBetterThanTheNoiseAndNotMuchWorse) {
    Capture capture = noisy_scene();
    SilentProgress progress;
    fit_bundle(capture, {}, progress);
    const std::vector<HeldOutFold> held_out =
        predict_held_out_views(capture, 0, {}, {}, 2, progress);
    ASSERT_EQ(held_out.size(), 10u);
    for (const HeldOutFold& fold : held_out) EXPECT_GT(fold.residuals, 500);
    // Points carry the noise of the eight views they come from: their share of a coordinate's
    // variance is 3 unknowns over 16 residuals.
    EXPECT_GT(rms_of(held_out), kNoise_px);
    EXPECT_LT(rms_of(held_out), kNoise_px * std::sqrt(1 + 2 * 3.0 / 16));
    EXPECT_LT(rms_of(fitted_views(capture, 0, {})), kNoise_px);
}

TEST(HeldOutViews, AWrongLensPredictsWorse) {
    Capture right = noisy_scene();
    Capture wrong = right;
    wrong.cameras[0].parameters[0] = 990;
    BundleAdjustmentOptions held;
    held.refine_lens = false;
    SilentProgress progress;
    fit_bundle(right, held, progress);
    fit_bundle(wrong, held, progress);
    EXPECT_GT(rms_of(predict_held_out_views(wrong, 0, held, {}, 2, progress)),
              1.2 * rms_of(predict_held_out_views(right, 0, held, {}, 2, progress)));
}

TEST(HeldOutViews, GrossErrorsCountTheLimit) {
    Capture capture = noisy_scene();
    SilentProgress progress;
    fit_bundle(capture, {}, progress);
    capture.points[0].track[0].pixel += Eigen::Vector2d(500, 0);
    HeldOutViewsOptions options;
    options.max_error_px = 3;
    const auto view = static_cast<std::size_t>(capture.points[0].track[0].view_index);
    const double before = fitted_views(noisy_scene(), 0, options)[view].squared_error_px2;
    const double after = fitted_views(capture, 0, options)[view].squared_error_px2;
    EXPECT_LT(std::abs(after - before), 0.3 * before + 9.0);
}

TEST(HeldOutViews, AreUnusableWhereNoTwoOthersSeeTheSame) {
    Capture capture = noisy_scene();
    for (ScenePoint& point : capture.points) point.track.resize(2);
    SilentProgress progress;
    EXPECT_FALSE(any_usable(predict_held_out_views(capture, 0, {}, {}, 1, progress)));
    EXPECT_FALSE(any_usable(fitted_views(capture, 0, {})));
}

TEST(HeldOutViews, CountTheSameResidualsForEveryLens) {
    Capture capture = noisy_scene();
    SilentProgress progress;
    const auto first = predict_held_out_views(capture, 0, {}, {}, 1, progress);
    capture.cameras[0] = {1000, 800, LensModel::kRadial, {800, 500, 400, 0.2, 0.1}};
    const auto second = predict_held_out_views(capture, 0, {}, {}, 1, progress);
    const auto third = fitted_views(capture, 0, {});
    for (std::size_t view = 0; view < first.size(); ++view) {
        EXPECT_EQ(first[view].residuals, second[view].residuals);
        EXPECT_EQ(first[view].residuals, third[view].residuals);
    }
}

}  // namespace
}  // namespace lumi
