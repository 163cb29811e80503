#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/reference/eye_depths.h"
#include "render/reference/reference_renderer.h"
#include "render/rivals/forward_warping.h"
#include "render/rivals/spherical_light_field.h"
#include "render/rivals/two_plane.h"
#include "render/rivals/unstructured_lumigraph.h"
#include "render/rivals/view_dependent_texture.h"
#include "render/transfer/sampling.h"
#include "tests/render/analytic_scene.h"
#include "tests/render/frame_difference.h"

namespace lumi {
namespace {

Eye eye_of(const LumigraphView& view) { return {view.camera, view.cam_from_world}; }

TEST(TwoPlane, PicturesOfASlabCoverTheSameRectangleOfTheFocalPlane) {
    const Lumigraph lumigraph = card_before_wall();
    const LightFieldLayout slab =
        two_plane_slab(lumigraph, {.columns = 4, .rows = 3, .width_px = 64, .height_px = 48});
    ASSERT_EQ(slab.eyes.size(), 12U);
    EXPECT_EQ(slab.mesh.faces.size(), 2U * 3U * 2U);
    const auto place_of = [&](const Eye& eye, const Eigen::Vector2d& pixel) {
        const Eigen::Vector3d centre = eye.cam_from_world * lumigraph.mesh.scene_centre_in_world;
        return (inverse(eye.cam_from_world) * (unproject(eye.camera, pixel) * centre.z()).eval())
            .eval();
    };
    for (const Eye& eye : slab.eyes)
        for (const Eigen::Vector2d& corner :
             {Eigen::Vector2d(0, 0), Eigen::Vector2d(64, 0), Eigen::Vector2d(64, 48)})
            EXPECT_LT((place_of(eye, corner) - place_of(slab.eyes[0], corner)).norm(), 1e-9);
}

TEST(TwoPlane, AnEyePointReturnsItsResampledPicture) {
    const Lumigraph source = card_before_wall();
    const Lumigraph slab = resampled(
        source, two_plane_slab(source, {.columns = 3, .rows = 3, .width_px = 48, .height_px = 48}),
        [&](const Eye& eye) { return draw_reference(source, eye, {}); });
    const LumigraphView& view = slab.views[4];
    const Frame drawn = draw_reference(slab, eye_of(view), {.mode = RenderMode::kLightField});
    EXPECT_LE(difference_between(drawn.color, view.photograph).largest, 1);
}

/// A slab of three by three eye points, and its pictures of the printed card, which have no depth.
struct SlabOfPrintedCard {
    static constexpr int kAcross = 3;
    static constexpr double kSide_px = 48;

    Lumigraph source = [] {
        Lumigraph scene = card_before_wall();
        for (LumigraphView& view : scene.views) view.depth = {};
        return scene;
    }();
    LightFieldLayout layout = two_plane_slab(
        source, {.columns = kAcross, .rows = kAcross, .width_px = 48, .height_px = 48});
    Lumigraph pictures = resampled(source, layout, [](const Eye& eye) {
        Frame frame = empty_frame(eye.camera);
        frame.color = ideal_photograph(AnalyticScene::kPrintedCard, eye);
        return frame;
    });

