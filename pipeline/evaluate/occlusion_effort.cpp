#include "pipeline/evaluate/occlusion_effort.h"

#include <array>
#include <cstddef>
#include <vector>

#include "meshing/selection/one_standard_error.h"

namespace lumi {
namespace {

/// The widest first: each takes fewer views away than the next. Beyond it hardly any occlusion is
/// corrected any more.
constexpr std::array<double, 5> kTolerances_px{24.0, 12.0, 6.0, 3.0, kOcclusionTolerance_px};

/// What blocks share is asked, as for all else that photographs choose.
const RenderOptions kAlike{.smooth_silhouettes = false};

/// What the choice is measured beside: the narrowest, or the next wider where it is that.
std::size_t beside(std::size_t chosen) {
    const std::size_t narrowest = kTolerances_px.size() - 1;
    return chosen == narrowest ? narrowest - 1 : narrowest;
}

}  // namespace

OcclusionEffort sufficient_occlusion_effort(KeptBackPhotographs& photographs,
                                            DrawingChoices drawing) {
    const std::size_t asked = photographs.ask("asking photographs how far depth is to be trusted");
    if (asked == 0) return {};
    std::vector<std::vector<double>> losses_db;
    for (const double tolerance_px : kTolerances_px) {
        drawing.occlusion_tolerance_px = tolerance_px;
        losses_db.push_back(photographs.draw(drawing, kAlike).losses_db);
    }
    const std::size_t chosen = simplest_as_good(losses_db);
    const Excess gain = excess_over(losses_db[beside(chosen)], losses_db[chosen]);
    return {.tolerance_px = kTolerances_px[chosen],
            .pictures = static_cast<int>(asked),
            .beside_px = kTolerances_px[beside(chosen)],
            .gains_db = gain.mean,
            .standard_error_db = gain.standard_error};
}

}  // namespace lumi
