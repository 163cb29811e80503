#include "pipeline/report/report_sources.h"

#include <algorithm>

#include "pipeline/text/html.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

/// "mean_reprojection_error_px" as words.
std::string words_of(std::string key) {
    std::replace(key.begin(), key.end(), '_', ' ');
    return key;
}

}  // namespace

Json evidence_of(const Json& stages, const std::string& stage, const char* part) {
    for (const Json& candidate : stages.at("stages")) {
        if (candidate.at("name") == stage) return candidate.at(part);
    }
    return nullptr;
}

std::string text_of(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return number_text(value.get<double>(), 3);
    return value.dump();
}

std::string table_of_values(const Json& object) {
    TableRows rows;
    for (const auto& [key, value] : object.items()) {
        if (!value.is_structured()) rows.push_back({words_of(key), text_of(value)});
    }
    return html_table({"what", "value"}, rows);
}

}  // namespace lumi
