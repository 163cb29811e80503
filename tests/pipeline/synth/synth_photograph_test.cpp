#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdlib>

#include "calib/work/progress.h"
#include "pipeline/synth/photographer.h"
#include "pipeline/synth/solid_noise.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

const SyntheticCapture& box_scene() {
    static const SyntheticCapture kScene = textured_box_scene();
    return kScene;
}

double difference(const Rgb8& a, const Rgb8& b) {
    return (std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b)) / 3.0;
}

double mean_difference(const ColorImage& a, const ColorImage& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        sum += difference(a.pixels()[i], b.pixels()[i]);
    }
    return sum / static_cast<double>(a.pixels().size());
}

struct PixelInWorld {
    Eigen::Vector3d point;
    int x;
    int y;
};

/// Every third pixel of a view, placed in the world by its true depth.
std::vector<PixelInWorld> placed_pixels(const SyntheticCapture& scene, std::size_t view_index) {
    const View& view = scene.capture.views[view_index];
    const Camera& camera = camera_of(scene.capture, view);
    std::vector<PixelInWorld> placed;
    for (int y = 1; y < camera.height_px; y += 3) {
        for (int x = 1; x < camera.width_px; x += 3) {
            const double z = static_cast<double>(scene.depths[view_index](x, y));
            if (z == 0.0) continue;
            const Eigen::Vector3d in_cam = z * unproject(camera, {x + 0.5, y + 0.5});
            placed.push_back({inverse(view.cam_from_world) * in_cam, x, y});
        }
    }
    return placed;
}

constexpr std::size_t kMiddleView = 4;

ColorImage taken(const SceneDescription& description, const Capture& capture) {
    const View& view = capture.views[kMiddleView];
    return develop(photograph(description.scene, camera_of(capture, view), view.cam_from_world,
                              description.sampling)
                       .light,
                   {}, 0);
}

/// The same picture taken at 4 times the size and averaged down.
ColorImage finer_averaged_down(const SceneDescription& description, const Capture& capture) {
    const View& view = capture.views[kMiddleView];
    const Camera& camera = camera_of(capture, view);
    const Camera fine_camera = resized(camera, 4 * camera.width_px, 4 * camera.height_px);
    const auto fine =
        photograph(description.scene, fine_camera, view.cam_from_world, description.sampling).light;
    Image<LinearColor> averaged(camera.width_px, camera.height_px, LinearColor::Zero());
    for (int y = 0; y < fine.height(); ++y) {
        for (int x = 0; x < fine.width(); ++x) averaged(x / 4, y / 4) += fine(x, y) / 16.0f;
    }
    return develop(averaged, {}, 0);
}

double aliasing(const SceneDescription& description, const Capture& capture) {
    return mean_difference(taken(description, capture), finer_averaged_down(description, capture));
}

