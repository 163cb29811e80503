#include "pipeline/report/verdict.h"

#include <nlohmann/json.hpp>

#include "pipeline/text/number_text.h"

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
        add_remark(verdict, std::to_string(left_out) +
                                " files were left out; the reasons are listed below.");
    }
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

void judge_evaluation(Verdict& verdict, const Json& evaluation) {
    if (evaluation.is_null()) {
        verdict.remarks.emplace_back(
            "No rendering was measured yet: hold out photographs and run lumi evaluate.");
        return;
    }
    const Json& mean = evaluation.at("mean");
    verdict.headline += " Held-out photographs are reproduced at " +
                        number_text(mean.at("psnr_db").get<double>(), 1) + " dB, " +
                        number_text(100.0 * mean.at("coverage").get<double>(), 1) +
                        " % of the frame covered.";
}

}  // namespace

Verdict verdict_of(const Json& stages, const Json& evaluation) {
    Verdict verdict;
    if (stages.contains("failure")) {
        const Json& failure = stages.at("failure");
        verdict.level = Verdict::Level::kBad;
        verdict.headline =
            failure.at("code").get<std::string>() + ": " + failure.at("what").get<std::string>();
        verdict.remarks = {failure.at("advice").get<std::string>()};
        return verdict;
    }
    bool is_packed = false;
    for (const Json& stage : stages.at("stages")) {
        if (stage.at("name") == "ingest") judge_ingest(verdict, stage.at("evidence"));
        if (stage.at("name") == "poses") judge_poses(verdict, stage.at("evidence"));
        is_packed = is_packed || stage.at("name") == "pack";
    }
    if (!is_packed) {
        verdict.headline = "The line was not run to its end: there is no package yet.";
        verdict.level = Verdict::Level::kFair;
        return verdict;
    }
    verdict.headline = "The package is finished.";
    judge_evaluation(verdict, evaluation);
    return verdict;
}

}  // namespace lumi
