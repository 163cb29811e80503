#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/stages/depth_files.h"
#include "pipeline/stages/depth_range.h"
#include "pipeline/stages/file_stems.h"
#include "pipeline/stages/photograph_list.h"
#include "pipeline/stages/posed_files.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using testing::ElementsAre;

TEST(FileStems, ArePortableAndUnique) {
    EXPECT_THAT(file_stems_of_views({"a.jpg", "a.png", "b/IMG 1.jpg", "ü.jpg", ".jpg", "noending"}),
                ElementsAre("a", "a-2", "b_IMG_1", "__", "_jpg", "noending"));
}

TEST(FileStems, FitIntoAFileSystemAndStayApart) {
    const std::string longest(241, 'a');
    const auto stems = file_stems_of_views({longest + ".jpg", longest + ".png"});
    EXPECT_LT(stems[0].size(), 220U);
    EXPECT_NE(stems[0], stems[1]);
}

TEST(FileStems, WithoutDotsTellPicturesOfViewsApart) {
    EXPECT_THAT(file_stems_without_dots({"IMG.jpg", "IMG.flip.jpg", "IMG_flip.jpg", "noending"}),
                testing::ElementsAre("IMG", "IMG_flip", "IMG_flip-2", "noending"));
}

TEST(PhotographList, ComesBackAsItWas) {
    const ScratchFolder scratch;
    IngestResult written;
    Photograph photograph;
    photograph.name = "sub/\"quoted\" ü.jpg";
    photograph.picture_path = scratch / "000001.png";
    photograph.width_px = 640;
    photograph.height_px = 480;
    photograph.original_width_px = 1280;
    photograph.original_height_px = 960;
    photograph.exif_orientation = 6;
    photograph.focal_length_px = 512.1234567890123;
    photograph.camera_key = "Make Model";
    written.photographs = {photograph};
    written.left_out = {{"bad.jpg", "E-INGEST-TRUNCATED", "it ends early"}};
    write_photograph_list(scratch.path(), written);

    const IngestResult read = read_photograph_list(scratch.path());
    ASSERT_EQ(read.photographs.size(), 1U);
    EXPECT_EQ(read.photographs[0].name, photograph.name);
    EXPECT_EQ(read.photographs[0].picture_path, photograph.picture_path);
    EXPECT_EQ(read.photographs[0].focal_length_px, photograph.focal_length_px);
    EXPECT_EQ(read.photographs[0].original_height_px, 960);
    EXPECT_EQ(read.photographs[0].exif_orientation, 6);
    ASSERT_EQ(read.left_out.size(), 1U);
    EXPECT_EQ(read.left_out[0].code, "E-INGEST-TRUNCATED");
}

TEST(PosedFiles, FindTheirPicturesAfterTheFolderIsRenamed) {
    const ScratchFolder scratch;
    PosedPhotographs written;
    written.capture.cameras = {pinhole_camera(64, 48, 50.0)};
    written.capture.views = {{"a b.jpg", 0, {}}, {"c.jpg", 0, {}}};
    written.picture_paths = {scratch.path() / "poses.tmp" / "pinhole" / "000001.png",
                             scratch.path() / "ingest" / "000002.png"};
    write_posed_photographs(scratch.path() / "poses.tmp" / "pinhole", written);
    std::filesystem::rename(scratch.path() / "poses.tmp", scratch.path() / "poses");

    const PosedPhotographs read = read_posed_photographs(scratch.path() / "poses" / "pinhole");
    EXPECT_THAT(read.picture_paths, ElementsAre(scratch.path() / "poses" / "pinhole" / "000001.png",
                                                scratch.path() / "ingest" / "000002.png"));
    EXPECT_EQ(read.capture.views[0].name, "a b.jpg");
}

DepthMap ramp(int width, int height) {
    DepthMap map{FloatImage(width, height), GrayImage(width, height, 255)};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            map.inverse_depth(x, y) = 1.0F / static_cast<float>(1 + x + y * width);
        }
    }
    return map;
}

TEST(DepthFiles, KeepEveryBit) {
    const ScratchFolder scratch;
    const std::vector<DepthMap> maps{ramp(17, 9), ramp(5, 30)};
    write_depth_files(scratch.path(), {"a", "b"}, maps, 2);
    const std::vector<DepthMap> read = read_depth_files(scratch.path(), {"a", "b"}, 2);
    ASSERT_EQ(read.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(read[i].inverse_depth, maps[i].inverse_depth);
        EXPECT_EQ(read[i].confidence, maps[i].confidence);
    }
}

TEST(DepthRange, IsThatOfConfidentPixels) {
    LumigraphView view;
    view.depth = {FloatImage(160, 100, 0.5F), GrayImage(160, 100, 255)};
    for (int y = 0; y < 50; ++y) {
        for (int x = 0; x < 160; ++x) view.depth.inverse_depth(x, y) = 0.25F;
    }
    for (const std::uint8_t confidence : {std::uint8_t{0}, kFilledBeforeBackground}) {
        LumigraphView fill;
        fill.depth = {FloatImage(160, 100, 100.0F), GrayImage(160, 100, confidence)};
        const DepthRange range = depth_range_of({view, fill});
        EXPECT_DOUBLE_EQ(range.near_depth, 2.0);
        EXPECT_DOUBLE_EQ(range.far_depth, 4.0);
    }
}

}  // namespace
}  // namespace lumi
