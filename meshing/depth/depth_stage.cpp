#include "meshing/depth/depth_stage.h"

#include <time.h>

#include <algorithm>
#include <cmath>

#include "calib/work/parallel_for.h"
#include "meshing/depth/cross_view_check.h"
#include "meshing/depth/depth_choice.h"
#include "meshing/depth/depth_model.h"
#include "meshing/depth/depth_scene.h"
#include "meshing/depth/edge_aware_fill.h"
#include "meshing/depth/edge_snapping.h"
#include "meshing/depth/sparse_depth.h"
#include "meshing/depth/surrounding_depth.h"
#include "meshing/depth/view_mask.h"

namespace lumi {
namespace {

// A view in flight takes up to 300 MB of matching costs.
constexpr int kMaxViewsInFlight = 8;

double seconds_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double thread_cpu_s() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }

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
    constexpr double kIslandShare = 5e-4;  // Of the picture.
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

/// Which pixels belong to the scene; empty images where all do.
std::vector<GrayImage> scene_masks(const DepthScene& scene, const DepthOptions& options,
                                   int threads) {
    std::vector<GrayImage> masks(scene.views.size());
    const bool is_drawn = !options.mask_folder.empty();
    const bool looks_for_background = !is_drawn && options.background == "auto";
    const auto background = looks_for_background ? plain_background(scene) : std::nullopt;
    if (!is_drawn && !background) return masks;
    parallel_for(static_cast<int>(masks.size()), threads, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        const DepthView& view = scene.views[index];
        masks[index] = is_drawn ? drawn_mask(view, options.mask_folder)
                                : mask_of_background(view, *background);
    });
    return masks;
}

/// Nothing is claimed of what does not belong to the scene.
void claim_nothing_beyond(const GrayImage& mask, DepthMap& map) {
    for (std::size_t i = 0; i < mask.pixels().size(); ++i) {
        if (mask.pixels()[i] == 0) map.confidence.pixels()[i] = 0;
    }
}

/// What does not belong to the scene is known to be behind all of it. Returns its share.
double put_at_infinity(const GrayImage& mask, DepthMap& map) {
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < mask.pixels().size(); ++i) {
        if (mask.pixels()[i] != 0) continue;
        map.inverse_depth.pixels()[i] = 0.0F;
        map.confidence.pixels()[i] = 255;
        ++beyond;
    }
    return static_cast<double>(beyond) /
           static_cast<double>(std::max<std::size_t>(1, map.confidence.pixels().size()));
}

std::unique_ptr<DepthModel> model_of(const DepthScene& scene, const DepthOptions& options,
                                     int threads, Progress& progress, std::string& choice) {
    if (!options.import_folder.empty()) {
        return imported_depth_model(options.import_folder, options.import_png_unit);
    }
    if (!options.import_mesh.empty()) return mesh_depth_model(options.import_mesh);
    if (options.model != "auto") return depth_model_named(options.model);
    const DepthChoice chosen = choose_depth_model(scene, "sweep", threads, progress);
    choice = chosen.explanation;
    return depth_model_named(chosen.model);
}

}  // namespace

DepthResult estimate_depth(const PosedPhotographs& photographs,
                           const std::vector<int>& view_indices, const DepthOptions& options,
                           int threads, Progress& progress) {
    validate(options);
    const DepthScene scene =
        make_depth_scene(photographs, view_indices, options, threads, progress);
    DepthResult result;
    result.depth_maps.resize(scene.views.size());
    result.evidence.resize(scene.views.size());
    const double before_choice = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    const std::unique_ptr<DepthModel> model =
        model_of(scene, options, threads, progress, result.choice);
    result.choice_cpu_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - before_choice;
    const std::vector<GrayImage> masks = scene_masks(scene, options, threads);
    std::vector<DepthEstimate> estimates(scene.views.size());

    for_each_view("depth: matching", result, threads, progress, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        estimates[index] = model->estimate(scene, i);
        claim_nothing_beyond(masks[index], estimates[index].map);
    });
    for (int round = 0; round < model->refinements(); ++round) {
        const std::vector<DepthEstimate> before = estimates;
        for_each_view("depth: refinement", result, threads, progress, [&](int i) {
            const auto index = static_cast<std::size_t>(i);
            estimates[index] = model->refine(scene, before, i);
            claim_nothing_beyond(masks[index], estimates[index].map);
        });
    }
    for_each_view("depth: agreement of views", result, threads, progress, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        const DepthView& view = scene.views[index];
        DepthMap& map = result.depth_maps[index];
        map = confirmed(scene, estimates, i);
        DepthEvidence& evidence = result.evidence[index];
        evidence.view_name = view.name;
        evidence.model = estimates[index].model;
        evidence.confident_share = confident_share(map);
        evidence.background_share = put_at_infinity(masks[index], map);
    });
    const std::vector<DepthMap> confirmed_maps = result.depth_maps;
    for_each_view("depth: filling", result, threads, progress, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        const DepthView& view = scene.views[index];
        DepthMap& map = result.depth_maps[index];
        if (!estimates[index].is_complete) {
            edge_aware_fill(map, view.photograph, sparse_depth(view).inverse_depth,
                            one_pixel_of(view), surrounding_depth(scene, confirmed_maps, i));
            snap_edges(map, view.photograph, one_pixel_of(view));
        }
        result.evidence[index].sparse_residual_px = sparse_residual_px(map, view);
    });
    return result;
}

}  // namespace lumi
