#include "pipeline/evaluate/kept_back_rounds.h"

#include <array>
#include <utility>

#include "pipeline/stages/chosen_views.h"
#include "render/depth_mesh/view_depth_mesh.h"
#include "render/lumigraph/even_exposure.h"

namespace lumi {
namespace {

/// What is left of fewer views would tell of another capture.
constexpr std::size_t kLeastViews = 8;
constexpr int kEvery = 6;
/// Where each round begins: views that follow each other are alike, and so rounds keep apart from
/// each other as long as they can. After the last each view was asked.
constexpr std::array<int, kEvery> kRounds{0, 2, 4, 1, 3, 5};
constexpr std::size_t kEnoughPictures = 8;
constexpr std::size_t kMostPictures = 12;
/// As large as frames are looked at: in smaller ones blocks are coarser than they will be.
constexpr int kMaxPicture_px = 1280;

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

std::size_t visit_kept_back(const Lumigraph& lumigraph, const Capture& capture,
                            const CameraMeshOptions& mesh_options, const std::string& step,
                            Progress& progress, const KeptBackVisitor& visit) {
    if (lumigraph.views.size() < kLeastViews) return 0;
    progress.begin(step, 0);
    std::size_t asked = 0;
    for (const int first : kRounds) {
        if (asked >= kEnoughPictures) break;
        KeptBackViews kept = keep_back(lumigraph, kEvery, first);
        const auto pictures = to_be_drawn(std::move(kept.pictures), kMostPictures);
        Lumigraph others = lumigraph_of_views(lumigraph, capture, kept.others, mesh_options);
        even_exposures(others);
        // Fewer views may want other meshes; else each that draws them would make its own.
        QuietPart of_the_step(progress);
        make_depth_meshes(others, 0, of_the_step);
        visit(others, pictures);
        asked += pictures.size();
    }
    return asked;
}

}  // namespace lumi
