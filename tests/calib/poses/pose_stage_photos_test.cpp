// Photographs that nothing was made for: ctest label "photos".
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

/// Rendered with one lens without distortion, before a plain wall: a small subject, whose focal
/// length is known to a few per cent only.
TEST(SmallSubject, IsPlacedWithOneLensThatDoesNotFold) {
    const std::filesystem::path folder = photographs_folder() / "ulr-tv/images";
    if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << folder << " is not there";
    const ScratchFolder scratch;
    SilentProgress progress;
    const std::vector<Photograph> photographs =
        ingest(folder, {}, scratch / "copies", 2, progress).photographs;
    const PoseResult result =
        estimate_poses(photographs, std::nullopt, {}, scratch / "poses", 2, progress);
    EXPECT_GE(result.capture.views.size(), 22u) << "of 25";
    ASSERT_EQ(result.capture.cameras.size(), 1u);
    const Camera& lens = result.capture.cameras[0];
    const Eigen::Vector2d corner = unproject(lens, {0, 0}).head<2>();
    const Eigen::Vector2d straight = -principal_point_px(lens).cwiseQuotient(focal_length_px(lens));
    EXPECT_LT((corner - straight).norm(), 0.2 * straight.norm());
}

INSTANTIATE_TEST_SUITE_P(Stitching, Panorama,
                         testing::Values("apartment_building", "cave", "grass_rotate", "kayak",
                                         "mountain_rotate", "trees_rotate"));
INSTANTIATE_TEST_SUITE_P(WholeFolder, Panorama, testing::Values(""));

}  // namespace
}  // namespace lumi
