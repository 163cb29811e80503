#include "render/uploaded/photograph_lod.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/depth_search/occlusion.h"
#include "render/transfer/pixels_per_unit.h"

namespace lumi {
namespace {

/// A level is looked up alone where so many of its texels fall on a pixel: fewer would be blurred,
/// and of more some would be left out between two lookups.
constexpr double kFewestAlone = 1.5;
constexpr double kMostAlone = 2.0;

/// Between these the next level takes over.
double level_for(double texels_per_pixel) {
    const double finer = std::floor(std::log2(texels_per_pixel / kFewestAlone));
    const double beyond_alone = texels_per_pixel / std::exp2(finer) / kMostAlone;
    const double share_of_coarser =
        std::max(0.0, std::log(beyond_alone) / std::log(2 * kFewestAlone / kMostAlone));
    return std::max(0.0, finer + share_of_coarser);
}

/// Squared, of directions from the scene's centre: views this near to the eye count alike, and
/// neighbours of a view, which lie ten times as far apart, hardly count where the eye is at it.
constexpr double kNear = 1e-4;

/// The mean of logarithms over the views, in which those count most that see the scene from the
/// eye's direction; minus infinity where all stand in it.
double log2_pixels_per_unit(const Lumigraph& lumigraph, const Eigen::Vector3d& eye_in_world) {
    const Eigen::Vector3d& centre = lumigraph.mesh.scene_centre_in_world;
    const Eigen::Vector3d to_eye = (eye_in_world - centre).normalized();
    double sum = 0;
    double weights = 0;
    for (const LumigraphView& view : lumigraph.views) {
        const double of_view = pixels_per_unit(view.camera, view.cam_from_world, centre);
        if (!(of_view > 0)) continue;
        const Eigen::Vector3d to_view =
            (centre_in_world(view.cam_from_world) - centre).normalized();
        const double weight = 1 / ((to_view - to_eye).squaredNorm() + kNear);
        sum += weight * std::log2(of_view);
        weights += weight;
    }
    return weights > 0 ? sum / weights : -std::numeric_limits<double>::infinity();
}

}  // namespace

double photograph_lod(const Lumigraph& lumigraph, const Eye& eye, double samples_across_pixel) {
    const Eigen::Vector3d& centre = lumigraph.mesh.scene_centre_in_world;
    const double of_eye = pixels_per_unit(eye.camera, eye.cam_from_world, centre);
    if (!(of_eye > 0)) return 0.0;
    const double of_views =
        std::exp2(log2_pixels_per_unit(lumigraph, centre_in_world(eye.cam_from_world)));
    return of_views > 0 ? level_for(samples_across_pixel * of_views / of_eye) : 0.0;
}

double unsure_border_px(double lod) {
    // Halves are rounded down, which makes texels less than twice as wide.
    return lod > 0 ? 2 * std::exp2(std::ceil(lod)) : kFinestBorder_px;
}

}  // namespace lumi
