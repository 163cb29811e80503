#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/work/progress.h"
#include "render/lumigraph/lumigraph.h"
#include "render/modes/frame.h"

namespace lumi {

/// How close a rendering comes to the photograph that was held out.
struct ViewScore {
    std::string name;
    double psnr_db = 0.0;                   ///< Over the full frame.
    std::optional<double> psnr_covered_db;  ///< Over covered pixels; empty when none is.
    double ssim = 0.0;
    double coverage = 0.0;  ///< Share of pixels drawn, 0 to 1.
    double ms = 0.0;        ///< Median over repeated frames, one warm-up frame aside.
};

/// A photograph, what the Lumigraph shows from its place, and how they compare.
struct JudgedView {
    ViewScore score;
    ColorImage photograph;
    Frame rendering;
};

/// Scores of all held-out views in one mode.
struct ModeScores {
    RenderMode mode = RenderMode::kPerPixel;
    std::vector<ViewScore> views;
};

/// The mean over views; for `psnr_covered_db` over those that have one. `name` is "mean".
[[nodiscard]] ViewScore mean_score(const std::vector<ViewScore>& views);

struct Evaluation {
    std::string gl_description;
    std::vector<ModeScores> modes;
};

/// Called once per mode and view, in order, with what is to be kept of it.
using JudgedViewSink = std::function<void(RenderMode mode, const JudgedView& view)>;

/// Draws every view of `held_out` from the Lumigraph at the view's own pinhole camera, in every
/// mode, and compares the frame with the photograph. Throws Error (E-GL-...).
[[nodiscard]] Evaluation evaluate_held_out(const Lumigraph& lumigraph,
                                           const PosedPhotographs& held_out,
                                           const std::vector<RenderMode>& modes,
                                           const JudgedViewSink& keep, Progress& progress);

}  // namespace lumi
