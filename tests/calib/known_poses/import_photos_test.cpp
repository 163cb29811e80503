#include <gmock/gmock.h>

#include "calib/ingest/ingest.h"
#include "calib/poses/pose_comparison.h"
#include "calib/poses/pose_stage.h"
#include "calib/work/error.h"
#include "tests/calib/photographs.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using ::testing::HasSubstr;

class KnownPosesOfRealPhotographs : public testing::Test {
 protected:
    void SetUp() override {
        if (!std::filesystem::exists(photographs_folder())) {
            GTEST_SKIP() << photographs_folder() << " is not there; set LUMI_PHOTOS";
        }
    }
    [[nodiscard]] PoseResult imported(const std::string& photographs, const std::string& poses) {
        SilentProgress progress;
        const IngestResult taken = ingest(photographs_folder() / photographs, {.max_width_px = 320},
                                          scratch_ / "copies", 0, progress);
        return import_poses(taken.photographs, {}, photographs_folder() / poses);
    }
    [[nodiscard]] Error refusal(const std::string& photographs, const std::string& poses) {
        try {
            static_cast<void>(imported(photographs, poses));
        } catch (const Error& error) {
            return error;
        }
        return {ErrorKind::kUsage, "none", "was not refused", ""};
    }

 private:
    ScratchFolder scratch_;
};

TEST_F(KnownPosesOfRealPhotographs, FountainHasElevenStrechaCamerasForTwiceTheSize) {
    const PoseResult result = imported("fountain-P11/images", "fountain-P11/cameras");
    ASSERT_EQ(result.capture.views.size(), 11U);
    // The first line of each file: 2759.48 0 1520.69, for 3072 pixels; working copies have 320.
    const Camera& camera = result.capture.cameras.at(0);
    EXPECT_NEAR(focal_length_px(camera).x(), 2759.48 * 320 / 3072, 1e-9);
    EXPECT_NEAR(principal_point_px(camera).x(), (1520.69 + 0.5) * 320 / 3072, 1e-9);
    NamedPoses found;
    for (const View& view : result.capture.views) found[view.name] = view.cam_from_world;
    const PoseComparison same =
        compare_poses(found, read_named_poses(photographs_folder() / "fountain-P11/cameras"));
    EXPECT_EQ(same.views.size(), 11U);
    EXPECT_LT(same.max_position, 1e-9);
}

TEST_F(KnownPosesOfRealPhotographs, KettleIsRefusedBecauseItsPhotographsWereUndistortedSince) {
    const Error error = refusal("ulr-kettle/images", "ulr-kettle");
    EXPECT_EQ(error.code(), "E-IMPORT-SIZE");
    EXPECT_THAT(error.what(), HasSubstr("1280x960"));
    EXPECT_THAT(error.what(), HasSubstr("several sizes"));
}

TEST_F(KnownPosesOfRealPhotographs, TelevisionIsRefusedBecauseItsLensHasNoModel) {
    EXPECT_EQ(refusal("ulr-tv/images", "ulr-tv").code(), "E-COLMAP-MODEL");
}

}  // namespace
}  // namespace lumi
