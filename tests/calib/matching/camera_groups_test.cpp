#include "calib/matching/camera_groups.h"

#include <gtest/gtest.h>

#include "calib/work/error.h"

namespace lumi {
namespace {

Photograph photograph(const std::string& key, int width_px, int height_px,
                      std::optional<double> focal_length_px = {}) {
    Photograph result;
    result.name = key + ".jpg";
    result.camera_key = key;
    result.width_px = width_px;
    result.height_px = height_px;
    result.focal_length_px = focal_length_px;
    return result;
}

TEST(CameraGroups, PhotographsOfOneCameraShareALens) {
    const CameraGroups groups =
        group_cameras({photograph("a", 800, 600, 700), photograph("b", 800, 600, 900),
                       photograph("a", 800, 600, 710), photograph("a", 800, 600, 705)},
                      std::nullopt, {});
    EXPECT_EQ(groups.camera_of_photograph, (std::vector<int>{0, 1, 0, 0}));
    ASSERT_EQ(groups.cameras.size(), 2u);
    EXPECT_EQ(groups.cameras[0].camera,
              (Camera{800, 600, LensModel::kSimpleRadial, {705, 400, 300, 0}}));
    EXPECT_TRUE(groups.cameras[0].focal_length_is_known);
}

TEST(CameraGroups, EachPhotographItsOwnWhenAsked) {
    const CameraGroups groups =
        group_cameras({photograph("a", 800, 600), photograph("a", 800, 600)}, std::nullopt,
                      {.shared_lens = false});
    EXPECT_EQ(groups.camera_of_photograph, (std::vector<int>{0, 1}));
    EXPECT_EQ(groups.cameras.size(), 2u);
}

TEST(CameraGroups, CropsOfOneSizeStartFromTheSameFocalLength) {
    const CameraGroups groups =
        group_cameras({photograph("a", 1000, 750), photograph("b", 1010, 740),
                       photograph("c", 990, 760), photograph("d", 500, 400)},
                      std::nullopt, {});
    EXPECT_EQ(groups.cameras[0].camera.parameters[0], 1200);
    EXPECT_EQ(groups.cameras[1].camera.parameters[0], 1200);
    EXPECT_EQ(groups.cameras[2].camera.parameters[0], 1200);
    EXPECT_EQ(groups.cameras[3].camera.parameters[0], 600);
    EXPECT_FALSE(groups.cameras[0].focal_length_is_known);
}

TEST(CameraGroups, EveryLensModelStartsWithoutDistortion) {
    for (const char* model : {"SIMPLE_PINHOLE", "PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV",
                              "OPENCV_FISHEYE", "FULL_OPENCV"}) {
        const Camera camera =
            group_cameras({photograph("a", 800, 600, 700)}, std::nullopt, {.lens_model = model})
                .cameras[0]
                .camera;
        EXPECT_EQ(name_of(camera.model), model);
        EXPECT_NO_THROW(validate(camera, model));
        EXPECT_EQ(focal_length_px(camera), Eigen::Vector2d(700, 700)) << model;
        EXPECT_EQ(principal_point_px(camera), Eigen::Vector2d(400, 300)) << model;
    }
}

TEST(CameraGroups, MixedZoomsAreLensesOfTheirOwnWithTheirOwnFocalLengths) {
    const CameraGroups groups = group_cameras({photograph("800x600 Maker 18 mm", 800, 600, 640),
                                               photograph("800x600 Maker 55 mm", 800, 600, 1950),
                                               photograph("800x600 Maker 18 mm", 800, 600, 640),
                                               photograph("800x600 Maker 55 mm", 800, 600, 1960)},
                                              std::nullopt, {});
    EXPECT_EQ(groups.camera_of_photograph, (std::vector<int>{0, 1, 0, 1}));
    EXPECT_EQ(groups.cameras[0].camera.parameters[0], 640);
    EXPECT_NEAR(groups.cameras[1].camera.parameters[0], 1955, 5.1);
}

TEST(CameraGroups, APhotographWithoutExifStartsFromThoseOfItsSize) {
    // One that lost its EXIF data is a group of its own: its zoom is not known. Its best guess is
    // what photographs of its size were taken with.
    const CameraGroups groups = group_cameras(
        {photograph("800x600 Maker 18 mm", 800, 600, 640), photograph("800x600", 800, 600),
         photograph("800x600 Maker 18 mm", 800, 600, 640), photograph("900x600", 900, 600)},
        std::nullopt, {});
    EXPECT_EQ(groups.camera_of_photograph, (std::vector<int>{0, 1, 0, 2}));
    EXPECT_EQ(groups.cameras[1].camera.parameters[0], 640);
    EXPECT_FALSE(groups.cameras[1].focal_length_is_known);
    EXPECT_EQ(groups.cameras[2].camera.parameters[0], 1.2 * 900);
}

TEST(CameraGroups, AGivenLensIsRescaled) {
    const Camera given{1600, 1200, LensModel::kRadial, {1500, 810, 590, -0.1, 0.02}};
    const CameraGroups groups = group_cameras({photograph("a", 800, 600, 333)}, given, {});
    EXPECT_EQ(groups.cameras[0].camera,
              (Camera{800, 600, LensModel::kRadial, {750, 405, 295, -0.1, 0.02}}));
    EXPECT_TRUE(groups.cameras[0].focal_length_is_known);
}

TEST(CameraGroups, AGivenLensForAnotherShapeIsRefused) {
    const Camera given = pinhole_camera(1600, 1200, 1500);
    try {
        static_cast<void>(group_cameras({photograph("a", 800, 500)}, given, {}));
        ADD_FAILURE() << "expected a refusal";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-POSES-LENS");
    }
    EXPECT_NO_THROW(static_cast<void>(group_cameras({photograph("a", 533, 400)}, given, {})));
}

}  // namespace
}  // namespace lumi
