#include "calib/features/nearest_descriptors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <random>
#include <stdexcept>

namespace lumi {
namespace {

/// Random values; few different ones, so that equal similarities are common.
std::vector<Descriptor> random_descriptors(std::size_t count, unsigned seed, unsigned largest) {
    std::mt19937 random(seed);
    std::vector<Descriptor> result(count);
    for (Descriptor& descriptor : result) {
        for (std::uint8_t& value : descriptor) {
            value = static_cast<std::uint8_t>(random() % (largest + 1));
        }
    }
    return result;
}

/// A few values of the full 255, the rest nothing: where 8-bit arithmetic would overflow first.
std::vector<Descriptor> extreme_descriptors(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Descriptor> result(count);
    for (Descriptor& descriptor : result) {
        descriptor.fill(0);
        const std::size_t begin = random() % (kDescriptorSize - 8);
        std::fill_n(descriptor.begin() + static_cast<std::ptrdiff_t>(begin), random() % 9,
                    std::uint8_t{255});
    }
    return result;
}

/// The definition, word for word.
std::vector<NearestDescriptors> nearest_by_definition(const std::vector<Descriptor>& from,
                                                      const std::vector<Descriptor>& to) {
    std::vector<NearestDescriptors> result;
    for (const Descriptor& one : from) {
        NearestDescriptors nearest;
        for (std::size_t index = 0; index < to.size(); ++index) {
            std::uint32_t similarity = 0;
            for (std::size_t bin = 0; bin < kDescriptorSize; ++bin) {
                similarity += std::uint32_t{one[bin]} * to[index][bin];
            }
            if (similarity > nearest.best) {
                nearest = {similarity, nearest.best, static_cast<std::uint32_t>(index)};
            } else {
                nearest.second = std::max(nearest.second, similarity);
            }
        }
        result.push_back(nearest);
    }
    return result;
}

class NearestDescriptorsWith : public testing::TestWithParam<DescriptorInstructions> {
 protected:
    static void expect_equal_to_definition(const std::vector<Descriptor>& first,
                                           const std::vector<Descriptor>& second) {
        const NearestBothWays nearest = nearest_descriptors(first, second, GetParam());
        EXPECT_EQ(nearest.of_first, nearest_by_definition(first, second))
            << first.size() << " by " << second.size();
        EXPECT_EQ(nearest.of_second, nearest_by_definition(second, first))
            << first.size() << " by " << second.size();
    }
};

TEST_P(NearestDescriptorsWith, EqualTheDefinitionOnSetsOfAnySize) {
    const std::vector<std::pair<std::size_t, std::size_t>> sizes{
        {0, 5}, {5, 0}, {1, 1}, {2, 3}, {11, 31}, {12, 32}, {13, 33}, {100, 300}, {40, 2100}};
    for (const auto& [first, second] : sizes) {
        expect_equal_to_definition(random_descriptors(first, 1, 60),
                                   random_descriptors(second, 2, 60));
    }
}

TEST_P(NearestDescriptorsWith, TakeTheFirstOfEqualOnes) {
    expect_equal_to_definition(random_descriptors(150, 3, 1), random_descriptors(250, 4, 1));
}

TEST_P(NearestDescriptorsWith, AreExactForTheLargestValues) {
    expect_equal_to_definition(extreme_descriptors(70, 5), extreme_descriptors(90, 6));
}

TEST_P(NearestDescriptorsWith, CrossTheBlocksThatTheWorkIsCutInto) {
    // More rows than one block has; the likes of some are in another block.
    std::vector<Descriptor> many = random_descriptors(8200, 7, 60);
    many[8195] = many[3];
    const std::vector<Descriptor> few{many[3], many[8191], many[8192], many[8199]};
    expect_equal_to_definition(many, few);
    expect_equal_to_definition(few, many);
}

TEST_P(NearestDescriptorsWith, RefuseWhatIsLongerThanTheirArithmeticHolds) {
    Descriptor too_long{};
    too_long.fill(65);
    const std::vector<Descriptor> one{too_long};
    EXPECT_THROW(static_cast<void>(nearest_descriptors(one, {}, GetParam())),
                 std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(AllInstructionsHere, NearestDescriptorsWith,
                         testing::ValuesIn(descriptor_instructions_here()), [](const auto& set) {
                             std::string name;
                             for (const char letter : name_of(set.param)) {
                                 if (std::isalnum(static_cast<unsigned char>(letter)) != 0) {
                                     name += letter;
                                 }
                             }
                             return name;
                         });

TEST(NearestDescriptors, PortableCodeIsAlwaysThere) {
    EXPECT_EQ(descriptor_instructions_here().front(), DescriptorInstructions::kPortable);
}

}  // namespace
}  // namespace lumi
