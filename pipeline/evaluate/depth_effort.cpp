#include "pipeline/evaluate/depth_effort.h"

#include <algorithm>
#include <array>

#include "meshing/selection/one_standard_error.h"
#include "pipeline/evaluate/block_width.h"
#include "pipeline/evaluate/kept_back_rounds.h"

namespace lumi {
namespace {

/// Viewers begin to see half a decibel.
constexpr double kUnseenLoss_db = 0.1;

struct Choice {
    int depth_views;
    double depth_block_px;
};
/// Each but the first is to be told from the one before it.
constexpr std::array<Choice, 3> kChoices{{{kMaxDepthViews, kLeastDepthBlock_px},
                                          {kLeastDepthViews, kLeastDepthBlock_px},
                                          {kLeastDepthViews, kMaxDepthBlock_px}}};

/// What blocks share is asked, not what smooth silhouettes, which blocks do not have, would bring
/// at twice the work and in small frames alone.
const RenderOptions kAlike{.smooth_silhouettes = false};

}  // namespace

DepthEffort sufficient_depth_effort(const Lumigraph& lumigraph, const Capture& capture,
                                    const CameraMeshOptions& mesh_options, Progress& progress) {
    std::vector<std::vector<double>> losses_db(kChoices.size());
    const std::size_t asked = visit_kept_back(
        lumigraph, capture, mesh_options, "asking photographs how well depth must be known",
        progress, [&](Lumigraph& others, const std::vector<PicturedEye>& pictures) {
            for (std::size_t choice = 0; choice < kChoices.size(); ++choice) {
                progress.throw_if_interrupted();
                others.depth_views = kChoices[choice].depth_views;
                others.depth_block_px = kChoices[choice].depth_block_px;
                OffscreenRenderer renderer(others);
                const DrawnPictures drawn = draw_pictures(renderer, pictures, kAlike);
                losses_db[choice].insert(losses_db[choice].end(), drawn.losses_db.begin(),
                                         drawn.losses_db.end());
            }
        });
    if (asked == 0) return {};
    const Excess of_fewest = excess_over(losses_db[1], losses_db[0]);
    const Excess of_blocks = excess_over(losses_db[2], losses_db[1]);
    const std::size_t views = simplest_as_good({losses_db[0], losses_db[1]});
    const double block_px = of_blocks.mean <= kUnseenLoss_db
                                ? kMaxDepthBlock_px
                                : sufficient_block_px(lumigraph, capture, mesh_options,
                                                      of_blocks.mean, kUnseenLoss_db, progress);
    return {.views = kChoices[views].depth_views,
            .block_px = block_px,
            .pictures = static_cast<int>(asked),
            .fewer_views_lose_db = of_fewest.mean,
            .standard_error_db = of_fewest.standard_error,
            .blocks_lose_db = of_blocks.mean};
}

}  // namespace lumi
