// Real photographs of the stitching set: ctest label "photos".
#include <gtest/gtest.h>

#include "calib/poses/pose_stage.h"
#include "calib/work/error.h"
#include "tests/calib/photographs.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

class Panorama : public testing::TestWithParam<std::string> {};

TEST_P(Panorama, IsRefusedInThePhotographersWords) {
    const std::filesystem::path folder = photographs_folder() / "boofcv/stitch";
    if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << folder << " is not there";
    const ScratchFolder scratch;
    SilentProgress progress;
    std::vector<Photograph> photographs =
        ingest(folder, {}, scratch / "copies", 2, progress).photographs;
    std::erase_if(photographs, [](const Photograph& photograph) {
        return !photograph.name.starts_with(GetParam());
    });
    ASSERT_GE(photographs.size(), 2u);
    try {
        static_cast<void>(
            estimate_poses(photographs, std::nullopt, {}, scratch / "poses", 2, progress));
        ADD_FAILURE() << "expected a refusal";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-POSES-ROTATION");
        EXPECT_EQ(error.exit_code(), 4);
    }
}

INSTANTIATE_TEST_SUITE_P(Stitching, Panorama,
                         testing::Values("apartment_building", "cave", "grass_rotate", "kayak",
                                         "mountain_rotate", "trees_rotate"));
INSTANTIATE_TEST_SUITE_P(WholeFolder, Panorama, testing::Values(""));

}  // namespace
}  // namespace lumi
