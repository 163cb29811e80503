#include "pipeline/stages/used_views.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/stages/depth_stage.h"
#include "pipeline/stages/straightened_depth.h"
#include "pipeline/stages/straightened_masks.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using testing::ElementsAre;

/// Three views; one point seen by all, one by the first two, one without a track.
PosedPhotographs three_views() {
    PosedPhotographs photographs;
    photographs.capture.cameras = {pinhole_camera(64, 48, 50.0)};
    for (const char* name : {"a.jpg", "b.jpg", "c.jpg"}) {
        photographs.capture.views.push_back({name, 0, {}});
        photographs.picture_paths.emplace_back(std::string(name) + ".png");
    }
    photographs.capture.points.resize(3);
    photographs.capture.points[0].track = {{0, {1, 1}}, {1, {2, 2}}, {2, {3, 3}}};
    photographs.capture.points[1].track = {{0, {1, 1}}, {1, {2, 2}}};
    return photographs;
}

TEST(HeldOutNames, CountPhotographsInOrderOfName) {
    const std::vector<std::string> photographs{"a", "b", "c", "d", "e"};
    EXPECT_THAT(held_out_names(photographs, {2, {}}), ElementsAre("a", "c", "e"));
    EXPECT_THAT(held_out_names(photographs, {0, {"d", "b"}}), ElementsAre("b", "d"));
    EXPECT_THAT(held_out_names(photographs, {}), ElementsAre());
}

TEST(HeldOutNames, RefuseANameThatIsNotThereAndOfferTheNearest) {
    try {
        static_cast<void>(
            held_out_names({"b/IMG_10.jpg", "IMG_2.jpg"}, {0, {"IMG_10.jpg"}, "my.toml:7"}));
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-EVAL-NAME");
        EXPECT_THAT(error.what(), testing::StartsWith("my.toml:7: hold_out: "));
        EXPECT_THAT(error.what(), testing::HasSubstr("IMG_10.jpg"));
        EXPECT_THAT(error.advice(), testing::HasSubstr("did you mean `"));
    }
}

TEST(WithoutViews, NothingOfAHeldOutViewRemains) {
    const PosedPhotographs used = without_views(three_views(), {"b.jpg"});
    EXPECT_THAT(view_names(used.capture), ElementsAre("a.jpg", "c.jpg"));
    EXPECT_THAT(used.picture_paths, ElementsAre("a.jpg.png", "c.jpg.png"));
    // The second point is seen by one view only and goes; the third never had a track and stays.
    ASSERT_EQ(used.capture.points.size(), 2U);
    ASSERT_EQ(used.capture.points[0].track.size(), 2U);
    EXPECT_EQ(used.capture.points[0].track[1].view_index, 1);
    EXPECT_EQ(used.capture.points[0].track[1].pixel, Eigen::Vector2d(3, 3));
    EXPECT_TRUE(used.capture.points[1].track.empty());
}

TEST(OnlyViews, IsTheOtherHalf) {
    const PosedPhotographs held_out = only_views(three_views(), {"b.jpg"});
    EXPECT_THAT(view_names(held_out.capture), ElementsAre("b.jpg"));
    EXPECT_THAT(held_out.picture_paths, ElementsAre("b.jpg.png"));
}

/// One view of a lens that bends, as the poses stage has it below `poses`.
struct BentView {
    Capture lenses;
    Capture pinholes;
    explicit BentView(const std::filesystem::path& poses) {
        lenses.cameras = {{320, 240, LensModel::kSimpleRadial, {280, 160, 120, -0.2}}};
        lenses.views = {{"walk/a.jpg", 0, {}}};
        pinholes = lenses;
        pinholes.cameras = {{320, 240, LensModel::kPinhole, {330, 330, 160, 120}}};
        write_colmap_model_binary(lenses, poses / "sparse");
        write_colmap_model_binary(pinholes, poses / "pinhole");
    }
};

TEST(StraightenedMasks, AStraightEdgeOfTheSceneIsStraightAgain) {
    const ScratchFolder scratch;
    const Capture lenses = BentView(scratch / "poses").lenses;
    // Drawn at twice the photograph's size: the subject lies right of column 60 of the straight
    // picture, which bends by several pixels in the photograph.
    GrayImage drawn(640, 480);
    for (int y = 0; y < 480; ++y) {
        for (int x = 0; x < 640; ++x) {
            const auto ray = unproject(lenses.cameras[0], {(x + 0.5) / 2, (y + 0.5) / 2});
            drawn(x, y) = 330 * ray.x() / ray.z() + 160 > 60 ? 255 : 0;
        }
    }
    write_png(scratch / "masks" / "walk" / "a.png", drawn);
    SilentProgress progress;
    straighten_masks({scratch / "masks", scratch / "poses", {"walk/a.jpg"}, {}}, scratch / "out", 1,
                     progress);
    const GrayImage mask = read_gray_png(straightened_mask_file(scratch / "out", "walk/a.jpg"));
    ASSERT_EQ(mask.width(), 320);
    for (int y = 0; y < 240; ++y) {
        for (int x = 0; x < 320; ++x) {
            if (std::abs(x + 0.5 - 60) <= 1) continue;
            ASSERT_EQ(mask(x, y) != 0, x >= 60) << x << ' ' << y;
        }
    }
}

