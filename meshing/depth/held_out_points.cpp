#include "meshing/depth/held_out_points.h"

#include <algorithm>
#include <cmath>

#include "calib/work/parallel_for.h"
#include "meshing/depth/depth_model.h"
#include "meshing/depth/views_far_apart.h"

namespace lumi {
namespace {

constexpr std::size_t kMaxViews = 4;
constexpr std::size_t kFolds = 4;

std::vector<int> sampled_views(const DepthScene& scene) {
    std::vector<int> candidates;
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
        const DepthView& view = scene.views[i];
        if (view.points.size() >= kMinTrialPoints && view.disparity_px_per_inverse_depth > 0) {
            candidates.push_back(static_cast<int>(i));
        }
    }
    return views_far_apart(scene, std::move(candidates), kMaxViews);
}

/// Takes a part of the view's points from it.
std::vector<SparsePoint> keep_back(DepthView& view, std::size_t fold) {
    std::vector<SparsePoint> kept;
    std::vector<SparsePoint> back;
    for (std::size_t i = 0; i < view.points.size(); ++i) {
        (i % kFolds == fold ? back : kept).push_back(view.points[i]);
    }
    view.points = std::move(kept);
    return back;
}

/// Of all points of one view, each once.
std::vector<double> residuals_px(const DepthView& source, const DepthModel& model) {
    std::vector<double> residuals;
    for (std::size_t fold = 0; fold < kFolds; ++fold) {
        DepthScene alone;
        alone.views.push_back(source);
        alone.views.front().neighbours.clear();
        const std::vector<SparsePoint> back = keep_back(alone.views.front(), fold);
        const DepthMap map = model.estimate(alone, 0).map;
        for (const SparsePoint& point : back) {
            const double found = static_cast<double>(map.inverse_depth(
                static_cast<int>(point.pixel.x()), static_cast<int>(point.pixel.y())));
            residuals.push_back(std::abs(found - point.inverse_depth) *
                                source.disparity_px_per_inverse_depth);
        }
    }
    return residuals;
}

}  // namespace

std::optional<double> held_out_points_p95_px(const DepthScene& scene, const std::string& model,
                                             int threads, const Progress& progress) {
    const std::vector<int> views = sampled_views(scene);
    const std::unique_ptr<DepthModel> rung = depth_model_named(model);
    std::vector<std::vector<double>> by_view(views.size());
    parallel_for(static_cast<int>(views.size()), threads, [&](int k) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(k);
        by_view[index] = residuals_px(scene.views[static_cast<std::size_t>(views[index])], *rung);
    });
    std::vector<double> residuals;
    for (const std::vector<double>& some : by_view) {
        residuals.insert(residuals.end(), some.begin(), some.end());
    }
    if (residuals.empty()) return std::nullopt;
    const auto p95 = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() * 95 / 100);
    std::nth_element(residuals.begin(), p95, residuals.end());
    return *p95;
}

}  // namespace lumi
