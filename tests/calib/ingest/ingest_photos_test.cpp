#include <gtest/gtest.h>

#include "calib/ingest/ingest.h"
#include "tests/calib/photographs.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

struct Folder {
    const char* name;
    std::size_t photographs;
    double focal_length_per_width;  ///< As EXIF tells it; 0 when it does not.
};

class RealPhotographs : public testing::TestWithParam<Folder> {};

TEST_P(RealPhotographs, AreAllTaken) {
    const std::filesystem::path folder = photographs_folder() / GetParam().name;
    if (!std::filesystem::exists(folder)) {
        GTEST_SKIP() << folder << " is not there; set LUMI_PHOTOS to run this test";
    }
    const ScratchFolder scratch;
    SilentProgress progress;
    const IngestResult result =
        ingest(folder, {.max_width_px = 480}, scratch / "copies", 0, progress);
    EXPECT_EQ(result.photographs.size(), GetParam().photographs);
    for (const LeftOut& left_out : result.left_out) {
        ADD_FAILURE() << left_out.name << ": " << left_out.code << " " << left_out.reason;
    }
    for (const Photograph& photograph : result.photographs) {
        EXPECT_NEAR(photograph.focal_length_px.value_or(0) / photograph.width_px,
                    GetParam().focal_length_per_width, 0.01)
            << photograph.name;
    }
}

// Expected focal lengths are worked out by hand from each camera's 35 mm equivalent or pixel pitch.
INSTANTIATE_TEST_SUITE_P(
    Folders, RealPhotographs,
    testing::Values(Folder{"banana/images", 16, 1.665}, Folder{"fountain-P11/images", 11, 0.0},
                    Folder{"miku/images", 97, 0.751}, Folder{"skull/images", 66, 2.393},
                    Folder{"ulr-kettle/images", 28, 0.0}, Folder{"boofcv/chair", 21, 0.0}));

}  // namespace
}  // namespace lumi
