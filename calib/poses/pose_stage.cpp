#include "calib/poses/pose_stage.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <system_error>

#include "calib/poses/explained_refusal.h"
#include "calib/poses/firm_joints.h"
#include "calib/poses/incremental_mapping.h"
#include "calib/poses/mapping_ladder.h"
#include "calib/poses/model_check.h"
#include "calib/poses/model_doubts.h"
#include "calib/poses/order_of_taking.h"
#include "calib/poses/own_focal_lengths.h"
#include "calib/poses/own_lenses.h"
#include "calib/poses/point_colors.h"
#include "calib/poses/refinement.h"
#include "calib/poses/registration.h"
#include "calib/poses/stated_uncertainty.h"
#include "calib/poses/verified_matching.h"
#include "calib/work/counted.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

void make_empty(const fs::path& folder) {
    std::error_code status;
    fs::remove_all(folder, status);
    fs::create_directories(folder, status);
    if (status) {
        throw Error(ErrorKind::kResources, "E-FILE-WRITE",
                    folder.string() + ": cannot be made: " + status.message(),
                    "check that you may write there and that the disk has space left");
    }
}

void expect_photographs(const std::vector<Photograph>& photographs) {
    if (photographs.size() >= 2) return;
    throw Error(ErrorKind::kBadInput, "E-POSES-FEW",
                photographs.empty() ? "there are no photographs: at least two are needed"
                                    : "one photograph is not enough: at least two are needed",
                "add photographs of the same subject from other places");
}

/// What `work` returns; what it refuses may be an effect, and the evidence may name the cause.
template <class Work>
auto or_explain(const MappingJob& job, const MatchedPhotographs& matched, const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::kDegenerateCapture) throw;
        refuse_explained(job, matched,
                         reason_with_code(error.code()).value_or(CaptureReason::kUncertain),
                         error.what());
    }
}

MatchedPhotographs matched_photographs(const MappingJob& job) {
    MatchedPhotographs matched = or_explain(job, {}, [&] { return match_and_verify(job); });
    refuse_turning_camera(matched.motion);
    return matched;
}

Capture mapped_photographs(const MappingJob& job, MatchedPhotographs& matched) {
    std::optional<Capture> mapped = job.options.mapper == PoseProgram::kColmap
                                        ? map_by_ladder(job, matched)
                                        : map_incrementally(job, matched);
    if (!mapped) {
        refuse_capture(CaptureReason::kNoPair, "no two of the " +
                                                   std::to_string(job.photographs.size()) +
                                                   " photographs share enough to start from");
    }
    return std::move(*mapped);
}

/// What the photographs were taken to show, so far.
struct PosesInQuestion {
    Capture mapped;             ///< Before the refinement, with the observations that it dropped.
    Capture refined;            ///< After it.
    std::string joint_trouble;  ///< JointCheck::trouble.
    std::vector<std::string> warnings;  ///< Of second models that were taken.
};

PosesInQuestion refined_from(JointCheck joints, LensPolicy policy, const MappingJob& job) {
    PosesInQuestion poses{joints.mapped, std::move(joints.mapped), std::move(joints.trouble), {}};
    refine(poses.refined, policy, job.options, job.threads, job.evidence, job.progress);
    return poses;
}

/// Joints tell nothing of a camera that only turned: they are asked about where the mapped model
/// shows parallax, or else where the refined one does.
PosesInQuestion refined_with_firm_joints(const Capture& mapped, LensPolicy policy,
                                         const MappingJob& job, const MatchedPhotographs& matched) {
    if (lacks_parallax(matched.motion, mapped)) {
        PoseEvidence evidence = job.evidence;
        PosesInQuestion unasked = refined_from({mapped, {}}, policy, with_evidence(job, evidence));
        if (lacks_parallax(matched.motion, unasked.refined)) {
            job.evidence = std::move(evidence);
            return unasked;
        }
    }
    return refined_from(with_firm_joints(job, mapped), policy, job);
}

/// By a second model, where the first is in doubt.
void replace_if_in_doubt(PosesInQuestion& poses, LensPolicy policy, const MappingJob& job,
                         MatchedPhotographs& matched) {
    const auto take = [&](SecondModel model) {
        poses.mapped = std::move(model.mapped);
        poses.refined = std::move(model.refined);
        poses.joint_trouble = std::move(model.joint_trouble);
        poses.warnings.push_back(std::move(model.warning));
    };
    if (auto in_order = find_model_in_order(job, matched, policy, poses.refined))
        take(std::move(*in_order));
    if (auto own = find_own_lenses(job, matched, policy, poses.refined)) take(std::move(*own));
    if (auto own = find_own_focal_lengths(job, policy, poses.mapped, poses.refined)) {
        own->joint_trouble = poses.joint_trouble;
        take(std::move(*own));
    }
}

