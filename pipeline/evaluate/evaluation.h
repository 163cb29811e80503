#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/work/progress.h"
#include "pipeline/evaluate/view_score.h"
#include "render/frame/frame.h"
#include "render/lumigraph/package.h"

namespace lumi {

/// A photograph, what the Lumigraph shows from its place, and how they compare.
struct JudgedView {
    ViewScore score;
    ColorImage photograph;
    GrayImage subject;  ///< Of the photograph; empty where it is not known.
    Frame rendering;
    FloatImage flip;          ///< Error map.
    FloatImage ghost_energy;  ///< Empty when it was not asked for.
};

/// Which pixels of a held-out photograph are of the subject (255) and which are not (0), by the
/// view's name; an empty picture where that is not known.
using SubjectMask =
    std::function<GrayImage(const std::string& view_name, const ColorImage& photograph)>;

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
};

struct EvaluationOptions {
    std::vector<RenderMode> modes{RenderMode::kPerPixel, RenderMode::kLightField};
    bool ghost_energy = true;                  ///< Measured for the first mode.
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
