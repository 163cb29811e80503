#include "calib/poses/pose_stage.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <system_error>

#include "calib/poses/explained_refusal.h"
#include "calib/poses/firm_joints.h"
#include "calib/poses/mapping.h"
#include "calib/poses/model_check.h"
#include "calib/poses/model_doubts.h"
#include "calib/poses/order_of_taking.h"
#include "calib/poses/own_focal_lengths.h"
#include "calib/poses/own_lenses.h"
#include "calib/poses/point_colors.h"
#include "calib/poses/refinement.h"
#include "calib/poses/registration.h"
#include "calib/poses/stated_uncertainty.h"
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

/// Runs `work`; what it refuses may be an effect, and the evidence may name the cause.
template <class Work>
void or_explain(const MappingJob& job, const MatchedPhotographs& matched, const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::kDegenerateCapture) throw;
        refuse_explained(job, matched,
                         reason_with_code(error.code()).value_or(CaptureReason::kUncertain),
                         error.what());
    }
}

void refuse_without_model(const std::optional<Capture>& mapped, std::size_t photographs) {
    if (mapped) return;
    refuse_capture(CaptureReason::kNoPair, "no two of the " + std::to_string(photographs) +
                                               " photographs share enough to start from");
}

/// Joints tell nothing of a camera that only turned: they are asked about where the mapped model
/// shows parallax, or else where the refined one does.
void refine_with_firm_joints(const MappingJob& job, const MatchedPhotographs& matched,
                             LensPolicy policy, Capture& mapped, std::string& joint_trouble,
                             Capture& refined) {
    const auto ask_joints = [&] {
        JointCheck joints = with_firm_joints(job, mapped);
        mapped = std::move(joints.mapped);
        joint_trouble = std::move(joints.trouble);
    };
    const auto refine_mapped = [&] {
        refined = mapped;
        refine(refined, policy, job.options, job.threads, job.evidence, job.progress);
    };
    const bool seems_turned = lacks_parallax(matched.motion, mapped);
    if (!seems_turned) ask_joints();
    PoseEvidence before = job.evidence;
    refine_mapped();
    if (!seems_turned || lacks_parallax(matched.motion, refined)) return;
    job.evidence = std::move(before);
    ask_joints();
    refine_mapped();
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
    // A given lens is held until there are poses to judge it by.
    const bool refine_lens = !given_lens;
    const MappingJob job{photographs,    groups,  options,  given_lens.has_value(), refine_lens,
                         scratch_folder, threads, progress, result.evidence};

    MatchedPhotographs matched;
    or_explain(job, {}, [&] { matched = match_and_verify(job, FeatureDetail::kUsual, "default"); });
    std::optional<Capture> mapped;
    std::string joint_trouble;
    const LensPolicy policy = lens_policy(given_lens.has_value(), options);
    refuse_turning_camera(matched.motion);
    or_explain(job, matched, [&] {
        mapped = options.mapper == "colmap" ? map_by_ladder(job, matched)
                                            : map_incrementally(job, matched);
        refuse_without_model(mapped, photographs.size());
        refine_with_firm_joints(job, matched, policy, *mapped, joint_trouble, result.capture);
    });
    std::vector<std::string> told;
    const auto take = [&](SecondModel model) {
        mapped = std::move(model.mapped);
        result.capture = std::move(model.refined);
        joint_trouble = std::move(model.joint_trouble);
        told.push_back(std::move(model.warning));
    };
    if (auto in_order = find_model_in_order(job, matched, policy, result.capture))
        take(std::move(*in_order));
    if (auto own = find_own_lenses(job, matched, policy, result.capture)) take(std::move(*own));
    if (auto own = find_own_focal_lengths(job, policy, *mapped, result.capture)) {
        own->joint_trouble = joint_trouble;
        take(std::move(*own));
    }
    for (std::string& warning : warnings_of_uncertainty(result.capture, result.evidence.views)) {
        result.evidence.warnings.push_back(std::move(warning));
    }
    std::move(told.begin(), told.end(), std::back_inserter(result.evidence.warnings));
    settle_doubts(job, matched, *mapped, result.capture);
    if (!joint_trouble.empty()) {
        refuse_contradiction(job, matched, CaptureReason::kSplit, joint_trouble);
    }
    result.not_registered =
        explain_unregistered(result.capture, photographs, matched.photographs, matched.pairs);
    refuse_too_few(result.capture, photographs, result.not_registered, options);
    for (std::string& warning : check_model(result.capture, focal_lengths_are_known(groups))) {
        result.evidence.warnings.push_back(std::move(warning));
    }
    color_points(result.capture, picture_paths_of(result.capture, photographs), threads);
    complete(result.evidence, result.capture, matched);
    validate(result.capture, "the estimated poses");
    return result;
}

}  // namespace lumi
