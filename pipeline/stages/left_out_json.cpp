#include "pipeline/stages/left_out_json.h"

#include <nlohmann/json.hpp>

namespace lumi {

using Json = nlohmann::ordered_json;

Json left_out_json(const std::vector<LeftOut>& left_out) {
    Json json = Json::array();
    for (const LeftOut& entry : left_out) {
        json.push_back({{"name", entry.name}, {"code", entry.code}, {"reason", entry.reason}});
    }
    return json;
}

std::vector<LeftOut> left_out_from(const Json& json) {
    std::vector<LeftOut> left_out;
    for (const Json& entry : json) {
        left_out.push_back({entry.at("name"), entry.at("code"), entry.at("reason")});
    }
    return left_out;
}

}  // namespace lumi
