#include "render/modes/photograph_lod.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "calib/work/median.h"
#include "render/modes/pixels_per_unit.h"

namespace lumi {
namespace {

constexpr double kFineEnough = 1.5;

}  // namespace

double photograph_lod(const Lumigraph& lumigraph, const Eye& eye, double samples_across_pixel) {
    const Eigen::Vector3d& centre = lumigraph.mesh.scene_centre_in_world;
    const double of_eye = pixels_per_unit(eye.camera, eye.cam_from_world, centre);
    if (!(of_eye > 0)) return 0.0;
    std::vector<double> of_views;
    for (const LumigraphView& view : lumigraph.views)
        of_views.push_back(pixels_per_unit(view.camera, view.cam_from_world, centre));
    const double minified = samples_across_pixel * median_of(std::move(of_views)) / of_eye;
    return minified > kFineEnough ? std::log2(minified / kFineEnough) : 0.0;
}

}  // namespace lumi
