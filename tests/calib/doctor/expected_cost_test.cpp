#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "calib/doctor/examination.h"

namespace lumi {
namespace {

/// A capture that was built, all stages, on two cores of a server.
struct BuiltCapture {
    const char* name;
    int photographs;
    Eigen::Vector2i size_px;
    double cpu_s;
};

TEST(ExpectedCost, IsWithinTwoTimesOfWhatBuildsTook) {
    for (const BuiltCapture& built :
         {BuiltCapture{"smallest copies of a desk", 12, {240, 160}, 9.0},
          BuiltCapture{"small copies of it", 12, {420, 280}, 22.6},
          BuiltCapture{"chair", 21, {640, 480}, 57.0},
          BuiltCapture{"demo scene", 28, {768, 512}, 75.0},
          BuiltCapture{"television", 25, {960, 540}, 34.5},
          BuiltCapture{"miku", 97, {1008, 756}, 534.0},
          BuiltCapture{"skull", 66, {1424, 949}, 212.0},
          BuiltCapture{"fountain", 11, {1536, 1024}, 64.0},
          BuiltCapture{"banana", 16, {1600, 1064}, 136.0}}) {
        const std::vector<Eigen::Vector2i> sizes_px(static_cast<std::size_t>(built.photographs),
                                                    built.size_px);
        const double expected_s = expected_cost(sizes_px).cpu_s;
        EXPECT_LT(std::max(expected_s / built.cpu_s, built.cpu_s / expected_s), 2.0)
            << built.name << ": " << expected_s << " s";
    }
}

/// As each photograph of a capture was built, and the most memory that any stage took.
struct BuiltWithin {
    const char* name;
    std::vector<Eigen::Vector2i> sizes_px;
    double peak_mib;
};

std::vector<Eigen::Vector2i> all_of(int count, Eigen::Vector2i size_px) {
    return std::vector<Eigen::Vector2i>(static_cast<std::size_t>(count), size_px);
}

TEST(ExpectedCost, MemoryIsWithinAQuarterOfWhatBuildsTook) {
    for (const BuiltWithin& built : {BuiltWithin{"a few small ones", all_of(9, {500, 320}), 573},
                                     BuiltWithin{"chair", all_of(21, {640, 480}), 743},
                                     BuiltWithin{"demo scene", all_of(28, {768, 512}), 825},
                                     BuiltWithin{"statue", all_of(26, {720, 720}), 847},
                                     BuiltWithin{"television", all_of(25, {960, 540}), 919},
                                     BuiltWithin{"cube", all_of(13, {1000, 750}), 1021},
                                     BuiltWithin{"kettle", all_of(28, {1265, 948}), 1199},
                                     BuiltWithin{"banana", all_of(16, {1600, 1064}), 1350},
                                     BuiltWithin{"fountain", all_of(11, {1536, 1024}), 1546},
                                     BuiltWithin{"skull", all_of(66, {1424, 949}), 1638},
                                     BuiltWithin{"miku", all_of(97, {1008, 756}), 1946}}) {
        const double expected_mib = expected_cost(built.sizes_px).peak_mib;
        EXPECT_LT(std::max(expected_mib / built.peak_mib, built.peak_mib / expected_mib), 1.25)
            << built.name << ": " << expected_mib << " MiB";
    }
}

TEST(ExpectedCost, MemoryGrowsWithTheLargestPhotographAndWithTheirNumber) {
    const double two_mib = expected_cost({{200, 100}, {2000, 1000}}).peak_mib;
    EXPECT_GT(two_mib, expected_cost({{200, 100}, {200, 100}}).peak_mib);
    const std::vector<Eigen::Vector2i> many = all_of(1000, {1600, 1064});
    EXPECT_GT(expected_cost(many).peak_mib, 12 * 1024) << "what their package takes, decoded";
}

}  // namespace
}  // namespace lumi
