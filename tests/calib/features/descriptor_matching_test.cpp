#include "calib/features/descriptor_matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace lumi {
namespace {

Descriptor random_descriptor(std::mt19937& random) {
    std::array<double, kDescriptorSize> values{};
    for (double& value : values) value = std::uniform_real_distribution<double>(0, 1)(random);
    const double norm =
        std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.0));
    Descriptor result{};
    for (std::size_t bin = 0; bin < kDescriptorSize; ++bin) {
        result[bin] = static_cast<std::uint8_t>(std::lround(512 * values[bin] / norm));
    }
    return result;
}

std::vector<Descriptor> random_descriptors(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Descriptor> result;
    for (std::size_t index = 0; index < count; ++index) {
        result.push_back(random_descriptor(random));
    }
    return result;
}

double angle_rad(const Descriptor& a, const Descriptor& b) {
    const double dot = std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
    return std::acos(std::clamp(dot / (512.0 * 512.0), 0.0, 1.0));
}

/// The definition, word for word and slowly.
std::vector<FeatureMatch> matches_by_definition(const std::vector<Descriptor>& first,
                                                const std::vector<Descriptor>& second,
                                                const DescriptorMatchingOptions& options) {
    const auto best_two = [](const Descriptor& one, const std::vector<Descriptor>& many) {
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t index = 0; index < many.size(); ++index) {
            order.emplace_back(angle_rad(one, many[index]), index);
        }
        std::sort(order.begin(), order.end());
        return order;
    };
    std::vector<FeatureMatch> matches;
    for (std::size_t index = 0; index < first.size(); ++index) {
        const auto there = best_two(first[index], second);
        const auto back = best_two(second[there[0].second], first);
        if (back[0].second != index || there[0].first > options.max_angle_rad) continue;
        if (there[0].first >= options.max_ratio * there[1].first) continue;
        if (back[0].first >= options.max_ratio * back[1].first) continue;
        matches.push_back(
            {static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(there[0].second)});
    }
    return matches;
}

TEST(DescriptorMatching, EqualsTheDefinitionOnSetsOfAnySize) {
    // Sizes on both sides of the tiles that the work is cut into.
    const std::vector<std::pair<std::size_t, std::size_t>> sizes{
        {2, 3}, {31, 127}, {32, 128}, {33, 129}, {100, 300}};
    for (const auto& [first_size, second_size] : sizes) {
        const auto first = random_descriptors(first_size, 1);
        auto second = random_descriptors(second_size, 2);
        for (std::size_t index = 0; index < first_size; index += 2) {
            second[second_size - 1 - index] = first[index];
            second[second_size - 1 - index][5] =
                static_cast<std::uint8_t>(second[second_size - 1 - index][5] + 20);
        }
        const DescriptorMatchingOptions loose{.max_ratio = 0.97, .max_angle_rad = 0.7};
        for (const DescriptorMatchingOptions& options : {DescriptorMatchingOptions{}, loose}) {
            const auto expected = matches_by_definition(first, second, options);
            EXPECT_FALSE(expected.empty());
            EXPECT_EQ(match_descriptors(first, second, options), expected)
                << first_size << " by " << second_size;
        }
    }
}

TEST(DescriptorMatching, FindsAPermutation) {
    const auto first = random_descriptors(200, 5);
    std::vector<std::size_t> order(first.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937(3));
    std::vector<Descriptor> second;
    for (const std::size_t index : order) second.push_back(first[index]);
    const auto matches = match_descriptors(first, second, {});
    ASSERT_EQ(matches.size(), first.size());
    for (const FeatureMatch& match : matches) EXPECT_EQ(order[match.second], match.first);
}

TEST(DescriptorMatching, RejectsWhatOccursTwice) {
    const auto first = random_descriptors(10, 5);
    std::vector<Descriptor> second = first;
    second.push_back(first[3]);
    const auto matches = match_descriptors(first, second, {});
    EXPECT_EQ(matches.size(), first.size() - 1);
    for (const FeatureMatch& match : matches) EXPECT_NE(match.first, 3u);
}

TEST(DescriptorMatching, HasNoMatchesForNothing) {
    const auto some = random_descriptors(5, 5);
    EXPECT_TRUE(match_descriptors({}, some, {}).empty());
    EXPECT_TRUE(match_descriptors(some, {}, {}).empty());
}

}  // namespace
}  // namespace lumi
