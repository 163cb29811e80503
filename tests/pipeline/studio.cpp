#include "tests/pipeline/studio.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "pipeline/stages/chosen_views.h"
#include "pipeline/synth/exact_points.h"
#include "pipeline/synth/hand_held_path.h"
#include "pipeline/synth/photographer.h"
#include "pipeline/synth/sensor.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {

namespace {

/// Of every scene; the path is not walked, photographs are taken one by one.
constexpr const char* kCameraAndPath = R"(
[camera]
width_px = 72
height_px = 72
focal_length_px = 90
[path]
kind = "ring"
count = 4
distance = 2.6
)";

SceneDescription described(const char* scene) {
    return read_scene_description(
        ConfigSection::from_text(std::string(kCameraAndPath) + scene, "the studio"));
}

}  // namespace

const char* const kBodiesInTheWay = R"(
[[material]]
name = "stone"
pattern = "stone"
colors = ["#b05a3c", "#e8d8a0", "#304860"]
feature_size = 0.12
detail_size = 0.05
[[material]]
name = "marble"
pattern = "marble"
colors = ["#5f7f6c", "#d9dfc9", "#2e4a40"]
feature_size = 0.2
gloss = 0.2
[[body]]
name = "middle"
material = "stone"
solids = [{ shape = "ellipsoid", at = [0, 0, 0], radii = [0.35, 0.3, 0.4] }]
[[body]]
name = "bars"
material = "marble"
solids = [
    { shape = "box", at = [0.45, 0.1, 0.1], size = [0.12, 0.5, 0.12] },
    { shape = "box", at = [-0.45, -0.1, 0.2], size = [0.12, 0.12, 0.6] },
    { shape = "box", at = [0.1, 0.48, -0.1], size = [0.5, 0.12, 0.12] },
    { shape = "box", at = [-0.1, -0.48, 0.0], size = [0.3, 0.12, 0.4] },
    { shape = "box", at = [0.0, 0.1, 0.5], size = [0.5, 0.2, 0.08] },
    { shape = "box", at = [0.1, 0.0, -0.5], size = [0.2, 0.5, 0.08] },
]
)";

const char* const kThinThings = R"(
[[material]]
name = "stone"
pattern = "stone"
colors = ["#3c70b0", "#f0e0c0", "#602020"]
feature_size = 0.1
detail_size = 0.04
[[body]]
name = "posts"
material = "stone"
solids = [
    { shape = "box", at = [0.5, 0.3, 0.0], size = [0.1, 0.1, 0.9] },
    { shape = "box", at = [-0.4, 0.4, 0.1], size = [0.1, 0.1, 0.7] },
    { shape = "box", at = [-0.3, -0.5, -0.1], size = [0.1, 0.1, 0.8] },
    { shape = "box", at = [0.4, -0.4, 0.0], size = [0.12, 0.3, 0.12] },
    { shape = "ellipsoid", at = [0, 0, 0.45], radii = [0.2, 0.25, 0.12] },
    { shape = "ellipsoid", at = [0.05, 0.1, -0.45], radii = [0.3, 0.15, 0.1] },
]
)";

const char* const kFlatBoard = R"(
[[material]]
name = "stone"
pattern = "stone"
colors = ["#b05a3c", "#e8d8a0", "#304860"]
feature_size = 0.12
detail_size = 0.05
[[body]]
name = "board"
material = "stone"
solids = [{ shape = "box", at = [0, 0, -0.1], size = [6, 6, 0.2] }]
)";

std::vector<Eigen::Vector3d> spiral(int count, double turn) {
    const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
    std::vector<Eigen::Vector3d> directions;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - 2 * (i + 0.5) / count;
        const double radius = std::sqrt(1 - z * z);
        const double azimuth = golden_angle * i + turn;
        directions.emplace_back(radius * std::cos(azimuth), radius * std::sin(azimuth), z);
    }
    return directions;
}

Studio::Studio(const char* scene) : description_(described(scene)) {}

void Studio::photograph_from(const Rigid3& cam_from_world) {
    const ExactPicture picture = lumi::photograph(description_.scene, description_.camera,
                                                  cam_from_world, description_.sampling);
    const std::string name = "view" + std::to_string(1000 + lumigraph.views.size());
    lumigraph.views.push_back({name, description_.camera, cam_from_world, 1,
                               develop(picture.light, description_.sensor, 1),
                               exact_depth_map(picture.depth)});
    if (capture.cameras.empty()) capture.cameras.push_back(description_.camera);
    capture.views.push_back({name, 0, cam_from_world});
}

void Studio::find_points() {
    capture.points = exact_scene_points(description_.scene, capture, 300, 1);
    lumigraph.near_depth = kStudioDistance - 0.7;
    lumigraph.far_depth = kStudioDistance + 0.7;
}

Studio from_all_around(const char* scene, int count) {
    Studio studio(scene);
    for (const Eigen::Vector3d& direction : spiral(count, 0.0))
        studio.photograph_from(looking_at(kStudioDistance * direction, Eigen::Vector3d::Zero()));
    return studio;
}

Lumigraph with_camera_mesh(const Studio& studio) {
    std::vector<int> all(studio.lumigraph.views.size());
    std::iota(all.begin(), all.end(), 0);
    return lumigraph_of_views(studio.lumigraph, studio.capture, all, {});
}

Studio before_a_board(int count, double radius) {
    Studio studio(kFlatBoard);
    const double golden_angle = 2.4;
    for (int i = 0; i < count; ++i) {
        const double from_middle = radius * std::sqrt((i + 0.5) / count);
        const Eigen::Vector3d place(from_middle * std::cos(golden_angle * i),
                                    from_middle * std::sin(golden_angle * i), kStudioDistance);
        studio.photograph_from(looking_at(place, Eigen::Vector3d(place.x(), place.y(), 0)));
    }
    return studio;
}

}  // namespace lumi
