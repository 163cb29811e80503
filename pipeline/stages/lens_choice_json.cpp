#include "pipeline/stages/lens_choice_json.h"

#include <nlohmann/json.hpp>

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

nlohmann::ordered_json lens_choice_json(const LensChoice& choice) {
    Json forms = Json::array();
    for (std::size_t index = 0; index < choice.trials.size(); ++index) {
        const LensTrial& trial = choice.trials[index];
        const bool is_predicted = !trial.folds.empty();
        forms.push_back({{"form", text_of(trial)},
                         {"free_parameters", free_parameters(trial)},
                         {"rms_px", trial.rms_px},
                         {"held_out_rms_px", is_predicted ? Json(trial.held_out_rms_px) : Json()},
                         {"excess_px2", is_predicted ? Json(trial.excess_px2) : Json()},
                         {"excess_sigma_px2", is_predicted ? Json(trial.excess_sigma_px2) : Json()},
                         {"bic", trial.bic},
                         {"is_chosen", index == choice.chosen},
                         {"predicts_best", is_predicted && index == choice.best_predicting},
                         {"has_least_bic", index == choice.least_bic},
                         {"not_predicted", trial.not_predicted}});
    }
    return forms;
}

}  // namespace lumi
