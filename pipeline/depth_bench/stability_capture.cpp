#include "pipeline/depth_bench/stability_capture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "calib/pictures/image_io.h"
#include "calib/work/parallel_for.h"
#include "pipeline/depth_bench/stability_scene.h"
#include "pipeline/synth/exact_points.h"
#include "pipeline/synth/hashed_random.h"
#include "pipeline/synth/photographer.h"
#include "pipeline/synth/sensor.h"

namespace lumi {
namespace {

/// Every use of chance has a stream of its own.
enum class Chance : std::uint64_t { kPoints = 21, kSensor = 22, kPose = 23 };

std::uint64_t seed_for(std::uint64_t seed, Chance use, std::size_t view) {
    return HashedRandom(mixed(seed) ^ mixed(view + 1), static_cast<std::uint64_t>(use)).word();
}

SensorOptions sensor_of(DepthHazard hazard, double strength) {
    SensorOptions sensor;
    sensor.noise_sigma = hazard == DepthHazard::kNoise ? strength : 1.0;
    if (hazard == DepthHazard::kExposure) sensor.exposure_drift_stops = strength;
    return sensor;
}

Eigen::Vector3d gaussian_vector(HashedRandom& random) {
    const double x = random.gaussian();
    const double y = random.gaussian();
    return {x, y, random.gaussian()};
}

/// Turned and moved by what shifts the picture of the wall by `sigma_px`.
Rigid3 shifted(const Rigid3& cam_from_world, double sigma_px, double focal_length_px,
               std::uint64_t seed) {
    HashedRandom random(seed);
    const Eigen::Vector3d turn_rad = sigma_px / focal_length_px * gaussian_vector(random);
    const Eigen::Vector3d way =
        sigma_px * kWallDistance / focal_length_px * gaussian_vector(random);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(
        turn_rad.norm(), turn_rad.norm() > 0 ? turn_rad.normalized() : Eigen::Vector3d::UnitX()));
    return {turn * cam_from_world.rotation, turn * cam_from_world.translation + way};
}

/// What depth is told of the cameras.
Capture told_of(const Capture& exact, DepthHazard hazard, double strength, std::uint64_t seed) {
    Capture told = exact;
    if (hazard == DepthHazard::kFocalLength) {
        const Camera& camera = exact.cameras.front();
        told.cameras.front() = pinhole_camera(camera.width_px, camera.height_px,
                                              (1 + strength / 100) * focal_length_px(camera).x());
    }
    if (hazard == DepthHazard::kPoses) {
        for (std::size_t i = 0; i < told.views.size(); ++i) {
            told.views[i].cam_from_world = shifted(exact.views[i].cam_from_world, strength,
                                                   focal_length_px(exact.cameras.front()).x(),
                                                   seed_for(seed, Chance::kPose, i));
        }
    }
    return told;
}

DepthMap truth_of(const FloatImage& depth) {
    DepthMap truth{FloatImage(depth.width(), depth.height()),
                   GrayImage(depth.width(), depth.height(), kKnown)};
    for (std::size_t i = 0; i < depth.pixels().size(); ++i) {
        const float z = depth.pixels()[i];
        truth.inverse_depth.pixels()[i] = z > 0 ? 1.0F / z : 0.0F;
        if (!(z > 0)) truth.confidence.pixels()[i] = kUnseen;
    }
    return truth;
}

/// True when the depth changes by leaps within a few pixels.
bool is_by_an_edge(const FloatImage& inverse_depth, int x, int y) {
    constexpr int kReachPx = 4;
    constexpr float kLeap = 0.004F;  // Of inverse depth; steps are higher, the wall's slope is not.
    for (int dy = -kReachPx; dy <= kReachPx; ++dy) {
        for (int dx = -kReachPx; dx <= kReachPx; ++dx) {
            if (!inverse_depth.contains(x + dx, y + dy)) continue;
            if (std::abs(inverse_depth(x + dx, y + dy) - inverse_depth(x, y)) > kLeap) return true;
        }
    }
    return false;
}

/// Where bars or edges are what is asked, the rest is not.
void ask_only(DepthHazard hazard, DepthMap& truth) {
    constexpr float kBarsAreNearerThan = 1.0F / (0.8F * static_cast<float>(kWallDistance));
    for (int y = 0; y < truth.confidence.height(); ++y) {
        for (int x = 0; x < truth.confidence.width(); ++x) {
            const bool is_asked =
                hazard == DepthHazard::kThin    ? truth.inverse_depth(x, y) > kBarsAreNearerThan
                : hazard == DepthHazard::kSteps ? is_by_an_edge(truth.inverse_depth, x, y)
                                                : true;
            if (!is_asked) truth.confidence(x, y) = 0;
        }
    }
}

}  // namespace

StabilityCapture stability_capture(DepthHazard hazard, double strength, std::uint64_t seed,
                                   const std::filesystem::path& folder, int threads,
                                   Progress& progress) {
    const Scene scene = stability_scene(hazard, strength, seed);
    Capture exact = stability_cameras(hazard, strength);
    constexpr int kPoints = 400;
    exact.points = exact_scene_points(scene, exact, kPoints, seed_for(seed, Chance::kPoints, 0));
    StabilityCapture capture{{told_of(exact, hazard, strength, seed), {}}, {exact, {}}, {}};
    capture.truth.resize(exact.views.size());
    for (const View& view : exact.views) {
        capture.told.picture_paths.push_back(folder / "told" / view.name);
        capture.harmless.picture_paths.push_back(folder / "harmless" / view.name);
    }
    std::filesystem::create_directories(folder / "told");
    std::filesystem::create_directories(folder / "harmless");
    progress.begin("photographing " + curve_of(hazard).name, exact.views.size());
    parallel_for(static_cast<int>(exact.views.size()), threads, [&](int i) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(i);
        ExactPicture picture = photograph(scene, exact.cameras.front(),
                                          exact.views[index].cam_from_world, SamplingOptions{});
        write_png(capture.harmless.picture_paths[index],
                  develop(picture.light, SensorOptions{}, 0));
        if (hazard == DepthHazard::kTexture) fade_to_grey(picture.light, strength);
        write_png(capture.told.picture_paths[index],
                  develop(picture.light, sensor_of(hazard, strength),
                          seed_for(seed, Chance::kSensor, index)));
        capture.truth[index] = truth_of(picture.depth);
        ask_only(hazard, capture.truth[index]);
        progress.advance();
    });
    return capture;
}

}  // namespace lumi
