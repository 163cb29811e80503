#include "pipeline/evaluate/depth_view_count.h"

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
constexpr int kMaxPicture_px = 640;

constexpr std::array<int, 2> kCounts{kMaxDepthViews, kLeastDepthViews};

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

DepthViewCount sufficient_depth_views(const Lumigraph& lumigraph, const Capture& capture,
                                      const CameraMeshOptions& mesh_options, Progress& progress) {
    if (lumigraph.views.size() < kLeastViews) return {};
    Lumigraph evened = lumigraph;
    even_exposures(evened);
    std::vector<std::vector<double>> losses_db(kCounts.size());
    progress.begin("asking photographs how many views' depth to compare", 0);
    for (int round = 0; round < kMostRounds && losses_db.front().size() < kEnoughPictures;
         ++round) {
        // Views that follow each other are alike: the rounds keep apart from each other.
        KeptBackViews kept = keep_back(evened, kEvery, (round * kEvery) / kMostRounds);
        const auto pictures = to_be_drawn(std::move(kept.pictures), kMostPictures);
        Lumigraph others = lumigraph_of_views(evened, capture, kept.others, mesh_options);
        for (std::size_t choice = 0; choice < kCounts.size(); ++choice) {
            progress.throw_if_interrupted();
            others.depth_views = kCounts[choice];
            const DrawnPictures drawn = draw_pictures(others, pictures);
            losses_db[choice].insert(losses_db[choice].end(), drawn.losses_db.begin(),
                                     drawn.losses_db.end());
        }
    }
    const Excess of_fewest = excess_over(losses_db.back(), losses_db.front());
    return {kCounts[simplest_as_good(losses_db)], static_cast<int>(losses_db.front().size()),
            of_fewest.mean, of_fewest.standard_error};
}

}  // namespace lumi
