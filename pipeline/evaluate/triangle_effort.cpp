#include "pipeline/evaluate/triangle_effort.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "calib/work/mean.h"
#include "meshing/selection/one_standard_error.h"

namespace lumi {
namespace {

/// Steps of about half an octave.
constexpr std::array<double, 8> kErrors_px{0.35, 0.5, kTriangleError_px, 1.0, 1.4, 2.0, 2.8, 4.0};
/// Two fifths of what viewers begin to see: `adaptive` is there for speed, and may lose twice what
/// `perpixel` may (depth_effort.cpp).
constexpr double kMostLoss_db = 0.2;

/// A fifth of it, as for holes (depth_effort.cpp): it costs up to a tenth of a frame.
constexpr double kLeastThinGain_db = 0.1;

using LossesDb = std::vector<double>;

/// Of triangles of this error.
RenderOptions with_error(double error_px, const DrawingChoices& drawing) {
    return {.mode = RenderMode::kAdaptive,
            .triangle_error_ratio = error_px / drawing.triangle_error_px};
}

LossesDb losses_at(double error_px, bool draws_thin, DrawingChoices drawing,
                   KeptBackPhotographs& photographs) {
    drawing.draws_thin = draws_thin;
    return photographs.draw(drawing, with_error(error_px, drawing)).losses_db;
}

void conclude_of_thin(const LossesDb& with, const LossesDb& without, TriangleEffort& effort) {
    const Excess gain = excess_over(without, with);
    effort.thin_gains_db = gain.mean;
    effort.thin_standard_error_db = gain.standard_error;
    effort.draws_thin = gain.mean > kLeastThinGain_db && simplest_as_good({with, without}) == 0;
}

}  // namespace

TriangleEffort sufficient_triangle_effort(KeptBackPhotographs& photographs, DrawingChoices drawing,
                                          double given_error_px) {
    const std::size_t asked = photographs.ask("asking photographs how fine triangles must be");
    if (asked == 0) return {};
    const double thin_error_px = given_error_px != 0 ? given_error_px : kTriangleError_px;
    const LossesDb with_thin = losses_at(thin_error_px, true, drawing, photographs);
    drawing.draws_thin = false;
    LossesDb without_thin;
    std::array<double, kErrors_px.size()> losses_db{};
    std::array<double, kErrors_px.size()> triangles{};
    for (std::size_t i = 0; i < kErrors_px.size(); ++i) {
        DrawnPictures drawn = photographs.draw(drawing, with_error(kErrors_px[i], drawing));
        losses_db[i] = mean_of(drawn.losses_db);
        triangles[i] = mean_of(drawn.triangles);
        if (kErrors_px[i] == thin_error_px) without_thin = std::move(drawn.losses_db);
    }
    if (without_thin.empty()) without_thin = losses_at(thin_error_px, false, drawing, photographs);
    const double least_db = *std::min_element(losses_db.begin(), losses_db.end());
    std::size_t chosen = kErrors_px.size() - 1;
    while (losses_db[chosen] > least_db + kMostLoss_db) --chosen;
    TriangleEffort effort{.error_px = kErrors_px[chosen],
                          .pictures = static_cast<int>(asked),
                          .loses_db = losses_db[chosen] - least_db,
                          .triangles = triangles[chosen]};
    conclude_of_thin(with_thin, without_thin, effort);
    return effort;
}

}  // namespace lumi
