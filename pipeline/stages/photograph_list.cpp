#include "pipeline/stages/photograph_list.h"

#include <nlohmann/json.hpp>

#include "pipeline/stages/left_out_json.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path list_path(const fs::path& ingest_folder) { return ingest_folder / "photographs.json"; }

Json photograph_json(const Photograph& photograph) {
    const auto& focal_length_px = photograph.focal_length_px;
    return Json{{"name", photograph.name},
                {"picture", photograph.picture_path.filename().string()},
                {"width_px", photograph.width_px},
                {"height_px", photograph.height_px},
                {"original_width_px", photograph.original_width_px},
                {"original_height_px", photograph.original_height_px},
                {"exif_orientation", photograph.exif_orientation},
                {"focal_length_px", focal_length_px ? Json(*focal_length_px) : Json(nullptr)},
                {"camera_key", photograph.camera_key}};
}

Photograph photograph_from(const Json& json, const fs::path& ingest_folder) {
    Photograph photograph;
    photograph.name = json.at("name");
    photograph.picture_path = ingest_folder / json.at("picture").get<std::string>();
    photograph.width_px = json.at("width_px");
    photograph.height_px = json.at("height_px");
    photograph.original_width_px = json.at("original_width_px");
    photograph.original_height_px = json.at("original_height_px");
    photograph.exif_orientation = json.at("exif_orientation");
    if (const Json& focal_length_px = json.at("focal_length_px"); !focal_length_px.is_null()) {
        photograph.focal_length_px = focal_length_px.get<double>();
    }
    photograph.camera_key = json.at("camera_key");
    return photograph;
}

}  // namespace

void write_photograph_list(const fs::path& ingest_folder, const IngestResult& result) {
    Json photographs = Json::array();
    for (const Photograph& photograph : result.photographs) {
        photographs.push_back(photograph_json(photograph));
    }
    write_json_file(list_path(ingest_folder), Json{{"photographs", std::move(photographs)},
                                                   {"left_out", left_out_json(result.left_out)}});
}

IngestResult read_photograph_list(const fs::path& ingest_folder) {
    const Json json = read_json_file(list_path(ingest_folder));
    try {
        IngestResult result;
        for (const Json& entry : json.at("photographs")) {
            result.photographs.push_back(photograph_from(entry, ingest_folder));
        }
        result.left_out = left_out_from(json.at("left_out"));
        return result;
    } catch (const Json::exception& error) {
        refuse_json(list_path(ingest_folder), error);
    }
}

}  // namespace lumi
