#include "pipeline/evaluate/depth_effort.h"

#include <algorithm>
#include <array>

#include "meshing/selection/one_standard_error.h"
#include "pipeline/evaluate/block_width.h"

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
    bool checks_guesses = false;
};
constexpr Choice kMostViews{kMaxDepthViews, kLeastDepthBlock_px};
/// To be told from the most.
constexpr Choice kFewestViews{kLeastDepthViews, kLeastDepthBlock_px};
/// To be told from the fewest.
constexpr Choice kInBlocks{kLeastDepthViews, kMaxDepthBlock_px};
/// To be told from as many views without.
constexpr Choice kMostViewsFilled{kMaxDepthViews, kLeastDepthBlock_px, true};
constexpr Choice kFewestViewsFilled{kLeastDepthViews, kLeastDepthBlock_px, true};
/// To be told from as many filled ones: what others know is no guess.
constexpr Choice kMostViewsChecked{kMaxDepthViews, kLeastDepthBlock_px, true, true};
constexpr std::array kChoices{kMostViews,       kFewestViews,       kInBlocks,
                              kMostViewsFilled, kFewestViewsFilled, kMostViewsChecked};

using LossesDb = std::vector<double>;

LossesDb losses_db_of(const Choice& choice, DrawingChoices drawing,
                      KeptBackPhotographs& photographs) {
    drawing.depth_views = choice.depth_views;
    drawing.depth_block_px = choice.depth_block_px;
    drawing.fills_holes = choice.fills_holes;
    drawing.checks_guesses = choice.checks_guesses;
    return photographs.draw(drawing, kAlike).losses_db;
}

}  // namespace

DepthEffort sufficient_depth_effort(KeptBackPhotographs& photographs, const DrawingChoices& drawing,
                                    int given_views) {
    const std::size_t asked = photographs.ask("asking photographs how well depth must be known");
    if (asked == 0) return {};
    std::array<LossesDb, kChoices.size()> losses_db;
    for (std::size_t choice = 0; choice < kChoices.size(); ++choice)
        losses_db[choice] = losses_db_of(kChoices[choice], drawing, photographs);
    const auto& [most_views, fewest_views, in_blocks, most_filled, fewest_filled, most_checked] =
        losses_db;
    const Excess of_fewest = excess_over(fewest_views, most_views);
    const Excess of_blocks = excess_over(in_blocks, fewest_views);
    const bool has_few = given_views != 0 ? given_views == kLeastDepthViews
                                          : simplest_as_good({most_views, fewest_views}) == 1;
    const LossesDb& filled = has_few ? fewest_filled : most_filled;
    const LossesDb& unfilled = has_few ? fewest_views : most_views;
    const Excess of_holes = excess_over(unfilled, filled);
    const Excess of_guesses = excess_over(most_filled, most_checked);
    const double block_px =
        of_blocks.mean <= kUnseenLoss_db
            ? kMaxDepthBlock_px
            : sufficient_block_px(photographs, drawing, of_blocks.mean, kUnseenLoss_db);
    return {
        .views = has_few ? kLeastDepthViews : kMaxDepthViews,
        .block_px = block_px,
        .fills_holes = simplest_as_good({filled, unfilled}) == 0 && of_holes.mean > kUnseenLoss_db,
        .checks_guesses =
            simplest_as_good({most_checked, most_filled}) == 0 && of_guesses.mean > kUnseenLoss_db,
        .pictures = static_cast<int>(asked),
        .fewer_views_lose_db = of_fewest.mean,
        .standard_error_db = of_fewest.standard_error,
        .blocks_lose_db = of_blocks.mean,
        .holes_lose_db = of_holes.mean,
        .guesses_lose_db = of_guesses.mean};
}

}  // namespace lumi
