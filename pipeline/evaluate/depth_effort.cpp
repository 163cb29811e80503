#include "pipeline/evaluate/depth_effort.h"

#include <algorithm>
#include <array>

#include "meshing/selection/one_standard_error.h"
#include "pipeline/evaluate/pictured_eye.h"
#include "pipeline/stages/chosen_views.h"
#include "render/lumigraph/even_exposure.h"

namespace lumi {
namespace {

constexpr std::size_t kLeastViews = 8;
constexpr int kEvery = 6;
/// Each time that every sixth view is kept back costs a camera mesh and textures of the others.
constexpr int kMostRounds = 3;
constexpr std::size_t kEnoughPictures = 8;
constexpr std::size_t kMostPictures = 12;
/// As large as frames are looked at: in smaller ones blocks are coarser than they will be.
constexpr int kMaxPicture_px = 1280;

/// Viewers begin to see half a decibel.
constexpr double kUnseenLoss_db = 0.1;

struct Choice {
    int depth_views;
    int depth_block_px;
};
/// Each but the first is to be told from the one before it.
constexpr std::array<Choice, 3> kChoices{
    {{kMaxDepthViews, 1}, {kLeastDepthViews, 1}, {kLeastDepthViews, kMaxDepthBlock_px}}};

void keep_evenly(std::vector<PicturedEye>& pictures, std::size_t most) {
    if (pictures.size() <= most) return;
    std::vector<PicturedEye> kept;
    for (std::size_t i = 0; i < most; ++i)
        kept.push_back(std::move(pictures[i * pictures.size() / most]));
    pictures = std::move(kept);
}

std::vector<PicturedEye> to_be_drawn(std::vector<PicturedEye> pictures, std::size_t most) {
    keep_evenly(pictures, most);
    for (PicturedEye& picture : pictures)
        picture = no_larger_than(std::move(picture), kMaxPicture_px);
    return pictures;
}

}  // namespace

DepthEffort sufficient_depth_effort(const Lumigraph& lumigraph, const Capture& capture,
                                    const CameraMeshOptions& mesh_options, Progress& progress) {
    if (lumigraph.views.size() < kLeastViews) return {};
    Lumigraph evened = lumigraph;
    even_exposures(evened);
    std::vector<std::vector<double>> losses_db(kChoices.size());
    progress.begin("asking photographs how well depth must be known", 0);
    for (int round = 0; round < kMostRounds && losses_db.front().size() < kEnoughPictures;
         ++round) {
        // Views that follow each other are alike: the rounds keep apart from each other.
        KeptBackViews kept = keep_back(evened, kEvery, (round * kEvery) / kMostRounds);
        const auto pictures = to_be_drawn(std::move(kept.pictures), kMostPictures);
        Lumigraph others = lumigraph_of_views(evened, capture, kept.others, mesh_options);
        for (std::size_t choice = 0; choice < kChoices.size(); ++choice) {
            progress.throw_if_interrupted();
            others.depth_views = kChoices[choice].depth_views;
            others.depth_block_px = kChoices[choice].depth_block_px;
            const DrawnPictures drawn = draw_pictures(others, pictures);
            losses_db[choice].insert(losses_db[choice].end(), drawn.losses_db.begin(),
                                     drawn.losses_db.end());
        }
    }
    const Excess of_fewest = excess_over(losses_db[1], losses_db[0]);
    const Excess of_blocks = excess_over(losses_db[2], losses_db[1]);
    const std::size_t views = simplest_as_good({losses_db[0], losses_db[1]});
    return {kChoices[views].depth_views,
            of_blocks.mean <= kUnseenLoss_db ? kMaxDepthBlock_px : 1,
            static_cast<int>(losses_db.front().size()),
            of_fewest.mean,
            of_fewest.standard_error,
            of_blocks.mean};
}

}  // namespace lumi
