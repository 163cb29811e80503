#include "pipeline/evaluate/filled_alike.h"

#include "render/lumigraph/even_exposure.h"
#include "render/surroundings/surroundings.h"

namespace lumi {

FilledAlike::FilledAlike(const Lumigraph& lumigraph, const PosedPhotographs& held_out) {
    const std::vector<Eye> eyes = eyes_of(held_out);
    for (std::size_t i = 0; i < eyes.size(); ++i)
        surroundings_[held_out.capture.views[i].name] = darkened_by_lens(
            surroundings_picture(lumigraph, eyes[i]), eyes[i].camera, lumigraph.evened_falloff);
}

void FilledAlike::add(const ComparedMethod& method, const JudgedView& view) {
    common_.add(method, view.score.name, view.photograph,
                filled(view.rendering, surroundings_.at(view.score.name)));
}

CommonPixelScores FilledAlike::scores_of(const Evaluation& evaluation) const {
    CommonPixelScores scores{common_.share(), {}};
    const auto add = [&](const std::string& method) {
        scores.methods.push_back({method, common_.mean_psnr_db(method)});
    };
    for (const ModeScores& mode : evaluation.modes) add(name_of(mode.mode));
    for (const RivalScores& rival : evaluation.rivals->methods) add(rival.method);
    return scores;
}

}  // namespace lumi
