#include "pipeline/stages/ingest_stage.h"

#include <nlohmann/json.hpp>

#include "calib/ingest/overlay_removal.h"
#include "pipeline/stages/left_out_json.h"
#include "pipeline/stages/overlays_json.h"
#include "pipeline/stages/photograph_list.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {

StageEvidence run_ingest_stage(const std::filesystem::path& photographs_or_video,
                               const IngestOptions& options, const std::filesystem::path& folder,
                               int threads, Progress& progress) {
    std::error_code status;
    if (options.video_fps != IngestOptions{}.video_fps &&
        std::filesystem::is_directory(photographs_or_video, status))
        progress.note("[capture] video_fps tells nothing of photographs, and is left aside");
    const IngestResult result = ingest(photographs_or_video, options, folder, threads, progress);
    write_photograph_list(folder, result);
    for (const LeftOut& left_out : result.left_out) {
        progress.note("left out " + left_out.name + " (" + left_out.code + "): " + left_out.reason);
    }
    for (const RemovedOverlay& overlay : result.overlays) progress.note(text_of(overlay));
    for (const std::string& note : result.color_notes) progress.note(note);
    nlohmann::ordered_json facts{{"photographs", result.photographs.size()},
                                 {"left_out", left_out_json(result.left_out)}};
    if (!result.overlays.empty()) facts["overlays"] = overlays_json(result.overlays);
    if (!result.color_notes.empty()) facts["colors"] = result.color_notes;
    return {json_text(facts), "{}"};
}

}  // namespace lumi
