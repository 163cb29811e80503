// Runs the real COLMAP on rendered photographs: ctest label "colmap".
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "calib/pictures/image_io.h"
#include "calib/poses/colmap_front_end.h"
#include "calib/poses/colmap_reconstruction.h"
#include "calib/poses/pose_comparison.h"
#include "calib/poses/pose_stage.h"
#include "calib/work/error.h"
#include "tests/calib/scratch_folder.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

constexpr int kWidth_px = 480;  ///< And the focal length.
constexpr int kHeight_px = 360;

const SyntheticCapture& box_scene() {
    static const SyntheticCapture scene = textured_box_scene({kWidth_px, kHeight_px, 50});
    return scene;
}

Photograph saved_photograph(const ColorImage& picture, const std::string& name,
                            const std::filesystem::path& path) {
    write_png(path, picture);
    Photograph photograph;
    photograph.name = name;
    photograph.picture_path = path;
    photograph.width_px = photograph.original_width_px = picture.width();
    photograph.height_px = photograph.original_height_px = picture.height();
    photograph.camera_key = "synthetic";
    return photograph;
}

std::vector<Photograph> box_photographs(const ScratchFolder& folder) {
    std::vector<Photograph> photographs;
    for (std::size_t index = 0; index < box_scene().photographs.size(); ++index) {
        const std::string name = "böx " + std::to_string(index) + ".png";
        photographs.push_back(
            saved_photograph(box_scene().photographs[index], name, folder / name));
    }
    return photographs;
}

NamedPoses true_poses() {
    NamedPoses poses;
    for (std::size_t index = 0; index < box_scene().capture.views.size(); ++index) {
        poses["böx " + std::to_string(index) + ".png"] =
            box_scene().capture.views[index].cam_from_world;
    }
    return poses;
}

NamedPoses poses_of(const Capture& capture) {
    NamedPoses poses;
    for (const View& view : capture.views) poses[view.name] = view.cam_from_world;
    return poses;
}

/// Distance between the two true cameras that are farthest apart.
double true_extent() {
    double extent = 0;
    for (const View& a : box_scene().capture.views) {
        for (const View& b : box_scene().capture.views) {
            extent = std::max(
                extent,
                (centre_in_world(a.cam_from_world) - centre_in_world(b.cam_from_world)).norm());
        }
    }
    return extent;
}

struct Means {
    PoseProgram front_end;
    PoseProgram mapper;
};

class PoseStageBy : public testing::TestWithParam<Means> {};

TEST_P(PoseStageBy, PlacesEveryPhotographOfARenderedScene) {
    const ScratchFolder folder;
    SilentProgress progress;
    PoseOptions options;
    options.front_end = GetParam().front_end;
    options.mapper = GetParam().mapper;
    const PoseResult result = estimate_poses(box_photographs(folder), std::nullopt, options,
                                             folder / "scratch", 2, progress);
    EXPECT_EQ(result.evidence.photographs_registered, 9);
    EXPECT_THAT(result.not_registered, testing::IsEmpty());
    EXPECT_EQ(result.capture.cameras.size(), 1u);
    EXPECT_NEAR(focal_length_px(result.capture.cameras[0]).x(), kWidth_px, 0.03 * kWidth_px);
    const PoseComparison difference = compare_poses(poses_of(result.capture), true_poses());
    EXPECT_LT(difference.max_position, 0.02 * true_extent());
    EXPECT_LT(result.evidence.mean_reprojection_error_px, 0.5);
    EXPECT_GT(result.evidence.points, 100);
}

INSTANTIATE_TEST_SUITE_P(All, PoseStageBy,
                         testing::Values(Means{PoseProgram::kLumi, PoseProgram::kLumi},
                                         Means{PoseProgram::kLumi, PoseProgram::kColmap},
                                         Means{PoseProgram::kColmap, PoseProgram::kLumi},
                                         Means{PoseProgram::kColmap, PoseProgram::kColmap}),
                         [](const auto& means) {
                             return std::string(name_of(means.param.front_end)) + "And" +
                                    std::string(name_of(means.param.mapper));
                         });

/// What a camera on a tripod sees around a window, behind which the box turns.
ColorImage behind_a_window(ColorImage picture, const GrayImage& window) {
    const ColorImage& still = box_scene().photographs.front();
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            if (window(x, y) == 0) picture(x, y) = still(picture.width() - 1 - x, y);
        }
    }
    return picture;
}

