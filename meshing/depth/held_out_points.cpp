#include "meshing/depth/held_out_points.h"

#include <cmath>
#include <utility>

#include "calib/work/median.h"
#include "calib/work/parallel_for.h"
#include "meshing/depth_models/depth_model.h"
#include "meshing/depth_scene/views_far_apart.h"

namespace lumi {
namespace {

constexpr int kMaxHeldOutViews = 4;
constexpr std::size_t kFolds = 4;

std::vector<int> sampled_views(const DepthScene& scene) {
    std::vector<int> candidates;
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
        const DepthView& view = scene.views[i];
        if (view.points.size() >= kMinTrialPoints && view.disparity_px_per_inverse_depth > 0) {
            candidates.push_back(static_cast<int>(i));
        }
    }
    return views_far_apart(scene, candidates, kMaxHeldOutViews);
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

/// The view, and what it is compared with.
DepthScene part_of(const DepthScene& scene, int view_index, bool with_neighbours) {
    DepthScene part;
    part.views.push_back(scene.views[static_cast<std::size_t>(view_index)]);
    const std::vector<int> neighbours = std::exchange(part.views.front().neighbours, {});
    if (!with_neighbours) return part;
    for (const int j : neighbours) {
        part.views.front().neighbours.push_back(static_cast<int>(part.views.size()));
        part.views.push_back(scene.views[static_cast<std::size_t>(j)]);
        part.views.back().neighbours.clear();
    }
    return part;
}

std::vector<double> residuals_px(const DepthScene& scene, int view_index, const DepthModel& model,
                                 bool compares) {
    DepthScene part = part_of(scene, view_index, compares);
    const std::vector<SparsePoint> all = part.views.front().points;
    const double px = part.views.front().disparity_px_per_inverse_depth;
    std::vector<double> residuals;
    for (std::size_t fold = 0; fold < (compares ? 1 : kFolds); ++fold) {
        part.views.front().points = all;
        const std::vector<SparsePoint> back = keep_back(part.views.front(), fold);
        const DepthMap map = model.estimate(part, 0).map;
        for (const SparsePoint& point : back) {
            const double found = static_cast<double>(map.inverse_depth(
                static_cast<int>(point.pixel.x()), static_cast<int>(point.pixel.y())));
            residuals.push_back(std::abs(found - point.inverse_depth) * px);
        }
    }
    return residuals;
}

}  // namespace

std::optional<double> held_out_points_p95_px(const DepthScene& scene, const std::string& model,
                                             int threads, const Progress& progress) {
    const std::vector<int> views = sampled_views(scene);
    const std::unique_ptr<DepthModel> rung = depth_model_named(model);
    const bool compares = compares_photographs(model);
    std::vector<std::vector<double>> by_view(views.size());
    // What matches takes its memory at full size: never that of more views than maps will be made
    // of at one time.
    parallel_for(static_cast<int>(views.size()), compares ? 1 : threads, [&](int k) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(k);
        by_view[index] = residuals_px(scene, views[index], *rung, compares);
    });
    std::vector<double> residuals;
    for (const std::vector<double>& some : by_view) {
        residuals.insert(residuals.end(), some.begin(), some.end());
    }
    if (residuals.empty()) return std::nullopt;
    const std::size_t p95 = residuals.size() * 95 / 100;
    return value_of_rank(std::move(residuals), p95);
}

}  // namespace lumi
