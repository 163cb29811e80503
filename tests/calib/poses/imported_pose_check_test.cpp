#include "calib/poses/imported_pose_check.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "calib/poses/imported_model_check.h"
#include "calib/work/error.h"
#include "tests/calib/synthetic_capture.h"

namespace lumi {
namespace {

Camera camera() { return pinhole_camera(640, 480, 500); }

/// Photographs of a capture as features would find its points, all of them in all neighbours.
struct Matched {
    Capture capture = synthetic_capture(camera(), 8, 60);
    std::vector<ColmapPhotograph> photographs = std::vector<ColmapPhotograph>(8);
    std::vector<VerifiedPair> pairs;

    Matched() {
        for (int view = 0; view + 1 < 8; ++view)
            pairs.push_back({view, view + 1, PairConfiguration::kUncalibrated, {}});
        for (const ScenePoint& point : capture.points) {
            if (point.track.size() < 8) continue;
            for (const Observation& seen : point.track) {
                photographs[static_cast<std::size_t>(seen.view_index)].keypoints_px.push_back(
                    seen.pixel.cast<float>());
            }
        }
        for (VerifiedPair& pair : pairs) {
            for (std::uint32_t i = 0; i < photographs[0].keypoints_px.size(); ++i) {
                pair.inliers.push_back({i, i});
            }
        }
    }
    [[nodiscard]] PoseCheck check() const { return check_poses(capture, photographs, pairs); }
};

std::string refusal_of(const PoseCheck& check) {
    try {
        return warning_of(check);
    } catch (const Error& error) {
        return error.code();
    }
}

TEST(ImportedPoseCheck, TruePosesAreLeftAlone) {
    const PoseCheck check = Matched().check();
    EXPECT_EQ(check.pairs, 7);
    EXPECT_EQ(check.pairs_denied, 0);
    EXPECT_LT(check.median_error_px, 1e-3);
    EXPECT_EQ(refusal_of(check), "");
}

TEST(ImportedPoseCheck, PicturesThatWereTurnedUprightElsewhereAreRefused) {
    Matched turned;
    for (ColmapPhotograph& photograph : turned.photographs) {
        for (Eigen::Vector2f& pixel : photograph.keypoints_px) {
            pixel = Eigen::Vector2f(640, 480) - pixel;
        }
    }
    // Within a pixel each is a picture of the scene inside out.
    EXPECT_LT(turned.check().median_error_px, 1);
    EXPECT_EQ(refusal_of(turned.check()), "E-IMPORT-TURNED");
}

TEST(ImportedPoseCheck, AxesOfAnotherConventionAreRefused) {
    Matched flipped;
    const Eigen::Quaterniond open_gl(0, 1, 0, 0);  // Half a turn around x.
    for (View& view : flipped.capture.views) {
        view.cam_from_world = Rigid3{open_gl, Eigen::Vector3d::Zero()} * view.cam_from_world;
    }
    EXPECT_EQ(refusal_of(flipped.check()), "E-IMPORT-DENIED");
}

TEST(ImportedPoseCheck, PosesOfOtherPhotographsAreRefusedAndOfTwoWarnedOf) {
    Matched shuffled;
    for (std::size_t view = 0; view < 4; ++view) {
        std::swap(shuffled.capture.views[view].cam_from_world,
                  shuffled.capture.views[(3 * view + 4) % 8].cam_from_world);
    }
    EXPECT_EQ(refusal_of(shuffled.check()), "E-IMPORT-DENIED");
    Matched one;
    Rigid3& pose = one.capture.views[3].cam_from_world;
    pose = Rigid3{Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX())),
                  Eigen::Vector3d::Zero()} *
           pose;
    EXPECT_THAT(refusal_of(one.check()), testing::HasSubstr("2 of 7 pairs"));
}

TEST(ImportedPoseCheck, SaysSoWhereFewPairsMatch) {
    EXPECT_THAT(warning_of({.pairs_asked = 8, .pairs = 3}), testing::HasSubstr("3 of 8 pairs"));
    EXPECT_EQ(warning_of({.pairs_asked = 4, .pairs = 3}), "");
    EXPECT_THAT(warning_of({.pairs_asked = 0, .pairs = 0}), testing::HasSubstr("nothing confirms"));
}

TEST(ImportedPoseCheck, TwoOrThreePhotographsAreNotTooFewToDenyTheirPoses) {
    EXPECT_EQ(refusal_of({.pairs_asked = 1, .pairs = 1, .pairs_denied = 1}), "E-IMPORT-DENIED");
    EXPECT_EQ(refusal_of({.pairs_asked = 2, .pairs = 2, .pairs_denied = 2}), "E-IMPORT-DENIED");
    EXPECT_EQ(refusal_of({.pairs_asked = 1, .pairs = 1, .pairs_denied = 1, .pairs_turned = 1}),
              "E-IMPORT-TURNED");
    // Of many that were asked two may be mistaken.
    EXPECT_THAT(refusal_of({.pairs_asked = 8, .pairs = 2, .pairs_denied = 2}),
                testing::HasSubstr("2 of 2 pairs of photographs deny"));
    EXPECT_EQ(refusal_of({.pairs_asked = 1, .pairs = 1}), "");
}

