#include "meshing/depth/found_depth.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "calib/work/formatted.h"
#include "calib/work/median.h"
#include "calib/work/parallel_for.h"
#include "calib/work/process_memory.h"
#include "calib/work/stopwatch.h"
#include "meshing/depth/finished_depth.h"
#include "meshing/depth/held_out_points.h"
#include "meshing/depth/subject.h"

namespace lumi {
namespace {

double thread_cpu_s() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Calls `work(view)` for each view, adds its CPU time to the view's evidence and reports progress.
void for_each_view(const std::string& step, DepthResult& result, int views_at_one_time,
                   Progress& progress, const std::function<void(int)>& work) {
    release_free_memory();
    progress.begin(step, result.evidence.size());
    parallel_for(static_cast<int>(result.evidence.size()), views_at_one_time, [&](int i) {
        progress.throw_if_interrupted();
        const double start = thread_cpu_s();
        work(i);
        result.evidence[static_cast<std::size_t>(i)].cpu_s += thread_cpu_s() - start;
        progress.advance();
    });
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
    return median_of(std::move(residuals));
}

std::string with_one_digit(double value) { return formatted("%.1f", value); }

/// Views that agree with each other may all be wrong, where poses or lens are: the scene points are
/// a second opinion on what was found by comparing photographs.
std::string doubt_about(const std::vector<DepthEvidence>& evidence,
                        const std::vector<DepthEstimate>& estimates, const DepthScene& scene) {
    constexpr double kDoubtfulPx = 1.0;
    std::vector<double> residuals_px;
    for (std::size_t i = 0; i < evidence.size(); ++i) {
        if (!estimates[i].needs_confirmation || scene.views[i].points.size() < kMinTrialPoints) {
            continue;
        }
        residuals_px.push_back(evidence[i].sparse_residual_px);
    }
    if (residuals_px.empty()) return "";
    const double residual_px = median_of(std::move(residuals_px));
    if (residual_px <= kDoubtfulPx) return "";
    return "depth is doubtful: in half of the views half of the scene points lie more than " +
           with_one_digit(residual_px) +
           " px of disparity from it. Are poses and focal length right, the photographs sharp and "
           "free of noise?";
}

/// What is given says where it is, and the scene points say so, too: by how much its unit of length
/// differs from that of the poses shows in the median of all.
std::string doubt_about_unit(const DepthScene& scene, const std::vector<DepthEstimate>& estimates,
                             const std::vector<DepthMap>& maps) {
    constexpr double kMostTimes = 1.5;
    std::vector<double> times_as_far;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (!estimates[i].is_exact) continue;
        for (const SparsePoint& point : scene.views[i].points) {
            const auto x = static_cast<int>(point.pixel.x());
            const auto y = static_cast<int>(point.pixel.y());
            const auto given = static_cast<double>(maps[i].inverse_depth(x, y));
            if (maps[i].confidence(x, y) == 0 || given <= 0) continue;
            times_as_far.push_back(point.inverse_depth / given);
        }
    }
    if (times_as_far.size() < kMinTrialPoints) return "";
    const double times = median_of(std::move(times_as_far));
    if (times <= kMostTimes && times >= 1 / kMostTimes) return "";
    return "depth is doubtful: what was imported lies " + formatted("%.4g", times) +
           " times as far away as the scene points. Is its unit of length that of the poses?";
}

/// Leaves in `result` what the views confirm of each other's estimates.
void confirm(const DepthScene& scene, const std::vector<DepthEstimate>& estimates,
             DepthResult& result, Progress& progress) {
    for_each_view(
        "depth: agreement of views", result, result.memory.views_filled, progress, [&](int i) {
            result.depth_maps[static_cast<std::size_t>(i)] = confirmed_depth(scene, estimates, i);
        });
}

/// Makes the estimates better, as often as the model does. Returns what they were.
std::vector<DepthEstimate> refine(const DepthModel& model, const DepthScene& scene,
                                  const Subject& subject, std::vector<DepthEstimate>& estimates,
                                  DepthResult& result, Progress& progress) {
    std::vector<DepthEstimate> first;
    for (int round = 0; round < model.refinements(); ++round) {
        std::vector<DepthEstimate> before =
            std::exchange(estimates, std::vector<DepthEstimate>(estimates.size()));
        for_each_view("depth: refinement", result, result.memory.views_matched, progress,
                      [&](int i) {
                          const auto index = static_cast<std::size_t>(i);
                          estimates[index] = model.refine(scene, before, i);
                          subject.leave_claims_within(i, estimates[index]);
                      });
        if (round == 0) first = std::move(before);
    }
    return first;
}

/// What the photographs say of depth beyond what is confirmed.
Recession recession_of_fill(const DepthScene& scene, const std::vector<GrayImage>& masks,
                            const std::vector<DepthEstimate>& estimates, const Progress& progress,
                            DepthResult& result) {
    release_free_memory();
    const Stopwatch stopwatch;
    Recession recession = fill_recession(scene, masks, estimates, result.memory.views_filled,
                                         progress, result.depth_maps);
    result.choice_cpu_s += stopwatch.elapsed().cpu_s;
    return recession;
}

void forget_maps(std::vector<DepthEstimate>& estimates) {
    for (DepthEstimate& estimate : estimates) estimate.map = {};
}

/// The same, of what matching alone confirms: refinement confirms more, and may leave too little to
/// ask where it does so best. What `result` holds stays.
std::optional<double> recession_before_refinement(const DepthScene& scene,
                                                  const std::vector<GrayImage>& masks,
                                                  std::vector<DepthEstimate> first,
                                                  DepthResult& result, Progress& progress) {
    std::vector<DepthMap> kept =
        std::exchange(result.depth_maps, std::vector<DepthMap>(result.depth_maps.size()));
    confirm(scene, first, result, progress);
    forget_maps(first);
    const auto recession_px = recession_of_fill(scene, masks, first, progress, result).slope_px;
    result.depth_maps = std::move(kept);
    return recession_px;
}

/// The confirmed maps, where views are still to be continued from them while others are filled.
std::vector<DepthMap> maps_to_continue_from(const DepthResult& result,
                                            const std::vector<DepthEstimate>& estimates,
                                            const Recession& recession) {
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        if (!estimates[i].is_complete && recession.continuations[i].distance_px.empty()) {
            return result.depth_maps;
        }
    }
    return {};
}

