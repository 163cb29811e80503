#include "render/rivals/rival_methods.h"

#include <algorithm>
#include <cmath>

#include "calib/work/median.h"
#include "render/rivals/dynamically_reparameterized.h"
#include "render/rivals/forward_warping.h"
#include "render/rivals/spherical_light_field.h"
#include "render/rivals/two_plane.h"
#include "render/rivals/unstructured_lumigraph.h"
#include "render/rivals/view_dependent_texture.h"

namespace lumi {
namespace {

std::string nothing_that_lacks(const Lumigraph&) { return {}; }

std::string depth_that_lacks(const Lumigraph& lumigraph) {
    const auto without =
        std::count_if(lumigraph.views.begin(), lumigraph.views.end(),
                      [](const LumigraphView& view) { return view.depth.inverse_depth.empty(); });
    if (without == 0) return {};
    return std::to_string(without) + " of " + std::to_string(lumigraph.views.size()) +
           " photographs have no depth, which it draws from";
}

/// Cosine of 60 degrees: the plane across the mean axis is then seen at no less than 30.
constexpr double kLeastCosine = 0.5;

/// No axis is far from the mean of all. That all look to one side of a plane would not be enough:
/// cameras all around that look down a little have their mean straight down, to one side of which
/// all look, and the plane across it is the one that they stand in.
bool can_one_plane_stand_before_all(const Lumigraph& lumigraph) {
    Eigen::Vector3d mean_axis = Eigen::Vector3d::Zero();
    for (const LumigraphView& view : lumigraph.views)
        mean_axis += optical_axis_in_world(view.cam_from_world);
    return std::all_of(lumigraph.views.begin(), lumigraph.views.end(), [&](const auto& view) {
        return optical_axis_in_world(view.cam_from_world).dot(mean_axis) >
               kLeastCosine * mean_axis.norm();
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

/// Width and height of the median photograph.
Eigen::Vector2i median_size_px(const Lumigraph& source) {
    std::vector<int> widths;
    std::vector<int> heights;
    for (const LumigraphView& view : source.views) {
        widths.push_back(view.camera.width_px);
        heights.push_back(view.camera.height_px);
    }
    return {median_of(std::move(widths)), median_of(std::move(heights))};
}

LightFieldLayout two_planes_of(const Lumigraph& source) {
    const Eigen::Vector2i size_px = median_size_px(source);
    TwoPlaneOptions options{.width_px = size_px.x(), .height_px = size_px.y()};
    if (can_one_plane_stand_before_all(source))
        return two_plane_slab(source, with_even_grid(source, source.views.size(), options));
    const double pictures_a_side = static_cast<double>(source.views.size()) / 6;
    options.columns = std::max(2, static_cast<int>(std::lround(std::sqrt(pictures_a_side))));
    return two_plane_cube(source, options);
}

LightFieldLayout directions_of(const Lumigraph& source) {
    const double pixels = median_size_px(source).cast<double>().prod();
    return spherical_light_field(source,
                                 {.subdivisions = subdivisions_for(source.views.size()),
                                  .size_px = static_cast<int>(std::lround(std::sqrt(pixels)))});
}

}  // namespace

const std::vector<PlainRival>& plain_rivals() {
    static const std::vector<PlainRival> rivals{
        {"unstructured lumigraph", depth_that_lacks, true, true,
         [](const Lumigraph& lumigraph, const Eye& eye, const EyeDepths& known) {
             return draw_unstructured_lumigraph(lumigraph, eye, known);
         }},
        {"view-dependent texture", depth_that_lacks, true, true,
         [](const Lumigraph& lumigraph, const Eye& eye, const EyeDepths& known) {
             return draw_view_dependent_texture(lumigraph, eye, known);
         }},
        {"forward warping", depth_that_lacks, true, false,
         [](const Lumigraph& lumigraph, const Eye& eye, const EyeDepths&) {
             return draw_forward_warping(lumigraph, eye);
         }},
        {"dynamically reparameterized", nothing_that_lacks, false, false,
         [](const Lumigraph& lumigraph, const Eye& eye, const EyeDepths&) {
             return draw_dynamically_reparameterized(
                 lumigraph, eye, {.diameter = usual_aperture_diameter(lumigraph), .threads = 1});
         }}};
    return rivals;
}

EyeDepths depths_for(const PlainRival& rival, const Lumigraph& lumigraph, const Eye& eye) {
    return rival.draws_on_eye_depths ? eye_depths(lumigraph, eye, kAgreeingDisparity_px)
                                     : EyeDepths{};
}

const std::vector<ResampledRival>& resampled_rivals() {
    static const std::vector<ResampledRival> rivals{
        {"two-plane", planes_that_lack, two_planes_of},
        {"spherical", directions_that_lack, directions_of}};
    return rivals;
}

}  // namespace lumi
