#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "calib/work/progress.h"
#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// A frame that was drawn within a time budget.
struct BudgetedFrame {
    std::size_t budget = 0;  ///< Which of the budgets.
    std::size_t place = 0;   ///< Which eye of the path.
    double wall_ms = 0.0;    ///< Of drawing it and waiting until it is done.
    DrawStatistics statistics;
    Frame frame;
};
using BudgetedFrameSink = std::function<void(const BudgetedFrame&)>;

/// Draws a path by `adaptive` for each number of frames a second that is asked for (0: any), as the
/// window does while its eye moves (LumigraphRenderer::forget_frame), but whole: with as many
/// triangles as the frames before it say that there is time for (triangle_budget.h). For each the
/// path is gone twice; frames of the first time teach what triangles cost, those of the second are
/// handed to `sink`. Throws Error (E-GL-...).
void draw_within_budgets(const Lumigraph& lumigraph, const std::vector<Eye>& path,
                         const std::vector<double>& frames_per_second,
                         const BudgetedFrameSink& sink, Progress& progress);

}  // namespace lumi