void tell_recession(double recession_px, Progress& progress) {
    if (recession_px <= 0) return;
    progress.note("depth: beyond what is known the scene recedes by " +
                  with_one_digit(recession_px) +
                  " px of disparity a pixel: so the photographs differ least");
}

/// Fills one view's confirmed map, and says what speaks for it.
void finish(const DepthScene& scene, const std::vector<DepthMap>& confirmed_maps,
            const DepthEstimate& estimate, const Continuation& continuation, double recession_px,
            const Subject& subject, int view_index, DepthMap& map, DepthEvidence& evidence) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    evidence.view_name = view.name;
    evidence.model = estimate.model;
    evidence.confident_share = confident_share(map);
    if (!continuation.distance_px.empty()) {
        finish_continued_depth(view, continuation, recession_px, map, estimate.is_exact);
    } else if (!estimate.is_complete) {
        fill_unknown_depth(scene, confirmed_maps, view_index, recession_px, map, estimate.is_exact);
    }
    // After filling: what belongs to the scene is not continued from what does not.
    evidence.background_share = subject.separate_from_background(view_index, estimate, map);
    evidence.sparse_residual_px = sparse_residual_px(map, view);
}

}  // namespace

void find_depth(const DepthScene& scene, const std::vector<GrayImage>& masks,
                std::unique_ptr<DepthModel> model, Progress& progress, DepthResult& result) {
    result.depth_maps.resize(scene.views.size());
    result.evidence.resize(scene.views.size());
    const Subject subject(scene, masks);
    std::vector<DepthEstimate> estimates(scene.views.size());
    for_each_view("depth: matching", result, result.memory.views_matched, progress, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        estimates[index] = model->estimate(scene, i);
        subject.leave_claims_within(i, estimates[index]);
    });
    std::vector<DepthEstimate> first = refine(*model, scene, subject, estimates, result, progress);
    model.reset();  // And the memory it matched in.
    confirm(scene, estimates, result, progress);
    forget_maps(estimates);  // They have said what they knew.
    Recession recession = recession_of_fill(scene, masks, estimates, progress, result);
    if (!recession.slope_px && !first.empty()) {
        recession.slope_px =
            recession_before_refinement(scene, masks, std::move(first), result, progress);
    }
    first.clear();
    const double recession_px = recession.slope_px.value_or(0.0);
    tell_recession(recession_px, progress);
    const std::vector<DepthMap> confirmed_maps =
        maps_to_continue_from(result, estimates, recession);
    for_each_view("depth: filling", result, result.memory.views_filled, progress, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        const Continuation continuation = std::exchange(recession.continuations[index], {});
        finish(scene, confirmed_maps, estimates[index], continuation, recession_px, subject, i,
               result.depth_maps[index], result.evidence[index]);
    });
    result.warning = doubt_about(result.evidence, estimates, scene);
    if (result.warning.empty()) {
        result.warning = doubt_about_unit(scene, estimates, result.depth_maps);
    }
    if (!result.warning.empty()) progress.note(result.warning);
}

}  // namespace lumi
