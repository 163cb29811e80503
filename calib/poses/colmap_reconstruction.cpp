#include "calib/poses/colmap_reconstruction.h"

#include <system_error>

#include "calib/poses/colmap_front_end.h"
#include "calib/poses/mapping_ladder.h"
#include "calib/work/parallel_for.h"

namespace lumi {

ColmapReconstruction reconstruct_with_colmap(const std::vector<Photograph>& photographs,
                                             const std::optional<Camera>& given_lens,
                                             const PoseOptions& options,
                                             const std::filesystem::path& scratch_folder,
                                             int threads, Progress& progress) {
    std::error_code status;
    std::filesystem::remove_all(scratch_folder, status);
    const std::filesystem::path models = scratch_folder / "models";
    std::filesystem::create_directories(models);
    PoseOptions colmaps = options;
    colmaps.max_features = ExtractorSettings{}.max_features;
    const CameraGroups groups =
        group_cameras(photographs, given_lens,
                      {.lens_model = colmaps.lens_model, .shared_lens = colmaps.shared_lens});
    PoseEvidence evidence;
    const MappingJob job{.photographs = photographs,
                         .groups = groups,
                         .options = colmaps,
                         .lens_is_calibrated = given_lens.has_value(),
                         .refine_lens = !given_lens || options.refine_lens,
                         .scratch_folder = scratch_folder,
                         .threads = resolve_threads(threads),
                         .progress = progress,
                         .evidence = evidence};
    const MatchedPhotographs matched =
        match_with_colmap_alone(job, FeatureDetail::kUsual, "colmap");
    progress.begin("placing photographs with COLMAP alone", photographs.size());
    const ColmapRun mapping = map_with_colmap_defaults(
        colmap_of(job), matched.database, models, job.refine_lens, job.threads,
        [&](int count) { progress.advance(static_cast<std::size_t>(count)); }, progress);
    record(evidence, mapping);
    // What it had made by then is not what COLMAP makes.
    expect_ended(mapping, job, "mapper");
    ColmapReconstruction result;
    if (auto best = read_best_model(models, photographs)) result.capture = std::move(best->capture);
    result.calls = std::move(evidence.calls);
    return result;
}

}  // namespace lumi
