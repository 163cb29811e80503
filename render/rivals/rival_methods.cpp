#include "render/rivals/rival_methods.h"

#include <algorithm>
#include <cmath>

#include "calib/work/median.h"
#include "render/rivals/forward_warping.h"
#include "render/rivals/spherical_light_field.h"
#include "render/rivals/two_plane.h"
#include "render/rivals/unstructured_lumigraph.h"
#include "render/rivals/view_dependent_texture.h"

namespace lumi {
namespace {

std::string depth_that_lacks(const Lumigraph& lumigraph) {
    const auto without =
        std::count_if(lumigraph.views.begin(), lumigraph.views.end(),
                      [](const LumigraphView& view) { return view.depth.inverse_depth.empty(); });
    if (without == 0) return {};
    return std::to_string(without) + " of " + std::to_string(lumigraph.views.size()) +
           " photographs have no depth, which it draws from";
}

/// All look to one side of it.
bool can_one_plane_stand_before_all(const Lumigraph& lumigraph) {
    Eigen::Vector3d mean_axis = Eigen::Vector3d::Zero();
    for (const LumigraphView& view : lumigraph.views)
        mean_axis += optical_axis_in_world(view.cam_from_world);
    return std::all_of(lumigraph.views.begin(), lumigraph.views.end(), [&](const auto& view) {
        return optical_axis_in_world(view.cam_from_world).dot(mean_axis) > 0;
    });
}

std::string planes_that_lack(const Lumigraph& lumigraph) {
    switch (lumigraph.mesh.construction) {
        case MeshConstruction::kClosed:
        case MeshConstruction::kOpen:
            return {};
        case MeshConstruction::kLine:
        case MeshConstruction::kPair:
        case MeshConstruction::kSingle:
            return "the cameras stand in a line, which spans no surface of eye points";
        case MeshConstruction::kNearest:
            return "no surface lies between the cameras and the scene";
    }
    return {};
}

std::string directions_that_lack(const Lumigraph& lumigraph) {
    if (can_one_plane_stand_before_all(lumigraph))
        return "the cameras do not stand all around the scene, as its directions do";
    return planes_that_lack(lumigraph);
}

/// Of a square picture with as many pixels as the median photograph.
int resampled_size_px(const Lumigraph& source) {
    std::vector<double> sizes;
    for (const LumigraphView& view : source.views)
        sizes.push_back(
            std::sqrt(static_cast<double>(view.camera.width_px) * view.camera.height_px));
    return static_cast<int>(std::lround(median_of(std::move(sizes))));
}

LightFieldLayout two_planes_of(const Lumigraph& source) {
    const bool is_one_slab = can_one_plane_stand_before_all(source);
    const double pictures = static_cast<double>(source.views.size()) / (is_one_slab ? 1 : 6);
    const int side = std::max(2, static_cast<int>(std::lround(std::sqrt(pictures))));
    const TwoPlaneOptions grid{.columns = side, .rows = side, .size_px = resampled_size_px(source)};
    return is_one_slab ? two_plane_slab(source, grid) : two_plane_cube(source, grid);
}

LightFieldLayout directions_of(const Lumigraph& source) {
    return spherical_light_field(source, {.size_px = resampled_size_px(source)});
}

}  // namespace

const std::vector<PlainRival>& plain_rivals() {
    static const std::vector<PlainRival> rivals{
        {"unstructured lumigraph", depth_that_lacks,
         [](const Lumigraph& lumigraph, const Eye& eye) {
             return draw_unstructured_lumigraph(lumigraph, eye);
         }},
        {"view-dependent texture", depth_that_lacks,
         [](const Lumigraph& lumigraph, const Eye& eye) {
             return draw_view_dependent_texture(lumigraph, eye);
         }},
        {"forward warping", depth_that_lacks, [](const Lumigraph& lumigraph, const Eye& eye) {
             return draw_forward_warping(lumigraph, eye);
         }}};
    return rivals;
}

const std::vector<ResampledRival>& resampled_rivals() {
    static const std::vector<ResampledRival> rivals{
        {"two-plane", planes_that_lack, two_planes_of},
        {"spherical", directions_that_lack, directions_of}};
    return rivals;
}

}  // namespace lumi
