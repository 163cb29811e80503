#include "calib/doctor/examination.h"

#include <algorithm>
#include <cmath>

#include "calib/matching/camera_groups.h"
#include "calib/matching/inlier_shares.h"
#include "calib/matching/pair_verification.h"
#include "calib/matching/photograph_matching.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"
#include "calib/work/whole_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDuplicate = "E-INGEST-DUPLICATE";
constexpr double kMaxErrorShare = 0.0025;  ///< Of the longer side, off the epipolar line.

int count_of_duplicates(const std::vector<LeftOut>& left_out) {
    return static_cast<int>(std::count_if(left_out.begin(), left_out.end(), [](const auto& entry) {
        return entry.code == kDuplicate;
    }));
}

std::vector<PhotographQuality> qualities_of(const std::vector<Photograph>& photographs,
                                            const std::vector<Features>& features, int threads) {
    std::vector<PhotographQuality> qualities(photographs.size());
    parallel_for(static_cast<int>(photographs.size()), threads, [&](int position) {
        const auto index = static_cast<std::size_t>(position);
        qualities[index] = quality_of(read_color_image(photographs[index].picture_path));
        qualities[index].name = photographs[index].name;
        qualities[index].features = static_cast<int>(features[index].size());
    });
    return qualities;
}

std::vector<ColmapPhotograph> keypoints_of(const std::vector<Features>& features,
                                           const CameraGroups& groups) {
    std::vector<ColmapPhotograph> photographs;
    for (std::size_t index = 0; index < features.size(); ++index) {
        ColmapPhotograph photograph{groups.camera_of_photograph[index], {}};
        for (const Keypoint& keypoint : features[index].keypoints) {
            photograph.keypoints_px.push_back(keypoint.pixel);
        }
        photographs.push_back(std::move(photograph));
    }
    return photographs;
}

void look_at_pairs(CaptureEvidence& evidence, const std::vector<Features>& features,
                   const CameraGroups& groups, bool lens_is_calibrated, int threads,
                   Progress& progress) {
    const std::vector<PairMatches> matches = match_photographs(features, threads, progress);
    const std::vector<ColmapPhotograph> photographs = keypoints_of(features, groups);
    PairVerificationOptions verification;
    verification.max_error_px =
        std::min(verification.max_error_px, std::max(1.5, kMaxErrorShare * evidence.width_px));
    const std::vector<VerifiedPair> verified = verify_pairs(
        matches, groups.cameras, photographs, lens_is_calibrated, verification, threads, progress);
    evidence.inlier_shares = inlier_shares_of(matches, verified);
    evidence.pairs.resize(verified.size());
    parallel_for(static_cast<int>(verified.size()), threads, [&](int position) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(position);
        evidence.pairs[index] = pair_geometry_of(verified[index], photographs, groups.cameras);
    });
    std::vector<const VerifiedPair*> pairs;
    for (const VerifiedPair& pair : verified) pairs.push_back(&pair);
    evidence.loops = follow_matches(photographs, pairs);
    evidence.motion =
        check_motion(groups.cameras, photographs, verified, lens_is_calibrated, progress);
}

std::vector<Eigen::Vector2i> sizes_in_build(const std::vector<Photograph>& photographs,
                                            int build_width_px) {
    std::vector<Eigen::Vector2i> sizes;
    for (const Photograph& photograph : photographs) {
        const double longer = std::max(photograph.original_width_px, photograph.original_height_px);
        const double scale = build_width_px == 0 ? 1.0 : std::min(1.0, build_width_px / longer);
        sizes.emplace_back(static_cast<int>(std::lround(scale * photograph.original_width_px)),
                           static_cast<int>(std::lround(scale * photograph.original_height_px)));
    }
    return sizes;
}

/// Small copies, of all that a build would take.
IngestOptions options_of_copies(const ExaminationOptions& options) {
    IngestOptions of_copies = options.build;
    of_copies.judged_width_px = options.build.max_width_px;
    of_copies.max_width_px = options.width_px;
    of_copies.min_photographs = 1;
    return of_copies;
}

int longer_side_px(const Photograph& photograph) {
    return std::max(photograph.width_px, photograph.height_px);
}

}  // namespace

// A photograph costs what matching it costs, and its pixels what depth and packing do. Within two
// times of what captures of 11 to 97 photographs took on two cores of a server. Memory is what
// poses take of the largest one, and what all take when they are packed and drawn; within a quarter
// of the peaks of captures of 9 to 97. Those of too few photographs to be asked take half of it.
ExpectedCost expected_cost(const std::vector<Eigen::Vector2i>& sizes_px) {
    constexpr double kCpuPerPhotograph_s = 1.0;
    constexpr double kCpuPerMegapixel_s = 3.0;
    constexpr double kBase_mib = 540;
    constexpr double kPerMegapixelOfLargest_mib = 400;
    constexpr double kPerMegapixel_mib = 10;
    double megapixels = 0;
    double largest = 0;
    for (const Eigen::Vector2i& size : sizes_px) {
        const double own = 1e-6 * size.x() * size.y();
        megapixels += own;
        largest = std::max(largest, own);
    }
    return {kCpuPerPhotograph_s * static_cast<double>(sizes_px.size()) +
                kCpuPerMegapixel_s * megapixels,
            kBase_mib + kPerMegapixelOfLargest_mib * largest + kPerMegapixel_mib * megapixels};
}

Examination examine_capture(const fs::path& photographs_or_video,
                            const std::optional<Camera>& given_lens,
                            const ExaminationOptions& options, const fs::path& folder, int threads,
                            Progress& progress) {
    const Stopwatch stopwatch;
    const WholeFolder copies(folder / "copies");
    IngestResult ingested = ingest(photographs_or_video, options_of_copies(options),
                                   copies.staging(), threads, progress);
    for (Photograph& photograph : ingested.photographs) {
        if (options.told_focal_length_px) photograph.focal_length_px = options.told_focal_length_px;
    }

    Examination result;
    CaptureEvidence& evidence = result.evidence;
    evidence.width_px = options.width_px;
    evidence.duplicates_left_out = count_of_duplicates(ingested.left_out);
    evidence.min_photographs = std::max(evidence.min_photographs, options.build.min_photographs);
    result.left_out = std::move(ingested.left_out);
    result.overlays = std::move(ingested.overlays);
    result.color_notes = std::move(ingested.color_notes);
    for (RemovedOverlay& overlay : result.overlays) overlay.mask_path.clear();  // It does not stay.
    if (!ingested.photographs.empty()) {
        const CameraGroups groups = group_cameras(ingested.photographs, given_lens, {});
        evidence.focal_lengths_are_known =
            options.lens_is_told_elsewhere || focal_lengths_are_known(groups);
        SiftOptions sift;
        sift.max_features = options.max_features;
        const std::vector<Features> features =
            detect_features(ingested.photographs, options.mask_folder, sift, threads, progress);
        evidence.width_px = 0;
        for (const Photograph& photograph : ingested.photographs)
            evidence.width_px = std::max(evidence.width_px, longer_side_px(photograph));
        evidence.photographs = qualities_of(ingested.photographs, features, threads);
        look_at_pairs(evidence, features, groups, given_lens.has_value(), threads, progress);
    }
    result.build_sizes_px = sizes_in_build(ingested.photographs, options.build.max_width_px);
    result.build = expected_cost(result.build_sizes_px);
    result.findings = diagnose(evidence);
    result.cost = stopwatch.elapsed();
    return result;
}

}  // namespace lumi
