#include "calib/poses/colmap_front_end.h"

#include <system_error>

#include "calib/pictures/drawn_mask.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// COLMAP knows photographs by the names in a folder: links to the working copies, or copies of
/// them on file systems that have no links.
void link_pictures(const std::vector<Photograph>& photographs, const fs::path& folder) {
    fs::create_directories(folder);
    for (std::size_t index = 0; index < photographs.size(); ++index) {
        const fs::path link = folder / colmap_image_name(static_cast<int>(index));
        std::error_code status;
        fs::create_symlink(fs::absolute(photographs[index].picture_path), link, status);
        if (status) fs::copy_file(photographs[index].picture_path, link, status);
        if (!status) continue;
        throw Error(ErrorKind::kResources, "E-FILE-WRITE",
                    link.string() + ": cannot be made: " + status.message(),
                    "check that you may write there and that the disk has space left");
    }
}

/// Masks as COLMAP expects them, NAME.png of each picture; empty without masks.
fs::path write_masks(const MappingJob& job, const fs::path& folder) {
    if (job.options.mask_folder.empty()) return {};
    expect_own_masks(names_of(job.photographs), job.options.mask_folder);
    for (std::size_t index = 0; index < job.photographs.size(); ++index) {
        const Photograph& photograph = job.photographs[index];
        write_png(folder / (colmap_image_name(static_cast<int>(index)) + ".png"),
                  drawn_mask(photograph.name, photograph.width_px, photograph.height_px,
                             job.options.mask_folder));
    }
    return folder;
}

ExtractorSettings extractor_settings(const MappingJob& job, FeatureDetail detail) {
    ExtractorSettings settings;
    settings.max_features = job.options.max_features;
    if (detail == FeatureDetail::kMore) {
        settings.max_features *= 2;
        settings.peak_threshold /= 2;
    }
    return settings;
}

}  // namespace

ColmapProgram colmap_of(const MappingJob& job) {
    return {job.options.colmap, job.scratch_folder, job.options.time_limit_s};
}

void record(PoseEvidence& evidence, const ColmapRun& run) {
    evidence.calls.push_back({run.command_line, run.result.wall_s, run.result.cpu_s});
}

void expect_ended(const ColmapRun& run, const MappingJob& job, const std::string& command) {
    if (run.result.end == ChildEnd::kExited) return;
    throw Error(ErrorKind::kExternalProgram, "E-COLMAP-TIME",
                job.options.colmap + " " + command + ": " + run.ending,
                "raise [poses] time_limit_s, or lower max_features");
}

MatchedPhotographs match_with_colmap_alone(const MappingJob& job, FeatureDetail detail,
                                           const std::string& name) {
    MatchedPhotographs result;
    result.name = name;
    result.database = job.scratch_folder / (name + ".db");
    for (const int camera : job.groups.camera_of_photograph) {
        result.photographs.push_back({camera, {}});
    }
    const fs::path pictures = job.scratch_folder / (name + "_pictures");
    link_pictures(job.photographs, pictures);
    const fs::path masks = write_masks(job, job.scratch_folder / (name + "_masks"));
    record(job.evidence, create_colmap_database(colmap_of(job), result.database, job.progress));
    fill_colmap_database(result.database, job.groups.cameras, result.photographs,
                         KeypointsIn::kNothing);
    const int threads = resolve_threads(job.threads);
    job.progress.begin("finding features with COLMAP", job.photographs.size());
    const ColmapRun extraction = extract_features_with_colmap(
        colmap_of(job), result.database, pictures, masks, extractor_settings(job, detail), threads,
        [&](int count) { job.progress.advance(static_cast<std::size_t>(count)); }, job.progress);
    record(job.evidence, extraction);
    expect_ended(extraction, job, "feature_extractor");
    read_keypoints(result.database, result.photographs);
    job.progress.begin("comparing photographs with COLMAP", 0);
    const ColmapRun matching =
        match_with_colmap(colmap_of(job), result.database, threads, job.progress);
    record(job.evidence, matching);
    expect_ended(matching, job, "exhaustive_matcher");
    const std::size_t count = job.photographs.size();
    result.pairs =
        read_verified_pairs(result.database, result.photographs, count * (count - 1) / 2);
    return result;
}

}  // namespace lumi
