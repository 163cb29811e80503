#include "pipeline/evaluate/kept_back_photographs.h"

#include <utility>

#include "pipeline/evaluate/kept_back_rounds.h"

namespace lumi {

struct KeptBackPhotographs::Round {
    std::unique_ptr<OffscreenRenderer> others;
    std::vector<PicturedEye> pictures;
};

KeptBackPhotographs::KeptBackPhotographs(const Lumigraph& lumigraph, const Capture& capture,
                                         const CameraMeshOptions& mesh_options, Progress& progress)
    : lumigraph_(lumigraph), capture_(capture), mesh_options_(mesh_options), progress_(progress) {}

KeptBackPhotographs::~KeptBackPhotographs() = default;

std::vector<KeptBackPhotographs::Round>& KeptBackPhotographs::rounds() {
    if (rounds_) return *rounds_;
    std::vector<Round> rounds;
    visit_kept_back(lumigraph_, capture_, mesh_options_, "keeping photographs back", progress_,
                    [&](Lumigraph& others, const std::vector<PicturedEye>& pictures) {
                        rounds.push_back({std::make_unique<OffscreenRenderer>(others), pictures});
                    });
    return rounds_.emplace(std::move(rounds));
}

std::size_t KeptBackPhotographs::count() {
    std::size_t count = 0;
    for (const Round& round : rounds()) count += round.pictures.size();
    return count;
}

std::size_t KeptBackPhotographs::ask(const std::string& question) {
    const std::size_t asked = count();
    if (asked > 0) progress_.begin(question, 0);
    return asked;
}

void KeptBackPhotographs::visit(
    const DrawingChoices& drawing,
    const std::function<void(OffscreenRenderer& others, const PicturedEye& kept_back)>& visit) {
    for (Round& round : rounds()) {
        round.others->choose(drawing);
        for (const PicturedEye& picture : round.pictures) {
            progress_.throw_if_interrupted();
            visit(*round.others, picture);
        }
    }
}

DrawnPictures KeptBackPhotographs::draw(const DrawingChoices& drawing,
                                        const RenderOptions& options) {
    DrawnPictures drawn;
    visit(drawing, [&](OffscreenRenderer& others, const PicturedEye& kept_back) {
        draw_picture(others, kept_back, options, drawn);
    });
    return drawn;
}

}  // namespace lumi
