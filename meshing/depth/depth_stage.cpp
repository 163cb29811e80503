#include "meshing/depth/depth_stage.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "calib/work/median.h"
#include "calib/work/parallel_for.h"
#include "calib/work/process_memory.h"
#include "meshing/depth/depth_choice.h"
#include "meshing/depth/depth_model.h"
#include "meshing/depth/depth_scene.h"
#include "meshing/depth/finished_depth.h"
#include "meshing/depth/held_out_points.h"
#include "meshing/depth/view_mask.h"

namespace lumi {
namespace {

double seconds_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double thread_cpu_s() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }

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

bool is_geometry_imported(const DepthOptions& options) {
    return !options.import_mesh.empty() || !options.import_volume.empty();
}

/// Geometry that lies beside every picture is not in the world of the poses.
void require_seen(const std::vector<DepthEstimate>& estimates, const DepthOptions& options) {
    const bool is_seen =
        std::any_of(estimates.begin(), estimates.end(), [](const DepthEstimate& estimate) {
            const auto& confidence = estimate.map.confidence.pixels();
            return std::any_of(confidence.begin(), confidence.end(), [](auto c) { return c > 0; });
        });
    if (is_seen || !is_geometry_imported(options)) return;
    const auto& file = options.import_mesh.empty() ? options.import_volume : options.import_mesh;
    throw Error(ErrorKind::kBadInput, "E-GEOMETRY-UNSEEN",
                file.string() + ": no view sees anything of it",
                "bring it into the world of the poses: axes, origin, unit of length");
}

std::vector<std::uint64_t> pixels_of_maps(const Capture& capture,
                                          const std::vector<int>& view_indices,
                                          const DepthOptions& options) {
    std::vector<std::uint64_t> pixels;
    for (const int i : view_indices) {
        const Camera camera = at_depth_map_size(
            camera_of(capture, capture.views[static_cast<std::size_t>(i)]), options.max_width_px);
        pixels.push_back(static_cast<std::uint64_t>(camera.width_px) *
                         static_cast<std::uint64_t>(camera.height_px));
    }
    return pixels;
}

std::uint64_t budget_of(const DepthOptions& options) {
    return static_cast<std::uint64_t>(options.max_memory_mib) << 20;
}

/// Says what memory the maps of these views will take, and refuses where there is not so much.
DepthMemory expected_memory(const std::vector<std::uint64_t>& pixels, const DepthOptions& options,
                            int threads, Progress& progress) {
    release_free_memory();
    const bool is_imported = !options.import_folder.empty() || is_geometry_imported(options);
    const std::string model = is_imported ? "imported" : options.model;
    const DepthMemory memory = predicted_depth_memory(
        pixels, model, resolve_threads(threads), budget_of(options), memory_in_use().value_or(0));
    progress.note(std::string("depth: ") + (model == "auto" ? "at most " : "about ") +
                  std::to_string(memory.peak() >> 20) + " MiB of memory");
    if (const auto available = memory_available()) require_memory(memory, *available);
    return memory;
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

std::string with_one_digit(double value) {
    const std::string text = std::to_string(value);
    return text.substr(0, text.find('.') + 2);
}

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

/// The model that the options name, or that is chosen; and what that does to the memory.
std::unique_ptr<DepthModel> model_of(const DepthScene& scene, const std::vector<GrayImage>& masks,
                                     const std::vector<std::uint64_t>& pixels,
                                     const DepthOptions& options, int threads, Progress& progress,
                                     DepthResult& result) {
    if (!options.import_folder.empty()) {
        return imported_depth_model(options.import_folder, options.import_png_unit);
    }
    if (!options.import_mesh.empty()) return mesh_depth_model(options.import_mesh);
    if (!options.import_volume.empty()) {
        return volume_depth_model(options.import_volume, options.import_volume_threshold);
    }
    if (options.model != "auto") return depth_model_named(options.model);
    const double before = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    // PatchMatch everywhere would gain next to nothing over PatchMatch where the sweep is unsure.
    const DepthChoice chosen = choose_depth_model(scene, masks, "refined_sweep", threads, progress);
    result.choice = chosen.explanation;
    result.choice_cpu_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - before;
    result.memory =
        predicted_memory_of_choice(result.memory, pixels, chosen.model, !chosen.compared.empty(),
                                   resolve_threads(threads), budget_of(options));
    progress.note("depth: " + chosen.model + ", about " +
                  std::to_string(result.memory.peak() >> 20) + " MiB of memory");
    return depth_model_named(chosen.model);
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
                                  const std::vector<GrayImage>& masks,
                                  std::vector<DepthEstimate>& estimates, DepthResult& result,
                                  Progress& progress) {
    std::vector<DepthEstimate> first;
    for (int round = 0; round < model.refinements(); ++round) {
        std::vector<DepthEstimate> before =
            std::exchange(estimates, std::vector<DepthEstimate>(estimates.size()));
        for_each_view("depth: refinement", result, result.memory.views_matched, progress,
                      [&](int i) {
                          const auto index = static_cast<std::size_t>(i);
                          estimates[index] = model.refine(scene, before, i);
                          claim_nothing_beyond(masks[index], estimates[index].map);
                      });
        if (round == 0) first = std::move(before);
    }
    return first;
}

/// What the photographs say of depth beyond what is confirmed; empty where they do not tell.
std::optional<double> recession_of_fill(const DepthScene& scene,
                                        const std::vector<GrayImage>& masks,
                                        const std::vector<DepthEstimate>& estimates,
                                        DepthResult& result) {
    release_free_memory();
    const double before = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    const auto recession_px =
        fill_recession(scene, masks, result.depth_maps, estimates, result.memory.views_filled);
    result.choice_cpu_s += seconds_of(CLOCK_PROCESS_CPUTIME_ID) - before;
    return recession_px;
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
    const auto recession_px = recession_of_fill(scene, masks, first, result);
    result.depth_maps = std::move(kept);
    return recession_px;
}

void tell_recession(double recession_px, Progress& progress) {
    if (recession_px <= 0) return;
    progress.note("depth: beyond what is known the scene recedes by " +
                  with_one_digit(recession_px) +
                  " px of disparity a pixel: so the photographs differ least");
}

}  // namespace

DepthResult estimate_depth(const PosedPhotographs& photographs,
                           const std::vector<int>& view_indices, const DepthOptions& options,
                           int threads, Progress& progress) {
    validate(options);
    DepthResult result;
    const std::vector<std::uint64_t> pixels =
        pixels_of_maps(photographs.capture, view_indices, options);
    result.memory = expected_memory(pixels, options, threads, progress);
    const DepthScene scene =
        make_depth_scene(photographs, view_indices, options, threads, progress);
    result.depth_maps.resize(scene.views.size());
    result.evidence.resize(scene.views.size());
    const SceneMasks found_masks =
        scene_masks(scene, options.mask_folder, options.background == "auto", threads);
    const std::vector<GrayImage>& masks = found_masks.of_views;
    result.background = found_masks.background;
    std::unique_ptr<DepthModel> model =
        model_of(scene, masks, pixels, options, threads, progress, result);
    std::vector<DepthEstimate> estimates(scene.views.size());

    for_each_view("depth: matching", result, result.memory.views_matched, progress, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        estimates[index] = model->estimate(scene, i);
        claim_nothing_beyond(masks[index], estimates[index].map);
    });
    require_seen(estimates, options);
    std::vector<DepthEstimate> first = refine(*model, scene, masks, estimates, result, progress);
    model.reset();  // And the memory it matched in.
    confirm(scene, estimates, result, progress);
    forget_maps(estimates);  // They have said what they knew.
    auto told_recession_px = recession_of_fill(scene, masks, estimates, result);
    if (!told_recession_px && !first.empty()) {
        told_recession_px =
            recession_before_refinement(scene, masks, std::move(first), result, progress);
    }
    first.clear();
    const double recession_px = told_recession_px.value_or(0.0);
    tell_recession(recession_px, progress);
    const std::vector<DepthMap> confirmed_maps = result.depth_maps;
    for_each_view("depth: filling", result, result.memory.views_filled, progress, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        DepthMap& map = result.depth_maps[index];
        DepthEvidence& evidence = result.evidence[index];
        evidence.view_name = scene.views[index].name;
        evidence.model = estimates[index].model;
        evidence.confident_share = confident_share(map);
        if (!estimates[index].is_complete) {
            fill_unknown_depth(scene, confirmed_maps, i, recession_px, map);
        }
        // After filling: what belongs to the scene is not continued from what does not.
        evidence.background_share = separate_background(masks[index], map);
        evidence.sparse_residual_px = sparse_residual_px(map, scene.views[index]);
    });
    result.warning = doubt_about(result.evidence, estimates, scene);
    if (!result.warning.empty()) progress.note(result.warning);
    return result;
}

}  // namespace lumi
