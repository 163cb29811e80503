#include <gmock/gmock.h>

#include "calib/ingest/ingest.h"
#include "calib/pictures/image_io.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

using ::testing::HasSubstr;

/// Two photographs that are large enough, and a third.
class TinyPictures : public testing::Test {
 protected:
    IngestResult ingested_with(const ColorImage& third) {
        write_png(scratch_ / "photos/1.png", wavy_picture(100, 64));
        write_png(scratch_ / "photos/2.png", wavy_picture(100, 64, 11));
        write_png(scratch_ / "photos/third.png", third);
        SilentProgress progress;
        return ingest(scratch_ / "photos", {}, scratch_ / "copies", 2, progress);
    }
    /// Why the third was left out.
    LeftOut reason_for(const ColorImage& third) {
        const IngestResult result = ingested_with(third);
        EXPECT_EQ(result.photographs.size(), 2U);
        EXPECT_EQ(result.left_out.size(), 1U);
        EXPECT_FALSE(std::filesystem::exists(scratch_ / "copies/000003.png"));
        return result.left_out.empty() ? LeftOut{} : result.left_out.front();
    }

    ScratchFolder scratch_;
};

TEST_F(TinyPictures, AreLeftOut) {
    const LeftOut icon = reason_for(wavy_picture(100, 63, 22));
    EXPECT_EQ(icon.name, "third.png");
    EXPECT_EQ(icon.code, "E-INGEST-TINY");
    EXPECT_THAT(icon.reason, HasSubstr("100x63 pixels; "));
}

TEST_F(TinyPictures, AreAlsoThoseThatScalingMakesTiny) {
    const LeftOut strip = reason_for(wavy_picture(64, 6400, 22));
    EXPECT_EQ(strip.code, "E-INGEST-TINY");
    EXPECT_THAT(strip.reason, HasSubstr("64x6400 pixels, scaled to 16x1600"));
}

/// Copies of 50 pixels of pictures that would be large enough at 1600.
TEST_F(TinyPictures, MayBeJudgedByOtherCopiesAndBeforeDuplicatesAre) {
    write_png(scratch_ / "photos/1.png", wavy_picture(100, 64));
    write_png(scratch_ / "photos/2.png", wavy_picture(100, 64, 11));
    write_png(scratch_ / "photos/icon.png", wavy_picture(100, 63, 22));
    write_png(scratch_ / "photos/icon again.png", wavy_picture(100, 63, 22));
    SilentProgress progress;
    const IngestResult result =
        ingest(scratch_ / "photos", {.max_width_px = 50, .judged_width_px = 1600},
               scratch_ / "copies", 2, progress);
    ASSERT_EQ(result.photographs.size(), 2U);
    EXPECT_EQ(result.photographs[0].width_px, 50);
    ASSERT_EQ(result.left_out.size(), 2U);
    for (const LeftOut& icon : result.left_out) {
        EXPECT_EQ(icon.code, "E-INGEST-TINY");
        EXPECT_THAT(icon.reason, HasSubstr("100x63 pixels; "));
    }
}

}  // namespace
}  // namespace lumi
