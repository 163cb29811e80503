#include "meshing/exposure/gains_among_neighbours.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lumi {
namespace {

/// Each tells white balance.
std::vector<char> all_of(const std::vector<std::array<double, 3>>& gains) {
    return std::vector<char>(gains.size(), 1);
}

TEST(GainsAmongNeighbours, StayWithinWhatAPackageMayHold) {
    std::vector<std::array<double, 3>> gains(6, {0.1, 0.1, 0.1});
    gains[0] = {100, 100, 100};
    std::vector<Eigen::Vector3d> centres;
    for (int i = 0; i < 6; ++i) centres.emplace_back(i, 0, 0);
    for (const auto& gain : gains_among_neighbours(gains, all_of(gains), centres)) {
        for (const double of_channel : gain) {
            EXPECT_LE(of_channel, 16);
            EXPECT_GE(of_channel, 1.0 / 16);
        }
    }
}

TEST(GainsAmongNeighbours, UndoAJumpAndLeaveASlowChange) {
    std::vector<std::array<double, 3>> slow;
    std::vector<Eigen::Vector3d> centres;
    for (int i = 0; i < 21; ++i) {
        const double gain = std::exp2(0.1 * i);
        slow.push_back({gain, gain, 1.0});
        centres.emplace_back(i, 0, 0);
    }
    const auto kept = gains_among_neighbours(slow, all_of(slow), centres);
    for (std::size_t i = 2; i + 2 < slow.size(); ++i) EXPECT_NEAR(kept[i][0], 1.0, 1e-9);

    std::vector<std::array<double, 3>> jump = slow;
    jump[10][0] *= 2.0;
    const auto undone = gains_among_neighbours(jump, all_of(jump), centres);
    EXPECT_NEAR(undone[10][0], std::exp2(0.8), 1e-9);
    // What differed by a stop differs by none: the neighbours come to meet it.
    EXPECT_NEAR(undone[10][0] / undone[9][0], 2.0, 1e-9);
    EXPECT_NEAR(undone[5][0], 1.0, 1e-9);
    EXPECT_EQ(undone[10][2], 1.0);

    EXPECT_EQ(gains_among_neighbours({{2.0, 2.0, 2.0}}, {1}, {Eigen::Vector3d::Zero()}),
              (std::vector<std::array<double, 3>>{{1.0, 1.0, 1.0}}));
    EXPECT_TRUE(gains_among_neighbours({}, {}, {}).empty());
}

/// Half of what stands around each is warm light, which the black and white one among them can say
/// nothing of.
TEST(GainsAmongNeighbours, OfABlackAndWhitePhotographAreOneForAllChannelsAndMoveNoWhiteBalance) {
    std::vector<std::array<double, 3>> gains(5, {1.5, 1.0, 0.5});
    gains[2] = {2.0, 2.0, 2.0};
    const std::vector<Eigen::Vector3d> centres{
        {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
    const auto evened = gains_among_neighbours(gains, {1, 1, 0, 1, 1}, centres);
    for (const auto& gain : evened) {
        EXPECT_NEAR(gain[0], gain[1], 1e-12);
        EXPECT_NEAR(gain[2], gain[1], 1e-12);
    }
    const double brightness = std::cbrt(1.5 * 1.0 * 0.5);
    EXPECT_NEAR(evened[2][1] / evened[0][1], 2.0 / brightness, 1e-12);
}

}  // namespace
}  // namespace lumi
