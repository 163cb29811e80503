#include "calib/poses/second_model.h"

#include <utility>

namespace lumi {

MatchedPhotographs without_features(const MatchedPhotographs& matched) {
    MatchedPhotographs same;
    same.name = matched.name;
    same.photographs = matched.photographs;
    same.pairs = matched.pairs;
    return same;
}

void tell_of_second_model(PoseEvidence& evidence, PoseEvidence of_second) {
    evidence.lenses = std::move(of_second.lenses);
    evidence.views = std::move(of_second.views);
    evidence.noise_px = of_second.noise_px;
    evidence.models_found = of_second.models_found;
    evidence.start = std::move(of_second.start);
    evidence.warnings = std::move(of_second.warnings);
}

}  // namespace lumi