TEST(Photograph, DepthAndPosesAgreeBetweenViews) {
    const SyntheticCapture& scene = box_scene();
    const SceneDescription description = textured_box_description();
    int compared = 0;
    double color_difference = 0.0;
    for (std::size_t other = 0; other < scene.capture.views.size(); ++other) {
        const View& view = scene.capture.views[other];
        const Camera& camera = camera_of(scene.capture, view);
        const Eigen::Vector3d eye = centre_in_world(view.cam_from_world);
        for (const PixelInWorld& pixel : placed_pixels(scene, 4)) {
            const Eigen::Vector3d in_cam = view.cam_from_world * pixel.point;
            const auto seen_at = project(camera, in_cam);
            if (!seen_at || !is_inside(camera, *seen_at)) continue;
            // Depth is a float: the point lies that far off its surface.
            const Ray ray{eye, (pixel.point - eye).normalized()};
            const auto hit = first_hit(description.scene, ray);
            ASSERT_TRUE(hit.has_value());
            const double distance = (pixel.point - eye).norm();
            ASSERT_LT(hit->distance, distance * (1 + 1e-5)) << "nothing is where depth says";
            if (hit->distance < distance * (1 - 1e-5)) continue;  // Hidden from this view.
            const int x = static_cast<int>(seen_at->x());
            const int y = static_cast<int>(seen_at->y());
            color_difference +=
                difference(scene.photographs[4](pixel.x, pixel.y), scene.photographs[other](x, y));
            ++compared;
        }
    }
    ASSERT_GT(compared, 10'000);
    // Nearest pixels of small, richly textured pictures; unrelated pixels differ by more than 30.
    EXPECT_LT(color_difference / compared, 8.0);
}

TEST(Photograph, DepthIsZOfTheFirstHitAtThePixelsCentre) {
    const SyntheticCapture& scene = box_scene();
    const SceneDescription description = textured_box_description();
    const View& view = scene.capture.views[0];
    for (int y = 0; y < 120; y += 7) {
        for (int x = 0; x < 160; x += 7) {
            const PixelRay through =
                ray_through(description.camera, inverse(view.cam_from_world), {x + 0.5, y + 0.5});
            const auto hit = first_hit(description.scene, through.ray);
            ASSERT_TRUE(hit.has_value());
            const double z = (view.cam_from_world * through.ray.at(hit->distance)).z();
            EXPECT_NEAR(static_cast<double>(scene.depths[0](x, y)), z, 1e-6 * z);
        }
    }
}

TEST(Photograph, TheBoxHidesPartsOfTheWall) {
    const SyntheticCapture& scene = box_scene();
    const SceneDescription description = textured_box_description();
    const Eigen::Vector3d eye = centre_in_world(scene.capture.views[0].cam_from_world);
    int hidden = 0;
    int visible = 0;
    for (const PixelInWorld& pixel : placed_pixels(scene, 2)) {
        (is_visible_from(description.scene, eye, pixel.point) ? visible : hidden) += 1;
    }
    EXPECT_GT(hidden, 50);
    EXPECT_GT(visible, 500);
}

TEST(Photograph, IsCloseToAFinerOneAveragedDown) {
    const SceneDescription description = textured_box_description({.points = 0});
    EXPECT_LT(aliasing(description, exact_capture(description)), 1.0);
}

TEST(Photograph, OfOneRayPerPixelIsFurtherFromAFinerOne) {
    SceneDescription description = textured_box_description({.points = 0});
    const Capture capture = exact_capture(description);
    const double smooth = aliasing(description, capture);
    const ColorImage reference = finer_averaged_down(description, capture);
    description.sampling = {.samples_per_texture = 1, .samples_per_edge = 1};
    EXPECT_GT(mean_difference(taken(description, capture), reference), 2.0 * smooth);
}

TEST(Photograph, LensDistortionBendsRaysAsTheCameraProjects) {
    SceneDescription description = textured_box_description({.points = 0});
    description.camera = {
        160, 120, LensModel::kOpenCv, {160, 158, 81, 59, -0.12, 0.03, 0.002, -0.001}};
    const Capture capture = exact_capture(description);
    const View& view = capture.views[4];
    const ExactPicture picture = photograph(description.scene, description.camera,
                                            view.cam_from_world, description.sampling);
    const ColorImage distorted = develop(picture.light, {}, 0);
    const Camera straight = pinhole_camera(160, 120, 160);
    const ColorImage pinhole = develop(
        photograph(description.scene, straight, view.cam_from_world, description.sampling).light,
        {}, 0);
    double straightened_difference = 0.0;
    double raw_difference = 0.0;
    int compared = 0;
    for (int y = 10; y < 110; ++y) {
        for (int x = 10; x < 150; ++x) {
            const auto from = project(description.camera, unproject(straight, {x + 0.5, y + 0.5}));
            ASSERT_TRUE(from && is_inside(description.camera, *from));
            const Rgb8& there = distorted(static_cast<int>(from->x()), static_cast<int>(from->y()));
            straightened_difference += difference(pinhole(x, y), there);
            raw_difference += difference(pinhole(x, y), distorted(x, y));
            ++compared;
        }
    }
    EXPECT_LT(straightened_difference, 0.5 * raw_difference);
    // And exactly so in depth: both see the same surface along the same ray.
    const PixelRay through =
        ray_through(description.camera, inverse(view.cam_from_world), {12.5, 100.5});
    const auto hit = first_hit(description.scene, through.ray);
    ASSERT_TRUE(hit.has_value());
    const Eigen::Vector3d in_cam = view.cam_from_world * through.ray.at(hit->distance);
    EXPECT_LT((*project(description.camera, in_cam) - Eigen::Vector2d(12.5, 100.5)).norm(), 1e-6);
    EXPECT_NEAR(static_cast<double>(picture.depth(12, 100)), in_cam.z(), 1e-5);
}

TEST(Sensor, NoiseHasTheStatedDeviationAndMeanZero) {
    const Image<LinearColor> grey(200, 200, LinearColor::Constant(0.2f));
    const ColorImage clean = develop(grey, {}, 5);
    const ColorImage noisy = develop(grey, {.noise_sigma = 4.0}, 5);
    double sum = 0.0;
    double squares = 0.0;
    for (const Rgb8& pixel : noisy.pixels()) {
        const double step = pixel.g - clean(0, 0).g;
        sum += step;
        squares += step * step;
    }
    EXPECT_NEAR(sum / 40'000.0, 0.0, 0.6);  // Half a step is the rounding of the clean value.
    EXPECT_NEAR(std::sqrt(squares / 40'000.0), 4.0, 0.2);
    EXPECT_EQ(noisy, develop(grey, {.noise_sigma = 4.0}, 5));
    EXPECT_NE(noisy, develop(grey, {.noise_sigma = 4.0}, 6));
}

TEST(Sensor, BlurKeepsTheMeanAndWidensAPointAsStated) {
    Image<LinearColor> point(41, 41, LinearColor::Zero());
    point(20, 20) = LinearColor::Constant(20.0f);
    const ColorImage blurred = develop(point, {.blur_sigma_px = 2.0}, 0);
    double sum = 0.0;
    double squares = 0.0;
    for (int x = 0; x < 41; ++x) {
        const Eigen::Vector3f srgb =
            Eigen::Vector3f::Constant(static_cast<float>(blurred(x, 20).g) / 255.0f);
        const double light = static_cast<double>(linear_from_srgb(srgb).x());
        sum += light;
        squares += light * (x - 20) * (x - 20);
    }
    EXPECT_NEAR(std::sqrt(squares / sum), 2.0, 0.1);
}

TEST(Sensor, ExposureDriftStaysWithinItsStops) {
    const Image<LinearColor> grey(4, 4, LinearColor::Constant(0.2f));
    const auto light_of = [](const ColorImage& image) {
        const auto value = static_cast<float>(image(0, 0).g) / 255.0f;
        return static_cast<double>(linear_from_srgb(Eigen::Vector3f::Constant(value)).x());
    };
    double least = 1.0;
    double most = 0.0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const double light = light_of(develop(grey, {.exposure_drift_stops = 0.5}, seed));
        least = std::min(least, light);
        most = std::max(most, light);
    }
    EXPECT_GT(least, 0.2 * std::exp2(-0.53));
    EXPECT_LT(least, 0.2 * std::exp2(-0.4));
    EXPECT_LT(most, 0.2 * std::exp2(0.53));
    EXPECT_GT(most, 0.2 * std::exp2(0.4));
}

TEST(SolidNoise, HasMeanZeroAndFadesWithTheFootprint) {
    double sum = 0.0;
    double fine = 0.0;
    double coarse = 0.0;
    constexpr int kCount = 20'000;
    for (int i = 0; i < kCount; ++i) {
        const Eigen::Vector3d point(0.173 * i, 0.711 * i, 1.37 * i);
        const double value = fractal_noise(point, 0.001, {1.0, 4, 0.5}, 3);
        const double faded = fractal_noise(point, 3.0, {1.0, 4, 0.5}, 3);
        sum += value;
        fine += value * value;
        coarse += faded * faded;
    }
    EXPECT_NEAR(sum / kCount, 0.0, 0.01);
    EXPECT_GT(fine / kCount, 0.01);
    EXPECT_EQ(coarse, 0.0);
}

}  // namespace
}  // namespace lumi
