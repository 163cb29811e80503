#include "pipeline/evaluate/occlusion_effort.h"

#include <array>
#include <cstddef>
#include <vector>

#include "meshing/selection/one_standard_error.h"
#include "pipeline/evaluate/kept_back_rounds.h"

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

OcclusionEffort sufficient_occlusion_effort(const Lumigraph& lumigraph, const Capture& capture,
                                            const CameraMeshOptions& mesh_options,
                                            Progress& progress) {
    std::vector<std::vector<double>> losses_db(kTolerances_px.size());
    const std::size_t asked = visit_kept_back(
        lumigraph, capture, mesh_options, "asking photographs how far depth is to be trusted",
        progress, [&](Lumigraph& others, const std::vector<PicturedEye>& pictures) {
            for (std::size_t i = 0; i < kTolerances_px.size(); ++i) {
                progress.throw_if_interrupted();
                others.drawing.occlusion_tolerance_px = kTolerances_px[i];
                OffscreenRenderer renderer(others);
                const DrawnPictures drawn = draw_pictures(renderer, pictures, kAlike);
                losses_db[i].insert(losses_db[i].end(), drawn.losses_db.begin(),
                                    drawn.losses_db.end());
            }
        });
    if (asked == 0) return {};
    const std::size_t chosen = simplest_as_good(losses_db);
    const Excess gain = excess_over(losses_db[beside(chosen)], losses_db[chosen]);
    return {.tolerance_px = kTolerances_px[chosen],
            .pictures = static_cast<int>(asked),
            .beside_px = kTolerances_px[beside(chosen)],
            .gains_db = gain.mean,
            .standard_error_db = gain.standard_error};
}

}  // namespace lumi
