#include "render/reference/agreed_depth.h"

#include <algorithm>
#include <cmath>

#include "render/depth_layers/depth_kind_ranges.h"
#include "render/depth_mesh/view_depth_mesh.h"
#include "render/reference/depth_raster.h"
#include "render/view_choice/depth_view_choice.h"

namespace lumi {
namespace {

/// What each view knows at one sample of a pixel.
using Sample = std::vector<EyeDepth>;

/// Whether all views see the same surface at both.
bool is_one_surface(const Sample& a, const Sample& b, double agreeing_inverse_depth) {
    for (std::size_t view = 0; view < a.size(); ++view) {
        if (a[view].is_known() != b[view].is_known()) return false;
        if (!a[view].is_known()) continue;
        if (a[view].kind != b[view].kind ||
            std::abs(a[view].inverse_depth - b[view].inverse_depth) > agreeing_inverse_depth)
            return false;
    }
    return true;
}

Sample mean_of(const std::vector<const Sample*>& samples) {
    Sample mean = *samples.front();
    for (std::size_t view = 0; view < mean.size(); ++view) {
        double sum = 0;
        for (const Sample* sample : samples) sum += (*sample)[view].inverse_depth;
        mean[view].inverse_depth = sum / static_cast<double>(samples.size());
    }
    return mean;
}

/// What is known and not behind tears.
bool is_sure(const AgreedPixelDepth& sample) {
    return sample.depth.support > 0 && !sample.depth.is_behind_tears;
}

}  // namespace

AgreedDepth::AgreedDepth(const Lumigraph& lumigraph, const std::vector<ViewGeometry>& geometries,
                         const Eye& eye, const RenderOptions& options)
    : depth_eye_(depth_eye(lumigraph, eye, options)) {
    const std::vector<DepthViewSet> sets =
        depth_view_sets(lumigraph, eye, lumigraph.drawing.depth_views);
    strip_ends_ = strip_ends(sets, depth_eye_.eye.camera.width_px);
    layer_views_ = depth_layer_views(sets, lumigraph.drawing.depth_views);
    agreeing_inverse_depth_ =
        agreeing_in_layers(lumigraph, geometries, sets, centre_in_world(eye.cam_from_world));
    for (const DepthViewSet& set : sets) {
        for (const int index : set.view_indices) {
            if (eye_depth_of_view_.contains(index)) continue;
            const auto view_index = static_cast<std::size_t>(index);
            const LumigraphView& view = lumigraph.views[view_index];
            const auto mesh = depth_mesh_of(view, max_disparity_px(geometries[view_index]),
                                            depth_mesh_options(lumigraph));
            eye_depth_of_view_.emplace(
                index, rasterise(*mesh, view, depth_eye_.eye, nearest_inverse_depth(lumigraph),
                                 agreeing_inverse_depth_));
            sights_.try_emplace(index, view, depth_eye_.eye);
        }
    }
}

std::vector<AgreedPixelDepth> AgreedDepth::samples_at(const Eigen::Vector2d& pixel) const {
    const std::vector<int>& views = views_at(column_of(pixel));
    if (!depth_eye_.is_smooth()) return {agreed(depths_at(pixel), views)};
    // From the bottom left on, as a GL counts: with the first of those that are left, others are of
    // one surface.
    std::vector<Sample> samples;
    for (const double y : {0.25, -0.25})
        for (const double x : {-0.25, 0.25})
            samples.push_back(depths_at(pixel + Eigen::Vector2d(x, y)));
    std::vector<const Sample*> left;
    for (const Sample& sample : samples) left.push_back(&sample);
    std::vector<AgreedPixelDepth> all;
    while (!left.empty()) {
        const auto others = std::stable_partition(
            left.begin(), left.end(), [&, first = left.front()](const Sample* sample) {
                return is_one_surface(*sample, *first, agreeing_inverse_depth_);
            });
        const std::vector<const Sample*> of_surface(left.begin(), others);
        left.erase(left.begin(), others);
        const AgreedPixelDepth surface = agreed(mean_of(of_surface), views);
        if (of_surface.size() == samples.size()) return {surface};
        all.insert(all.end(), of_surface.size(), surface);
    }
    if (std::any_of(all.begin(), all.end(), is_sure))
        std::erase_if(all,
                      [](const AgreedPixelDepth& sample) { return sample.depth.is_behind_tears; });
    return all;
}

bool AgreedDepth::is_hole(const Eigen::Vector2d& pixel) const {
    const ConsensusDepth depth = consensus_of(depths_at(pixel), agreeing_inverse_depth_);
    return depth.support == 0 || depth.kind == DepthKind::kStretched || depth.is_behind_tears;
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
