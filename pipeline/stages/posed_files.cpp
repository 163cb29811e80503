#include "pipeline/stages/posed_files.h"

#include <nlohmann/json.hpp>

#include "calib/capture/colmap_model.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path picture_list_path(const fs::path& pinhole_folder) {
    return pinhole_folder / "pictures.json";
}

}  // namespace

void write_posed_photographs(const fs::path& pinhole_folder, const PosedPhotographs& photographs) {
    write_colmap_model_binary(photographs.capture, pinhole_folder);
    Json pictures = Json::object();
    for (std::size_t i = 0; i < photographs.capture.views.size(); ++i) {
        pictures[photographs.capture.views[i].name] =
            fs::relative(photographs.picture_paths[i], pinhole_folder).generic_string();
    }
    write_json_file(picture_list_path(pinhole_folder), pictures);
}

PosedPhotographs read_posed_photographs(const fs::path& pinhole_folder) {
    PosedPhotographs photographs;
    photographs.capture = read_colmap_model(pinhole_folder);
    const Json pictures = read_json_file(picture_list_path(pinhole_folder));
    for (const View& view : photographs.capture.views) {
        const auto picture = pictures.find(view.name);
        if (picture == pictures.end() || !picture->is_string()) {
            refuse_json(picture_list_path(pinhole_folder), "no picture of " + view.name);
        }
        photographs.picture_paths.push_back(
            (pinhole_folder / picture->get<std::string>()).lexically_normal());
    }
    return photographs;
}

}  // namespace lumi
