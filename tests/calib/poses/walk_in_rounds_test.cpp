#include "calib/poses/walk_in_rounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "calib/work/formatted.h"
#include "tests/calib/synthetic_capture.h"

namespace lumi {
namespace {

/// A walk of which `place` tells where each photograph was taken, and how far the hand is off.
struct PhotographedWalk {
    Capture model;
    std::vector<Photograph> photographs;
};

PhotographedWalk walk_along(int photographs, double sway,
                            const std::function<Eigen::Vector3d(int)>& place) {
    PhotographedWalk walk;
    walk.model.cameras = {pinhole_camera(400, 300, 400)};
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> off(-sway, sway);
    for (int index = 0; index < photographs; ++index) {
        const Eigen::Vector3d eye =
            place(index) + Eigen::Vector3d(off(random), off(random), off(random));
        View view;
        view.name = formatted("%d.jpg", index + 1);
        view.cam_from_world = looking_at(eye, Eigen::Vector3d::Zero());
        walk.photographs.push_back({});
        walk.photographs.back().name = view.name;
        walk.model.views.push_back(view);
    }
    return walk;
}

Eigen::Vector3d on_circle(double azimuth_deg) {
    const double azimuth_rad = azimuth_deg * std::numbers::pi / 180;
    return {4 * std::cos(azimuth_rad), 4 * std::sin(azimuth_rad), 1.7};
}

TEST(WalkInRounds, OfAHouseWithFourLikeSidesIsAQuarterWalkedFourTimes) {
    const PhotographedWalk folded =
        walk_along(20, 0.08, [](int index) { return on_circle(18.0 * (index % 5)); });
    const auto rounds = walk_in_rounds(folded.model, folded.photographs);
    ASSERT_TRUE(rounds);
    EXPECT_EQ(rounds->places, 5);
    EXPECT_EQ(rounds->rounds, 4);
    EXPECT_LT(rounds->missed_share, 0.25);
}

TEST(WalkInRounds, IsFoundWhereOneSideIsSeenThriceAndSomePhotographsAreMissing) {
    PhotographedWalk folded =
        walk_along(24, 0.05, [](int index) { return on_circle(15.0 * (index % 6)); });
    folded.model.views.erase(folded.model.views.begin() + 8);
    folded.model.views.erase(folded.model.views.begin() + 17);
    ASSERT_TRUE(walk_in_rounds(folded.model, folded.photographs));
    EXPECT_EQ(walk_in_rounds(folded.model, folded.photographs)->places, 6);
}

TEST(WalkInRounds, IsNotOneAroundOnceOrTwice) {
    const auto around = [](int index) { return on_circle(18.0 * index); };
    for (const int photographs : {20, 40, 60}) {
        const PhotographedWalk walk = walk_along(photographs, 0.05, around);
        EXPECT_FALSE(walk_in_rounds(walk.model, walk.photographs)) << photographs;
    }
}

TEST(WalkInRounds, IsNotOneToAndFro) {
    const PhotographedWalk walk = walk_along(
        32, 0.05, [](int index) { return on_circle(10.0 * std::abs((index + 7) % 16 - 8)); });
    EXPECT_FALSE(walk_in_rounds(walk.model, walk.photographs));
}

TEST(WalkInRounds, IsNotOneRowByRowOrOfAPairOfCameras) {
    const PhotographedWalk rows = walk_along(
        36, 0.05, [](int index) { return Eigen::Vector3d(index % 9, -8, 0.2 * (index / 9)); });
    EXPECT_FALSE(walk_in_rounds(rows.model, rows.photographs));
    const PhotographedWalk pair = walk_along(
        40, 0.01, [](int index) { return Eigen::Vector3d(index % 2, -8, 0.1 * (index / 2)); });
    EXPECT_FALSE(walk_in_rounds(pair.model, pair.photographs));
}

TEST(WalkInRounds, IsNotOneOfAHandThatOnlyComesNear) {
    const PhotographedWalk walk =
        walk_along(20, 0.9, [](int index) { return on_circle(18.0 * (index % 5)); });
    EXPECT_FALSE(walk_in_rounds(walk.model, walk.photographs));
}

}  // namespace
}  // namespace lumi
