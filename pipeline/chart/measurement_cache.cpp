#include "pipeline/chart/measurement_cache.h"

#include <nlohmann/json.hpp>

#include "calib/work/content_hash.h"
#include "calib/work/error.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/line/code_version.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path MeasurementCache::path_of(const std::string& what, RenderMode mode) const {
    return folder_ / (sha256_hex(what + '|' + name_of(mode) + '|' + gl_description_ + '|' +
                                 code_version_of("evaluate")) +
                      ".json");
}

std::optional<Measurement> MeasurementCache::find(const std::string& what, RenderMode mode) const {
    try {
        const Json json = read_json_file(path_of(what, mode));
        return Measurement{mode_scores_from(mode, json.at("scores")), json.at("gl"),
                           json.at("cpu_s")};
    } catch (const Error&) {
        return std::nullopt;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

void MeasurementCache::keep(const std::string& what, const Measurement& measurement) const {
    write_json_file(path_of(what, measurement.scores.mode),
                    Json{{"gl", measurement.gl_description},
                         {"cpu_s", measurement.cpu_s},
                         {"scores", mode_scores_json(measurement.scores)}});
}

}  // namespace lumi
