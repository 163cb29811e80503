#include "calib/matching/rotation_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "calib/capture/degrees.h"
#include "calib/capture/rigid3.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

/// Views of one cloud of points, 3 to 9 units away, and the pairs between them.
struct Views {
    std::vector<ColmapPhotograph> photographs;
    std::vector<VerifiedPair> pairs;
};

Views views_of_a_cloud(const Camera& camera, const std::vector<Rigid3>& poses, double noise_px) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> noise(0.0, noise_px);
    Views views;
    views.photographs.resize(poses.size());
    for (int point = 0; point < 200; ++point) {
        const double depth = 3.0 + 6.0 * unit(random);
        const Eigen::Vector3d place(depth * (unit(random) - 0.5), depth * (unit(random) - 0.5),
                                    depth);
        for (std::size_t index = 0; index < poses.size(); ++index) {
            // Points need not lie inside the picture for this question.
            const Eigen::Vector2d pixel = project(camera, poses[index] * place).value();
            views.photographs[index].keypoints_px.push_back(
                (pixel + Eigen::Vector2d(noise(random), noise(random))).cast<float>());
        }
    }
    for (int first = 0; first < static_cast<int>(poses.size()); ++first) {
        for (int second = first + 1; second < static_cast<int>(poses.size()); ++second) {
            VerifiedPair pair{first, second, PairConfiguration::kPlanarOrPanoramic, {}};
            for (std::uint32_t match = 0; match < 200; ++match)
                pair.inliers.push_back({match, match});
            views.pairs.push_back(pair);
        }
    }
    return views;
}

/// Four poses: each turned by `turn_deg` and moved by `step` against the one before.
std::vector<Rigid3> walk(double turn_deg, double step) {
    std::vector<Rigid3> poses;
    for (int index = 0; index < 4; ++index) {
        const Eigen::Quaterniond turn(
            Eigen::AngleAxisd(turn_deg * index * kRadiansPerDegree, Eigen::Vector3d::UnitY()));
        poses.push_back({turn, Eigen::Vector3d(step * index, 0, 0)});
    }
    return poses;
}

const Camera kTurnedCamera = pinhole_camera(1000, 800, 900);

MotionEvidence evidence_of(const std::vector<Rigid3>& poses, double believed_focal_px,
                           bool calibrated = false) {
    const Views views = views_of_a_cloud(kTurnedCamera, poses, 0.7);
    return check_motion({{pinhole_camera(1000, 800, believed_focal_px), calibrated}},
                        views.photographs, views.pairs, calibrated, SilentProgress());
}

TEST(RotationCheck, SeesACameraThatTurnsOnTheSpot) {
    EXPECT_EQ(evidence_of(walk(8, 0), 900).pairs, 6);
    EXPECT_EQ(evidence_of(walk(8, 0), 900).rotation_share(), 1.0);
    EXPECT_EQ(evidence_of(walk(8, 0), 900, true).rotation_share(), 1.0);
}

TEST(RotationCheck, NearlyAllThatATurningCameraSeesMovesAlike) {
    EXPECT_TRUE(evidence_of(walk(8, 0), 900).only_turned());
    EXPECT_GT(evidence_of(walk(8, 0), 900).turned_share, 0.95);
    EXPECT_LT(evidence_of(walk(4, 0.3), 900).turned_share, 0.7);
}

TEST(RotationCheck, SeesItWithAWrongFocalLengthToo) {
    for (const double believed_px : {400.0, 650.0, 1300.0, 2700.0}) {
        EXPECT_EQ(evidence_of(walk(8, 0), believed_px).rotation_share(), 1.0) << believed_px;
    }
}

TEST(RotationCheck, SeesACameraThatStepsSideways) {
    // A tenth of the distance to the nearest points, as the advice says.
    for (const double believed_px : {450.0, 900.0, 1800.0}) {
        EXPECT_EQ(evidence_of(walk(0, 0.3), believed_px).rotation_share(), 0.0) << believed_px;
        EXPECT_EQ(evidence_of(walk(4, 0.3), believed_px).rotation_share(), 0.0) << believed_px;
    }
}

TEST(RotationCheck, TellsACameraThatStoodStillFromOneThatTurned) {
    EXPECT_TRUE(evidence_of(walk(0, 0), 900).stood_still());
    const std::string hint = turntable_hint(evidence_of(walk(0, 0), 900));
    EXPECT_THAT(hint, testing::HasSubstr("[poses] masks"));
    EXPECT_THAT(hint, testing::HasSubstr("[depth] masks")) << "else the room is drawn, too";
    EXPECT_FALSE(evidence_of(walk(1, 0), 900).stood_still());
    EXPECT_FALSE(evidence_of(walk(0, 0.3), 900).stood_still());
    EXPECT_EQ(turntable_hint(evidence_of(walk(8, 0), 900)), "");
}

TEST(RotationCheck, IgnoresPairsWithFewMatches) {
    Views views = views_of_a_cloud(kTurnedCamera, walk(8, 0), 0.7);
    for (VerifiedPair& pair : views.pairs) pair.inliers.resize(19);
    EXPECT_EQ(check_motion({{kTurnedCamera, false}}, views.photographs, views.pairs, false,
                           SilentProgress())
                  .pairs,
              0);
}

TEST(RotationCheck, StopsOnRequest) {
    const Views views = views_of_a_cloud(kTurnedCamera, walk(8, 0), 0.7);
    SilentProgress progress;
    progress.interrupt();
    EXPECT_THROW(static_cast<void>(check_motion({{kTurnedCamera, false}}, views.photographs,
                                                views.pairs, false, progress)),
                 Error);
}

TEST(RotationCheck, FitsTheRotationDespiteOutliers) {
    const Eigen::Quaterniond truth(
        Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, -2, 0.5).normalized()));
    std::mt19937 random(2);
    std::uniform_real_distribution<double> coordinate(-0.5, 0.5);
    DirectionPairs directions;
    for (int index = 0; index < 100; ++index) {
        const Eigen::Vector3d first(coordinate(random), coordinate(random), 1);
        const Eigen::Vector3d anywhere(coordinate(random), coordinate(random), 1);
        directions.first.push_back(first);
        directions.second.push_back(index % 4 == 0 ? anywhere : truth * first);
    }
    const RotationFit fit = fit_rotation(directions, 1e-3);
    EXPECT_LT(fit.second_from_first.angularDistance(truth), 1e-6);
    EXPECT_NEAR(fit.inlier_share, 0.75, 0.011);
}

}  // namespace
}  // namespace lumi