class PoseStageWithMasks : public testing::TestWithParam<PoseProgram> {};

TEST_P(PoseStageWithMasks, PlacesWhatTurnedBeforeACameraThatStoodStill) {
    const ScratchFolder folder;
    std::vector<Photograph> photographs = box_photographs(folder);
    GrayImage window(kWidth_px, kHeight_px, 0);
    for (int y = kHeight_px / 8; y < kHeight_px * 7 / 8; ++y) {
        for (int x = kWidth_px / 8; x < kWidth_px * 7 / 8; ++x) window(x, y) = 255;
    }
    for (std::size_t index = 0; index < photographs.size(); ++index) {
        write_png(photographs[index].picture_path,
                  behind_a_window(box_scene().photographs[index], window));
        write_png(folder / "masks" / photographs[index].name, window);
    }
    SilentProgress progress;
    PoseOptions options;
    options.front_end = GetParam();
    options.mask_folder = folder / "masks";
    const PoseResult result =
        estimate_poses(photographs, std::nullopt, options, folder / "scratch", 2, progress);
    EXPECT_EQ(result.evidence.photographs_registered, 9);
    const PoseComparison difference = compare_poses(poses_of(result.capture), true_poses());
    EXPECT_LT(difference.max_position, 0.03 * true_extent());
    options.mask_folder = folder / "no masks";
    EXPECT_THROW(static_cast<void>(estimate_poses(photographs, std::nullopt, options,
                                                  folder / "scratch", 2, progress)),
                 Error);
}

INSTANTIATE_TEST_SUITE_P(FrontEnds, PoseStageWithMasks,
                         testing::Values(PoseProgram::kLumi, PoseProgram::kColmap));

TEST(PoseStageWithColmap, IsTheSameForAnyNumberOfThreads) {
    const ScratchFolder folder;
    SilentProgress progress;
    const std::vector<Photograph> photographs = box_photographs(folder);
    const PoseResult one =
        estimate_poses(photographs, std::nullopt, {}, folder / "scratch", 1, progress);
    const PoseResult two =
        estimate_poses(photographs, std::nullopt, {}, folder / "scratch", 3, progress);
    ASSERT_EQ(one.capture.views.size(), two.capture.views.size());
    for (std::size_t index = 0; index < one.capture.views.size(); ++index) {
        EXPECT_EQ(one.capture.views[index].cam_from_world.translation,
                  two.capture.views[index].cam_from_world.translation);
    }
    EXPECT_EQ(one.capture.points.size(), two.capture.points.size());
    EXPECT_EQ(one.capture.cameras, two.capture.cameras);
}

TEST(PoseStageWithColmap, KeepsAGivenLensToTheBit) {
    const ScratchFolder folder;
    SilentProgress progress;
    PoseOptions options;
    options.refine_lens = false;
    const Camera truth = box_scene().capture.cameras[0];
    const PoseResult result =
        estimate_poses(box_photographs(folder), truth, options, folder / "scratch", 2, progress);
    ASSERT_EQ(result.capture.cameras.size(), 1u);
    EXPECT_EQ(result.capture.cameras[0], truth);
    const PoseComparison difference = compare_poses(poses_of(result.capture), true_poses());
    EXPECT_LT(difference.max_position, 0.005 * true_extent());
}

/// What a camera of focal length 400 px sees when it turns by `turn_rad` where `picture` was taken.
ColorImage turned(const ColorImage& picture, const Camera& camera, double turn_rad) {
    const Camera narrow = pinhole_camera(320, 320, 400);
    const Eigen::AngleAxisd turn(turn_rad, Eigen::Vector3d::UnitY());
    ColorImage result(narrow.width_px, narrow.height_px);
    for (int y = 0; y < result.height(); ++y) {
        for (int x = 0; x < result.width(); ++x) {
            const auto pixel = project(camera, turn * unproject(narrow, {x + 0.5, y + 0.5}));
            const int from_x = static_cast<int>(std::floor(pixel->x()));
            const int from_y = static_cast<int>(std::floor(pixel->y()));
            if (picture.contains(from_x, from_y)) result(x, y) = picture(from_x, from_y);
        }
    }
    return result;
}

