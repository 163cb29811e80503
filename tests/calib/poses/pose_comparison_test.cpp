#include "calib/poses/pose_comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "calib/capture/colmap_model.h"
#include "calib/work/error.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/synthetic_capture.h"

namespace lumi {
namespace {

NamedPoses poses_of(const Capture& capture) {
    NamedPoses poses;
    for (const View& view : capture.views) poses[view.name] = view.cam_from_world;
    return poses;
}

NamedPoses truth() { return poses_of(synthetic_capture(pinhole_camera(640, 480, 500), 8, 0)); }

/// The same cameras in a world that is turned, scaled and moved.
NamedPoses in_another_world(const NamedPoses& poses, const Similarity3& other_from_world) {
    NamedPoses moved;
    for (const auto& [name, cam_from_world] : poses) {
        const Eigen::Vector3d centre =
            other_from_world.scale * (other_from_world.rotation * centre_in_world(cam_from_world)) +
            other_from_world.translation;
        Rigid3 cam_from_other;
        cam_from_other.rotation = cam_from_world.rotation * other_from_world.rotation.conjugate();
        cam_from_other.translation = -(cam_from_other.rotation * centre);
        moved[name] = cam_from_other;
    }
    return moved;
}

Similarity3 some_similarity() {
    return {0.37,
            Eigen::Quaterniond(Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.5).normalized())),
            {3, -20, 7}};
}

TEST(PoseComparison, FindsTheSimilarityBetweenTwoWorlds) {
    const Similarity3 expected = some_similarity();
    const PoseComparison comparison = compare_poses(truth(), in_another_world(truth(), expected));
    EXPECT_NEAR(comparison.b_from_a.scale, expected.scale, 1e-12);
    EXPECT_LT(comparison.b_from_a.rotation.angularDistance(expected.rotation), 1e-7);
    EXPECT_LT((comparison.b_from_a.translation - expected.translation).norm(), 1e-10);
    EXPECT_EQ(comparison.views.size(), 8U);
    EXPECT_LT(comparison.max_position, 1e-10);
    EXPECT_LT(comparison.max_rotation_deg, 1e-5);
}

TEST(PoseComparison, TwoCamerasThatNumberAlikeAreNotMixedUp) {
    NamedPoses a;
    NamedPoses b;
    for (const auto& [name, pose] : truth()) {
        const std::string half = a.size() % 2 == 0 ? "left/" : "right/";
        const std::string number = std::to_string(a.size() / 2) + ".jpg";
        a[half + number] = pose;
        b["images/" + half + number] = pose;
    }
    const PoseComparison comparison = compare_poses(a, b);
    EXPECT_EQ(comparison.views.size(), 8U);
    EXPECT_LT(comparison.max_position, 1e-10);
}

TEST(PoseComparison, RotationErrorIsTheAngleByWhichACameraWasTurned) {
    NamedPoses turned = truth();
    Rigid3& pose = turned.at("view 003.jpg");
    const Eigen::Vector3d centre = centre_in_world(pose);
    constexpr double kAngleDeg = 1.25;
    pose.rotation = Eigen::AngleAxisd(kAngleDeg * std::numbers::pi / 180,
                                      Eigen::Vector3d(1, 1, 0).normalized()) *
                    pose.rotation;
    pose.translation = -(pose.rotation * centre);
    const PoseComparison comparison =
        compare_poses(in_another_world(turned, some_similarity()), truth());
    EXPECT_NEAR(comparison.max_rotation_deg, kAngleDeg, 1e-5);
    EXPECT_LT(comparison.median_rotation_deg, 1e-5);
    EXPECT_LT(comparison.max_position, 1e-10);
}

/// Cameras that stand `across_share` of their line's length beside it, this way and that.
NamedPoses on_a_line(double across_share) {
    NamedPoses poses;
    for (int i = 0; i < 6; ++i) {
        const double across = i % 2 == 0 ? across_share : -across_share;
        poses[std::to_string(i) + ".jpg"] =
            looking_at({0.2 * i, across, 0.3 * across}, {0.1 * i, 0.4, 3});
    }
    return poses;
}

NamedPoses at_one_place() {
    NamedPoses poses;
    for (int i = 0; i < 5; ++i) {
        poses[std::to_string(i) + ".jpg"] = looking_at({1, 2, 3}, {1 + 0.5 * i, 2.2, 8});
    }
    return poses;
}

