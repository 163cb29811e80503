#include "pipeline/line/finished_stages.h"

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

namespace lumi {

std::vector<ContentEntry> outputs_of(const std::vector<FinishedStage>& finished,
                                     const std::string& stage, const std::string& prefix) {
    const auto found =
        std::find_if(finished.begin(), finished.end(),
                     [&](const FinishedStage& candidate) { return candidate.name == stage; });
    assert(found != finished.end());
    std::vector<ContentEntry> outputs;
    for (const ContentEntry& output : found->outputs) {
        if (output.name.starts_with(prefix)) outputs.push_back(output);
    }
    return outputs;
}

std::string facts_of(const std::vector<FinishedStage>& finished) {
    auto facts = nlohmann::ordered_json::object();
    for (const FinishedStage& stage : finished) {
        facts[stage.name] = nlohmann::ordered_json::parse(stage.evidence.facts_json);
    }
    return facts.dump();
}

}  // namespace lumi
