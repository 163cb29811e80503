#include "calib/poses/walk_in_rounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "calib/work/formatted.h"
#include "tests/calib/synthetic_capture.h"

namespace lumi {
namespace {

/// A walk of which `place` tells where each photograph was taken, with z pointing up, and `sway`
/// how far the hand is off.
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
        // Who looks holds the camera by the y axis.
        view.cam_from_world = looking_at({eye.x(), eye.z(), -eye.y()}, Eigen::Vector3d::Zero());
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

/// A photograph that was deleted, or left out before, is none of the walk at all.
void take_out(PhotographedWalk& walk, std::ptrdiff_t index) {
    walk.model.views.erase(walk.model.views.begin() + index);
    walk.photographs.erase(walk.photographs.begin() + index);
}

PhotographedWalk folded_house() {
    return walk_along(20, 0.08, [](int index) { return on_circle(18.0 * (index % 5)); });
}

TEST(WalkInRounds, IsFoundWhicheverPhotographIsLeftOut) {
    for (int index = 0; index < 20; ++index) {
        PhotographedWalk folded = folded_house();
        take_out(folded, index);
        EXPECT_TRUE(walk_in_rounds(folded.model, folded.photographs)) << index;
    }
}

TEST(WalkInRounds, IsFoundWhicheverTwoPhotographsAreLeftOut) {
    for (int first = 0; first < 20; ++first) {
        for (int second = first + 1; second < 20; ++second) {
            PhotographedWalk folded = folded_house();
            take_out(folded, second);
            take_out(folded, first);
            EXPECT_TRUE(walk_in_rounds(folded.model, folded.photographs)) << first << second;
        }
    }
}

TEST(WalkInRounds, IsFoundWhereOnePhotographIsMisplacedOrLooksElsewhere) {
    for (std::size_t index = 0; index < 20; ++index) {
        PhotographedWalk misplaced = folded_house();
        Rigid3& pose = misplaced.model.views[index].cam_from_world;
        pose = looking_at({9, 9, 9}, Eigen::Vector3d::Zero());
        EXPECT_TRUE(walk_in_rounds(misplaced.model, misplaced.photographs)) << index;
        PhotographedWalk turned = folded_house();
        Rigid3& turned_pose = turned.model.views[index].cam_from_world;
        turned_pose = looking_at(centre_in_world(turned_pose), {0, 0, 9});
        EXPECT_TRUE(walk_in_rounds(turned.model, turned.photographs)) << index;
    }
}

/// The middle of the walk is not that of the house: seen from the house, each side's photographs
/// are shifted by the same, in the world.
TEST(WalkInRounds, IsFoundWhereSidesArePhotographedFromOtherDistances) {
    const PhotographedWalk folded = walk_along(16, 0.05, [](int index) {
        const double side_rad = -std::numbers::pi / 2 * (index / 4);
        return Eigen::Vector3d(Eigen::AngleAxisd(side_rad, Eigen::Vector3d::UnitZ()) *
                               (on_circle(22.5 * index) + Eigen::Vector3d(0.15, 0, 0)));
    });
    EXPECT_TRUE(walk_in_rounds(folded.model, folded.photographs));
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

TEST(WalkInRounds, IsNotOneThriceAroundInRingsOrASpiral) {
    const PhotographedWalk rings = walk_along(72, 0.02, [](int index) {
        return Eigen::Vector3d(on_circle(10.0 * index) +
                               Eigen::Vector3d(0, 0, index < 36 ? 0 : 0.16));
    });
    EXPECT_FALSE(walk_in_rounds(rings.model, rings.photographs));
    const PhotographedWalk spiral = walk_along(108, 0.03, [](int index) {
        return Eigen::Vector3d(on_circle(10.0 * index) + Eigen::Vector3d(0, 0, 0.006 * index));
    });
    EXPECT_FALSE(walk_in_rounds(spiral.model, spiral.photographs));
    const PhotographedWalk uneven =
        walk_along(200, 0.03, [](int index) { return on_circle(5.4 * index); });
    EXPECT_FALSE(walk_in_rounds(uneven.model, uneven.photographs));
}

/// All lengths of walks of all widths, up to three times to and fro.
TEST(WalkInRounds, IsNotOneOfFewPhotographsTakenToAndFro) {
    for (int width = 2; width <= 8; ++width) {
        const auto to_and_fro = [&](int index) {
            const int there = index % (2 * width - 2);
            return on_circle(5.0 * std::min(there, 2 * width - 2 - there));
        };
        const auto line = [&](int index) {
            const Eigen::Vector3d on_arc = to_and_fro(index);
            return Eigen::Vector3d(4 * on_arc.y(), -8, 1.7);
        };
        for (int photographs = 4; photographs <= (width == 2 ? 5 : 6 * width); ++photographs) {
            const PhotographedWalk arc = walk_along(photographs, 0.01, to_and_fro);
            EXPECT_FALSE(walk_in_rounds(arc.model, arc.photographs)) << width << photographs;
            const PhotographedWalk straight = walk_along(photographs, 0.01, line);
            EXPECT_FALSE(walk_in_rounds(straight.model, straight.photographs))
                << width << photographs;
        }
    }
}

TEST(WalkInRounds, IsNotOneOfThreePhotographsAndTwoFromNearlyTheSamePlaces) {
    const std::vector<double> azimuths_deg{0, -5, 0.5, 5, -0.3};
    for (const int photographs : {4, 5}) {
        const PhotographedWalk walk = walk_along(photographs, 0.01, [&](int index) {
            return on_circle(azimuths_deg[static_cast<std::size_t>(index)]);
        });
        EXPECT_FALSE(walk_in_rounds(walk.model, walk.photographs)) << photographs;
    }
}

/// The second half as the first, to the right by so much as the camera sees it.
PhotographedWalk seen_by_two(int photographs, double right, double sway) {
    PhotographedWalk walk = walk_along(
        photographs, sway, [&](int index) { return on_circle(8.0 * (index % (photographs / 2))); });
    for (std::size_t index = 0; index < walk.model.views.size() / 2; ++index) {
        View& second = walk.model.views[index + walk.model.views.size() / 2];
        second.cam_from_world = walk.model.views[index].cam_from_world;
        second.cam_from_world.translation.x() -= right;
    }
    return walk;
}

TEST(WalkInRounds, IsNotOneOfTwoLensesThatAreMovedTogether) {
    for (const double right : {0.03, 0.06, 0.12}) {
        const PhotographedWalk rig = seen_by_two(16, right, 0.05);
        EXPECT_FALSE(walk_in_rounds(rig.model, rig.photographs)) << right;
    }
}

/// Stops are met more closely than any hand does, and every turn is the same.
TEST(WalkInRounds, IsNotOneOfASliderThatGoesItsWayAgainTilted) {
    for (const double tilt_deg : {3.0, 8.0, 11.0}) {
        PhotographedWalk slider = walk_along(
            16, 0.003, [](int index) { return Eigen::Vector3d(0.3 * (index % 8), -3, 1.7); });
        for (std::size_t index = 8; index < 16; ++index) {
            Rigid3& pose = slider.model.views[index].cam_from_world;
            const Eigen::Vector3d centre = centre_in_world(pose);
            pose.rotation =
                Eigen::AngleAxisd(tilt_deg * std::numbers::pi / 180, Eigen::Vector3d::UnitX()) *
                slider.model.views[index - 8].cam_from_world.rotation;
            pose.translation = -(pose.rotation * centre);
        }
        EXPECT_FALSE(walk_in_rounds(slider.model, slider.photographs)) << tilt_deg;
    }
}

void rename(PhotographedWalk& walk, const std::function<std::string(int)>& name) {
    for (std::size_t index = 0; index < walk.model.views.size(); ++index) {
        walk.model.views[index].name = name(static_cast<int>(index));
        walk.photographs[index].name = walk.model.views[index].name;
    }
}

/// Whose places are nearer than poses are known.
TEST(WalkInRounds, IsNotOneOfCamerasWhoseNamesDoNotCountOn) {
    for (const auto& [first, second] : std::vector<std::pair<std::string, std::string>>{
             {"L_", "R_"}, {"left/", "right/"}, {"cam0/", "cam1/"}, {"scan.v2/", "scan.v3/"}}) {
        PhotographedWalk two =
            walk_along(16, 0.002, [](int i) { return on_circle(8.0 * (i % 8)); });
        ASSERT_TRUE(walk_in_rounds(two.model, two.photographs));
        rename(two, [&](int i) {
            return formatted("%s%d.png", (i < 8 ? first : second).c_str(), i % 8 + 1);
        });
        EXPECT_FALSE(walk_in_rounds(two.model, two.photographs)) << first;
    }
    PhotographedWalk two = walk_along(16, 0.002, [](int i) { return on_circle(8.0 * (i % 8)); });
    for (std::size_t i = 0; i < 16; ++i) two.photographs[i].camera_key = i < 8 ? "wide" : "tele";
    EXPECT_FALSE(walk_in_rounds(two.model, two.photographs));
}

TEST(WalkInRounds, IsFoundWhereNamesTellTheTime) {
    PhotographedWalk folded = folded_house();
    rename(folded,
           [](int i) { return formatted("2026-05-01 10.%02d.%02d.jpg", i / 3, i % 3 * 19); });
    EXPECT_TRUE(walk_in_rounds(folded.model, folded.photographs));
}

TEST(WalkInRounds, IsNotOneOfRowsThatAllBeginAtTheLeft) {
    const PhotographedWalk arcs = walk_along(26, 0.02, [](int index) {
        return Eigen::Vector3d(on_circle(10.0 * (index % 13)) +
                               Eigen::Vector3d(0, 0, index < 13 ? 0 : 0.09));
    });
    EXPECT_FALSE(walk_in_rounds(arcs.model, arcs.photographs));
    const PhotographedWalk shelf = walk_along(27, 0.01, [](int index) {
        return Eigen::Vector3d(0.5 * (index % 9), -8, 0.1 * (index / 9));
    });
    EXPECT_FALSE(walk_in_rounds(shelf.model, shelf.photographs));
    const PhotographedWalk turntable = walk_along(26, 0.002, [](int index) {
        const Eigen::Vector3d place = on_circle(15.0 * (index % 13));
        return Eigen::Vector3d(index < 13 ? place : 1.03 * place);
    });
    EXPECT_FALSE(walk_in_rounds(turntable.model, turntable.photographs));
}

TEST(WalkInRounds, IsNotOneOfGridsOfFewPhotographs) {
    for (int width = 2; width <= 7; ++width) {
        for (int rows = 2; rows <= 5; ++rows) {
            const auto place = [&](int index) {
                return Eigen::Vector3d(0.3 * (index % width), -3, 0.15 * (index / width));
            };
            const PhotographedWalk grid = walk_along(width * rows, 0.01, place);
            EXPECT_FALSE(walk_in_rounds(grid.model, grid.photographs)) << width << rows;
        }
    }
}

TEST(WalkInRounds, IsNotOneOfACameraThatStandsStill) {
    const PhotographedWalk still =
        walk_along(8, 0.0, [](int) { return Eigen::Vector3d(0, -3, 0); });
    EXPECT_FALSE(walk_in_rounds(still.model, still.photographs));
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
