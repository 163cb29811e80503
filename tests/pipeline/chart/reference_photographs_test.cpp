#include "pipeline/chart/reference_photographs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

using testing::HasSubstr;

/// A workspace that was built at 64x48, of whose two views one was held out.
class ReferencePhotographs : public testing::Test {
 protected:
    void SetUp() override {
        Capture capture;
        capture.cameras = {pinhole_camera(64, 48, 50.0)};
        capture.views = {{"a.jpg", 0, {}}, {"b.jpg", 0, {}}};
        write_colmap_model_binary(capture, workspace_.stage_folder("poses") / "sparse");
        write_whole_text(workspace_.stage_folder("pack") / "pack.json",
                         R"({"held_out": ["b.jpg"], "pictures_sha256": "", "package_sha256": ""})");
    }

    /// Of the working copy of the held-out photograph at another width.
    [[nodiscard]] PosedPhotographs of_copy(int width_px, int height_px) {
        Photograph copy;
        copy.name = "b.jpg";
        copy.width_px = width_px;
        copy.height_px = height_px;
        copy.picture_path = scratch_ / "copy.png";
        write_png(copy.picture_path, wavy_picture(width_px, height_px));
        SilentProgress progress;
        return reference_photographs(workspace_, {copy}, scratch_ / "undistorted", 1, progress);
    }

    ScratchFolder scratch_;
    WorkspaceLayout workspace_{scratch_ / "work", "some"};
};

TEST_F(ReferencePhotographs, HaveTheLensOfTheWorkspaceAtTheirSize) {
    const PosedPhotographs reference = of_copy(128, 96);
    ASSERT_EQ(reference.capture.views.size(), 1U);
    EXPECT_EQ(reference.capture.views[0].name, "b.jpg");
    const Camera& lens = camera_of(reference.capture, reference.capture.views[0]);
    EXPECT_EQ(lens.width_px, 128);
    EXPECT_EQ(lens.height_px, 96);
    EXPECT_NEAR(focal_length_px(lens).x(), 100.0, 1e-9);
}

TEST_F(ReferencePhotographs, MayBeARoundedPixelOfTheWorkspaceHigher) {
    EXPECT_EQ(of_copy(128, 98).capture.views.size(), 1U);
}

// Bars that were cut off at the larger width only would shift all that is compared.
TEST_F(ReferencePhotographs, AreRefusedInAnotherShape) {
    try {
        (void)of_copy(128, 99);
        FAIL() << "99 rows instead of 96";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-CHART-SHAPE");
        EXPECT_THAT(error.what(), HasSubstr("b.jpg"));
    }
}

}  // namespace
}  // namespace lumi
