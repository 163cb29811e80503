#include "pipeline/synth/synthesize.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"
#include "calib/work/whole_file.h"
#include "pipeline/synth/exact_points.h"
#include "pipeline/synth/hashed_random.h"

namespace lumi {
namespace {

/// Each use of chance has a stream of its own, so that none depends on how much another draws.
enum class Chance : std::uint64_t { kPath, kPoints, kSensor };

std::uint64_t seed_for(const SceneDescription& description, Chance use) {
    return HashedRandom(description.seed, static_cast<std::uint64_t>(use)).word();
}

std::string photograph_name(int index) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "IMG_%04d.png", index + 1);
    return name.data();
}

struct Developed {
    ColorImage photograph;
    FloatImage depth;
};

Developed take(const SceneDescription& description, const Capture& capture, int view_index) {
    const View& view = capture.views[static_cast<std::size_t>(view_index)];
    const Camera& camera = camera_of(capture, view);
    ExactPicture exact =
        photograph(description.scene, camera, view.cam_from_world, description.sampling);
    exact.light = behind_lens(std::move(exact.light), camera, description.sensor.light_falloff);
    const std::uint64_t seed = seed_for(description, Chance::kSensor);
    return {develop(exact.light, description.sensor,
                    mixed(seed ^ static_cast<std::uint64_t>(view_index))),
            std::move(exact.depth)};
}

/// Points take the colour that the first view of their track shows.
void color_points_of(int view_index, const ColorImage& photograph,
                     std::vector<ScenePoint>& points) {
    for (ScenePoint& point : points) {
        const Observation& first = point.track.front();
        if (first.view_index != view_index) continue;
        point.color =
            photograph(static_cast<int>(first.pixel.x()), static_cast<int>(first.pixel.y()));
    }
}

/// Takes every photograph, on several threads, and hands each to `keep` with its view's index.
template <class Keep>
void take_all(const SceneDescription& description, Capture& capture, int threads,
              Progress& progress, const Keep& keep) {
    const int count = static_cast<int>(capture.views.size());
    progress.begin("photographing", static_cast<std::size_t>(count));
    parallel_for(count, threads, [&](int index) {
        progress.throw_if_interrupted();
        Developed developed = take(description, capture, index);
        color_points_of(index, developed.photograph, capture.points);
        keep(index, std::move(developed));
        progress.advance();
    });
}

/// Photographs of another scene would be taken for photographs of this one.
void expect_only(const std::vector<std::string>& names, const std::filesystem::path& folder) {
    if (!std::filesystem::exists(folder)) return;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (std::find(names.begin(), names.end(), name) != names.end()) continue;
        throw Error(ErrorKind::kUsage, "E-SYNTH-FOLDER",
                    entry.path().string() + ": is not a file of this scene",
                    "name an empty folder, or remove what an earlier scene left there");
    }
}

}  // namespace

Capture exact_capture(const SceneDescription& description) {
    Capture capture;
    capture.cameras = {description.camera};
    for (const Rigid3& cam_from_world :
         poses_along(description.path, seed_for(description, Chance::kPath))) {
        const std::string name = photograph_name(static_cast<int>(capture.views.size()));
        if (signed_distance(description.scene, centre_in_world(cam_from_world)) <= 0.0) {
            throw Error(ErrorKind::kUsage, "E-SYNTH-INSIDE",
                        name + ": the camera stands inside a body of the scene",
                        "move the path away from the bodies, or lower its jitter");
        }
        capture.views.push_back({name, 0, cam_from_world});
    }
    capture.points = exact_scene_points(description.scene, capture, description.truth_points,
                                        seed_for(description, Chance::kPoints));
    return capture;
}

SyntheticCapture synthesize(const SceneDescription& description, int threads, Progress& progress) {
    SyntheticCapture result;
    result.capture = exact_capture(description);
    result.photographs.resize(result.capture.views.size());
    result.depths.resize(result.capture.views.size());
    take_all(description, result.capture, threads, progress, [&](int index, Developed developed) {
        result.photographs[static_cast<std::size_t>(index)] = std::move(developed.photograph);
        result.depths[static_cast<std::size_t>(index)] = std::move(developed.depth);
    });
    return result;
}

void synthesize_into(const std::filesystem::path& folder, const SceneDescription& description,
                     int threads, Progress& progress) {
    const std::filesystem::path photos = folder / "photos";
    const std::filesystem::path depths = folder / "truth" / "depth";
    Capture capture = exact_capture(description);
    std::vector<std::string> photo_names;
    std::vector<std::string> depth_names;
    for (const View& view : capture.views) {
        photo_names.push_back(view.name);
        depth_names.push_back(std::filesystem::path(view.name).replace_extension(".tiff").string());
    }
    expect_only(photo_names, photos);
    expect_only(depth_names, depths);
    // It stands there while all photographs do, and they are of this scene.
    const std::filesystem::path scene = folder / "truth" / "scene.toml";
    std::filesystem::remove(scene);
    take_all(description, capture, threads, progress, [&](int index, const Developed& developed) {
        const auto i = static_cast<std::size_t>(index);
        write_png(photos / photo_names[i], developed.photograph);
        write_float_tiff(depths / depth_names[i], developed.depth);
    });
    write_colmap_model_text(capture, folder / "truth" / "sparse");
    write_whole_text(scene, description.resolved_toml);
}

}  // namespace lumi
