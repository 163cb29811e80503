// Two groups of views before a wall that share a strip of it.
#include <gtest/gtest.h>

#include <random>

#include "calib/adjust/bundle_adjustment.h"
#include "calib/poses/part_joint.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

const Camera kPartCamera = pinhole_camera(400, 300, 450);
constexpr double kWall_z = 4.7;
const std::vector<char> kSecondHalf{0, 0, 0, 0, 1, 1, 1, 1};

/// Four views to the left of the middle and four to the right, 0.3 apart, whose innermost pictures
/// share `overlap` of their width; `points` on the wall a width of the picture, and a tenth as many
/// before it, outside of the strip.
Capture two_halves(double overlap, int points, unsigned seed) {
    Capture capture;
    capture.cameras = {kPartCamera};
    const double width = 400.0 / 450.0 * kWall_z;
    const double gap = (1 - overlap) * width;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> sway(-0.08, 0.08);
    for (int index = 0; index < 8; ++index) {
        const double along =
            index < 4 ? -0.5 * gap - 0.3 * (3 - index) : 0.5 * gap + 0.3 * (index - 4);
        const Eigen::Vector3d centre(along, sway(random), sway(random));
        capture.views.push_back(
            {"view" + std::to_string(index), 0, {Eigen::Quaterniond::Identity(), -centre}});
    }
    std::uniform_real_distribution<double> across(-1.2 * width, 1.2 * width);
    std::uniform_real_distribution<double> height(-1.5, 1.5);
    std::uniform_real_distribution<double> depth(2.5, 4.0);
    std::normal_distribution<double> noise(0.0, 0.3);
    for (int index = 0; index < 24 * points / 10; ++index) {
        ScenePoint point;
        const bool is_before_wall = index % 10 == 0;
        point.position_in_world = {across(random), height(random),
                                   is_before_wall ? depth(random) : kWall_z};
        if (is_before_wall && std::abs(point.position_in_world.x()) < 0.5 * width) continue;
        for (int view = 0; view < 8; ++view) {
            const auto pixel =
                project(kPartCamera, capture.views[static_cast<std::size_t>(view)].cam_from_world *
                                         point.position_in_world);
            if (!pixel || !is_inside(kPartCamera, *pixel)) continue;
            point.track.push_back({view, *pixel + Eigen::Vector2d(noise(random), noise(random))});
        }
        if (point.track.size() >= 2) capture.points.push_back(point);
    }
    return capture;
}

PartJoint examined(const Capture& capture, const std::vector<char>& is_in_part) {
    return examine_joint(capture, is_in_part, cauchy_scale_px(capture), SilentProgress());
}

TEST(PartJoint, AWideStripHoldsBothHalvesFirmly) {
    const PartJoint joint = examined(two_halves(0.6, 300, 1), kSecondHalf);
    EXPECT_GT(joint.points, 50);
    EXPECT_FALSE(joint.uncertainty.matters());
    EXPECT_FALSE(joint.is_weak());
    EXPECT_FALSE(joint.is_elsewhere());
}

TEST(PartJoint, AFewPointsDoNotHoldThem) {
    const PartJoint joint = examined(two_halves(0.05, 150, 2), kSecondHalf);
    EXPECT_GT(joint.points, 0);
    EXPECT_TRUE(joint.is_weak());
}

TEST(PartJoint, HalvesThatShareNothingAreNotHeld) {
    EXPECT_TRUE(examined(two_halves(0.0, 100, 3), kSecondHalf).is_weak());
}

TEST(PartJoint, HalvesWithoutASinglePointInCommonAreNotHeld) {
    const PartJoint joint = examined(two_halves(-0.5, 100, 3), kSecondHalf);
    EXPECT_EQ(joint.points, 0);
    EXPECT_TRUE(joint.is_weak());
    EXPECT_FALSE(joint.is_elsewhere());
}

TEST(PartJoint, FromTheWrongAttitudeOfANarrowStripItFindsTheTrueOne) {
    const Capture truth = two_halves(0.2, 300, 4);
    const PartJoint joint = examined(truth, kSecondHalf);
    ASSERT_TRUE(joint.other.has_value());
    EXPECT_FALSE(joint.is_elsewhere());
    EXPECT_GT(joint.other->cost_ratio, 1.0);
    EXPECT_GT(joint.other->shift.rotation_deg, 5.0);

    const PartJoint back = examined(joint.other->moved, kSecondHalf);
    ASSERT_TRUE(back.is_elsewhere()) << (back.other ? back.other->cost_ratio : 0.0);
    const PoseShift error = pose_shift(named_poses(back.other->moved), named_poses(truth));
    EXPECT_LT(error.position_share, 0.05);
    EXPECT_LT(error.rotation_deg, 1.0);
}

TEST(PartJoint, OneViewIsHeldWithoutASizeOfItsOwn) {
    const PartJoint joint = examined(two_halves(0.6, 300, 5), {1, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_FALSE(joint.is_weak());
}

TEST(PartJoint, ExaminationStopsOnRequest) {
    SilentProgress progress;
    progress.interrupt();
    EXPECT_THROW(
        static_cast<void>(examine_joint(two_halves(0.6, 300, 1), kSecondHalf, 1.0, progress)),
        Error);
}

}  // namespace
}  // namespace lumi
