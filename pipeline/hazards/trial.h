#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "calib/doctor/capture_reason.h"
#include "calib/poses/pose_shift.h"
#include "calib/work/progress.h"
#include "pipeline/hazards/hazard.h"

namespace lumi {

/// Poses count as right up to here: no camera farther from its true place than this share of the
/// cameras' spread, none turned by more.
inline constexpr double kMaxPositionErrorShare = 0.1;
inline constexpr double kMaxRotationError_deg = 2.0;

/// How an attempt at poses ended.
enum class Ending {
    kRight,    ///< Poses, and they are right.
    kRefused,  ///< No poses, with a reason that is named.
    kFalse,    ///< Poses, and at least one of them is wrong: a false success.
    kFailed,   ///< No poses, and no reason but a program that failed.
    kNotTried,
};

[[nodiscard]] std::string_view name_of(Ending ending);

struct Attempt {
    Ending ending = Ending::kNotTried;
    std::string code;  ///< What ended it, when it was refused.
    std::string what;
    PoseShift error;                 ///< Against the truth.
    double focal_error_share = 0.0;  ///< Of the worst lens, where there are poses.
    double cpu_s = 0.0;
};

/// One capture, by lumi, by lumi's doctor, and by COLMAP alone.
struct Trial {
    Hazard hazard = Hazard::kBaseline;
    double strength = 0.0;
    std::uint64_t seed = 0;
    int photographs = 0;
    Attempt lumi;
    Attempt colmap;
    std::optional<CaptureReason> doctor_reason;  ///< The doctor's first finding.
    double doctor_cpu_s = 0.0;
    std::optional<CaptureReason> given_reason;  ///< The refusal's, else the doctor's.
};

struct TrialOptions {
    bool with_colmap = true;           ///< Runs COLMAP alone as well.
    double colmap_time_limit_s = 300;  ///< For each of its programs. > 0.
    int threads = 1;
};

/// Photographs a hazard into a folder beside `scratch_of`, which goes at the end, and tries. The
/// reason given is right when it is the hazard's; where the poses came out right, none at all is
/// right as well.
[[nodiscard]] Trial run_trial(Hazard hazard, double strength, std::uint64_t seed,
                              const TrialOptions& options, const std::filesystem::path& scratch_of,
                              Progress& progress);
[[nodiscard]] bool reason_is_right(const Trial& trial);

}  // namespace lumi
