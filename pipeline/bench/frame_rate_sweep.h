#pragma once

#include <vector>

#include "calib/work/progress.h"
#include "render/lumigraph/lumigraph.h"
#include "render/viewer/commands.h"

namespace lumi {

/// What `adaptive` comes to when so many frames a second are asked for.
struct FrameRateFigures {
    double asked = 0.0;          ///< Frames a second; 0: any.
    double reached = 0.0;        ///< By the median frame.
    double share_in_time = 0.0;  ///< Of the frames that took no longer than asked.
    double triangles = 0.0;      ///< Median.
    double psnr_db = 0.0;        ///< Mean over the held-out photographs.
};

/// Goes from held-out photograph to held-out photograph (draw_within_budgets) without a limit and
/// then with each of those asked for. At the places of the photographs frames are compared with
/// them, so that speed and error are of the same frames. `held_out` is not empty. Throws Error
/// (E-GL-...).
[[nodiscard]] std::vector<FrameRateFigures> sweep_frame_rates(
    const Lumigraph& lumigraph, const std::vector<HeldOutView>& held_out,
    const std::vector<double>& frames_per_second, Progress& progress);

}  // namespace lumi
