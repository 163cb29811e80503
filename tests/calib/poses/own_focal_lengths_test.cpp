// When photographs that share a lens are given focal lengths of their own.
#include "calib/poses/own_focal_lengths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "calib/poses/pose_comparison.h"
#include "calib/poses/residual_pattern.h"
#include "tests/calib/adjust/synthetic_capture.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

const Camera kBreathingLens{1000, 800, LensModel::kSimpleRadial, {850, 500, 400, -0.08}};

const Camera kOffCentreLens{1000, 800, LensModel::kSimpleRadial, {850, 540, 370, -0.08}};

/// The truth: as if the focus had changed each view's focal length by up to `share` at random.
struct Breathing {
    Capture truth;  ///< Poses, and what was seen.
    std::vector<double> zooms;
};

Breathing breathing_capture(double share, unsigned seed, const Camera& lens = kBreathingLens) {
    Breathing breathing{
        synthetic_capture(
            lens, {.views = 10, .points = 200, .noise_px = 0.2, .arc_radius = 2.2, .seed = seed}),
        {}};
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> zoom(1.0, 1.0 + share);
    for (std::size_t view = 0; view < breathing.truth.views.size(); ++view) {
        breathing.zooms.push_back(zoom(random));
    }
    const Eigen::Vector2d middle_px = principal_point_px(lens);
    for (ScenePoint& point : breathing.truth.points) {
        for (Observation& seen : point.track) {
            const double factor = breathing.zooms[static_cast<std::size_t>(seen.view_index)];
            seen.pixel = middle_px + factor * (seen.pixel - middle_px);
        }
    }
    return breathing;
}

class OwnFocalLengths : public testing::Test {
 protected:
    /// As mapping leaves it, but for the truth of its poses, and refined with a shared lens.
    void refine_shared(const Capture& seen, LensPolicy policy = LensPolicy::kNamed) {
        policy_ = policy;
        mapped_ = seen;
        if (policy == LensPolicy::kNamed || policy == LensPolicy::kAuto) {
            mapped_.cameras[0] = {1000, 800, LensModel::kSimpleRadial, {860, 500, 400, 0}};
        }
        refined_ = mapped_;
        refine(refined_, policy, {}, 1, evidence_, progress_);
    }

    [[nodiscard]] std::optional<SecondModel> asked(bool shared_lens = true) {
        PoseOptions options;
        options.shared_lens = shared_lens;
        const std::vector<Photograph> photographs;
        const CameraGroups groups;
        const MappingJob job{photographs,     groups, options,   false,    true,
                             scratch_.path(), 1,      progress_, evidence_};
        return find_own_focal_lengths(job, policy_, mapped_, refined_);
    }

    ScratchFolder scratch_;
    SilentProgress progress_;
    PoseEvidence evidence_;
    LensPolicy policy_ = LensPolicy::kNamed;
    Capture mapped_;
    Capture refined_;
};

TEST_F(OwnFocalLengths, AreFoundWhereTheFocusMoved) {
    const Breathing breathing = breathing_capture(0.02, 1);
    refine_shared(breathing.truth, LensPolicy::kAuto);
    const std::optional<SecondModel> own = asked();
    ASSERT_TRUE(own.has_value());
    ASSERT_EQ(own->refined.views.size(), breathing.zooms.size());
    const double first_px = focal_length_px(own->refined.cameras[0]).mean();
    for (std::size_t view = 0; view < breathing.zooms.size(); ++view) {
        const Camera& lens = camera_of(own->refined, own->refined.views[view]);
        EXPECT_NEAR(focal_length_px(lens).mean() / first_px,
                    breathing.zooms[view] / breathing.zooms[0], 0.002)
            << view;
    }
    EXPECT_EQ(evidence_.lenses.size(), breathing.zooms.size());
    EXPECT_TRUE(evidence_.lenses.front().choice.has_value());
    EXPECT_THAT(own->warning, testing::HasSubstr("E-POSES-ZOOM"));
}

TEST_F(OwnFocalLengths, PlaceCamerasAsWellAsIfTheFocusHadStayed) {
    const Breathing still = breathing_capture(0, 2);
    refine_shared(still.truth);
    const auto error_of = [](const Capture& found, const Capture& truth) {
        return compare_poses(named_poses(found), named_poses(truth)).max_rotation_deg;
    };
    const double still_deg = error_of(refined_, still.truth);
    const Breathing breathing = breathing_capture(0.03, 2);
    refine_shared(breathing.truth);
    const double shared_deg = error_of(refined_, breathing.truth);
    const std::optional<SecondModel> own = asked();
    ASSERT_TRUE(own.has_value());
    const double own_deg = error_of(own->refined, breathing.truth);
    EXPECT_GT(shared_deg, 3 * own_deg);
    EXPECT_LT(own_deg, 3 * still_deg + 0.02);
}

