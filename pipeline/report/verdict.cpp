#include "pipeline/report/verdict.h"

#include <nlohmann/json.hpp>

#include "calib/work/counted.h"
#include "pipeline/evaluate/view_score.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/optional_json.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

void add_remark(Verdict& verdict, const std::string& remark) {
    verdict.remarks.push_back(remark);
    if (verdict.level == Verdict::Level::kGood) verdict.level = Verdict::Level::kFair;
}

void judge_ingest(Verdict& verdict, const Json& evidence) {
    const std::size_t left_out = evidence.at("left_out").size();
    if (left_out > 0) {
        add_remark(verdict, counted(left_out, "file") + (left_out == 1 ? " was" : " were") +
                                " left out; the reasons are listed below.");
    }
}

std::string remark_on_former(const StandingPackage& package) {
    return "What was measured of the package that stands here is left out, as " +
           package.stale_because + ": run lumi build to its end, and lumi evaluate again.";
}

void judge_poses(Verdict& verdict, const Json& evidence) {
    const std::size_t lost = evidence.at("not_registered").size();
    if (lost > 0) {
        add_remark(verdict, std::to_string(lost) + " of " +
                                std::to_string(evidence.at("photographs_total").get<int>()) +
                                " photographs found no place; the reasons are listed below.");
    }
    for (const Json& warning : evidence.at("warnings")) {
        add_remark(verdict, warning.get<std::string>());
    }
}

/// Those without a pose are no part of the mean.
std::string judged_photographs(const Json& evaluation) {
    const std::size_t not_judged = evaluation.value("not_judged", Json::array()).size();
    if (not_judged == 0) return "Held-out photographs are";
    const std::size_t judged = evaluation.at("views").size();
    return std::to_string(judged) + " of " + std::to_string(judged + not_judged) +
           " held-out photographs " + (judged == 1 ? "is" : "are");
}

void judge_evaluation(Verdict& verdict, const Json& evaluation) {
    if (evaluation.is_null()) {
        verdict.remarks.emplace_back(
            "No rendering was measured yet: hold out photographs and run lumi evaluate.");
        return;
    }
    const Json& mean = evaluation.at("mean");
    verdict.headline += " " + judged_photographs(evaluation) + " reproduced at " +
                        number_text(mean.at("psnr_db").get<double>(), 1) + " dB, " +
                        number_text(100.0 * mean.at("coverage").get<double>(), 1) +
                        " % of the frame covered.";
    if (const auto but_for_exposure =
            psnr_but_for_exposure_db(optional_number(mean.value("psnr_covered_db", Json())),
                                     optional_number(mean.value("psnr_gain_fitted_db", Json()))))
        verdict.headline +=
            " Photographs and pictures of them differ in exposure: but for that it "
            "would be " +
            number_text(*but_for_exposure, 1) + " dB over what is covered.";
}

}  // namespace

Verdict verdict_of(const Json& stages, const StandingPackage& package, const Json& evaluation) {
    Verdict verdict;
    if (stages.contains("failure")) {
        const Json& failure = stages.at("failure");
        verdict.level = Verdict::Level::kBad;
        verdict.headline =
            failure.at("code").get<std::string>() + ": " + failure.at("what").get<std::string>();
        verdict.remarks = {failure.at("advice").get<std::string>()};
        if (package.is_former()) verdict.remarks.push_back(remark_on_former(package));
        return verdict;
    }
    bool is_packed = false;
    for (const Json& stage : stages.at("stages")) {
        if (stage.at("name") == "ingest") judge_ingest(verdict, stage.at("evidence"));
        if (stage.at("name") == "poses") judge_poses(verdict, stage.at("evidence"));
        is_packed = is_packed || stage.at("name") == "pack";
    }
    if (!package.exists) {
        verdict.headline = "The line was not run to its end: there is no package yet.";
        verdict.level = Verdict::Level::kFair;
        return verdict;
    }
    if (package.is_former()) {
        verdict.headline = "The line was not run to its end.";
        add_remark(verdict, remark_on_former(package));
        return verdict;
    }
    verdict.headline = is_packed ? "The package is finished."
                                 : "The package is finished, by a run before the last one.";
    judge_evaluation(verdict, evaluation);
    return verdict;
}

}  // namespace lumi
