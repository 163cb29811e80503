#include "pipeline/stages/depth_stage.h"

#include <nlohmann/json.hpp>

#include "calib/capture/all_views.h"
#include "pipeline/stages/depth_files.h"
#include "pipeline/stages/file_stems.h"
#include "pipeline/stages/straightened_depth.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Json subject_json(const DepthResult& result, const DepthOptions& options) {
    if (!options.mask_folder.empty()) return {{"from", kSubjectDrawn}};
    if (!result.background) return nullptr;
    return {{"from", kSubjectBeforeBackground},
            {"color", {result.background->r, result.background->g, result.background->b}},
            {"width_px", options.max_width_px}};
}

Json facts_json(const DepthResult& result, const DepthOptions& options) {
    Json views = Json::array();
    for (const DepthEvidence& view : result.evidence) {
        views.push_back({{"name", view.view_name},
                         {"model", view.model},
                         {"confident_share", view.confident_share},
                         {"background_share", view.background_share},
                         {"sparse_residual_px", view.sparse_residual_px}});
    }
    Json facts{{"subject", subject_json(result, options)}, {"views", std::move(views)}};
    if (!result.choice.empty()) facts["choice"] = result.choice;
    if (!result.warning.empty()) facts["warning"] = result.warning;
    return facts;
}

Json timings_json(const DepthResult& result) {
    Json cpu_s = Json::object();
    for (const DepthEvidence& view : result.evidence) cpu_s[view.view_name] = view.cpu_s;
    return Json{{"cpu_s", std::move(cpu_s)}, {"expected_peak_mib", result.memory.peak() >> 20}};
}

}  // namespace

StageEvidence run_depth_stage(const PosedPhotographs& photographs, const MaskedPhotographs& masked,
                              DepthOptions options, const std::filesystem::path& folder,
                              int threads, Progress& progress) {
    if (!masked.mask_folder.empty()) {
        options.mask_folder = folder / kMaskFolder;
        straighten_masks(masked, options.mask_folder, threads, progress);
    }
    if (!options.import_folder.empty()) {
        options.imported_files =
            straighten_depth({options.import_folder, options.import_png_unit}, photographs.capture,
                             masked.poses_folder, folder / kImportedDepthFolder, threads, progress);
    }
    const DepthResult result =
        estimate_depth(photographs, all_views(photographs.capture), options, threads, progress);
    write_depth_files(folder, file_stems_of_views(view_names(photographs.capture)),
                      result.depth_maps, threads);
    return {json_text(facts_json(result, options)), json_text(timings_json(result))};
}

}  // namespace lumi
