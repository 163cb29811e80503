#include "calib/poses/verified_matching.h"

// What is done where the usual features verify no pair.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "tests/calib/poses/matched_job.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

constexpr int kSpeckledWidth = 320;
constexpr int kSpeckledHeight = 240;

/// Discs of any size and brightness, shifted to the right.
ColorImage speckled(int discs, int shift_px) {
    ColorImage picture(kSpeckledWidth, kSpeckledHeight, {120, 120, 120});
    std::mt19937 random(4);
    for (int disc = 0; disc < discs; ++disc) {
        const int left = static_cast<int>(random() % kSpeckledWidth) + shift_px;
        const int top = static_cast<int>(random() % kSpeckledHeight);
        const int radius = 3 + static_cast<int>(random() % 12);
        const auto level = static_cast<std::uint8_t>(random() % 256);
        for (int y = std::max(0, top - radius); y < std::min(kSpeckledHeight, top + radius); ++y) {
            for (int x = std::max(0, left - radius); x < std::min(kSpeckledWidth, left + radius);
                 ++x) {
                const int off = (x - left) * (x - left) + (y - top) * (y - top);
                if (off < radius * radius) picture(x, y) = {level, level, level};
            }
        }
    }
    return picture;
}

class VerifiedMatching : public MatchedJob {
 protected:
    VerifiedMatching() {
        match(synthetic_capture(pinhole_camera(kSpeckledWidth, kSpeckledHeight, 300), {}));
        photographs_.resize(2);
        groups_.camera_of_photograph.resize(2);
    }

    void photograph(int discs) {
        for (std::size_t index = 0; index < photographs_.size(); ++index) {
            Photograph& photograph = photographs_[index];
            photograph.picture_path = folder_ / (std::to_string(index) + ".png");
            photograph.width_px = kSpeckledWidth;
            photograph.height_px = kSpeckledHeight;
            write_png(photograph.picture_path, speckled(discs, 9 * static_cast<int>(index)));
        }
    }

    ScratchFolder folder_;
};

/// As many as allowed are too few to verify a pair; twice as many are enough.
TEST_F(VerifiedMatching, TriesMoreFeaturesWhereTheUsualOnesVerifyNoPair) {
    photograph(400);
    options_.max_features = 19;
    const MatchedPhotographs matched = match_and_verify(job());
    EXPECT_EQ(matched.pairs.size(), 1u);
    EXPECT_EQ(matched.detail, FeatureDetail::kMore);
    EXPECT_FALSE(match_more_features(job(), matched, 0, "again")) << "these were more already";
}

TEST_F(VerifiedMatching, UsualFeaturesDoWhereTheyVerifyPairs) {
    photograph(400);
    EXPECT_EQ(match_and_verify(job()).detail, FeatureDetail::kUsual);
}

TEST_F(VerifiedMatching, NamesTextureWhereHardlyAnyFeaturesAreFound) {
    photograph(2);
    try {
        static_cast<void>(match_and_verify(job()));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-POSES-TEXTURE");
        EXPECT_THAT(error.what(), testing::HasSubstr("no two of the 2 photographs"));
    }
}

}  // namespace
}  // namespace lumi
