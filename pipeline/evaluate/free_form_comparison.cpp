#include "pipeline/evaluate/free_form_comparison.h"

#include <algorithm>

namespace lumi {
namespace {

const ModeScores* same_mode(const RivalScores& rival, const std::vector<ModeScores>& modes) {
    if (rival.resampling_cpu_s <= 0) return nullptr;
    const auto same = std::find_if(modes.begin(), modes.end(), [&](const ModeScores& scores) {
        return rival.method.ends_with(' ' + name_of(scores.mode));
    });
    return same == modes.end() ? nullptr : &*same;
}

std::optional<double> common_psnr_db(const std::optional<CommonPixelScores>& common,
                                     const std::string& method) {
    if (!common) return std::nullopt;
    const auto scores =
        std::find_if(common->methods.begin(), common->methods.end(),
                     [&](const CommonPixelScores::Method& one) { return one.name == method; });
    return scores == common->methods.end() ? std::nullopt : scores->psnr_db;
}

FreeFormBesideResampled beside(const ModeScores& free_form, const RivalScores& rival,
                               const std::optional<CommonPixelScores>& common) {
    const ViewScore own = mean_score(free_form.views);
    const ViewScore resampled = mean_score(rival.views);
    FreeFormBesideResampled compared{.mode = free_form.mode,
                                     .resampled = rival.method,
                                     .cpu_ratio = {},
                                     .psnr_gain_db = own.psnr_db - resampled.psnr_db,
                                     .common_psnr_gain_db = {}};
    if (resampled.cpu_ms > 0) compared.cpu_ratio = own.cpu_ms / resampled.cpu_ms;
    const auto own_common = common_psnr_db(common, name_of(free_form.mode));
    const auto resampled_common = common_psnr_db(common, rival.method);
    if (own_common && resampled_common)
        compared.common_psnr_gain_db = *own_common - *resampled_common;
    return compared;
}

}  // namespace

std::vector<FreeFormBesideResampled> free_form_beside_resampled(const Evaluation& evaluation) {
    std::vector<FreeFormBesideResampled> compared;
    if (!evaluation.rivals) return compared;
    for (const RivalScores& rival : evaluation.rivals->methods)
        if (const ModeScores* free_form = same_mode(rival, evaluation.modes))
            compared.push_back(beside(*free_form, rival, evaluation.rivals->common));
    return compared;
}

}  // namespace lumi
