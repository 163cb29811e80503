#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/capture/image.h"
#include "calib/capture/posed_photographs.h"
#include "calib/capture/rigid3.h"
#include "calib/work/progress.h"
#include "meshing/surface/inverse_depth_range.h"

namespace lumi {

/// A triangulated scene point as one view sees it.
struct SparsePoint {
    Eigen::Vector2d pixel;  ///< In the raster of the depth map.
    double inverse_depth = 0.0;
};

/// One listed view at the size of its depth map.
struct DepthView {
    std::string name;
    Camera camera;
    Rigid3 cam_from_world;
    ColorImage photograph;
    std::vector<SparsePoint> points;  ///< Of its own tracks.
    std::vector<int> neighbours;      ///< Into DepthScene::views, best first.
    InverseDepthRange range;          ///< In which its scene lies.
    /// How far the fastest-moving neighbour sees a pixel move, per unit of inverse depth (median
    /// over the picture): what turns inverse depth into pixels. 0 without neighbours.
    double disparity_px_per_inverse_depth = 0.0;
};

/// What depth is found from: the listed views, and nothing of the others.
///
/// Pictures are held at the size of the depth maps, so that the scene never takes more memory than
/// the depth maps that come of it.
struct DepthScene {
    std::vector<DepthView> views;
    /// Scene points that at least two listed views saw. A point that rests on a held-out view is
    /// dropped: with one listed observation left, its place is the held-out view's knowledge.
    std::vector<ScenePoint> points;  ///< Tracks index `views`; pixels in the rasters of the maps,
                                     ///< without those that a straight picture has lost.
};

/// The camera of a depth map that is at most `max_width_px` wide.
[[nodiscard]] Camera at_depth_map_size(const Camera& camera, int max_width_px);

/// How much of the photographs a scene holds.
struct DepthSceneOptions {
    int max_width_px = 800;  ///< Depth maps are at most this wide.
    int max_neighbours = 4;  ///< Views that one view is compared with.
};

/// Loads the pictures of `view_indices` and chooses ranges and neighbours.
/// Throws Error (E-DEPTH-PICTURE) when a picture has not the size of its camera.
[[nodiscard]] DepthScene make_depth_scene(const PosedPhotographs& photographs,
                                          const std::vector<int>& view_indices,
                                          const DepthSceneOptions& options, int threads,
                                          Progress& progress);

/// How far `other` sees a pixel of `view` move, per unit of inverse depth (median over the
/// picture).
[[nodiscard]] double disparity_px_per_inverse_depth(const DepthView& view, const DepthView& other);

}  // namespace lumi
