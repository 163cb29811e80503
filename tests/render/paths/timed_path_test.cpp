#include "render/paths/timed_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/lumigraph/same_eye.h"

namespace lumi {
namespace {

/// At a place, turned about the world's y axis, through a lens of this focal length.
Eye eye_of(const Eigen::Vector3d& centre, double angle_rad, double focal_px) {
    Eye eye{pinhole_camera(64, 48, focal_px), {}};
    eye.cam_from_world.rotation = Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitY());
    eye.cam_from_world.translation = -(eye.cam_from_world.rotation * centre);
    return eye;
}

Eigen::Vector3d place(const Eye& eye) { return centre_in_world(eye.cam_from_world); }

const Eye kFrom = eye_of({0, 0, 0}, 0.0, 60);
const Eye kTo = eye_of({4, 2, 1}, 2.0, 80);

TEST(TimedPath, RunsStraightAndTurnsAndZoomsEvenlyBetweenTwoEyes) {
    const std::vector<TimedEye> path{{1.0, kFrom}, {3.0, kTo}};
    for (const double share : {0.25, 0.5, 0.9}) {
        const Eye eye = eye_at_time(path, 1.0 + 2.0 * share);
        EXPECT_LT((place(eye) - share * Eigen::Vector3d(4, 2, 1)).norm(), 1e-12);
        const Eye expected = eye_of(place(eye), 2.0 * share, 60 + 20 * share);
        EXPECT_LT(eye.cam_from_world.rotation.angularDistance(expected.cam_from_world.rotation),
                  1e-7);
        EXPECT_NEAR(focal_length_px(eye.camera).x(), 60 + 20 * share, 1e-9);
    }
}

TEST(TimedPath, TurnsTheShortWayWhicheverSignAQuaternionHas) {
    Eye negated = eye_of({0, 0, 0}, 0.4, 60);
    negated.cam_from_world.rotation.coeffs() *= -1;
    const std::vector<TimedEye> path{{0.0, kFrom}, {1.0, negated}};
    const Eye middle = eye_at_time(path, 0.5);
    EXPECT_NEAR(middle.cam_from_world.rotation.angularDistance(kFrom.cam_from_world.rotation), 0.2,
                1e-7);
}

TEST(TimedPath, HoldsRecordedEyesToTheBitAndRestsBeyondItsEnds) {
    const std::vector<TimedEye> path{{1.0, kFrom}, {3.0, kTo}};
    for (const double time_s : {0.0, 1.0})
        EXPECT_TRUE(is_same_eye(eye_at_time(path, time_s), kFrom));
    for (const double time_s : {3.0, 9.0}) EXPECT_TRUE(is_same_eye(eye_at_time(path, time_s), kTo));
}

TEST(TimedPath, IsLookedUpAtEvenTimesHoweverUnevenlyItWasRecorded) {
    const std::vector<TimedEye> path{{0.0, kFrom},
                                     {0.1, eye_of({0.2, 0.1, 0.05}, 0.1, 61)},
                                     {2.1, eye_of({4.2, 2.1, 1.05}, 2.1, 81)}};
    const std::vector<Eye> eyes = eyes_at_even_times(path, 4.0);
    ASSERT_EQ(eyes.size(), 9U);
    for (std::size_t i = 0; i < eyes.size(); ++i)
        EXPECT_NEAR(place(eyes[i]).x(), 0.5 * static_cast<double>(i), 1e-9) << i;
}

TEST(TimedPath, OfOneEyeAFrameGivesEachEyeOnceAsItIs) {
    for (const double frames_per_second : {1.0, 24.0, 29.97, 30.0, 240.0}) {
        for (std::size_t count = 1; count < 100; ++count) {
            std::vector<TimedEye> path;
            for (std::size_t i = 0; i < count; ++i) {
                const auto index = static_cast<double>(i);
                path.push_back({index / frames_per_second, eye_of({index, 0, 0}, 0.01, 60)});
            }
            const std::vector<Eye> eyes = eyes_at_even_times(path, frames_per_second);
            ASSERT_EQ(eyes.size(), count);
            for (std::size_t i = 0; i < count; ++i)
                ASSERT_TRUE(is_same_eye(eyes[i], path[i].eye)) << i << " of " << count;
        }
    }
}

}  // namespace
}  // namespace lumi