/// Throws Error (E-POSES-...) where the poses do not stand.
void settle(const PosesInQuestion& poses, const MappingJob& job,
            const MatchedPhotographs& matched) {
    settle_doubts(job, matched, poses.mapped, poses.refined);
    if (!poses.joint_trouble.empty())
        refuse_contradiction(job, matched, CaptureReason::kSplit, poses.joint_trouble);
}

void append_warnings(std::vector<std::string>& warnings, std::vector<std::string> more) {
    std::move(more.begin(), more.end(), std::back_inserter(warnings));
}

void refuse_too_few(const Capture& capture, const std::vector<Photograph>& photographs,
                    const std::vector<LeftOut>& not_registered, const PoseOptions& options) {
    const double total = static_cast<double>(photographs.size());
    const double placed = static_cast<double>(capture.views.size());
    if (capture.views.size() >= 2 && placed >= options.min_registered_share * total) return;
    std::string names;
    for (std::size_t index = 0; index < std::min<std::size_t>(not_registered.size(), 5); ++index) {
        names += (index == 0 ? "; " : ", ") + not_registered[index].name;
    }
    throw Error(ErrorKind::kDegenerateCapture, "E-POSES-FEW",
                "only " + std::to_string(capture.views.size()) + " of " +
                    counted(photographs.size(), "photograph") + " could be placed" + names +
                    (not_registered.size() > 5 ? ", ... were not" : ""),
                "add photographs between those that are far apart, so that each overlaps by two "
                "thirds with the next" +
                    std::string(placed < 2 ? "" : "; or lower [poses] min_registered_share"));
}

std::vector<fs::path> picture_paths_of(const Capture& capture,
                                       const std::vector<Photograph>& photographs) {
    std::map<std::string, fs::path> path_of_name;
    for (const Photograph& photograph : photographs) {
        path_of_name.emplace(photograph.name, photograph.picture_path);
    }
    std::vector<fs::path> paths;
    for (const View& view : capture.views) paths.push_back(path_of_name.at(view.name));
    return paths;
}

void complete(PoseEvidence& evidence, const Capture& capture, const MatchedPhotographs& matched) {
    evidence.photographs_total = static_cast<int>(matched.photographs.size());
    evidence.photographs_registered = static_cast<int>(capture.views.size());
    evidence.points = static_cast<int>(capture.points.size());
    double error_sum = 0;
    for (const ScenePoint& point : capture.points) {
        evidence.observations += static_cast<int>(point.track.size());
        error_sum += point.error_px * static_cast<double>(point.track.size());
    }
    evidence.mean_reprojection_error_px = error_sum / std::max(1, evidence.observations);
    evidence.median_triangulation_angle_deg = median_triangulation_angle_deg(capture);
    evidence.pairs_verified = static_cast<int>(matched.pairs.size());
    evidence.planar_or_rotation_share = matched.motion.planar_share();
}

}  // namespace

PoseResult estimate_poses(const std::vector<Photograph>& photographs,
                          const std::optional<Camera>& given_lens, const PoseOptions& options,
                          const fs::path& scratch_folder, int threads, Progress& progress) {
    validate(options);
    expect_photographs(photographs);
    make_empty(scratch_folder);
    PoseResult result;
    const CameraGroups groups =
        group_cameras(photographs, given_lens,
                      {.lens_model = options.lens_model, .shared_lens = options.shared_lens});
    const MappingJob job{.photographs = photographs,
                         .groups = groups,
                         .options = options,
                         .lens_is_calibrated = given_lens.has_value(),
                         // A given lens is held until there are poses to judge it by.
                         .refine_lens = !given_lens,
                         .scratch_folder = scratch_folder,
                         .threads = threads,
                         .progress = progress,
                         .evidence = result.evidence};
    const LensPolicy policy = lens_policy(given_lens.has_value(), options);

    MatchedPhotographs matched = matched_photographs(job);
    PosesInQuestion poses = or_explain(job, matched, [&] {
        const Capture mapped = mapped_photographs(job, matched);
        return refined_with_firm_joints(mapped, policy, job, matched);
    });
    replace_if_in_doubt(poses, policy, job, matched);
    append_warnings(result.evidence.warnings,
                    warnings_of_uncertainty(poses.refined, result.evidence.views));
    append_warnings(result.evidence.warnings, std::move(poses.warnings));
    settle(poses, job, matched);

    result.capture = std::move(poses.refined);
    result.not_registered =
        explain_unregistered(result.capture, photographs, matched.photographs, matched.pairs);
    refuse_too_few(result.capture, photographs, result.not_registered, options);
    append_warnings(result.evidence.warnings,
                    check_model(result.capture, focal_lengths_are_known(groups)));
    color_points(result.capture, picture_paths_of(result.capture, photographs), threads);
    complete(result.evidence, result.capture, matched);
    validate(result.capture, "the estimated poses");
    return result;
}

}  // namespace lumi
