#include "pipeline/evaluate/depth_effort.h"

#include <algorithm>
#include <array>

#include "calib/work/mean.h"
#include "meshing/selection/one_standard_error.h"
#include "pipeline/evaluate/block_width.h"
#include "pipeline/evaluate/image_metrics.h"
#include "pipeline/evaluate/moved_eye.h"

namespace lumi {
namespace {

/// Viewers begin to see half a decibel.
constexpr double kUnseenLoss_db = 0.1;

/// Photographs stand where others stand, who look around from nearer and from farther, too: by this
/// share of the way to the scene.
constexpr double kMoved = 1.0 / 3;
/// Of such an eye's picture: what nobody would miss.
constexpr double kUnmissedShare = 0.01;

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
constexpr Choice kMostViewsFilled{
    .depth_views = kMaxDepthViews, .depth_block_px = kLeastDepthBlock_px, .fills_holes = true};
constexpr Choice kFewestViewsFilled{
    .depth_views = kLeastDepthViews, .depth_block_px = kLeastDepthBlock_px, .fills_holes = true};
/// To be told from as many filled ones: what others know is no guess.
constexpr Choice kMostViewsChecked{.depth_views = kMaxDepthViews,
                                   .depth_block_px = kLeastDepthBlock_px,
                                   .fills_holes = true,
                                   .checks_guesses = true};
constexpr std::array kChoices{kMostViews,       kFewestViews,       kInBlocks,
                              kMostViewsFilled, kFewestViewsFilled, kMostViewsChecked};

using LossesDb = std::vector<double>;

DrawingChoices with(const Choice& choice, DrawingChoices drawing) {
    drawing.depth_views = choice.depth_views;
    drawing.depth_block_px = choice.depth_block_px;
    drawing.fills_holes = choice.fills_holes;
    drawing.checks_guesses = choice.checks_guesses;
    return drawing;
}

/// Whether anyone would see that these lose beside the others, and it is no chance.
bool lose_visibly(const LossesDb& losses, const LossesDb& least) {
    return simplest_as_good({least, losses}) == 0 &&
           excess_over(losses, least).mean > kUnseenLoss_db;
}

/// How much of its picture an eye knows that looks from nearer or from farther, in the mean.
double known_share_of_moved(KeptBackPhotographs& photographs, const DrawingChoices& drawing) {
    std::vector<double> shares;
    photographs.visit(drawing, [&](OffscreenRenderer& others, const PicturedEye& kept_back) {
        for (const double share : {kMoved, -kMoved}) {
            const Eye eye = moved_ahead(photographs.lumigraph(), kept_back.eye, share);
            shares.push_back(covered_share(others.draw(eye, kAlike).coverage));
        }
    });
    return mean_of(shares);
}

/// What of such a picture only others know.
double share_known_by_filling(KeptBackPhotographs& photographs, const DrawingChoices& drawing,
                              Choice choice) {
    choice.fills_holes = true;
    const double filled = known_share_of_moved(photographs, with(choice, drawing));
    choice.fills_holes = false;
    return filled - known_share_of_moved(photographs, with(choice, drawing));
}

/// Whether what the views that are asked for depth do not see is drawn from others, and why.
struct Filling {
    bool is_done = false;
    double left_loses_db = 0.0;
    double moved_know_more = 0.0;  ///< As a share of their pictures; 0 where nobody asked.
};

/// Done where photographs gain by it, left where they lose: there others know no better. Where
/// nobody would see that in them, those decide that look from elsewhere.
Filling filling_of(KeptBackPhotographs& photographs, const DrawingChoices& drawing,
                   const Choice& choice, const LossesDb& left, const LossesDb& filled) {
    Filling filling{.is_done = lose_visibly(left, filled),
                    .left_loses_db = excess_over(left, filled).mean};
    if (filling.is_done || lose_visibly(filled, left)) return filling;
    filling.moved_know_more = share_known_by_filling(photographs, drawing, choice);
    filling.is_done = filling.moved_know_more > kUnmissedShare;
    return filling;
}

}  // namespace

DepthEffort sufficient_depth_effort(KeptBackPhotographs& photographs, const DrawingChoices& drawing,
                                    int given_views) {
    const std::size_t asked = photographs.ask("asking photographs how well depth must be known");
    if (asked == 0) return {};
    std::array<LossesDb, kChoices.size()> losses_db;
    for (std::size_t choice = 0; choice < kChoices.size(); ++choice)
        losses_db[choice] = photographs.draw(with(kChoices[choice], drawing), kAlike).losses_db;
    const auto& [most_views, fewest_views, in_blocks, most_filled, fewest_filled, most_checked] =
        losses_db;
    const Excess of_fewest = excess_over(fewest_views, most_views);
    const Excess of_blocks = excess_over(in_blocks, fewest_views);
    const bool has_few = given_views != 0 ? given_views == kLeastDepthViews
                                          : simplest_as_good({most_views, fewest_views}) == 1;
    const Filling filling =
        has_few ? filling_of(photographs, drawing, kFewestViews, fewest_views, fewest_filled)
                : filling_of(photographs, drawing, kMostViews, most_views, most_filled);
    const double block_px =
        of_blocks.mean <= kUnseenLoss_db
            ? kMaxDepthBlock_px
            : sufficient_block_px(photographs, drawing, of_blocks.mean, kUnseenLoss_db);
    return {.views = has_few ? kLeastDepthViews : kMaxDepthViews,
            .block_px = block_px,
            .fills_holes = filling.is_done,
            .checks_guesses = lose_visibly(most_filled, most_checked),
            .pictures = static_cast<int>(asked),
            .fewer_views_lose_db = of_fewest.mean,
            .standard_error_db = of_fewest.standard_error,
            .blocks_lose_db = of_blocks.mean,
            .holes_lose_db = filling.left_loses_db,
            .moved_know_more = filling.moved_know_more,
            .guesses_lose_db = excess_over(most_filled, most_checked).mean};
}

}  // namespace lumi