    /// The colour of a ray by its four coordinates, which are found here without any camera: where
    /// it meets the plane of the eye points and the parallel one through the scene's centre. Empty
    /// outside of the slab.
    [[nodiscard]] std::optional<Eigen::Vector3d> color_of(const Eigen::Vector3d& from_in_world,
                                                          const Eigen::Vector3d& direction) const {
        const Eigen::Quaterniond& plane_from_world = layout.eyes[0].cam_from_world.rotation;
        const auto eye_point = [&](std::size_t i) {
            return (plane_from_world * centre_in_world(layout.eyes[i].cam_from_world)).eval();
        };
        const Eigen::Vector3d from = plane_from_world * from_in_world;
        const Eigen::Vector3d along = plane_from_world * direction;
        const auto met_at = [&](double z) {
            return (from + (z - from.z()) / along.z() * along).head<2>().eval();
        };
        const Eigen::Vector3d centre = plane_from_world * source.mesh.scene_centre_in_world;
        const Eigen::Vector2d pixel =
            0.5 * kSide_px *
            (Eigen::Vector2d::Ones() +
             (met_at(centre.z()) - centre.head<2>()).cwiseQuotient(seen_half_size(source)));
        const Eigen::Vector2d steps =
            (met_at(eye_point(0).z()) - eye_point(0).head<2>())
                .cwiseQuotient((eye_point(kAcross + 1) - eye_point(0)).head<2>());
        if (pixel.minCoeff() < 2 || pixel.maxCoeff() > kSide_px - 2 || steps.minCoeff() < 0 ||
            steps.maxCoeff() > kAcross - 1)
            return std::nullopt;
        const Eigen::Vector2d cell = steps.array().floor().min(kAcross - 2.0);
        const double u = (steps - cell).x();
        const double v = (steps - cell).y();
        const auto first = static_cast<std::size_t>(kAcross * cell.y() + cell.x());
        // Squares are halved from the first corner to the last.
        const std::size_t third = u > v ? first + 1 : first + kAcross;
        const auto color = [&](std::size_t i) {
            return bilinear(pictures.views[i].photograph, pixel);
        };
        return (1 - std::max(u, v)) * color(first) + std::abs(u - v) * color(third) +
               std::min(u, v) * color(first + kAcross + 1);
    }
};

TEST(TwoPlane, ARayBetweenEyePointsIsLookedUpByItsFourCoordinates) {
    const SlabOfPrintedCard slab;
    const Eye eye = eye_at({0.7, 0.5, -1.5}, {0, 0, 4}, pinhole_camera(64, 48, 80));
    const auto farthest_off = [&](const FocalPlane& plane) {
        const Frame drawn = draw_reference(slab.pictures, eye,
                                           {.mode = RenderMode::kLightField, .focal_plane = plane});
        double farthest = 0;
        int rays = 0;
        for (int y = 0; y < eye.camera.height_px; ++y) {
            for (int x = 0; x < eye.camera.width_px; ++x) {
                const auto expected = slab.color_of(centre_in_world(eye.cam_from_world),
                                                    eye.cam_from_world.rotation.conjugate() *
                                                        unproject(eye.camera, {x + 0.5, y + 0.5}));
                if (!expected) continue;
                ++rays;
                const Rgb8& color = drawn.color(x, y);
                farthest =
                    std::max(farthest, (Eigen::Vector3d(color.r, color.g, color.b) - *expected)
                                           .lpNorm<Eigen::Infinity>());
            }
        }
        EXPECT_GT(rays, 500);
        return farthest;
    };
    EXPECT_LT(farthest_off(slab.layout.shared_plane), 1.5);
    EXPECT_GT(farthest_off({}), 5) << "on the scene plane, which faces the eye";
}

TEST(TwoPlane, SixSlabsAreEnteredByEveryRay) {
    const LightFieldLayout cube =
        two_plane_cube(ball_in_sky(), {.columns = 3, .rows = 3, .width_px = 32, .height_px = 32});
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

EyeDepths depths_at(const Lumigraph& lumigraph, const Eye& eye) {
    return eye_depths(lumigraph, eye, kAgreeingDisparity_px);
}

Frame unstructured(const Lumigraph& lumigraph, const Eye& eye) {
    return draw_unstructured_lumigraph(lumigraph, eye, depths_at(lumigraph, eye));
}

Frame view_dependent(const Lumigraph& lumigraph, const Eye& eye) {
    return draw_view_dependent_texture(lumigraph, eye, depths_at(lumigraph, eye));
}

Frame warped(const Lumigraph& lumigraph, const Eye& eye) {
    return draw_forward_warping(lumigraph, eye);
}

struct NamedRival {
    const char* name;
    Frame (*draw)(const Lumigraph& lumigraph, const Eye& eye);
    double most_off;  ///< Of the per-pixel mode, in the mean: along tears pixels take other views.
};
constexpr NamedRival kPlainRivals[] = {{"unstructured lumigraph", unstructured, 0.8},
                                       {"view-dependent texture", view_dependent, 0.9},
                                       {"forward warping", warped, 2.8}};

double uncovered_share(const Frame& frame) {
    const auto& pixels = frame.coverage.pixels();
    return static_cast<double>(std::count(pixels.begin(), pixels.end(), 0)) /
           static_cast<double>(pixels.size());
}

TEST(PlainRivals, ReturnThePhotographWhereACameraStands) {
    const Lumigraph lumigraph = card_before_wall();
    const LumigraphView& view = lumigraph.views[8];
    const Eye eye = eye_of(view);
    EXPECT_LT(difference_between(unstructured(lumigraph, eye).color, view.photograph).mean, 1.0);
    EXPECT_LT(difference_between(view_dependent(lumigraph, eye).color, view.photograph).mean, 1.0);
    const Frame frame = draw_forward_warping(lumigraph, eye, {.views = 1, .splat_px = 0.5});
    EXPECT_EQ(difference_between(frame.color, view.photograph).largest, 0);
}

/// The same photographs, all depth on a plane between card and wall.
Lumigraph on_one_plane(Lumigraph lumigraph) {
    for (LumigraphView& view : lumigraph.views) {
        for (float& inverse_depth : view.depth.inverse_depth.pixels()) inverse_depth = 0.25F;
        view.depth_mesh.reset();
    }
    return lumigraph;
}

TEST(PlainRivals, DrawBetweenCamerasWhatThePerPixelModeDraws) {
    const Lumigraph lumigraph = card_before_wall();
    const Lumigraph flat = on_one_plane(lumigraph);
    const Eye eye = eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, pinhole_camera(64, 48, 60));
    const ColorImage per_pixel =
        draw_reference(lumigraph, eye, {.mode = RenderMode::kPerPixel}).color;
    for (const NamedRival& rival : kPlainRivals) {
        const double off = difference_between(rival.draw(lumigraph, eye).color, per_pixel).mean;
        const double off_flat = difference_between(rival.draw(flat, eye).color, per_pixel).mean;
        EXPECT_LT(off, rival.most_off) << rival.name;
        EXPECT_GT(off_flat, 3 * off) << rival.name << " with all depth on one plane";
    }
}

TEST(ViewDependentTexture, ShowsNoOtherSurfaceWhereAViewOfItsPolygonIsHidden) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, pinhole_camera(128, 96, 120));
    const ColorImage truth = ideal_photograph(AnalyticScene::kCardBeforeWall, eye);
    const Frame frame = view_dependent(lumigraph, eye);
    int other = 0;
    for (int y = 0; y < truth.height(); ++y)
        for (int x = 0; x < truth.width(); ++x)
            if (frame.coverage(x, y) != 0 && std::abs(frame.color(x, y).r - truth(x, y).r) > 51)
                ++other;
    // By its outline, where a pixel may show either.
    EXPECT_LT(other, 55);
}

