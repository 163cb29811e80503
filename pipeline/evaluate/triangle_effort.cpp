#include "pipeline/evaluate/triangle_effort.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "meshing/selection/one_standard_error.h"
#include "pipeline/evaluate/kept_back_rounds.h"

namespace lumi {
namespace {

/// Steps of about half an octave.
constexpr std::array<double, 8> kErrors_px{0.35, 0.5, kTriangleError_px, 1.0, 1.4, 2.0, 2.8, 4.0};
/// Two fifths of what viewers begin to see: `adaptive` is there for speed, and may lose twice what
/// `perpixel` may (depth_effort.cpp).
constexpr double kMostLoss_db = 0.2;

/// A fifth of it, as for holes (depth_effort.cpp): it costs up to a fifth of a frame.
constexpr double kLeastThinGain_db = 0.1;

/// Of one error, over all pictures.
struct Outcome {
    double loss_db = 0.0;
    double triangles = 0.0;
};

using LossesDb = std::vector<double>;

/// With what is thin drawn over triangles of the usual error, and without.
class ThinTrial {
 public:
    void draw(Lumigraph& others, const std::vector<PicturedEye>& pictures) {
        for (const bool draws_thin : {false, true}) {
            others.draws_thin = draws_thin;
            OffscreenRenderer renderer(others);
            const LossesDb more =
                draw_pictures(renderer, pictures, {.mode = RenderMode::kAdaptive}).losses_db;
            LossesDb& losses_db = draws_thin ? with_ : without_;
            losses_db.insert(losses_db.end(), more.begin(), more.end());
        }
        others.draws_thin = false;
    }

    void conclude(TriangleEffort& effort) const {
        const Excess gain = excess_over(without_, with_);
        effort.thin_gains_db = gain.mean;
        effort.thin_standard_error_db = gain.standard_error;
        effort.draws_thin =
            gain.mean > kLeastThinGain_db && simplest_as_good({with_, without_}) == 0;
    }

 private:
    LossesDb with_;
    LossesDb without_;
};

}  // namespace

TriangleEffort sufficient_triangle_effort(const Lumigraph& lumigraph, const Capture& capture,
                                          const CameraMeshOptions& mesh_options,
                                          Progress& progress) {
    std::array<Outcome, kErrors_px.size()> sums;
    ThinTrial thin;
    const std::size_t asked = visit_kept_back(
        lumigraph, capture, mesh_options, "asking photographs how fine triangles must be", progress,
        [&](Lumigraph& others, const std::vector<PicturedEye>& pictures) {
            thin.draw(others, pictures);
            OffscreenRenderer renderer(others);
            for (std::size_t i = 0; i < kErrors_px.size(); ++i) {
                progress.throw_if_interrupted();
                const DrawnPictures drawn = draw_pictures(
                    renderer, pictures,
                    {.mode = RenderMode::kAdaptive,
                     .triangle_error_ratio = kErrors_px[i] / others.triangle_error_px});
                for (const double loss_db : drawn.losses_db) sums[i].loss_db += loss_db;
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
    thin.conclude(effort);
    return effort;
}

}  // namespace lumi
