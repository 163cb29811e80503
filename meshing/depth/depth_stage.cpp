#include "meshing/depth/depth_stage.h"

#include <time.h>

#include <algorithm>
#include <cmath>

#include "calib/work/parallel_for.h"
#include "meshing/depth/cross_view_check.h"
#include "meshing/depth/depth_model.h"
#include "meshing/depth/depth_scene.h"
#include "meshing/depth/edge_aware_fill.h"
#include "meshing/depth/sparse_depth.h"

namespace lumi {
namespace {

// A view in flight takes up to 300 MB of matching costs.
constexpr int kMaxViewsInFlight = 8;

double thread_cpu_s() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Calls `work(view)` for each view, adds its CPU time to the view's evidence and reports progress.
void for_each_view(const std::string& step, DepthResult& result, int threads, Progress& progress,
                   const std::function<void(int)>& work) {
    progress.begin(step, result.evidence.size());
    parallel_for(static_cast<int>(result.evidence.size()),
                 std::min(resolve_threads(threads), kMaxViewsInFlight), [&](int i) {
                     progress.throw_if_interrupted();
                     const double start = thread_cpu_s();
                     work(i);
                     result.evidence[static_cast<std::size_t>(i)].cpu_s += thread_cpu_s() - start;
                     progress.advance();
                 });
}

double one_pixel_of(const DepthView& view) {
    return view.disparity_px_per_inverse_depth > 0 ? 1.0 / view.disparity_px_per_inverse_depth
                                                   : 0.0;
}

/// What the neighbours confirm, without islands.
DepthMap confirmed(const DepthScene& scene, const std::vector<DepthEstimate>& estimates, int i) {
    constexpr double kIslandShare = 1e-4;  // Of the picture.
    const auto index = static_cast<std::size_t>(i);
    if (!estimates[index].needs_confirmation) return estimates[index].map;
    DepthMap map = cross_view_check(scene, estimates, i);
    const auto pixels = static_cast<double>(map.confidence.pixels().size());
    remove_speckles(map, 2 * one_pixel_of(scene.views[index]),
                    std::max(16, static_cast<int>(kIslandShare * pixels)));
    return map;
}

double confident_share(const DepthMap& map) {
    const auto& confidence = map.confidence.pixels();
    const auto unknown = std::count(confidence.begin(), confidence.end(), 0);
    return 1.0 - static_cast<double>(unknown) / static_cast<double>(confidence.size());
}

/// Median distance of the map to the view's points, in pixels of disparity.
double sparse_residual_px(const DepthMap& map, const DepthView& view) {
    std::vector<double> residuals;
    for (const SparsePoint& point : view.points) {
        const double found = static_cast<double>(map.inverse_depth(
            static_cast<int>(point.pixel.x()), static_cast<int>(point.pixel.y())));
        residuals.push_back(std::abs(found - point.inverse_depth) *
                            view.disparity_px_per_inverse_depth);
    }
    if (residuals.empty()) return 0.0;
    const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
    std::nth_element(residuals.begin(), middle, residuals.end());
    return *middle;
}

}  // namespace

DepthResult estimate_depth(const PosedPhotographs& photographs,
                           const std::vector<int>& view_indices, const DepthOptions& options,
                           int threads, Progress& progress) {
    validate(options);
    const DepthScene scene =
        make_depth_scene(photographs, view_indices, options, threads, progress);
    const std::unique_ptr<DepthModel> model = make_depth_model(options);
    DepthResult result;
    result.depth_maps.resize(scene.views.size());
    result.evidence.resize(scene.views.size());
    std::vector<DepthEstimate> estimates(scene.views.size());

    for_each_view("depth: matching", result, threads, progress, [&](int i) {
        estimates[static_cast<std::size_t>(i)] = model->estimate(scene, i);
    });
    for_each_view("depth: agreement of views", result, threads, progress, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        const DepthView& view = scene.views[index];
        DepthMap& map = result.depth_maps[index];
        map = confirmed(scene, estimates, i);
        DepthEvidence& evidence = result.evidence[index];
        evidence.view_name = view.name;
        evidence.model = estimates[index].model;
        evidence.confident_share = confident_share(map);
        edge_aware_fill(map, view.photograph, sparse_depth(view).inverse_depth, one_pixel_of(view));
        evidence.sparse_residual_px = sparse_residual_px(map, view);
    });
    return result;
}

}  // namespace lumi
