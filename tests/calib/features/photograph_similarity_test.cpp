#include "calib/features/photograph_similarity.h"

#include <gtest/gtest.h>

#include <random>

namespace lumi {
namespace {

/// Photographs of places: those of one place show mostly the same features.
std::vector<Features> photographs_of_places(int places, int photographs_of_each) {
    std::mt19937 random(8);
    const auto random_descriptor = [&] {
        Descriptor descriptor{};
        for (int count = 0; count < 10; ++count) descriptor[random() % kDescriptorSize] = 160;
        return descriptor;
    };
    std::vector<Features> photographs;
    for (int place = 0; place < places; ++place) {
        std::vector<Descriptor> shown(150);
        for (Descriptor& descriptor : shown) descriptor = random_descriptor();
        for (int count = 0; count < photographs_of_each; ++count) {
            Features features;
            features.descriptors = shown;
            for (int other = 0; other < 50; ++other) {
                features.descriptors.push_back(random_descriptor());
            }
            photographs.push_back(std::move(features));
        }
    }
    return photographs;
}

TEST(PhotographSimilarity, IsLargerWithinAPlaceThanBetweenPlaces) {
    const Eigen::MatrixXf similarity = photograph_similarity(photographs_of_places(5, 3), {});
    for (int a = 0; a < 15; ++a) {
        EXPECT_NEAR(similarity(a, a), 1, 1e-4);
        for (int same = 0; same < 15; ++same) {
            for (int other = 0; other < 15; ++other) {
                if (same / 3 != a / 3 || other / 3 == a / 3) continue;
                EXPECT_GT(similarity(a, same), similarity(a, other)) << a << same << other;
            }
        }
    }
}

TEST(PhotographSimilarity, IsSymmetricAndTheSameInEveryRun) {
    const auto photographs = photographs_of_places(3, 2);
    const Eigen::MatrixXf similarity = photograph_similarity(photographs, {});
    EXPECT_EQ(similarity, photograph_similarity(photographs, {}));
    EXPECT_TRUE(similarity.isApprox(similarity.transpose()));
}

TEST(PhotographSimilarity, IsZeroWhereThereAreNoFeatures) {
    std::vector<Features> photographs = photographs_of_places(1, 1);
    photographs.emplace_back();
    const Eigen::MatrixXf similarity = photograph_similarity(photographs, {});
    EXPECT_EQ(similarity(0, 1), 0);
    EXPECT_EQ(photograph_similarity(std::vector<Features>(2), {}), Eigen::MatrixXf::Zero(2, 2));
}

}  // namespace
}  // namespace lumi
