#include "render/depth_layers/depth_eye.h"

#include <gtest/gtest.h>

#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

/// One view, 64 pixels wide, with a depth map of so many columns, and an eye where it stands.
struct ViewAndEye {
    Lumigraph lumigraph;
    Eye eye;
};

ViewAndEye view_and_eye(int depth_columns, int eye_width_px) {
    ViewAndEye scene;
    const Eye view = eye_at({0, 0, 0}, {0, 0, 5}, pinhole_camera(64, 48, 60));
    scene.lumigraph.views.push_back({"", view.camera, view.cam_from_world, 1, {}, {}});
    scene.lumigraph.views.front().depth.inverse_depth =
        FloatImage(depth_columns, depth_columns * 3 / 4);
    scene.lumigraph.mesh.scene_centre_in_world = {0, 0, 5};
    scene.eye = {resized(view.camera, eye_width_px, eye_width_px * 3 / 4), view.cam_from_world};
    return scene;
}

/// Where silhouettes are not smooth.
double texels_per_pixel(int depth_columns, int eye_width_px) {
    const ViewAndEye scene = view_and_eye(depth_columns, eye_width_px);
    return depth_eye(scene.lumigraph, scene.eye, {.smooth_silhouettes = false}).texels_per_pixel;
}

TEST(DepthEye, HasTexelsAsLargeAsTheSamplesOfTheDepthMaps) {
    EXPECT_EQ(texels_per_pixel(32, 64), 0.5);
    EXPECT_EQ(texels_per_pixel(48, 64), 0.75);
    EXPECT_EQ(texels_per_pixel(46, 64), 0.75);  // In eighths, never too few.
}

TEST(DepthEye, HasNoMoreTexelsThanPixelsAndAtLeastOneForTwo) {
    EXPECT_EQ(texels_per_pixel(64, 32), 1.0);
    EXPECT_EQ(texels_per_pixel(52, 64), 1.0);  // Nearly as many are made as many.
    EXPECT_EQ(texels_per_pixel(16, 64), kLeastTexelsPerPixel);
}

TEST(DepthEye, HasAsManyTexelsAsPixelsWhereNothingIsKnownOfDepth) {
    ViewAndEye scene = view_and_eye(32, 64);
    scene.lumigraph.views.front().depth = {};
    EXPECT_EQ(depth_eye(scene.lumigraph, scene.eye, {.smooth_silhouettes = false}).texels_per_pixel,
              1.0);
}

TEST(DepthEye, HasATexelForEachOfSeveralSamplesAPixel) {
    const ViewAndEye scene = view_and_eye(32, 64);
    EXPECT_EQ(depth_eye(scene.lumigraph, scene.eye, {.supersample = true}).texels_per_pixel, 1.0);
}

TEST(DepthEye, HasSeveralTexelsAPixelWhereDepthTellsSilhouettesThatFinely) {
    const auto is_smooth = [](const ViewAndEye& scene, const RenderOptions& options = {}) {
        return depth_eye(scene.lumigraph, scene.eye, options).is_smooth();
    };
    EXPECT_TRUE(is_smooth(view_and_eye(64, 64)));
    EXPECT_TRUE(is_smooth(view_and_eye(64, 32)));
    EXPECT_FALSE(is_smooth(view_and_eye(32, 64)));
    EXPECT_FALSE(is_smooth(view_and_eye(64, 64), {.supersample = true}));
    EXPECT_FALSE(is_smooth(view_and_eye(64, 64), {.smooth_silhouettes = false}));
    EXPECT_FALSE(is_smooth(view_and_eye(64, 64), {.fade_beyond_capture = true}));
    ViewAndEye with_close_ups = view_and_eye(64, 64);
    with_close_ups.lumigraph.mesh.shells.emplace_back();
    EXPECT_FALSE(is_smooth(with_close_ups));
    ViewAndEye in_blocks = view_and_eye(64, 64);
    in_blocks.lumigraph.drawing.depth_block_px = kMaxDepthBlock_px;
    EXPECT_FALSE(is_smooth(in_blocks));
}

bool is_in_blocks(double allowed_block_px, int eye_width_px, const RenderOptions& options = {}) {
    ViewAndEye scene = view_and_eye(64, eye_width_px);  // Its photograph is 64 pixels wide.
    scene.lumigraph.drawing.depth_block_px = allowed_block_px;
    return is_drawn_in_blocks(scene.lumigraph, scene.eye, options);
}

TEST(DepthEye, IsOfBlocksInFramesSoFineThatTheyAreNoWiderThanTheyMayBe) {
    EXPECT_TRUE(is_in_blocks(kLeastDepthBlock_px, 128));
    EXPECT_FALSE(is_in_blocks(kLeastDepthBlock_px, 124));
    EXPECT_TRUE(is_in_blocks(1.6, 80));
    EXPECT_FALSE(is_in_blocks(1.6, 76));
    for (const int eye_width_px : {16, 64, 128})
        EXPECT_TRUE(is_in_blocks(kMaxDepthBlock_px, eye_width_px));
}

TEST(DepthEye, IsNeverOfBlocksWhereSamplesAreSeveralOrFramesFade) {
    EXPECT_FALSE(is_in_blocks(kMaxDepthBlock_px, 128, {.supersample = true}));
    EXPECT_FALSE(is_in_blocks(kMaxDepthBlock_px, 128, {.fade_beyond_capture = true}));
}

TEST(DepthEye, SeesAPointWhereTheEyeDoesInTexels) {
    const ViewAndEye scene = view_and_eye(32, 63);
    const DepthEye depth = depth_eye(scene.lumigraph, scene.eye, {});
    const Eigen::Vector3d point(0.4, -0.3, 2);
    const Eigen::Vector2d in_eye = *project(scene.eye.camera, scene.eye.cam_from_world * point);
    const Eigen::Vector2d in_texels = *project(depth.eye.camera, depth.eye.cam_from_world * point);
    EXPECT_LT((in_texels - depth.texels_per_pixel * in_eye).norm(), 1e-9);
    EXPECT_GE(depth.eye.camera.width_px, depth.texels_per_pixel * 63);
}

}  // namespace
}  // namespace lumi
