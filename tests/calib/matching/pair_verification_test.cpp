#include "calib/matching/pair_verification.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/calib/synthetic_capture.h"

namespace lumi {
namespace {

const Camera kCamera = pinhole_camera(1000, 800, 900);

/// Two photographs of the same points: as many matches right as wrong ones are added.
struct Pair {
    std::vector<ColmapCamera> cameras{{kCamera, true}};
    std::vector<ColmapPhotograph> photographs{{0, {}}, {0, {}}};
    PairMatches matches{0, 1, {}};

    void add(const Eigen::Vector2d& first, const Eigen::Vector2d& second) {
        const auto index = static_cast<std::uint32_t>(matches.matches.size());
        photographs[0].keypoints_px.push_back(first.cast<float>());
        photographs[1].keypoints_px.push_back(second.cast<float>());
        matches.matches.push_back({index, index});
    }
    [[nodiscard]] std::optional<VerifiedPair> verified(bool lens_is_calibrated) const {
        return verify_pair(matches, cameras, photographs, lens_is_calibrated, {});
    }
};

Pair pair_of(const Rigid3& second, double depth_of_cloud, int right, int wrong) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> within(-1, 1);
    std::uniform_real_distribution<double> x(0, 1000);
    std::uniform_real_distribution<double> y(0, 800);
    const Rigid3 first = looking_at({0, 0, -4}, {0, 0, 0});
    Pair pair;
    while (static_cast<int>(pair.matches.matches.size()) < right) {
        const Eigen::Vector3d point(within(random), within(random),
                                    depth_of_cloud * within(random));
        pair.add(project(kCamera, first * point).value(), project(kCamera, second * point).value());
    }
    for (int index = 0; index < wrong; ++index) {
        pair.add({x(random), y(random)}, {x(random), y(random)});
    }
    return pair;
}

const Rigid3 kBeside = looking_at({1, 0.3, -4}, {0, 0, 0});

class PairVerification : public testing::TestWithParam<bool> {};

TEST_P(PairVerification, KeepsAllRightMatchesAndFewWrongOnes) {
    const auto found = pair_of(kBeside, 1, 100, 100).verified(GetParam());
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->configuration,
              GetParam() ? PairConfiguration::kCalibrated : PairConfiguration::kUncalibrated);
    int right = 0;
    for (const FeatureMatch& match : found->inliers) right += match.first < 100 ? 1 : 0;
    EXPECT_EQ(right, 100);
    // A wrong match may lie on its epipolar line: a band of 8 of about 800 pixels.
    EXPECT_LE(found->inliers.size(), 106u);
}

TEST_P(PairVerification, KnowsAPlane) {
    const auto found = pair_of(kBeside, 0, 100, 50).verified(GetParam());
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->configuration, PairConfiguration::kPlanar);
    EXPECT_GE(found->inliers.size(), 100u);
}

TEST_P(PairVerification, KnowsACameraThatTurned) {
    Rigid3 turned = looking_at({0, 0, -4}, {0, 0, 0});
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.2, Eigen::Vector3d(0.2, 1, 0).normalized()));
    turned = Rigid3{turn, Eigen::Vector3d::Zero()} * turned;
    const auto found = pair_of(turned, 1, 100, 50).verified(GetParam());
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->configuration, PairConfiguration::kPanoramic);
    EXPECT_GE(found->inliers.size(), 100u);
}

TEST_P(PairVerification, FindsNothingInChance) {
    EXPECT_FALSE(pair_of(kBeside, 1, 0, 100).verified(GetParam()).has_value());
    EXPECT_FALSE(pair_of(kBeside, 1, 0, 20).verified(GetParam()).has_value());
    EXPECT_FALSE(pair_of(kBeside, 1, 0, 0).verified(GetParam()).has_value());
}

TEST_P(PairVerification, IsTheSameInEveryRun) {
    const Pair pair = pair_of(kBeside, 1, 60, 100);
    EXPECT_EQ(pair.verified(GetParam())->inliers, pair.verified(GetParam())->inliers);
}

INSTANTIATE_TEST_SUITE_P(Lens, PairVerification, testing::Bool(), [](const auto& calibrated) {
    return std::string(calibrated.param ? "Calibrated" : "Unknown");
});

TEST(PairVerificationOfMany, IsTheSameForAnyNumberOfThreads) {
    const Pair pair = pair_of(kBeside, 1, 60, 60);
    const Pair chance = pair_of(kBeside, 1, 0, 120);
    std::vector<PairMatches> pairs(6, pair.matches);
    SilentProgress progress;
    const auto one = verify_pairs(pairs, pair.cameras, pair.photographs, false, {}, 1, progress);
    const auto three = verify_pairs(pairs, pair.cameras, pair.photographs, false, {}, 3, progress);
    ASSERT_EQ(one.size(), 6u);
    ASSERT_EQ(three.size(), 6u);
    for (std::size_t index = 0; index < 6; ++index) {
        EXPECT_EQ(one[index].inliers, three[index].inliers);
    }
    EXPECT_TRUE(
        verify_pairs({chance.matches}, chance.cameras, chance.photographs, false, {}, 2, progress)
            .empty());
}

}  // namespace
}  // namespace lumi
