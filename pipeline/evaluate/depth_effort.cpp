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

/// What blocks share is asked, not what smooth silhouettes, which blocks do not have, would bring
/// at twice the work and in small frames alone.
const RenderOptions kAlike{.smooth_silhouettes = false};

struct Choice {
    int depth_views;
    double depth_block_px;
    bool fills_holes = false;
};
/// To be told from each other, the one that takes the longest first; each that fills holes comes
/// before the same without.
constexpr std::array<Choice, 4> kDepthChoices{{{kMaxDepthViews, kLeastDepthBlock_px, true},
                                               {kMaxDepthViews, kLeastDepthBlock_px},
                                               {kLeastDepthViews, kLeastDepthBlock_px, true},
                                               {kLeastDepthViews, kLeastDepthBlock_px}}};
constexpr std::size_t kMostViews = 1;
constexpr std::size_t kFewestViews = 3;
/// To be told from the last of them.
constexpr Choice kInBlocks{kLeastDepthViews, kMaxDepthBlock_px};

using LossesDb = std::vector<double>;

LossesDb losses_db_of(const Choice& choice, Lumigraph& lumigraph,
                      const std::vector<PicturedEye>& pictures) {
    lumigraph.depth_views = choice.depth_views;
    lumigraph.depth_block_px = choice.depth_block_px;
    lumigraph.fills_holes = choice.fills_holes;
    OffscreenRenderer renderer(lumigraph);
    return draw_pictures(renderer, pictures, kAlike).losses_db;
}

void append(const LossesDb& more, LossesDb& losses_db) {
    losses_db.insert(losses_db.end(), more.begin(), more.end());
}

/// What a depth choice and the same with the holes filled differ by.
Excess loss_of_holes(const std::vector<LossesDb>& losses_db, int depth_views) {
    const std::size_t unfilled = depth_views == kMaxDepthViews ? kMostViews : kFewestViews;
    return excess_over(losses_db[unfilled], losses_db[unfilled - 1]);
}

/// Holes are filled only for what anyone would miss.
Choice sufficient_choice(const std::vector<LossesDb>& losses_db) {
    Choice choice = kDepthChoices[simplest_as_good(losses_db)];
    if (loss_of_holes(losses_db, choice.depth_views).mean <= kUnseenLoss_db)
        choice.fills_holes = false;
    return choice;
}

}  // namespace

DepthEffort sufficient_depth_effort(const Lumigraph& lumigraph, const Capture& capture,
                                    const CameraMeshOptions& mesh_options, Progress& progress) {
    std::vector<LossesDb> losses_db(kDepthChoices.size());
    LossesDb in_blocks_db;
    const std::size_t asked = visit_kept_back(
        lumigraph, capture, mesh_options, "asking photographs how well depth must be known",
        progress, [&](Lumigraph& others, const std::vector<PicturedEye>& pictures) {
            for (std::size_t choice = 0; choice < kDepthChoices.size(); ++choice) {
                progress.throw_if_interrupted();
                append(losses_db_of(kDepthChoices[choice], others, pictures), losses_db[choice]);
            }
            append(losses_db_of(kInBlocks, others, pictures), in_blocks_db);
        });
    if (asked == 0) return {};
    const Choice sufficient = sufficient_choice(losses_db);
    const Excess of_fewest = excess_over(losses_db[kFewestViews], losses_db[kMostViews]);
    const Excess of_blocks = excess_over(in_blocks_db, losses_db[kFewestViews]);
    const double block_px = of_blocks.mean <= kUnseenLoss_db
                                ? kMaxDepthBlock_px
                                : sufficient_block_px(lumigraph, capture, mesh_options,
                                                      of_blocks.mean, kUnseenLoss_db, progress);
    return {.views = sufficient.depth_views,
            .block_px = block_px,
            .fills_holes = sufficient.fills_holes,
            .pictures = static_cast<int>(asked),
            .fewer_views_lose_db = of_fewest.mean,
            .standard_error_db = of_fewest.standard_error,
            .blocks_lose_db = of_blocks.mean,
            .holes_lose_db = loss_of_holes(losses_db, sufficient.depth_views).mean};
}

}  // namespace lumi
