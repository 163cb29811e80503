#pragma once

#include <functional>

#include "calib/mapping/growing_model.h"
#include "calib/work/progress.h"

namespace lumi {

struct IncrementalMappingOptions {
    bool refine_lenses = true;
    /// Per lens: its focal length is a mere guess, and others are tried where it fits badly.
    std::vector<char> focal_length_is_guessed;
    double max_error_px = 4.0;  ///< Of a sighting that agrees with its point. > 0.
    int min_inliers = 30;       ///< Of a photograph that is added. >= 4.
    double min_inlier_share = 0.25;
    int starts = 4;  ///< Pairs begun with, until one leads to most photographs. > 0.
};

/// A reconstruction photograph by photograph (Snavely, Seitz, Szeliski, SIGGRAPH 2006; Schönberger
/// and Frahm, CVPR 2016): two photographs with many points under a wide angle begin; then, again
/// and again, the one that sees most points, well spread, is placed by resection, sees new points
/// by triangulation, and is adjusted with its neighbours; all are adjusted together each time they
/// have grown by a fifth. Sightings that contradict are dropped, and may come back. When no start
/// places nearly all, the best of several is kept; where none leads anywhere, such as have less
/// parallax are tried. `model` has no photograph placed before (std::invalid_argument otherwise),
/// and none after when nothing came of it. `on_placed` is called with each photograph. On one
/// thread: the same result to the bit in every run. Throws Error (E-INTERRUPTED).
void map_from_start(GrowingModel& model, const std::vector<VerifiedPair>& pairs,
                    const IncrementalMappingOptions& options,
                    const std::function<void(int)>& on_placed, Progress& progress);

/// The loop above without the start: adds to the placed photographs until none can be added.
void grow_model(GrowingModel& model, const IncrementalMappingOptions& options,
                const std::function<void(int)>& on_placed, Progress& progress);

}  // namespace lumi
