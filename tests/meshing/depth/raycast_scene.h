#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// A part of a plane with a grey texture, all in world coordinates.
struct TexturedPlane {
    Eigen::Vector3d point;
    Eigen::Vector3d normal;
    std::function<bool(const Eigen::Vector3d&)> covers = [](const Eigen::Vector3d&) {
        return true;
    };
    std::function<double(const Eigen::Vector3d&)> gray;
};

/// Smooth noise in space, 40 to 215, whose finest detail is `detail` world units wide.
[[nodiscard]] std::function<double(const Eigen::Vector3d&)> noise_texture(double detail,
                                                                          unsigned seed);

/// Photograph and exact inverse depth (0 where no plane is hit) of the planes, with four samples a
/// pixel for the photograph.
struct Raycast {
    ColorImage photograph;
    FloatImage inverse_depth;
};
[[nodiscard]] Raycast raycast(const std::vector<TexturedPlane>& planes, const Camera& camera,
                              const Rigid3& cam_from_world);

/// Cameras 240 x 180 pixels large that look along +z from the given centres.
[[nodiscard]] Camera small_camera();
[[nodiscard]] Rigid3 looking_ahead_from(const Eigen::Vector3d& centre);
/// Centre first, then left, right, up, down at this distance.
[[nodiscard]] std::vector<Eigen::Vector3d> cross_of_centres(double baseline);

/// A depth scene whose first view has all others as neighbours, and the truth.
struct KnownDepthScene {
    DepthScene scene;
    std::vector<FloatImage> inverse_depths;
};
[[nodiscard]] KnownDepthScene known_depth_scene(const std::vector<TexturedPlane>& planes,
                                                const std::vector<Eigen::Vector3d>& centres,
                                                const InverseDepthRange& range);

/// The same photographs as files below `folder`, without scene points.
[[nodiscard]] PosedPhotographs written(const KnownDepthScene& known,
                                       const std::filesystem::path& folder);

/// Pixels of disparity by which the map is wrong.
[[nodiscard]] FloatImage errors_px(const DepthMap& map, const FloatImage& truth,
                                   const DepthView& view);

}  // namespace lumi