TEST(PoseComparison, FindsTheTurnAboutALineOfCentres) {
    const Similarity3 expected = some_similarity();
    const PoseComparison comparison =
        compare_poses(on_a_line(0), in_another_world(on_a_line(0), expected));
    EXPECT_LT(comparison.max_rotation_deg, 1e-5);
    EXPECT_LT(comparison.max_position, 1e-10);
    EXPECT_NEAR(comparison.b_from_a.scale, expected.scale, 1e-12);
    EXPECT_LT(comparison.b_from_a.rotation.angularDistance(expected.rotation), 1e-7);
}

TEST(PoseComparison, ErrorsBesideALineOfCentresDoNotTurnIt) {
    // On either side of the line by as much as an estimate errs, but on the other side.
    const PoseComparison comparison = compare_poses(on_a_line(1e-3), on_a_line(-1e-3));
    EXPECT_LT(comparison.max_rotation_deg, 0.2);
    EXPECT_LT(comparison.max_position, 3e-3);
}

TEST(PoseComparison, PositionsFitBestWhereTheCentresTellTheRotation) {
    NamedPoses twisted = truth();
    for (auto& [name, pose] : twisted) {
        const Eigen::Vector3d centre = centre_in_world(pose);
        pose.rotation = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()) * pose.rotation;
        pose.translation = -(pose.rotation * centre);
    }
    const PoseComparison comparison = compare_poses(twisted, truth());
    EXPECT_LT(comparison.max_position, 1e-10);
    EXPECT_NEAR(comparison.median_rotation_deg, 0.1 * 180 / std::numbers::pi, 1e-5);
}

TEST(PoseComparison, CentresAtOnePlaceStillShowHowCamerasAreTurned) {
    NamedPoses turned = at_one_place();
    Rigid3& pose = turned.at("2.jpg");
    const Eigen::Vector3d centre = centre_in_world(pose);
    pose.rotation = Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitX()) * pose.rotation;
    pose.translation = -(pose.rotation * centre);
    const PoseComparison comparison =
        compare_poses(in_another_world(turned, some_similarity()), at_one_place());
    EXPECT_EQ(comparison.b_from_a.scale, 1.0);
    EXPECT_LT(comparison.max_position, 1e-10);
    // A fifth of it turns the mean.
    EXPECT_NEAR(comparison.max_rotation_deg, 0.8 * 0.02 * 180 / std::numbers::pi, 1e-3);
    const PoseComparison with_others = compare_poses(at_one_place(), on_a_line(0.1));
    EXPECT_TRUE(std::isfinite(with_others.max_position));
    EXPECT_TRUE(std::isfinite(with_others.max_rotation_deg));
}

TEST(PoseComparison, PositionErrorIsInTheUnitsOfB) {
    // Two offsets that cancel leave the fit of a symmetric square alone to first order: the errors
    // are the offsets themselves, up to their square.
    NamedPoses square;
    NamedPoses moved;
    for (int i = 0; i < 4; ++i) {
        const double angle = i * std::numbers::pi / 2;
        const Rigid3 pose = looking_at({std::cos(angle), 0, std::sin(angle)}, {0, 0, 0});
        const std::string name = std::to_string(i) + ".jpg";
        square[name] = pose;
        const double up = i % 2 == 0 ? 1e-3 : -1e-3;
        Rigid3 shifted = pose;
        shifted.translation -= shifted.rotation * Eigen::Vector3d(0, up, 0);
        moved[name] = shifted;
    }
    const Similarity3 tenfold{10, Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()};
    const PoseComparison comparison = compare_poses(moved, in_another_world(square, tenfold));
    EXPECT_NEAR(comparison.median_position, 1e-2, 1e-6);
    EXPECT_NEAR(comparison.mean_position, 1e-2, 1e-6);
    EXPECT_NEAR(comparison.max_position, 1e-2, 1e-6);
}

TEST(PoseComparison, MatchesNamesThatDifferInEndingAndFolder) {
    NamedPoses renamed;
    for (const auto& [name, pose] : truth()) renamed["images/" + name.substr(0, 8) + ".png"] = pose;
    EXPECT_EQ(compare_poses(truth(), renamed).views.size(), 8U);
}

TEST(PoseComparison, RefusesFewerThanThreeCommonViews) {
    NamedPoses few = truth();
    while (few.size() > 2) few.erase(few.begin());
    EXPECT_THROW(static_cast<void>(compare_poses(truth(), few)), Error);
}

TEST(PoseComparison, ReadsAColmapModel) {
    const ScratchFolder scratch;
    write_colmap_model_text(synthetic_capture(pinhole_camera(640, 480, 500), 8, 0), scratch.path());
    EXPECT_LT(compare_poses(read_named_poses(scratch.path()), truth()).max_position, 1e-10);
}

}  // namespace
}  // namespace lumi
