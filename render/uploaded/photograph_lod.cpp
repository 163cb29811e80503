#include "render/uploaded/photograph_lod.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "calib/work/median.h"
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

}  // namespace

double photograph_lod(const Lumigraph& lumigraph, const Eye& eye, double samples_across_pixel) {
    const Eigen::Vector3d& centre = lumigraph.mesh.scene_centre_in_world;
    const double of_eye = pixels_per_unit(eye.camera, eye.cam_from_world, centre);
    if (!(of_eye > 0)) return 0.0;
    std::vector<double> of_views;
    for (const LumigraphView& view : lumigraph.views)
        of_views.push_back(pixels_per_unit(view.camera, view.cam_from_world, centre));
    return level_for(samples_across_pixel * median_of(std::move(of_views)) / of_eye);
}

}  // namespace lumi
