#include "calib/matching/photograph_matching.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "calib/pictures/image_io.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

constexpr int kWaves_px = 240;  ///< Width and height.

TEST(PhotographMatching, FeaturesAreThoseOfEachPicture) {
    const ScratchFolder folder;
    std::vector<Photograph> photographs(2);
    for (std::size_t index = 0; index < photographs.size(); ++index) {
        photographs[index].picture_path = folder / (std::to_string(index) + ".png");
        write_png(photographs[index].picture_path,
                  wavy_picture(kWaves_px, kWaves_px, 31.0 * static_cast<double>(index)));
    }
    SilentProgress progress;
    const std::vector<Features> both = detect_features(photographs, {}, {}, 2, progress);
    ASSERT_EQ(both.size(), 2u);
    for (std::size_t index = 0; index < photographs.size(); ++index) {
        const std::vector<Features> alone =
            detect_features({photographs[index]}, {}, {}, 1, progress);
        EXPECT_GT(alone[0].size(), 50u);
        EXPECT_EQ(both[index].descriptors, alone[0].descriptors);
    }
    EXPECT_NE(both[0].descriptors, both[1].descriptors);
}

TEST(PhotographMatching, FeaturesAreFoundOnlyWhereTheMaskOfTheirPhotographIsWhite) {
    const ScratchFolder folder;
    Photograph photograph;
    photograph.name = "waves.jpg";
    photograph.picture_path = folder / "waves copy.png";
    write_png(photograph.picture_path, wavy_picture(kWaves_px, kWaves_px));
    GrayImage mask(kWaves_px, kWaves_px, 0);
    for (int y = 0; y < kWaves_px; ++y) {
        for (int x = kWaves_px / 2; x < kWaves_px; ++x) mask(x, y) = 255;
    }
    write_png(folder / "masks/waves.png", mask);
    SilentProgress progress;
    const auto is_left = [](const Keypoint& keypoint) {
        return keypoint.pixel.x() < kWaves_px / 2;
    };
    const auto left_of = [&](const Features& features) {
        return std::count_if(features.keypoints.begin(), features.keypoints.end(), is_left);
    };
    const Features all = detect_features({photograph}, {}, {}, 1, progress)[0];
    EXPECT_GT(left_of(all), 20);
    const Features masked = detect_features({photograph}, folder / "masks", {}, 1, progress)[0];
    EXPECT_GT(masked.size(), 20u);
    EXPECT_EQ(left_of(masked), 0);
}

}  // namespace
}  // namespace lumi