TEST(StraightenedDepth, ASlantedPlaneIsWhereThePinholeSeesIt) {
    const ScratchFolder scratch;
    const BentView view(scratch / "poses");
    // The plane z = 2 + 0.5 x, at twice the photograph's size: x = z * tangent.
    const auto depth_along = [](const Eigen::Vector3d& ray) {
        return 2 / (1 - 0.5 * ray.x() / ray.z());
    };
    FloatImage depth(640, 480);
    for (int y = 0; y < 480; ++y) {
        for (int x = 0; x < 640; ++x) {
            depth(x, y) = static_cast<float>(
                depth_along(unproject(view.lenses.cameras[0], {(x + 0.5) / 2, (y + 0.5) / 2})));
        }
    }
    write_float_tiff(scratch / "depth" / "walk" / "a.tiff", depth);
    SilentProgress progress;
    const auto files = straighten_depth({scratch / "depth"}, view.pinholes, scratch / "poses",
                                        scratch / "out", 1, progress);
    ASSERT_EQ(files.size(), 1U);
    ASSERT_EQ(files[0].parent_path(), scratch / "out");
    const FloatImage straight = read_float_tiff(files[0]);
    ASSERT_EQ(straight.width(), 320);
    for (int y = 0; y < 240; ++y) {
        for (int x = 0; x < 320; ++x) {
            const auto ray = unproject(view.pinholes.cameras[0], {x + 0.5, y + 0.5});
            // Half a sample to the side, a quarter of a pixel, changes it by z^2 / 4 times that
            // over the focal length at most; a whole pixel by four times as much.
            ASSERT_NEAR(straight(x, y), depth_along(ray), 0.003) << x << ' ' << y;
        }
    }
}

TEST(StraightenedDepth, IsTheUsersOwnWhereNoLensBends) {
    const ScratchFolder scratch;
    const Capture pinholes = BentView(scratch / "poses").pinholes;
    write_colmap_model_binary(pinholes, scratch / "poses" / "sparse");
    write_float_tiff(scratch / "depth" / "walk" / "a.tiff", FloatImage(320, 240, 2.0F));
    SilentProgress progress;
    EXPECT_THAT(straighten_depth({scratch / "depth"}, pinholes, scratch / "poses", scratch / "out",
                                 1, progress),
                ElementsAre(scratch / "depth" / "walk" / "a.tiff"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
}

TEST(StraightenedDepth, OfAPhotographWithTheLongestNameHasAFileAsWell) {
    const ScratchFolder scratch;
    BentView view(scratch / "poses");
    const std::string name = std::string(251, 'a') + ".jpg";
    view.lenses.views[0].name = name;
    view.pinholes.views[0].name = name;
    write_colmap_model_binary(view.lenses, scratch / "poses" / "sparse");
    write_float_tiff(scratch / "depth.tif", FloatImage(320, 240, 2.0F));
    std::filesystem::create_directories(scratch / "depth");
    std::filesystem::rename(scratch / "depth.tif",
                            scratch / "depth" / (std::string(251, 'a') + ".tif"));
    SilentProgress progress;
    const auto files = straighten_depth({scratch / "depth"}, view.pinholes, scratch / "poses",
                                        scratch / "out", 1, progress);
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(read_float_tiff(files[0])(160, 120), 2.0F);
}

TEST(StraightenedDepth, MapsOfPicturesThatColmapStraightenedAreNotBentOnceMore) {
    const ScratchFolder scratch;
    const BentView view(scratch / "poses");
    write_whole_text(scratch / "depth" / "walk" / "a.jpg.geometric.bin", "320&240&1&");
    SilentProgress progress;
    try {
        static_cast<void>(straighten_depth({scratch / "depth"}, view.pinholes, scratch / "poses",
                                           scratch / "out", 1, progress));
        FAIL() << "expected E-DEPTH-UNDISTORTED";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-DEPTH-UNDISTORTED") << error.what();
    }
}

TEST(StraightenedDepth, ThatSaysNothingIsNamedByTheFolderThatWasGiven) {
    const ScratchFolder scratch;
    const BentView view(scratch / "poses");
    write_float_tiff(scratch / "depth" / "walk" / "a.tiff", FloatImage(320, 240, 0.0F));
    write_png(scratch / "a.png", ColorImage(320, 240));
    DepthOptions options;
    options.import_folder = scratch / "depth";
    SilentProgress progress;
    try {
        static_cast<void>(run_depth_stage({view.pinholes, {scratch / "a.png"}},
                                          {{}, scratch / "poses", {"walk/a.jpg"}, {}}, options,
                                          scratch / "stage", 1, progress));
        FAIL() << "expected E-DEPTH-EMPTY";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-DEPTH-EMPTY") << error.what();
        EXPECT_THAT(error.what(), testing::StartsWith((scratch / "depth").string() + ": "));
    }
}

}  // namespace
}  // namespace lumi
