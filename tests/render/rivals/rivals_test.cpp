#include <gtest/gtest.h>

#include "render/reference/reference_renderer.h"
#include "render/rivals/forward_warping.h"
#include "render/rivals/spherical_light_field.h"
#include "render/rivals/two_plane.h"
#include "render/rivals/unstructured_lumigraph.h"
#include "render/rivals/view_dependent_texture.h"
#include "tests/render/analytic_scene.h"
#include "tests/render/frame_difference.h"

namespace lumi {
namespace {

Eye eye_of(const LumigraphView& view) { return {view.camera, view.cam_from_world}; }

TEST(TwoPlane, PicturesOfASlabCoverTheSameSquareOfTheFocalPlane) {
    const Lumigraph lumigraph = card_before_wall();
    const LightFieldLayout slab =
        two_plane_slab(lumigraph, {.columns = 4, .rows = 3, .size_px = 64});
    ASSERT_EQ(slab.eyes.size(), 12U);
    EXPECT_EQ(slab.mesh.faces.size(), 2U * 3U * 2U);
    const auto place_of = [&](const Eye& eye, const Eigen::Vector2d& pixel) {
        const Eigen::Vector3d centre = eye.cam_from_world * lumigraph.mesh.scene_centre_in_world;
        return (inverse(eye.cam_from_world) * (unproject(eye.camera, pixel) * centre.z()).eval())
            .eval();
    };
    for (const Eye& eye : slab.eyes)
        for (const Eigen::Vector2d& corner :
             {Eigen::Vector2d(0, 0), Eigen::Vector2d(64, 0), Eigen::Vector2d(64, 64)})
            EXPECT_LT((place_of(eye, corner) - place_of(slab.eyes[0], corner)).norm(), 1e-9);
}

TEST(TwoPlane, AnEyePointReturnsItsResampledPicture) {
    const Lumigraph source = card_before_wall();
    const Lumigraph slab =
        resampled(source, two_plane_slab(source, {.columns = 3, .rows = 3, .size_px = 48}),
                  [&](const Eye& eye) { return draw_reference(source, eye, {}); });
    const LumigraphView& view = slab.views[4];
    const Frame drawn = draw_reference(slab, eye_of(view), {.mode = RenderMode::kLightField});
    EXPECT_LE(difference_between(drawn.color, view.photograph).largest, 1);
}

TEST(TwoPlane, SixSlabsAreEnteredByEveryRay) {
    const LightFieldLayout cube =
        two_plane_cube(ball_in_sky(), {.columns = 3, .rows = 3, .size_px = 32});
    EXPECT_EQ(cube.eyes.size(), 54U);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d direction(std::cos(0.7 * i), std::sin(1.3 * i), std::cos(2.1 * i));
        EXPECT_TRUE(weights_of_ray(cube.mesh, {0.1, 0.2, -0.1}, direction).has_value()) << i;
    }
}

TEST(SphericalLightField, HasAPictureOfTheSceneForEachDirection) {
    const Lumigraph source = ball_in_sky();
    const LightFieldLayout sphere = spherical_light_field(source, {.size_px = 32});
    ASSERT_EQ(sphere.eyes.size(), 42U);
    EXPECT_EQ(sphere.mesh.faces.size(), 80U);
    for (const Eye& eye : sphere.eyes) {
        const auto centre =
            project(eye.camera, eye.cam_from_world * source.mesh.scene_centre_in_world);
        ASSERT_TRUE(centre.has_value());
        EXPECT_LT((*centre - Eigen::Vector2d(16, 16)).norm(), 1e-6);
    }
    EXPECT_TRUE(weights_of_ray(sphere.mesh, {0.1, 0, 0.2}, {1, 2, 3}).has_value());
}

TEST(PlainRivals, ReturnThePhotographWhereACameraStands) {
    const Lumigraph lumigraph = card_before_wall();
    const LumigraphView& view = lumigraph.views[8];
    const Eye eye = eye_of(view);
    EXPECT_LT(
        difference_between(draw_unstructured_lumigraph(lumigraph, eye).color, view.photograph).mean,
        1.0);
    EXPECT_LT(
        difference_between(draw_view_dependent_texture(lumigraph, eye).color, view.photograph).mean,
        1.0);
    const Frame warped = draw_forward_warping(lumigraph, eye, {.views = 1, .splat_px = 0.5});
    EXPECT_EQ(difference_between(warped.color, view.photograph).largest, 0);
}

TEST(PlainRivals, DrawBetweenCamerasWhatThePerPixelModeDraws) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, pinhole_camera(64, 48, 60));
    const ColorImage truth = ideal_photograph(AnalyticScene::kCardBeforeWall, eye);
    // Pixels along tears take other views.
    EXPECT_LT(difference_between(draw_unstructured_lumigraph(lumigraph, eye).color, truth).mean, 4);
    EXPECT_LT(difference_between(draw_view_dependent_texture(lumigraph, eye).color, truth).mean, 4);
    EXPECT_LT(difference_between(draw_forward_warping(lumigraph, eye).color, truth).mean, 4);
}

}  // namespace
}  // namespace lumi
