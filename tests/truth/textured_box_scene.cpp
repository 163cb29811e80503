#include "tests/truth/textured_box_scene.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <string>
#include <vector>

#include "calib/work/progress.h"

namespace lumi {
namespace {

constexpr int kGridSize = 3;

constexpr const char* kScene = R"(
seed = 3

[path]
kind = "grid"
count = 9
rows = 3
target = [0, 0, 0.45]
distance = 3.2
elevation_deg = 20
length_share = 0.5

[light]
towards_lamp = [-0.6, -0.8, 1.0]

[[material]]
name = "floor"
pattern = "stone"
colors = ["#a08a66", "#6d7f8a", "#3f3a35"]
feature_size = 0.6
detail_contrast = 0.5
detail_size = 0.3

[[material]]
name = "wall"
pattern = "bricks"
colors = ["#a8664a", "#7f4a3c", "#cdc4b2"]
feature_size = 0.8
detail_contrast = 0.4
detail_size = 0.35

[[material]]
name = "box"
pattern = "marble"
colors = ["#5d7d9c", "#e4e0d2", "#2f4660"]
feature_size = 0.6
detail_contrast = 0.4
detail_size = 0.25

[[body]]
name = "floor"
material = "floor"
casts_shadow = false
solids = [{ shape = "box", at = [0, 0, -0.1], size = [30, 30, 0.2] }]

[[body]]
name = "wall"
material = "wall"
casts_shadow = false
solids = [{ shape = "box", at = [0, 1.6, 5], size = [30, 0.4, 12] }]

[[body]]
name = "box"
material = "box"
solids = [{ shape = "box", at = [0.05, 0, 0.45], size = [0.9, 0.7, 0.9], turn_deg = [0, 0, 25] }]
)";

std::string camera_section(const TexturedBoxOptions& options) {
    return "[camera]\nwidth_px = " + std::to_string(options.width_px) +
           "\nheight_px = " + std::to_string(options.height_px) +
           "\nfocal_length_px = " + std::to_string(options.width_px) +
           "\n[truth]\npoints = " + std::to_string(options.points) + "\n";
}

/// The depth below which lies `share` of all seen depths.
double depth_quantile(const std::vector<FloatImage>& depths, double share) {
    std::vector<float> seen;
    for (const FloatImage& depth : depths) {
        std::copy_if(depth.pixels().begin(), depth.pixels().end(), std::back_inserter(seen),
                     [](float z) { return z > 0.0f; });
    }
    assert(!seen.empty());
    const auto nth =
        seen.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(seen.size() - 1));
    std::nth_element(seen.begin(), nth, seen.end());
    return static_cast<double>(*nth);
}

}  // namespace

SceneDescription textured_box_description(const TexturedBoxOptions& options) {
    return read_scene_description(
        ConfigSection::from_text(kScene + camera_section(options), "textured box"));
}

SyntheticCapture textured_box_scene(const TexturedBoxOptions& options) {
    SilentProgress progress;
    return synthesize(textured_box_description(options), 0, progress);
}

int textured_box_view(int column, int row) {
    assert(column >= 0 && column < kGridSize && row >= 0 && row < kGridSize);
    return row * kGridSize + (row % 2 == 0 ? column : kGridSize - 1 - column);
}

CameraMesh textured_box_camera_mesh(const Capture& capture) {
    CameraMesh mesh;
    mesh.construction = MeshConstruction::kOpen;
    mesh.scene_centre_in_world = {0.0, 0.0, 0.45};
    for (std::size_t i = 0; i < capture.views.size(); ++i) {
        mesh.vertices.push_back(
            {centre_in_world(capture.views[i].cam_from_world), static_cast<int>(i)});
    }
    for (int row = 0; row + 1 < kGridSize; ++row) {
        for (int column = 0; column + 1 < kGridSize; ++column) {
            const int left_low = textured_box_view(column, row);
            const int right_low = textured_box_view(column + 1, row);
            const int left_high = textured_box_view(column, row + 1);
            const int right_high = textured_box_view(column + 1, row + 1);
            // From behind the cameras, right is right and up is up: counter-clockwise.
            mesh.faces.push_back({left_low, right_low, right_high});
            mesh.faces.push_back({left_low, right_high, left_high});
        }
    }
    return mesh;
}

DepthMap exact_depth_map(const FloatImage& depth) {
    DepthMap map{FloatImage(depth.width(), depth.height()),
                 GrayImage(depth.width(), depth.height(), 255)};
    std::transform(depth.pixels().begin(), depth.pixels().end(), map.inverse_depth.pixels().begin(),
                   [](float z) { return z > 0.0f ? 1.0f / z : 0.0f; });
    return map;
}

Lumigraph exact_lumigraph(const SyntheticCapture& scene, CameraMesh mesh) {
    Lumigraph lumigraph;
    lumigraph.name = "exact";
    lumigraph.mesh = std::move(mesh);
    for (std::size_t i = 0; i < scene.capture.views.size(); ++i) {
        const View& view = scene.capture.views[i];
        const Camera& camera = camera_of(scene.capture, view);
        assert(camera.model == LensModel::kPinhole);
        lumigraph.views.push_back({view.name, camera, view.cam_from_world, 1, scene.photographs[i],
                                   exact_depth_map(scene.depths[i])});
    }
    lumigraph.near_depth = depth_quantile(scene.depths, 0.01);
    lumigraph.far_depth = depth_quantile(scene.depths, 0.99);
    return lumigraph;
}

}  // namespace lumi
