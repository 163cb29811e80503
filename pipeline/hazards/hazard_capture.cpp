#include "pipeline/hazards/hazard_capture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "calib/work/parallel_for.h"
#include "pipeline/hazards/hazard_scene.h"
#include "pipeline/synth/hashed_random.h"
#include "pipeline/synth/photographer.h"
#include "pipeline/synth/sensor.h"
#include "pipeline/synth/solid_noise.h"

namespace lumi {
namespace {

/// Every use of chance has a stream of its own.
enum class Chance : std::uint64_t { kSensor = 11, kShake = 12, kClutter = 13 };

/// Rows that are read out together: the picture is put together from strips, each seen from the
/// pose at its own moment.
Image<LinearColor> rolling_shutter_light(const Scene& scene, const Camera& camera,
                                         const Rigid3& cam_from_world, double skew_px,
                                         HashedRandom random) {
    constexpr int kStripRows = 15;
    const double heading = 2.0 * std::numbers::pi * random.uniform();
    const Eigen::Vector3d axis(std::cos(heading), std::sin(heading), 0.0);
    const double turn_rad = skew_px / focal_length_px(camera).x();
    Image<LinearColor> light(camera.width_px, camera.height_px, LinearColor::Zero());
    for (int top = 0; top < camera.height_px; top += kStripRows) {
        const int rows = std::min(kStripRows, camera.height_px - top);
        Camera strip = camera;
        strip.height_px = rows;
        strip.parameters[3] -= top;
        const double time = (top + 0.5 * rows) / camera.height_px - 0.5;
        const Rigid3 shaken{
            Eigen::Quaterniond(Eigen::AngleAxisd(turn_rad * time, axis)) * cam_from_world.rotation,
            Eigen::AngleAxisd(turn_rad * time, axis) * cam_from_world.translation};
        const ExactPicture picture = photograph(scene, strip, shaken, {});
        for (int row = 0; row < rows; ++row) {
            std::copy_n(picture.light.row(row), camera.width_px, light.row(top + row));
        }
    }
    return light;
}

/// The same round stickers in every photograph, each time at other places: features that look alike
/// but belong to nothing that stands still.
void cover_with_stickers(ColorImage& picture, double share, std::uint64_t seed,
                         HashedRandom random) {
    constexpr int kRadius = 16;
    constexpr std::size_t kKinds = 40;
    Image<std::uint8_t> is_covered(picture.width(), picture.height(), 0);
    const auto wanted = static_cast<std::ptrdiff_t>(
        share * static_cast<double>(picture.width() * picture.height()));
    std::ptrdiff_t covered = 0;
    while (covered < wanted) {
        const int left = static_cast<int>(random.below(static_cast<std::size_t>(picture.width())));
        const int top = static_cast<int>(random.below(static_cast<std::size_t>(picture.height())));
        const auto kind = static_cast<std::uint32_t>(random.below(kKinds));
        for (int dy = -kRadius; dy <= kRadius; ++dy) {
            for (int dx = -kRadius; dx <= kRadius; ++dx) {
                if (dx * dx + dy * dy > kRadius * kRadius) continue;
                const int x = left + dx;
                const int y = top + dy;
                if (!picture.contains(x, y)) continue;
                const auto shade = [&](std::uint32_t channel) {
                    const double value =
                        fractal_noise(Eigen::Vector3d(dx, dy, 0.5), 1.0, {0.08, 3, 0.6},
                                      static_cast<std::uint32_t>(seed) + 97 * kind + channel);
                    return static_cast<std::uint8_t>(std::clamp(128.0 + 160.0 * value, 0.0, 255.0));
                };
                picture(x, y) = {shade(0), shade(0), shade(1)};
                if (is_covered(x, y) == 0) ++covered;
                is_covered(x, y) = 1;
            }
        }
    }
}

Image<LinearColor> light_of(const HazardScene& scene, std::size_t index, Hazard hazard,
                            double strength, std::uint64_t seed) {
    const Camera& camera = scene.cameras[index];
    const Rigid3& pose = scene.cam_from_world[index];
    if (hazard == Hazard::kShutter && strength > 0) {
        const HashedRandom random(seed ^ mixed(index), static_cast<std::uint64_t>(Chance::kShake));
        return rolling_shutter_light(scene.scene, camera, pose, strength, random);
    }
    Image<LinearColor> light = photograph(scene.scene, camera, pose, {}).light;
    if (hazard == Hazard::kTexture) fade_to_grey(light, strength);
    return light;
}

SensorOptions sensor_of(Hazard hazard, double strength) {
    SensorOptions sensor;
    sensor.noise_sigma = hazard == Hazard::kNoise ? strength : 1.0;
    if (hazard == Hazard::kBlur) sensor.blur_sigma_px = strength;
    if (hazard == Hazard::kExposure) sensor.exposure_drift_stops = strength;
    return sensor;
}

std::string photograph_name(std::size_t index) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "IMG_%04zu.png", index + 1);
    return name.data();
}

}  // namespace

HazardCapture photograph_hazard(Hazard hazard, double strength, std::uint64_t seed, int threads,
                                Progress& progress) {
    const HazardScene scene = hazard_scene(hazard, strength, seed);
    HazardCapture capture;
    capture.photos.resize(scene.cameras.size());
    if (hazard == Hazard::kFocalPrior) {
        capture.told_focal_length_px = strength * focal_length_px(scene.cameras.front()).x();
    }
    progress.begin("photographing " + curve_of(hazard).name, capture.photos.size());
    parallel_for(static_cast<int>(capture.photos.size()), threads, [&](int position) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(position);
        const std::uint64_t own_seed = mixed(seed) ^ mixed(index + 1);
        HazardCapture::Photo& photo = capture.photos[index];
        photo.name = photograph_name(index);
        photo.camera = scene.cameras[index];
        photo.cam_from_world = scene.cam_from_world[index];
        photo.picture =
            develop(light_of(scene, index, hazard, strength, seed), sensor_of(hazard, strength),
                    HashedRandom(own_seed, static_cast<std::uint64_t>(Chance::kSensor)).word());
        if (hazard == Hazard::kClutter) {
            cover_with_stickers(
                photo.picture, strength, seed,
                HashedRandom(own_seed, static_cast<std::uint64_t>(Chance::kClutter)));
        }
        progress.advance();
    });
    return capture;
}

}  // namespace lumi
