#include "pipeline/stages/poses_stage.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/undistortion.h"
#include "calib/poses/imported_model_check.h"
#include "calib/poses/imported_pose_check.h"
#include "pipeline/stages/left_out_json.h"
#include "pipeline/stages/lens_choice_json.h"
#include "pipeline/stages/photograph_list.h"
#include "pipeline/stages/posed_files.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

PoseResult find_poses(const IngestResult& ingested, const PoseSource& source,
                      const fs::path& scratch_folder, int threads, Progress& progress) {
    if (!source.imported_poses.empty()) {
        PoseResult result =
            import_poses(ingested.photographs, ingested.left_out, source.imported_poses);
        expect_consistent(result.capture);
        // No other confirms a photograph alone.
        if (result.capture.views.size() < 2) return result;
        const std::string warning = warning_of(check_imported_poses(
            result.capture, ingested.photographs, source.options.mask_folder, threads, progress));
        if (!warning.empty()) result.evidence.warnings.push_back(warning);
        return result;
    }
    PoseResult result = estimate_poses(ingested.photographs, source.given_lens, source.options,
                                       scratch_folder, threads, progress);
    fs::remove_all(scratch_folder);
    return result;
}

std::vector<fs::path> working_copies(const Capture& capture,
                                     const std::vector<Photograph>& photographs) {
    std::map<std::string, fs::path> path_of;
    for (const Photograph& photograph : photographs) {
        path_of[photograph.name] = photograph.picture_path;
    }
    std::vector<fs::path> paths;
    for (const View& view : capture.views) paths.push_back(path_of.at(view.name));
    return paths;
}

Json lenses_json(const std::vector<Camera>& cameras, const std::vector<LensEvidence>& evidence) {
    Json json = Json::array();
    for (std::size_t index = 0; index < cameras.size(); ++index) {
        const Camera& camera = cameras[index];
        Json lens{{"model", name_of(camera.model)},
                  {"width_px", camera.width_px},
                  {"height_px", camera.height_px},
                  {"names", parameter_names(camera.model)},
                  {"parameters", camera.parameters}};
        // Imported lenses come without any.
        if (index < evidence.size()) {
            lens["sigma"] = evidence[index].sigma;
            lens["form"] = text_of(evidence[index].form);
            lens["views"] = evidence[index].views;
            lens["dropped"] = evidence[index].dropped;
            if (evidence[index].choice) {
                lens["compared"] = lens_choice_json(*evidence[index].choice);
            }
        }
        json.push_back(std::move(lens));
    }
    return json;
}

Json uncertainty_json(const std::vector<ViewUncertainty>& views) {
    Json json = Json::array();
    for (const ViewUncertainty& view : views) {
        json.push_back({{"name", view.name},
                        {"jitter_px", view.jitter_px},
                        {"position_sigma", view.position_sigma},
                        {"rotation_sigma_deg", view.rotation_sigma_deg}});
    }
    return json;
}

double largest_jitter_px(const std::vector<ViewUncertainty>& views) {
    double largest = 0;
    for (const ViewUncertainty& view : views) largest = std::max(largest, view.jitter_px);
    return largest;
}

Json facts_json(const PoseResult& result) {
    const PoseEvidence& evidence = result.evidence;
    return Json{{"photographs_total", evidence.photographs_total},
                {"photographs_registered", evidence.photographs_registered},
                {"points", evidence.points},
                {"observations", evidence.observations},
                {"mean_reprojection_error_px", evidence.mean_reprojection_error_px},
                {"median_triangulation_angle_deg", evidence.median_triangulation_angle_deg},
                {"models_found", evidence.models_found},
                {"start", evidence.start},
                {"pairs_verified", evidence.pairs_verified},
                {"planar_or_rotation_share", evidence.planar_or_rotation_share},
                {"noise_px", evidence.noise_px},
                {"largest_jitter_px", largest_jitter_px(evidence.views)},
                {"shutter_variance_ratio", evidence.residual_pattern.shutter_ratio},
                {"zoom_variance_ratio", evidence.residual_pattern.zoom_ratio},
                {"contradicted_share", evidence.contradicted_share},
                {"warnings", evidence.warnings},
                {"lenses", lenses_json(result.capture.cameras, evidence.lenses)},
                {"views", uncertainty_json(evidence.views)},
                {"not_registered", left_out_json(result.not_registered)}};
}

Json timings_json(const PoseEvidence& evidence) {
    Json calls = Json::array();
    for (const ColmapCall& call : evidence.calls) {
        calls.push_back(
            {{"command_line", call.command_line}, {"wall_s", call.wall_s}, {"cpu_s", call.cpu_s}});
    }
    return Json{{"colmap_calls", std::move(calls)}};
}

/// In one line those that follow each other and lack a pose for the same reason.
void note_missing_poses(const std::vector<LeftOut>& not_registered, Progress& progress) {
    constexpr std::ptrdiff_t kNamed = 3;
    for (auto first = not_registered.begin(); first != not_registered.end();) {
        const auto end = std::find_if(first, not_registered.end(), [&](const LeftOut& other) {
            return other.code != first->code || other.reason != first->reason;
        });
        std::string names;
        for (auto one = first; one != end && one - first < kNamed; ++one)
            names += (one == first ? "" : ", ") + one->name;
        if (end - first > kNamed) names += " and " + std::to_string(end - first - kNamed) + " more";
        progress.note("no pose for " + names + " (" + first->code + "): " + first->reason);
        first = end;
    }
}

}  // namespace

StageEvidence run_poses_stage(const fs::path& ingest_folder, const PoseSource& source,
                              const fs::path& folder, int threads, Progress& progress) {
    const IngestResult ingested = read_photograph_list(ingest_folder);
    const PoseResult result = find_poses(ingested, source, folder / "scratch", threads, progress);
    write_colmap_model_binary(result.capture, folder / "sparse");
    for (const std::string& warning : result.evidence.warnings) progress.note(warning);
    note_missing_poses(result.not_registered, progress);
    const fs::path pinhole_folder = folder / "pinhole";
    write_posed_photographs(
        pinhole_folder,
        undistort(result.capture, working_copies(result.capture, ingested.photographs),
                  pinhole_folder, threads, progress));
    return {json_text(facts_json(result)), json_text(timings_json(result.evidence))};
}

}  // namespace lumi