TEST_F(OwnFocalLengths, KeepTheDistortionThatAllShare) {
    const Breathing breathing = breathing_capture(0.02, 3);
    refine_shared(breathing.truth);
    const std::optional<SecondModel> own = asked();
    ASSERT_TRUE(own.has_value());
    for (const Camera& lens : own->refined.cameras) {
        const Eigen::Vector3d far(0.5, 0.4, 1);
        const Camera true_lens{
            1000, 800, LensModel::kSimpleRadial, {focal_length_px(lens).mean(), 500, 400, -0.08}};
        EXPECT_LT((*project(lens, far) - *project(true_lens, far)).norm(), 1.0);
    }
}

TEST_F(OwnFocalLengths, PlaceCamerasBetterAlsoWhereThePrincipalPointIsOffTheMiddle) {
    const Breathing breathing = breathing_capture(0.02, 2, kOffCentreLens);
    refine_shared(breathing.truth, LensPolicy::kAuto);
    const std::optional<SecondModel> own = asked();
    ASSERT_TRUE(own.has_value());
    const auto error_of = [&](const Capture& found) {
        return compare_poses(named_poses(found), named_poses(breathing.truth)).max_position;
    };
    EXPECT_LT(error_of(own->refined), error_of(refined_) / 4);
    const Eigen::Vector2d true_px = principal_point_px(kOffCentreLens);
    for (const Camera& lens : own->refined.cameras) {
        EXPECT_LT((principal_point_px(lens) - true_px).norm(), 12) << "50 px from the middle";
    }
}

/// The focus moved, and a second lens has one view, of which hardly anything is seen.
TEST_F(OwnFocalLengths, AreFoundBesideALensWhosePhotographIsDropped) {
    Breathing breathing = breathing_capture(0.02, 1);
    int seen_points = 0;
    for (ScenePoint& point : breathing.truth.points) {
        std::erase_if(point.track, [&](const Observation& seen) {
            return seen.view_index == 4 && ++seen_points > 5;
        });
    }
    breathing.truth.cameras.insert(breathing.truth.cameras.begin(), kBreathingLens);
    for (View& view : breathing.truth.views) view.camera_index = 1;
    breathing.truth.views[4].camera_index = 0;
    policy_ = LensPolicy::kNamed;
    mapped_ = breathing.truth;
    for (Camera& lens : mapped_.cameras) {
        lens = {1000, 800, LensModel::kSimpleRadial, {860, 500, 400, 0}};
    }
    refined_ = mapped_;
    refine(refined_, policy_, {}, 1, evidence_, progress_);
    ASSERT_EQ(refined_.cameras.size(), 1u);
    const std::optional<SecondModel> own = asked();
    ASSERT_TRUE(own.has_value());
    EXPECT_EQ(own->refined.views.size(), breathing.zooms.size() - 1);
    EXPECT_EQ(own->refined.cameras.size(), breathing.zooms.size() - 1);
    EXPECT_EQ(evidence_.lenses.size(), breathing.zooms.size() - 1);
    validate(own->mapped, "the mapped model");
}

TEST_F(OwnFocalLengths, AreFoundOfACalibratedLensUnlessItIsHeld) {
    const Breathing breathing = breathing_capture(0.02, 1);
    refine_shared(breathing.truth, LensPolicy::kGiven);
    EXPECT_TRUE(asked().has_value());
    refine_shared(breathing.truth, LensPolicy::kHeld);
    EXPECT_FALSE(asked().has_value());
}

TEST_F(OwnFocalLengths, AreNotAskedForWhereOneFocusExplainsThePictures) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        refine_shared(breathing_capture(0, seed).truth);
        EXPECT_FALSE(residual_pattern(refined_).is_zoomed()) << seed;
        EXPECT_FALSE(asked().has_value()) << seed;
    }
}

TEST_F(OwnFocalLengths, AreNotTakenForAPrincipalPointOffTheMiddleOfAllPictures) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        refine_shared(breathing_capture(0, seed, kOffCentreLens).truth);
        EXPECT_TRUE(residual_pattern(refined_).is_zoomed()) << seed << ": it looks like a zoom";
        EXPECT_FALSE(asked().has_value()) << seed;
    }
}

TEST_F(OwnFocalLengths, AreNotAskedForWhereLensesAreNotShared) {
    refine_shared(breathing_capture(0.02, 1).truth);
    EXPECT_FALSE(asked(false).has_value());
}

}  // namespace
}  // namespace lumi
