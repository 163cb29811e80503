#include "pipeline/hazards/trial.h"

#include <algorithm>
#include <cmath>

#include "calib/doctor/examination.h"
#include "calib/ingest/ingest.h"
#include "calib/pictures/image_io.h"
#include "calib/poses/pose_stage.h"
#include "calib/work/error.h"
#include "calib/work/stopwatch.h"
#include "calib/work/whole_folder.h"
#include "pipeline/hazards/colmap_alone.h"
#include "pipeline/hazards/hazard_capture.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

NamedPoses true_poses(const HazardCapture& capture) {
    NamedPoses poses;
    for (const HazardCapture::Photo& photo : capture.photos) {
        poses[photo.name] = photo.cam_from_world;
    }
    return poses;
}

/// Poses that came out, against the truth.
void judge(Attempt& attempt, const Capture& estimated, const HazardCapture& capture) {
    for (const View& view : estimated.views) {
        const auto photo = std::find_if(capture.photos.begin(), capture.photos.end(),
                                        [&](const auto& taken) { return taken.name == view.name; });
        if (photo == capture.photos.end()) continue;
        const double ratio =
            focal_length_px(camera_of(estimated, view)).x() / focal_length_px(photo->camera).x();
        attempt.focal_error_share = std::max(attempt.focal_error_share, std::abs(ratio - 1));
    }
    attempt.error = pose_shift(named_poses(estimated), true_poses(capture));
    const bool is_right = attempt.error.position_share <= kMaxPositionErrorShare &&
                          attempt.error.rotation_deg <= kMaxRotationError_deg;
    attempt.ending = is_right ? Ending::kRight : Ending::kFalse;
}

void judge(Attempt& attempt, const Error& error) {
    const bool is_named =
        error.kind() == ErrorKind::kDegenerateCapture || error.kind() == ErrorKind::kBadInput;
    attempt.ending = is_named ? Ending::kRefused : Ending::kFailed;
    attempt.code = error.code();
    attempt.what = error.what();
}

void tell_focal_length(std::vector<Photograph>& photographs, const HazardCapture& capture) {
    for (Photograph& photograph : photographs) {
        photograph.focal_length_px = capture.told_focal_length_px;
    }
}

void try_lumi(Trial& trial, const HazardCapture& capture, const fs::path& folder,
              const TrialOptions& options, Progress& progress) {
    const Stopwatch stopwatch;
    try {
        IngestResult ingested =
            ingest(folder / "photos", {}, folder / "copies", options.threads, progress);
        tell_focal_length(ingested.photographs, capture);
        const PoseResult result = estimate_poses(ingested.photographs, std::nullopt, {},
                                                 folder / "scratch", options.threads, progress);
        judge(trial.lumi, result.capture, capture);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::kInterrupted) throw;
        judge(trial.lumi, error);
    }
    trial.lumi.cpu_s = stopwatch.elapsed().cpu_s;
}

void ask_doctor(Trial& trial, const HazardCapture& capture, const fs::path& folder,
                const TrialOptions& options, Progress& progress) {
    const Stopwatch stopwatch;
    ExaminationOptions examination;
    examination.told_focal_length_px = capture.told_focal_length_px;
    const Examination seen = examine_capture(folder / "photos", std::nullopt, examination,
                                             folder / "doctor", options.threads, progress);
    if (seen.verdict() >= Severity::kRisk) trial.doctor_reason = seen.findings.front().reason;
    trial.doctor_cpu_s = stopwatch.elapsed().cpu_s;
}

void try_colmap(Trial& trial, const HazardCapture& capture, const fs::path& folder,
                const TrialOptions& options, Progress& progress) {
    const ColmapAlone alone =
        reconstruct_with_colmap_alone(folder / "photos", capture.told_focal_length_px,
                                      folder / "colmap", options.colmap_time_limit_s, progress);
    trial.colmap.cpu_s = alone.cpu_s;
    trial.colmap.what = alone.ending;
    if (alone.model) {
        judge(trial.colmap, *alone.model, capture);
    } else {
        trial.colmap.ending = alone.ended_by_itself ? Ending::kRefused : Ending::kFailed;
    }
}

void write_photographs(const HazardCapture& capture, const fs::path& folder) {
    for (const HazardCapture::Photo& photo : capture.photos) {
        write_png(folder / "photos" / photo.name, photo.picture);
    }
}

}  // namespace

std::string_view name_of(Ending ending) {
    switch (ending) {
        case Ending::kRight:
            return "right";
        case Ending::kRefused:
            return "refused";
        case Ending::kFalse:
            return "false";
        case Ending::kFailed:
            return "failed";
        case Ending::kNotTried:
            return "not tried";
    }
    return {};
}

Trial run_trial(Hazard hazard, double strength, std::uint64_t seed, const TrialOptions& options,
                const fs::path& scratch_of, Progress& progress) {
    const HazardCapture capture =
        photograph_hazard(hazard, strength, seed, options.threads, progress);
    const WholeFolder scratch(scratch_of);
    const fs::path& folder = scratch.staging();
    write_photographs(capture, folder);
    Trial trial{hazard, strength, seed, static_cast<int>(capture.photos.size()), {}, {}, {}, 0, {}};
    try_lumi(trial, capture, folder, options, progress);
    ask_doctor(trial, capture, folder, options, progress);
    if (options.with_colmap) try_colmap(trial, capture, folder, options, progress);
    trial.given_reason = trial.doctor_reason;
    if (trial.lumi.ending == Ending::kRefused) {
        const auto refused_for = reason_with_code(trial.lumi.code);
        if (refused_for && is_cause(*refused_for)) trial.given_reason = refused_for;
    }
    return trial;
}

bool reason_is_right(const Trial& trial) {
    if (trial.given_reason == curve_of(trial.hazard).reason) return true;
    return trial.lumi.ending == Ending::kRight && !trial.given_reason;
}

}  // namespace lumi
