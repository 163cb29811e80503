#include <gtest/gtest.h>

#include <algorithm>

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

TEST(ExpectedCost, MemoryIsThatOfTheLargestPhotograph) {
    const double alone_mib = expected_cost({{2000, 1000}}).peak_mib;
    EXPECT_EQ(expected_cost({{200, 100}, {2000, 1000}, {200, 100}}).peak_mib, alone_mib);
    EXPECT_GT(alone_mib, expected_cost({{200, 100}}).peak_mib);
}

}  // namespace
}  // namespace lumi
