#include <algorithm>

#include "calib/poses/mapping.h"
#include "calib/poses/photograph_matching.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

void record(PoseEvidence& evidence, const ColmapRun& run) {
    evidence.calls.push_back({run.command_line, run.result.wall_s, run.result.cpu_s});
}

ColmapProgram colmap_of(const MappingJob& job) {
    return {job.options.colmap, job.scratch_folder, job.options.time_limit_s};
}

[[noreturn]] void refuse_unmatched(const std::vector<ColmapPhotograph>& photographs) {
    std::vector<std::size_t> counts;
    for (const ColmapPhotograph& photograph : photographs) {
        counts.push_back(photograph.keypoints_px.size());
    }
    std::sort(counts.begin(), counts.end());
    throw Error(ErrorKind::kDegenerateCapture, "E-POSES-NOPAIR",
                "no two of the " + std::to_string(photographs.size()) +
                    " photographs show the same things (" +
                    std::to_string(counts[counts.size() / 2]) +
                    " features in the middle photograph)",
                "take sharp photographs that overlap by two thirds with the next one; surfaces "
                "without any texture need something with a pattern in view");
}

}  // namespace

MatchedPhotographs match_and_verify(const MappingJob& job, const SiftOptions& sift,
                                    const std::string& name) {
    const std::vector<Features> features =
        detect_features(job.photographs, sift, job.threads, job.progress);
    MatchedPhotographs result;
    for (std::size_t index = 0; index < features.size(); ++index) {
        ColmapPhotograph photograph{job.groups.camera_of_photograph[index], {}};
        for (const Keypoint& keypoint : features[index].keypoints) {
            photograph.keypoints_px.push_back(keypoint.pixel);
        }
        result.photographs.push_back(std::move(photograph));
    }
    const std::vector<PairMatches> matches = match_photographs(features, job.threads, job.progress);
    if (matches.empty()) refuse_unmatched(result.photographs);

    result.database = job.scratch_folder / (name + ".db");
    const std::filesystem::path match_list = job.scratch_folder / (name + "_matches.txt");
    record(job.evidence, create_colmap_database(colmap_of(job), result.database, job.progress));
    fill_colmap_database(result.database, job.groups.cameras, result.photographs);
    write_whole_text(match_list, colmap_match_list(matches));
    job.progress.begin("verifying pairs of photographs", matches.size());
    const ColmapRun run = verify_matches_with_colmap(
        colmap_of(job), result.database, match_list,
        [&](int pairs) { job.progress.advance(static_cast<std::size_t>(pairs)); }, job.progress);
    record(job.evidence, run);
    if (run.result.end != ChildEnd::kExited) {
        throw Error(ErrorKind::kExternalProgram, "E-COLMAP-TIME",
                    job.options.colmap + " matches_importer: " + run.ending,
                    "raise [poses] time_limit_s, or lower max_features");
    }
    result.pairs = read_verified_pairs(result.database, result.photographs, matches.size());
    if (result.pairs.empty()) refuse_unmatched(result.photographs);
    result.motion =
        check_motion(job.groups.cameras, result.photographs, result.pairs, job.lens_is_calibrated);
    return result;
}

}  // namespace lumi
