// When photographs that share a lens are given one each.
#include "calib/poses/own_lenses.h"

#include <gtest/gtest.h>

#include <cmath>

#include "calib/poses/residual_pattern.h"
#include "tests/calib/adjust/synthetic_capture.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

/// A capture as if its photographs had been matched without a mistake, and nothing been told of
/// their lens.
class OwnLenses : public testing::Test {
 protected:
    void photograph(const Capture& truth) {
        std::vector<std::vector<std::uint32_t>> feature_of(truth.views.size());
        for (const View& view : truth.views) {
            const Camera& camera = camera_of(truth, view);
            Photograph photograph;
            photograph.name = view.name;
            photograph.width_px = camera.width_px;
            photograph.height_px = camera.height_px;
            photographs_.push_back(photograph);
            ColmapPhotograph features;
            matched_.photographs.push_back(features);
        }
        constexpr std::uint32_t kNotSeen = 0xffffffffU;
        for (std::vector<std::uint32_t>& features : feature_of)
            features.assign(truth.points.size(), kNotSeen);
        for (std::size_t point = 0; point < truth.points.size(); ++point) {
            for (const Observation& seen : truth.points[point].track) {
                const auto view = static_cast<std::size_t>(seen.view_index);
                auto& keypoints_px = matched_.photographs[view].keypoints_px;
                feature_of[view][point] = static_cast<std::uint32_t>(keypoints_px.size());
                keypoints_px.push_back(seen.pixel.cast<float>());
            }
        }
        for (std::size_t first = 0; first < truth.views.size(); ++first) {
            for (std::size_t second = first + 1; second < truth.views.size(); ++second) {
                VerifiedPair pair{static_cast<int>(first),
                                  static_cast<int>(second),
                                  PairConfiguration::kUncalibrated,
                                  {}};
                for (std::size_t point = 0; point < truth.points.size(); ++point)
                    if (feature_of[first][point] != kNotSeen &&
                        feature_of[second][point] != kNotSeen)
                        pair.inliers.push_back(
                            {feature_of[first][point], feature_of[second][point]});
                matched_.pairs.push_back(std::move(pair));
            }
        }
    }

    [[nodiscard]] std::optional<SecondModel> asked(const Capture& refined) {
        const PoseOptions options;
        const CameraGroups groups = group_cameras(photographs_, std::nullopt, {});
        const MappingJob job{photographs_,    groups, options,   false,    true,
                             scratch_.path(), 1,      progress_, evidence_};
        return find_own_lenses(job, matched_, LensPolicy::kAuto, refined);
    }

    ScratchFolder scratch_;
    SilentProgress progress_;
    PoseEvidence evidence_;
    std::vector<Photograph> photographs_;
    MatchedPhotographs matched_;
};

TEST_F(OwnLenses, AreNotTakenForAFisheyeThatAllShare) {
    const Camera fisheye{
        1100, 1100, LensModel::kOpenCvFisheye, {480, 480, 550, 550, 0.02, 0, 0, 0}};
    const Capture truth = synthetic_capture(
        fisheye,
        {.views = 12, .points = 2000, .noise_px = 0.07, .depth_of_cloud = 0.5, .arc_radius = 1.2});
    photograph(truth);
    EXPECT_FALSE(asked(truth).has_value());
}

TEST_F(OwnLenses, AreFoundWherePhotographsWereZoomed) {
    Capture truth = synthetic_capture(pinhole_camera(1000, 800, 900),
                                      {.views = 10, .points = 900, .noise_px = 0.3});
    Capture shared = truth;
    for (ScenePoint& point : truth.points)
        for (Observation& seen : point.track)
            if (seen.view_index % 2 == 1)
                seen.pixel =
                    Eigen::Vector2d(500, 400) + 0.85 * (seen.pixel - Eigen::Vector2d(500, 400));
    shared.points = truth.points;
    PoseEvidence evidence;
    refine(shared, LensPolicy::kAuto, {}, 1, evidence, progress_);
    photograph(truth);
    const std::optional<SecondModel> own = asked(shared);
    ASSERT_TRUE(own.has_value());
    ASSERT_EQ(own->refined.cameras.size(), truth.views.size());
    for (const View& view : own->refined.views) {
        const bool is_zoomed = view.name.at(6) % 2 == 1;
        EXPECT_NEAR(focal_length_px(camera_of(own->refined, view)).x(), is_zoomed ? 765 : 900, 20)
            << view.name;
    }
}

TEST(ZoomEvidence, TellsOfAZoomThatSharedLensesLeaveMoreFor) {
    EXPECT_TRUE((ZoomEvidence{0.0, true, false, false}.is_told()));
}

TEST(ZoomEvidence, TellsOfASmallZoomWhereMoreIsExplainedAndFocalLengthsAreSureToDiffer) {
    EXPECT_TRUE((ZoomEvidence{0.016, false, false, true}.is_told()));
    EXPECT_FALSE((ZoomEvidence{0.016, false, false, false}.is_told()));
    EXPECT_FALSE((ZoomEvidence{0.016, false, true, true}.is_told())) << "a fisheye";
}

TEST(ZoomEvidence, TellsOfNoZoomThatExplainsNothingMore) {
    // Two groups along a wall that share a strip: focal lengths of 351 +- 3 and 417 +- 4 px, and
    // as much left as with the one of 384 px that they have. Cameras would be 19 % off.
    EXPECT_FALSE((ZoomEvidence{0.0, false, false, true}.is_told()));
}

}  // namespace
}  // namespace lumi
