#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/work/progress.h"
#include "pipeline/evaluate/common_pixels.h"
#include "pipeline/evaluate/judged_view.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Scores of all held-out views drawn by another method.
struct RivalScores {
    std::string method;  ///< With the mode that it is drawn in where it is resampled.
    std::vector<ViewScore> views;
    double resampling_cpu_s = 0.0;  ///< Before the first frame.
};

/// A method that cannot draw from this Lumigraph.
struct RivalLeftOut {
    std::string method;
    std::string reason;
};

/// Every mode and every other method on the same pixels (common_pixels.h). Where a method covers
/// nothing it has the colours of the surroundings (surroundings.h), the same for all.
struct CommonPixelScores {
    struct Method {
        std::string name;
        std::optional<double> psnr_db;  ///< Mean over the views that have such pixels.
    };
    double share = 0.0;  ///< Of all pixels, that all methods that have a say cover.
    std::vector<Method> methods;
};

struct RivalEvaluation {
    std::vector<RivalScores> methods;
    std::vector<RivalLeftOut> left_out;
    std::optional<CommonPixelScores> common = {};  ///< Empty where it was not measured.
};

/// Called once per method and view, in order, with what is to be kept of it.
using JudgedRivalSink = std::function<void(const ComparedMethod& method, const JudgedView& view)>;

/// Draws every view of `held_out` from the Lumigraph by the methods that the paper is compared with
/// (render/rivals/rival_methods.h), as evaluate_held_out does in lumi's modes. Plain code draws
/// each frame once, and what it does not cover has the colours of the surroundings
/// (surroundings.h), as in lumi's modes but for those of papers, which are black there. What is
/// resampled is drawn in the modes `lightfield` and `adaptive`. Throws Error (E-GL-...).
[[nodiscard]] RivalEvaluation evaluate_rivals(const Lumigraph& lumigraph,
                                              const PosedPhotographs& held_out,
                                              const SubjectMask& subject_mask, int timed_frames,
                                              const JudgedRivalSink& keep, Progress& progress);

}  // namespace lumi