/// An object that looks alike from all sides, from its sides: opposite ones may.
TEST(ImportedPoseCheck, WhereThePosesMakeNoNeighboursPairsThatLookAlikeOnlyWarn) {
    for (const int pairs : {1, 2}) {
        EXPECT_THAT(refusal_of({.pairs_asked = 0, .pairs = pairs, .pairs_denied = pairs}),
                    testing::HasSubstr("deny the imported poses"));
        EXPECT_THAT(
            refusal_of(
                {.pairs_asked = 0, .pairs = pairs, .pairs_denied = pairs, .pairs_turned = pairs}),
            testing::HasSubstr("deny the imported poses"));
    }
    EXPECT_THAT(refusal_of({.pairs_asked = 0, .pairs = 6, .pairs_denied = 5}),
                testing::HasSubstr("deny the imported poses"));
}

/// One facade, by axes that were exported wrongly.
TEST(ImportedPoseCheck, WhereThePosesMakeNoNeighboursAllPairsTogetherRefuseThem) {
    for (const int pairs : {3, 6}) {
        EXPECT_EQ(refusal_of({.pairs_asked = 0, .pairs = pairs, .pairs_denied = pairs}),
                  "E-IMPORT-DENIED");
        EXPECT_EQ(
            refusal_of(
                {.pairs_asked = 0, .pairs = pairs, .pairs_denied = pairs, .pairs_turned = pairs}),
            "E-IMPORT-TURNED");
    }
}

std::string contradiction_in(const Capture& capture) {
    try {
        expect_consistent(capture);
    } catch (const Error& error) {
        return error.code();
    }
    return "";
}

TEST(ImportedPoseCheck, PosesThatDenyTheirOwnPointsAreRefused) {
    const Capture truth = synthetic_capture(camera(), 3, 60);
    EXPECT_EQ(contradiction_in(truth), "");
    Capture backwards = truth;
    for (View& view : backwards.views) {
        view.cam_from_world =
            Rigid3{Eigen::Quaterniond(0, 1, 0, 0), Eigen::Vector3d::Zero()} * view.cam_from_world;
    }
    EXPECT_EQ(contradiction_in(backwards), "E-IMPORT-DENIED");
    Capture swapped = truth;
    std::swap(swapped.views[0].cam_from_world, swapped.views[2].cam_from_world);
    EXPECT_EQ(contradiction_in(swapped), "E-IMPORT-DENIED");
    Capture without_points = swapped;
    without_points.points.clear();
    EXPECT_EQ(contradiction_in(without_points), "");
}

TEST(ImportedPoseCheck, CamerasThatAllStandAtOnePlaceAreRefused) {
    Capture turning = synthetic_capture(camera(), 5, 0);
    for (View& view : turning.views) view.cam_from_world.translation.setZero();
    EXPECT_EQ(contradiction_in(turning), "E-IMPORT-ONEPLACE");
    turning.views.resize(1);
    EXPECT_EQ(contradiction_in(turning), "");
}

/// Far from the origin rounding leaves them some way apart.
TEST(ImportedPoseCheck, OfCamerasAtOnePlaceADistanceIsMeasuredTowardsAllSides) {
    const Eigen::Vector3d place(300000, 5000000, 200);
    const Rigid3 first = looking_at(place, place + Eigen::Vector3d(1, 0, 4));
    const Rigid3 second = looking_at(place, place + Eigen::Vector3d(0, 0.2, 4));
    const Eigen::Vector3d far = first.rotation.conjugate() * Eigen::Vector3d(0.1, 0.2, 1);
    const Eigen::Vector2d in_first = *project(camera(), first.rotation * far);
    const Eigen::Vector2d in_second = *project(camera(), second.rotation * far);
    for (int eighth = 0; eighth < 8; ++eighth) {
        const double angle = eighth * std::numbers::pi / 4;
        const Eigen::Vector2d aside_px(3 * std::cos(angle), 3 * std::sin(angle));
        EXPECT_NEAR(
            distance_from_ray_px(camera(), first, in_first, camera(), second, in_second + aside_px),
            3, 0.3)
            << eighth;
    }
}

TEST(ImportedPoseCheck, TheDistanceFromARayIsNoneBeforeTheFirstCameraAloneAndSidewaysInPixels) {
    const Rigid3 first = looking_at({0, 0, -4}, {0, 0, 0});
    const Rigid3 second = looking_at({1, 0, -4}, {0, 0, 0});
    const auto distance_px = [&](const Eigen::Vector3d& point, const Eigen::Vector2d& aside_px) {
        const Eigen::Vector2d in_second = *project(camera(), second * point);
        return distance_from_ray_px(camera(), first, *project(camera(), first * point), camera(),
                                    second, in_second + aside_px);
    };
    for (const double depth : {-2.0, 0.0, 1.0, 50.0}) {
        EXPECT_LT(distance_px({0, 0, depth}, {0, 0}), 1e-6) << depth;
    }
    // The epipolar line of the middle is level; one pixel across it near the middle is an angle of
    // 1/500.
    EXPECT_NEAR(distance_px({0, 0, 0}, {0, 3}), 3, 0.01);
    // Nothing is farther than infinitely far.
    const Eigen::Vector2d middle(320, 240);
    const Eigen::Vector2d infinitely_far = *project(
        camera(), second.rotation * (first.rotation.conjugate() * Eigen::Vector3d(0, 0, 1)));
    EXPECT_LT(distance_from_ray_px(camera(), first, middle, camera(), second, infinitely_far),
              1e-6);
    const double beyond_px = distance_from_ray_px(camera(), first, middle, camera(), second,
                                                  infinitely_far - Eigen::Vector2d(30, 0));
    EXPECT_GT(beyond_px, 20);
    EXPECT_NEAR(distance_from_ray_px(camera(), first, middle, camera(), first, {320, 250}), 10,
                0.01);
}

}  // namespace
}  // namespace lumi
