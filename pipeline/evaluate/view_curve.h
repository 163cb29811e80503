#pragma once

#include <cstdint>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/work/progress.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/selection/view_selection.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// What so many views are worth, and what they cost.
struct ViewCurvePoint {
    int views = 0;
    double psnr_db = 0.0;  ///< Mean over the held-out photographs, full frame.
    double texture_mib = 0.0;
    double ms = 0.0;  ///< Median time of a frame.
    /// Mean, standard deviation and best over random choices of the same number; 0 where none was
    /// drawn.
    double random_psnr_db = 0.0;
    double random_deviation_db = 0.0;
    double best_random_psnr_db = 0.0;
};

struct ViewCurve {
    std::vector<ViewCurvePoint> points;  ///< All views first.
    int auto_views = 0;  ///< The fewest that the one-standard-error rule cannot tell from the best.
    int third_db_views = 0;      ///< The fewest that lose at most 0.3 dB.
    double ranking_cpu_s = 0.0;  ///< What it took to order the views by their worth.
};

struct ViewCurveOptions {
    int least_views = 4;
    /// Numbers of views to try besides all; empty: each time a quarter less, and then between the
    /// fewest that lose at most 0.3 dB and the next fewer, until they are known to a twentieth.
    std::vector<int> sizes;
    int random_choices = 0;  ///< Drawn at each size, to compare with.
    std::uint64_t seed = 1;
    CameraMeshOptions mesh;
};

/// Draws the held-out photographs from ever fewer views, keeping those that would be missed most
/// (view_worth.h), and depth as it is. `capture.views` lists the Lumigraph's views in the same
/// order.
[[nodiscard]] ViewCurve measure_view_curve(const Lumigraph& lumigraph, const Capture& capture,
                                           const PosedPhotographs& held_out,
                                           const ViewCurveOptions& options, int threads,
                                           Progress& progress);

/// How many of the Lumigraph's views are enough, without any held-out photograph: every sixth of
/// its own (three at least) is drawn from ever fewer of the others, and the one-standard-error rule
/// chooses a share of them. All of fewer than 12.
[[nodiscard]] int sufficient_views(const Lumigraph& lumigraph, const Capture& capture,
                                   const CameraMeshOptions& mesh_options, int threads,
                                   Progress& progress);

}  // namespace lumi
