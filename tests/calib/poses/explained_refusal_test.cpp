// What a refusal names as its cause.
#include "calib/poses/explained_refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "tests/calib/poses/matched_job.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

class ExplainedRefusal : public MatchedJob {
 protected:
    ExplainedRefusal() { match(synthetic_capture(pinhole_camera(1000, 800, 900), {})); }

    /// All photographs show this.
    void photograph(const ColorImage& picture) {
        write_png(folder_ / "all.png", picture);
        for (Photograph& photograph : photographs_) {
            photograph.picture_path = folder_ / "all.png";
            photograph.width_px = picture.width();
            photograph.height_px = picture.height();
        }
    }

    std::string refusal() {
        try {
            refuse_explained(job(), matched_, CaptureReason::kUncertain, "nothing fits");
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::kDegenerateCapture);
            return error.code() + ": " + error.what();
        }
    }

    ScratchFolder folder_;
};

TEST_F(ExplainedRefusal, IsWhatWasFoundWherePicturesAndMatchesAreFine) {
    photograph(wavy_picture(1000, 800));
    EXPECT_EQ(refusal(), "E-POSES-UNCERTAIN: nothing fits");
}

TEST_F(ExplainedRefusal, NamesPicturesThatShowNothing) {
    photograph(ColorImage(1000, 800, {90, 90, 90}));
    matched_ = {};
    EXPECT_THAT(refusal(), testing::StartsWith("E-POSES-TEXTURE: "));
}

TEST_F(ExplainedRefusal, NamesACameraThatOnlyTurned) {
    photograph(wavy_picture(1000, 800));
    matched_.motion = {28, 28, 28, 0.98, 0};
    EXPECT_THAT(refusal(), testing::StartsWith("E-POSES-ROTATION: "));
}

}  // namespace
}  // namespace lumi
