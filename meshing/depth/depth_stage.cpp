#include "meshing/depth/depth_stage.h"

#include <algorithm>
#include <utility>

#include "calib/work/parallel_for.h"
#include "calib/work/process_memory.h"
#include "calib/work/stopwatch.h"
#include "meshing/depth/depth_choice.h"
#include "meshing/depth/found_depth.h"
#include "meshing/depth_models/depth_model.h"
#include "meshing/depth_models/imported_depth.h"
#include "meshing/depth_scene/depth_scene.h"
#include "meshing/depth_scene/view_mask.h"

namespace lumi {
namespace {

bool is_geometry_imported(const DepthOptions& options) {
    return !options.import_mesh.empty() || !options.import_volume.empty();
}

/// What was imported must say something: maps that know nothing would be filled with nothing, and
/// geometry that lies beside every picture is not in the world of the poses.
void require_seen(const std::vector<DepthEvidence>& evidence, const DepthOptions& options) {
    const bool is_seen = std::any_of(evidence.begin(), evidence.end(),
                                     [](const auto& view) { return view.confident_share > 0; });
    if (is_seen) return;
    if (!options.import_folder.empty()) {
        throw Error(ErrorKind::kBadInput, "E-DEPTH-EMPTY",
                    options.import_folder.string() +
                        ": no depth map says anything: all is 0, NaN "
                        "or too small to be a depth",
                    "export depth along the optical axis in the unit of the poses");
    }
    if (!is_geometry_imported(options)) return;
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
    const DepthMemory memory =
        predicted_depth_memory(pixels, model, resolve_threads(threads), budget_of(options),
                               memory_in_use().value_or(0), options.max_neighbours);
    progress.note(std::string("depth: ") + (model == "auto" ? "at most " : "about ") +
                  std::to_string(memory.peak() >> 20) + " MiB of memory");
    if (const auto available = memory_available()) require_memory(memory, *available);
    return memory;
}

std::vector<std::filesystem::path> files_to_import(const DepthScene& scene,
                                                   const DepthOptions& options) {
    if (!options.imported_files.empty()) return options.imported_files;
    std::vector<std::string> names;
    for (const DepthView& view : scene.views) names.push_back(view.name);
    return imported_depth_files(names, options.import_folder);
}

/// The model that the options name, or that is chosen; and what that does to the memory.
std::unique_ptr<DepthModel> model_of(const DepthScene& scene, const std::vector<GrayImage>& masks,
                                     const std::vector<std::uint64_t>& pixels,
                                     const DepthOptions& options, int threads, Progress& progress,
                                     DepthResult& result) {
    if (!options.import_folder.empty()) {
        return imported_depth_model(files_to_import(scene, options), options.import_png_unit);
    }
    if (!options.import_mesh.empty()) return mesh_depth_model(options.import_mesh);
    if (!options.import_volume.empty()) {
        return volume_depth_model(options.import_volume, options.import_volume_threshold);
    }
    if (options.model != "auto") return depth_model_named(options.model);
    const Stopwatch stopwatch;
    // PatchMatch everywhere would gain next to nothing over PatchMatch where the sweep is unsure.
    const DepthChoice chosen =
        choose_depth_model(scene, masks, "refined_sweep", result.memory.views_tried, progress);
    result.choice = chosen.explanation;
    result.choice_cpu_s = stopwatch.elapsed().cpu_s;
    result.memory =
        predicted_memory_of_choice(result.memory, pixels, chosen.model, !chosen.compared.empty(),
                                   resolve_threads(threads), budget_of(options));
    progress.note("depth: " + chosen.model + ", about " +
                  std::to_string(result.memory.peak() >> 20) + " MiB of memory");
    return depth_model_named(chosen.model);
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
    const DepthScene scene = make_depth_scene(
        photographs, view_indices,
        {.max_width_px = options.max_width_px, .max_neighbours = options.max_neighbours}, threads,
        progress);
    const SceneMasks found_masks =
        scene_masks(scene, options.mask_folder, options.background == "auto", threads);
    const std::vector<GrayImage>& masks = found_masks.of_views;
    result.background = found_masks.background;
    std::unique_ptr<DepthModel> model =
        model_of(scene, masks, pixels, options, threads, progress, result);
    find_depth(scene, masks, std::move(model), progress, result);
    require_seen(result.evidence, options);
    return result;
}

}  // namespace lumi
