#include "render/reference/agreed_depth.h"

#include <algorithm>
#include <optional>

#include "render/depth_mesh/view_depth_mesh.h"
#include "render/reference/depth_raster.h"
#include "render/view_choice/depth_view_choice.h"

namespace lumi {
namespace {

/// What each view knows in the mean of the samples, if all that it knows there is of one surface.
std::optional<std::vector<EyeDepth>> mean_of_one_surface(
    const std::vector<std::vector<EyeDepth>>& samples, double agreeing_inverse_depth) {
    std::vector<EyeDepth> mean = samples.front();
    for (std::size_t view = 0; view < mean.size(); ++view) {
        double sum = 0;
        double least = mean[view].inverse_depth;
        double most = least;
        for (const std::vector<EyeDepth>& depths : samples) {
            const EyeDepth& depth = depths[view];
            if (depth.is_known() != mean[view].is_known() ||
                (depth.is_known() && depth.kind != mean[view].kind))
                return std::nullopt;
            sum += depth.inverse_depth;
            least = std::min(least, depth.inverse_depth);
            most = std::max(most, depth.inverse_depth);
        }
        if (most - least > agreeing_inverse_depth) return std::nullopt;
        mean[view].inverse_depth = sum / static_cast<double>(samples.size());
    }
    return mean;
}

}  // namespace

AgreedDepth::AgreedDepth(const Lumigraph& lumigraph, const std::vector<ViewGeometry>& geometries,
                         const Eye& eye, const RenderOptions& options)
    : depth_eye_(depth_eye(lumigraph, eye, options)) {
    const std::vector<DepthViewSet> sets =
        depth_view_sets(lumigraph, eye, lumigraph.drawing.depth_views);
    strip_ends_ = strip_ends(sets, depth_eye_.eye.camera.width_px);
    layer_views_ = depth_layer_views(sets, lumigraph.drawing.depth_views);
    agreeing_inverse_depth_ = agreeing_inverse_depth(
        lumigraph, geometries, sets, centre_in_world(eye.cam_from_world), kAgreeingDisparity_px);
    for (const DepthViewSet& set : sets) {
        for (const int index : set.view_indices) {
            if (eye_depth_of_view_.contains(index)) continue;
            const auto view_index = static_cast<std::size_t>(index);
            const LumigraphView& view = lumigraph.views[view_index];
            const auto mesh = depth_mesh_of(view, max_disparity_px(geometries[view_index]),
                                            depth_mesh_options(lumigraph));
            eye_depth_of_view_.emplace(index, rasterise(*mesh, view, depth_eye_.eye));
            sights_.try_emplace(index, view, depth_eye_.eye);
        }
    }
}

std::vector<AgreedPixelDepth> AgreedDepth::samples_at(const Eigen::Vector2d& pixel) const {
    const std::vector<int>& views = views_at(column_of(pixel));
    if (!depth_eye_.is_smooth()) return {agreed(depths_at(pixel), views)};
    std::vector<std::vector<EyeDepth>> samples;
    for (const double y : {-0.25, 0.25})
        for (const double x : {-0.25, 0.25})
            samples.push_back(depths_at(pixel + Eigen::Vector2d(x, y)));
    if (const auto mean = mean_of_one_surface(samples, agreeing_inverse_depth_))
        return {agreed(*mean, views)};
    std::vector<AgreedPixelDepth> all;
    for (const std::vector<EyeDepth>& depths : samples) all.push_back(agreed(depths, views));
    return all;
}

bool AgreedDepth::is_hole(const Eigen::Vector2d& pixel) const {
    const std::vector<EyeDepth> depths = depths_at(pixel);
    return std::none_of(depths.begin(), depths.end(), [](const EyeDepth& depth) {
        return depth.is_known() && depth.kind != DepthKind::kStretched;
    });
}

int AgreedDepth::column_of(const Eigen::Vector2d& pixel) const {
    return static_cast<int>(pixel.x() * depth_eye_.texels_per_pixel);
}

std::vector<EyeDepth> AgreedDepth::depths_at(const Eigen::Vector2d& pixel) const {
    const int column = column_of(pixel);
    const auto row = static_cast<int>(pixel.y() * depth_eye_.texels_per_pixel);
    const std::vector<int>& views = views_at(column);
    std::vector<EyeDepth> depths;
    for (const int index : views)
        depths.push_back(index == kNoView ? EyeDepth{} : eye_depth_of_view_.at(index)(column, row));
    settle_lone_surface(depths, agreeing_inverse_depth_,
                        [&](std::size_t layer, double inverse_depth, double nearest_seen) {
                            return sights_.at(views[layer])
                                .past({column + 0.5, row + 0.5}, inverse_depth,
                                      agreeing_inverse_depth_, nearest_seen);
                        });
    return depths;
}

AgreedPixelDepth AgreedDepth::agreed(const std::vector<EyeDepth>& depths,
                                     const std::vector<int>& views) const {
    AgreedPixelDepth agreed;
    for (std::size_t i = 0; i < views.size(); ++i)
        if (views[i] != kNoView) agreed.of_views[views[i]] = depths[i];
    agreed.depth = consensus_of(depths, agreeing_inverse_depth_);
    if (agreed.depth.support > 0)
        agreed.known_by = views[static_cast<std::size_t>(agreed.depth.best_layer)];
    return agreed;
}

const std::vector<int>& AgreedDepth::views_at(int column) const {
    const auto end = std::upper_bound(strip_ends_.begin(), strip_ends_.end(), column);
    return layer_views_[static_cast<std::size_t>(end - strip_ends_.begin())];
}

}  // namespace lumi