TEST(PoseStageWithColmap, RefusesACameraThatOnlyTurned) {
    const ScratchFolder folder;
    SilentProgress progress;
    std::vector<Photograph> photographs;
    for (int index = 0; index < 4; ++index) {
        const std::string name = std::to_string(index) + ".png";
        const ColorImage picture = turned(box_scene().photographs[4],
                                          box_scene().capture.cameras[0], 0.06 * (index - 1.5));
        photographs.push_back(saved_photograph(picture, name, folder / name));
    }
    try {
        static_cast<void>(
            estimate_poses(photographs, std::nullopt, {}, folder / "scratch", 2, progress));
        ADD_FAILURE() << "expected a refusal";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-POSES-ROTATION");
        EXPECT_EQ(error.kind(), ErrorKind::kDegenerateCapture);
        EXPECT_THAT(error.what(), testing::HasSubstr("turned on the spot"));
        EXPECT_THAT(error.advice(), testing::HasSubstr("step sideways"));
    }
}

TEST(PoseStageWithColmap, RefusesPhotographsThatShowNothing) {
    const ScratchFolder folder;
    SilentProgress progress;
    std::vector<Photograph> photographs;
    for (const char* name : {"a.png", "b.png", "c.png"}) {
        photographs.push_back(
            saved_photograph(ColorImage(320, 240, {90, 90, 90}), name, folder / name));
    }
    try {
        static_cast<void>(
            estimate_poses(photographs, std::nullopt, {}, folder / "scratch", 2, progress));
        ADD_FAILURE() << "expected a refusal";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-POSES-TEXTURE");
        EXPECT_EQ(error.kind(), ErrorKind::kDegenerateCapture);
    }
}

TEST(ColmapFrontEnd, FindsMoreFeaturesWhereMoreAreAskedFor) {
    const ScratchFolder folder;
    SilentProgress progress;
    std::vector<Photograph> photographs = box_photographs(folder);
    photographs.resize(2);
    const CameraGroups groups = group_cameras(photographs, std::nullopt, {});
    const auto features = [&](int max_features, FeatureDetail detail) {
        PoseOptions options;
        options.max_features = max_features;
        PoseEvidence evidence;
        const MappingJob job{photographs,        groups, options,  false,   true,
                             folder / "scratch", 2,      progress, evidence};
        std::filesystem::remove_all(folder / "scratch");
        std::filesystem::create_directories(folder / "scratch");
        std::size_t count = 0;
        for (const ColmapPhotograph& photograph :
             match_with_colmap_alone(job, detail, "asked").photographs) {
            count += photograph.keypoints_px.size();
        }
        return static_cast<double>(count);
    };
    constexpr int kFew = 150;
    constexpr int kNoLimit = 20000;
    const double few = features(kFew, FeatureDetail::kUsual);
    const double all = features(kNoLimit, FeatureDetail::kUsual);
    ASSERT_GT(all, 3 * few);
    EXPECT_GT(features(kFew, FeatureDetail::kMore), 1.6 * few);
    EXPECT_GT(features(kNoLimit, FeatureDetail::kMore), all);
}

TEST(ColmapAlone, IsNotWhatAMapperThatHadToBeEndedLeft) {
    const ScratchFolder folder;
    SilentProgress progress;
    std::vector<Photograph> photographs = box_photographs(folder);
    photographs.resize(3);
    PoseOptions options;
    options.colmap = folder.put_text("colmap",
                                     "#!/bin/sh\n"
                                     "colmap \"$@\" || exit\n"
                                     "[ \"$1\" = mapper ] && kill -SEGV $$\n"
                                     "exit 0\n");
    std::filesystem::permissions(options.colmap, std::filesystem::perms::owner_all);
    try {
        static_cast<void>(reconstruct_with_colmap(photographs, std::nullopt, options,
                                                  folder / "scratch", 2, progress));
        ADD_FAILURE() << "expected an error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-COLMAP-TIME");
        EXPECT_THAT(error.what(), testing::HasSubstr("mapper: signal 11"));
    }
}

TEST(PoseStageWithColmap, SaysWhenColmapIsNotInstalled) {
    const ScratchFolder folder;
    SilentProgress progress;
    PoseOptions options;
    options.mapper = PoseProgram::kColmap;
    options.colmap = "no-such-colmap";
    try {
        static_cast<void>(estimate_poses(box_photographs(folder), std::nullopt, options,
                                         folder / "scratch", 2, progress));
        ADD_FAILURE() << "expected an error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-CHILD-MISSING");
        EXPECT_EQ(error.kind(), ErrorKind::kExternalProgram);
        EXPECT_THAT(error.advice(), testing::HasSubstr("colmap"));
    }
}

}  // namespace
}  // namespace lumi
