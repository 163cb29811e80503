#include "pipeline/evaluate/occlusion_effort.h"

#include <array>
#include <cstddef>
#include <vector>

#include "meshing/selection/one_standard_error.h"
#include "pipeline/evaluate/kept_back_rounds.h"

namespace lumi {
namespace {

/// The richest first: each takes fewer views away than the next.
constexpr std::array<double, 5> kTolerances_px{24.0, 12.0, 6.0, 3.0, kOcclusionTolerance_px};

RenderOptions with_tolerance(double tolerance_px, const Lumigraph& others) {
    return {.occlusion_tolerance_ratio = tolerance_px / others.occlusion_tolerance_px,
            .smooth_silhouettes = false};
}

}  // namespace

OcclusionEffort sufficient_occlusion_effort(const Lumigraph& lumigraph, const Capture& capture,
                                            const CameraMeshOptions& mesh_options,
                                            Progress& progress) {
    std::vector<std::vector<double>> losses_db(kTolerances_px.size());
    const std::size_t asked = visit_kept_back(
        lumigraph, capture, mesh_options, "asking photographs how far depth is to be trusted",
        progress, [&](Lumigraph& others, const std::vector<PicturedEye>& pictures) {
            OffscreenRenderer renderer(others);
            for (std::size_t i = 0; i < kTolerances_px.size(); ++i) {
                progress.throw_if_interrupted();
                const DrawnPictures drawn =
                    draw_pictures(renderer, pictures, with_tolerance(kTolerances_px[i], others));
                losses_db[i].insert(losses_db[i].end(), drawn.losses_db.begin(),
                                    drawn.losses_db.end());
            }
        });
    if (asked == 0) return {};
    const std::size_t chosen = simplest_as_good(losses_db);
    const Excess gain = excess_over(losses_db.back(), losses_db[chosen]);
    return {.tolerance_px = kTolerances_px[chosen],
            .pictures = static_cast<int>(asked),
            .gains_db = gain.mean,
            .standard_error_db = gain.standard_error};
}

}  // namespace lumi
