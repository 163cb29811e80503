#include "meshing/depth_scene/depth_scene.h"

#include <algorithm>
#include <cmath>

#include "calib/capture/inverse_depth_warp.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/median.h"
#include "calib/work/parallel_for.h"
#include "meshing/depth_scene/depth_range.h"
#include "meshing/depth_scene/neighbour_selection.h"
#include "meshing/warp/disparity.h"

namespace lumi {
namespace {

ColorImage read_photograph(const PosedPhotographs& photographs, std::size_t view_index,
                           const Camera& at_size) {
    const std::filesystem::path& path = photographs.picture_paths[view_index];
    const Capture& capture = photographs.capture;
    const Camera& camera = camera_of(capture, capture.views[view_index]);
    ColorImage photograph = read_color_image(path);
    if (photograph.width() != camera.width_px || photograph.height() != camera.height_px) {
        throw Error(ErrorKind::kBadInput, "E-DEPTH-PICTURE",
                    path.string() + ": expected " + std::to_string(camera.width_px) + "x" +
                        std::to_string(camera.height_px) + " like its camera, found " +
                        std::to_string(photograph.width()) + "x" +
                        std::to_string(photograph.height()),
                    "run the poses stage again, or import poses that belong to these pictures");
    }
    if (at_size.width_px == photograph.width()) return photograph;
    return resized(photograph, at_size.width_px, at_size.height_px);
}

/// The points that two listed views saw, with tracks in terms of `scene.views`.
void take_points(const Capture& capture, const std::vector<int>& view_indices, DepthScene& scene) {
    std::vector<int> listed(capture.views.size(), -1);
    for (std::size_t i = 0; i < view_indices.size(); ++i) {
        listed[static_cast<std::size_t>(view_indices[i])] = static_cast<int>(i);
    }
    for (const ScenePoint& point : capture.points) {
        ScenePoint kept = point;
        kept.track.clear();
        for (const Observation& observation : point.track) {
            const int i = listed[static_cast<std::size_t>(observation.view_index)];
            if (i >= 0) kept.track.push_back({i, observation.pixel});
        }
        if (kept.track.size() >= 2) scene.points.push_back(std::move(kept));
    }
}

/// Where each view sees its points: projected anew, so that pixel and inverse depth belong
/// together. An observation that ends up outside the picture is no longer one; its point stays,
/// since the views that saw it know its place all the same.
void place_points_in_views(DepthScene& scene) {
    for (ScenePoint& point : scene.points) {
        std::erase_if(point.track, [&](Observation& observation) {
            DepthView& view = scene.views[static_cast<std::size_t>(observation.view_index)];
            const Eigen::Vector3d in_cam = view.cam_from_world * point.position_in_world;
            const auto pixel = project(view.camera, in_cam);
            if (!pixel || !is_inside(view.camera, *pixel)) return true;
            observation.pixel = *pixel;
            view.points.push_back({*pixel, 1.0 / in_cam.z()});
            return false;
        });
    }
}

double fastest_disparity(const DepthScene& scene, const DepthView& view) {
    double fastest = 0.0;
    for (const int j : view.neighbours) {
        fastest = std::max(fastest, disparity_px_per_inverse_depth(
                                        view, scene.views[static_cast<std::size_t>(j)]));
    }
    return fastest;
}

}  // namespace

double disparity_px_per_inverse_depth(const DepthView& view, const DepthView& other) {
    constexpr int kSide = 7;
    const InverseDepthWarp warp = warp_from(view).to(other);
    std::vector<double> disparities;
    for (int i = 0; i < kSide * kSide; ++i) {
        const Eigen::Vector2d pixel((i % kSide + 0.5) * view.camera.width_px / kSide,
                                    (i / kSide + 0.5) * view.camera.height_px / kSide);
        const double middle = 0.5 * (view.range.far + view.range.near);
        disparities.push_back(disparity_per_inverse_depth(
            warp, pixel, comparable_inverse_depth(warp, pixel, middle)));
    }
    return median_of(std::move(disparities));
}

Camera at_depth_map_size(const Camera& camera, int max_width_px) {
    if (camera.width_px <= max_width_px) return camera;
    const double scale = static_cast<double>(max_width_px) / camera.width_px;
    const int height_px = std::max(1, static_cast<int>(std::lround(camera.height_px * scale)));
    return resized(camera, max_width_px, height_px);
}

DepthScene make_depth_scene(const PosedPhotographs& photographs,
                            const std::vector<int>& view_indices, const DepthSceneOptions& options,
                            int threads, Progress& progress) {
    const Capture& capture = photographs.capture;
    DepthScene scene;
    scene.views.resize(view_indices.size());
    progress.begin("depth: pictures", view_indices.size());
    parallel_for(static_cast<int>(view_indices.size()), threads, [&](int i) {
        progress.throw_if_interrupted();
        const auto view_index = static_cast<std::size_t>(view_indices[static_cast<std::size_t>(i)]);
        const View& source = capture.views[view_index];
        DepthView& view = scene.views[static_cast<std::size_t>(i)];
        view.name = source.name;
        view.camera = at_depth_map_size(camera_of(capture, source), options.max_width_px);
        view.cam_from_world = source.cam_from_world;
        view.photograph = read_photograph(photographs, view_index, view.camera);
        progress.advance();
    });
    take_points(capture, view_indices, scene);
    place_points_in_views(scene);
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
        scene.views[i].range =
            inverse_depth_range(scene, static_cast<int>(i)).value_or(InverseDepthRange{});
    }
    auto neighbours = select_neighbours(scene, options.max_neighbours);
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
        scene.views[i].neighbours = std::move(neighbours[i]);
        scene.views[i].disparity_px_per_inverse_depth = fastest_disparity(scene, scene.views[i]);
    }
    return scene;
}

}  // namespace lumi
