#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/doctor/diagnosis.h"
#include "calib/ingest/ingest.h"
#include "calib/work/progress.h"
#include "calib/work/stopwatch.h"

namespace lumi {

/// How closely the doctor looks.
struct ExaminationOptions {
    int width_px = 800;                      ///< Longer sides are scaled down to this. >= 64.
    int max_features = 1500;                 ///< Per photograph. > 0.
    IngestOptions build = {};                ///< Those of the build that is asked about.
    std::filesystem::path mask_folder = {};  ///< See PoseOptions; empty: none.
    bool lens_is_told_elsewhere = false;     ///< A build will know it: from boards, or with poses.
    std::optional<double> told_focal_length_px;  ///< For the size looked at, instead of EXIF's.
};

/// What a build of these photographs will probably take.
struct ExpectedCost {
    double cpu_s = 0.0;     ///< Within a factor of two or so.
    double peak_mib = 0.0;  ///< Within a quarter or so.
};

/// From the sizes of the photographs, as a build scales them.
[[nodiscard]] ExpectedCost expected_cost(const std::vector<Eigen::Vector2i>& sizes_px);

/// What the doctor saw, and what to do about it.
struct Examination {
    CaptureEvidence evidence;
    std::vector<LeftOut> left_out;
    std::vector<RemovedOverlay> overlays;
    std::vector<std::string> color_notes;  ///< See IngestResult.
    std::vector<Finding> findings;         ///< The worst first.
    ExpectedCost build;
    std::vector<Eigen::Vector2i> build_sizes_px;  ///< Of the photographs, as a build scales them.
    Cost cost;                                    ///< Of the examination.

    [[nodiscard]] Severity verdict() const {
        return findings.empty() ? Severity::kNote : findings.front().severity;
    }
};

/// Looks at photographs (or a video) before the long step: ingest, features, matches and two-view
/// geometry on small copies, without placing anything. `given_lens`, if any, is the lens of all
/// photographs. The copies lie in a hidden folder of their own within `folder`, which is made, and
/// are gone at the end, however it comes. Throws Error (E-INGEST-..., E-FILE-WRITE).
[[nodiscard]] Examination examine_capture(const std::filesystem::path& photographs_or_video,
                                          const std::optional<Camera>& given_lens,
                                          const ExaminationOptions& options,
                                          const std::filesystem::path& folder, int threads,
                                          Progress& progress);

}  // namespace lumi