TEST(PlainRivals, DrawASkyThatIsInfinitelyFar) {
    const Lumigraph lumigraph = ball_in_sky();
    const LumigraphView& view = lumigraph.views[0];
    const Eigen::Vector3d beside = centre_in_world(view.cam_from_world) * 1.1;
    const Eye eye = eye_at(beside, {0.1, 0, 0}, view.camera);
    const ColorImage truth = ideal_photograph(AnalyticScene::kBallInSky, eye);
    for (const NamedRival& rival : kPlainRivals) {
        const Frame frame = rival.draw(lumigraph, eye);
        EXPECT_LT(uncovered_share(frame), 0.1) << rival.name;
        EXPECT_EQ(frame.coverage(2, 2), 255) << rival.name;
        const Rgb8& sky = frame.color(2, 2);
        EXPECT_NEAR(sky.r, truth(2, 2).r, 6) << rival.name;
        EXPECT_NEAR(sky.g, truth(2, 2).g, 6) << rival.name;
        EXPECT_NEAR(sky.b, truth(2, 2).b, 6) << rival.name;
    }
}

TEST(ForwardWarping, LeavesNoHolesWhereTheFrameIsFinerThanThePhotographs) {
    const Lumigraph lumigraph = card_before_wall();
    const LumigraphView& view = lumigraph.views[8];
    const Eye eye{pinhole_camera(160, 120, 240), view.cam_from_world};
    EXPECT_EQ(uncovered_share(draw_forward_warping(lumigraph, eye, {.views = 1})), 0);
}

TEST(ForwardWarping, SpreadsNoSampleOverAllOfThePictureOfAnEyeThatTouchesASurface) {
    const Lumigraph lumigraph = card_before_wall();
    // The card's samples are thirty pixels apart here, and what is behind it no view has seen.
    const Eye eye = eye_at({0, 0, 2.9}, {0, 0, 3}, lumigraph.views[8].camera);
    const double uncovered = uncovered_share(draw_forward_warping(lumigraph, eye, {.views = 1}));
    EXPECT_GT(uncovered, 0.5);
    EXPECT_LT(uncovered, 1);
}

}  // namespace
}  // namespace lumi
