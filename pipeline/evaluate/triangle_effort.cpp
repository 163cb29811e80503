#include "pipeline/evaluate/triangle_effort.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "meshing/selection/one_standard_error.h"
#include "pipeline/evaluate/kept_back_rounds.h"

namespace lumi {
namespace {

/// Steps of about half an octave.
constexpr std::array<double, 8> kErrors_px{0.35, 0.5, kTriangleError_px, 1.0, 1.4, 2.0, 2.8, 4.0};
/// Two fifths of what viewers begin to see: `adaptive` is there for speed, and may lose twice what
/// `perpixel` may (depth_effort.cpp).
constexpr double kMostLoss_db = 0.2;

/// A fifth of it, as for holes (depth_effort.cpp): it costs up to a tenth of a frame.
constexpr double kLeastThinGain_db = 0.1;

/// Of one error, over all pictures.
struct Outcome {
    double loss_db = 0.0;
    double triangles = 0.0;
};

using LossesDb = std::vector<double>;

RenderOptions with_error(double error_px, const Lumigraph& others) {
    return {.mode = RenderMode::kAdaptive,
            .triangle_error_ratio = error_px / others.drawing.triangle_error_px};
}

/// Of triangles of the usual error, with what is thin drawn over them.
LossesDb losses_with_thin(Lumigraph& others, const std::vector<PicturedEye>& pictures) {
    others.drawing.draws_thin = true;
    OffscreenRenderer renderer(others);
    others.drawing.draws_thin = false;
    return draw_pictures(renderer, pictures, with_error(kTriangleError_px, others)).losses_db;
}

void conclude_of_thin(const LossesDb& with, const LossesDb& without, TriangleEffort& effort) {
    const Excess gain = excess_over(without, with);
    effort.thin_gains_db = gain.mean;
    effort.thin_standard_error_db = gain.standard_error;
    effort.draws_thin = gain.mean > kLeastThinGain_db && simplest_as_good({with, without}) == 0;
}

}  // namespace

TriangleEffort sufficient_triangle_effort(const Lumigraph& lumigraph, const Capture& capture,
                                          const CameraMeshOptions& mesh_options,
                                          Progress& progress) {
    std::array<Outcome, kErrors_px.size()> sums;
    LossesDb with_thin;
    LossesDb without_thin;
    const std::size_t asked = visit_kept_back(
        lumigraph, capture, mesh_options, "asking photographs how fine triangles must be", progress,
        [&](Lumigraph& others, const std::vector<PicturedEye>& pictures) {
            const LossesDb more = losses_with_thin(others, pictures);
            with_thin.insert(with_thin.end(), more.begin(), more.end());
            OffscreenRenderer renderer(others);
            for (std::size_t i = 0; i < kErrors_px.size(); ++i) {
                progress.throw_if_interrupted();
                const DrawnPictures drawn =
                    draw_pictures(renderer, pictures, with_error(kErrors_px[i], others));
                for (const double loss_db : drawn.losses_db) {
                    sums[i].loss_db += loss_db;
                    if (kErrors_px[i] == kTriangleError_px) without_thin.push_back(loss_db);
                }
                sums[i].triangles += drawn.mean_triangles * static_cast<double>(pictures.size());
            }
        });
    if (asked == 0) return {};
    const auto count = static_cast<double>(asked);
    const double least_db =
        std::min_element(sums.begin(), sums.end(),
                         [](const Outcome& a, const Outcome& b) { return a.loss_db < b.loss_db; })
            ->loss_db /
        count;
    std::size_t chosen = kErrors_px.size() - 1;
    while (sums[chosen].loss_db / count > least_db + kMostLoss_db) --chosen;
    TriangleEffort effort{.error_px = kErrors_px[chosen],
                          .pictures = static_cast<int>(asked),
                          .loses_db = sums[chosen].loss_db / count - least_db,
                          .triangles = sums[chosen].triangles / count};
    conclude_of_thin(with_thin, without_thin, effort);
    return effort;
}

}  // namespace lumi
