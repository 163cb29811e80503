#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "calib/capture/capture.h"
#include "calib/work/progress.h"

namespace lumi {

/// What COLMAP 3.8 makes of photographs when nobody looks after it.
struct ColmapAlone {
    std::optional<Capture> model;  ///< With most photographs, of those it left; none: it gave up.
    bool ended_by_itself = true;   ///< False when one of its programs had to be killed or crashed.
    std::string ending;
    double cpu_s = 0.0;
};

/// `feature_extractor`, `exhaustive_matcher` and `mapper` with their defaults (without GPU, which
/// needs a display) on a folder of photographs; `focal_length_px`, as EXIF would tell it, if any.
/// `scratch_folder` is emptied and used. Throws Error (E-CHILD-MISSING, E-INTERRUPTED).
[[nodiscard]] ColmapAlone reconstruct_with_colmap_alone(const std::filesystem::path& photographs,
                                                        std::optional<double> focal_length_px,
                                                        const std::filesystem::path& scratch_folder,
                                                        double time_limit_s, Progress& progress);

}  // namespace lumi
