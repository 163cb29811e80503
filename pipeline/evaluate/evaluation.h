#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/work/progress.h"
#include "pipeline/evaluate/judged_view.h"
#include "pipeline/evaluate/rival_evaluation.h"
#include "render/lumigraph/package.h"

namespace lumi {

/// Scores of all held-out views in one mode.
struct ModeScores {
    RenderMode mode = RenderMode::kPerPixel;
    std::vector<ViewScore> views;
    /// Rank correlation of ghost energy with the true error; empty when it was not measured.
    std::optional<double> ghost_between_blocks;
    std::optional<double> ghost_between_views;
};

struct Evaluation {
    std::string gl_description;
    std::string subject_from;  ///< Of EvaluationOptions.
    std::vector<ModeScores> modes;
    std::optional<RivalEvaluation> rivals = {};  ///< Empty when they were not asked for.
    std::vector<std::string> not_judged = {};    ///< Held-out photographs without a pose.
};

struct EvaluationOptions {
    std::vector<RenderMode> modes{RenderMode::kPerPixel, RenderMode::kLightField};
    bool ghost_energy = true;                  ///< Measured for the first mode.
    bool rivals = false;                       ///< Other methods, too (of a workspace).
    int timed_frames = 5;                      ///< Repetitions of each frame.
    Exposures exposures = Exposures::kEvened;  ///< Of packages that are read for it.
    /// The subject is judged beside the frame where this is set.
    SubjectMask subject_mask = {};
    std::string subject_from = {};  ///< How it knows: "drawn masks" or "plain background".
};

/// Called once per mode and view, in order, with what is to be kept of it.
using JudgedViewSink = std::function<void(RenderMode mode, const JudgedView& view)>;

/// Draws every view of `held_out` from the Lumigraph at the view's own pinhole camera, in every
/// mode, and compares the frame with the photograph. Figures of pictures are the same in every run,
/// times are not. Throws Error (E-GL-...).
[[nodiscard]] Evaluation evaluate_held_out(const Lumigraph& lumigraph,
                                           const PosedPhotographs& held_out,
                                           const EvaluationOptions& options,
                                           const JudgedViewSink& keep, Progress& progress);

}  // namespace lumi
