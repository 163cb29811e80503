#include "pipeline/workspace/done_marker.h"

#include <nlohmann/json.hpp>

#include "calib/work/content_hash.h"
#include "calib/work/error.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Json outputs_json(const std::vector<ContentEntry>& outputs) {
    Json json = Json::object();
    for (const ContentEntry& output : outputs) json[output.name] = output.sha256;
    return json;
}

DoneMarker marker_from(const Json& json) {
    DoneMarker marker;
    const Json& identity = json.at("identity");
    marker.identity = {identity.at("stage"), identity.at("code"), identity.at("parameters"),
                       identity.at("external_tool"), identity.at("inputs")};
    for (const auto& [name, sha256] : json.at("outputs").items()) {
        marker.outputs.push_back({name, sha256});
    }
    marker.cost = {json.at("wall_s"), json.at("cpu_s"), json.at("peak_mib")};
    marker.evidence = {json.at("evidence").dump(), json.at("timings").dump()};
    return marker;
}

}  // namespace

std::string stage_key(const StageIdentity& identity) {
    std::string text;
    for (const std::string* part : {&identity.stage, &identity.code, &identity.parameters,
                                    &identity.external_tool, &identity.inputs}) {
        text += std::to_string(part->size()) + ':' + *part;
    }
    return sha256_hex(text);
}

void write_done_marker(const std::filesystem::path& path, const DoneMarker& marker) {
    const StageIdentity& identity = marker.identity;
    write_json_file(path, Json{{"key", stage_key(identity)},
                               {"identity",
                                {{"stage", identity.stage},
                                 {"code", identity.code},
                                 {"parameters", identity.parameters},
                                 {"external_tool", identity.external_tool},
                                 {"inputs", identity.inputs}}},
                               {"outputs", outputs_json(marker.outputs)},
                               {"wall_s", marker.cost.wall_s},
                               {"cpu_s", marker.cost.cpu_s},
                               {"peak_mib", marker.cost.peak_mib},
                               {"evidence", Json::parse(marker.evidence.facts_json)},
                               {"timings", Json::parse(marker.evidence.timings_json)}});
}

std::optional<DoneMarker> read_done_marker(const std::filesystem::path& path) {
    try {
        const Json json = read_json_file(path);
        DoneMarker marker = marker_from(json);
        if (json.at("key") != stage_key(marker.identity)) return std::nullopt;
        return marker;
    } catch (const Error&) {
        return std::nullopt;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

}  // namespace lumi
