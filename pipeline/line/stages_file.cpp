#include "pipeline/line/stages_file.h"

#include <nlohmann/json.hpp>

#include "calib/work/printable.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Json stage_json(const FinishedStage& stage) {
    return Json{{"name", stage.name},
                {"state", stage.was_run ? "run" : "up to date"},
                {"reason", stage.reason},
                {"wall_s", stage.cost.wall_s},
                {"cpu_s", stage.cost.cpu_s},
                {"peak_mib", stage.cost.peak_mib},
                {"evidence", Json::parse(stage.evidence.facts_json)},
                {"timings", Json::parse(stage.evidence.timings_json)}};
}

Json run_json(const std::vector<FinishedStage>& stages, const std::string& configuration_sha256) {
    Json json = stages_json(stages);
    json["configuration_sha256"] = configuration_sha256;
    return json;
}

}  // namespace

Json stages_json(const std::vector<FinishedStage>& stages) {
    Json list = Json::array();
    for (const FinishedStage& stage : stages) list.push_back(stage_json(stage));
    return Json{{"schema_version", 1}, {"stages", std::move(list)}};
}

void write_stages_file(const std::filesystem::path& path, const std::vector<FinishedStage>& stages,
                       const std::string& configuration_sha256) {
    write_json_file(path, run_json(stages, configuration_sha256));
}

void write_stages_file(const std::filesystem::path& path, const std::vector<FinishedStage>& stages,
                       const std::string& configuration_sha256, const std::string& failed_stage,
                       const Error& failure) {
    Json json = run_json(stages, configuration_sha256);
    json["failure"] = {{"stage", failed_stage},
                       {"code", failure.code()},
                       {"what", printable(failure.what())},
                       {"advice", printable(failure.advice())},
                       {"exit_code", failure.exit_code()}};
    write_json_file(path, json);
}

}  // namespace lumi
