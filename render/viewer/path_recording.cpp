#include "render/viewer/path_recording.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "render/lumigraph/same_eye.h"
#include "render/viewer/eye_json.h"

namespace lumi {

void write_path_file(const std::filesystem::path& path, std::span<const Eye> eyes) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Eye& eye : eyes) list.push_back(eye_json(eye));
    write_whole_text(path, nlohmann::ordered_json{{"eyes", std::move(list)}}.dump(1) + "\n");
}

std::filesystem::path next_path_file(const std::filesystem::path& folder) {
    for (int number = 1;; ++number) {
        char name[32];
        std::snprintf(name, sizeof(name), "lumi-path-%04d.json", number);
        if (!std::filesystem::exists(folder / name)) return folder / name;
    }
}

std::string PathRecording::append(const Eye& eye) {
    const bool has_size = eyes_.empty() || (eyes_.front().camera.width_px == eye.camera.width_px &&
                                            eyes_.front().camera.height_px == eye.camera.height_px);
    if (has_size && (eyes_.empty() || !is_same_eye(eyes_.back(), eye))) eyes_.push_back(eye);
    return "recording: " + std::to_string(eyes_.size()) + " eyes";
}

std::string PathRecording::end(const std::filesystem::path& folder) {
    if (eyes_.empty()) return {};
    const std::vector<Eye> eyes = std::exchange(eyes_, {});
    const std::filesystem::path path = next_path_file(folder);
    try {
        write_path_file(path, eyes);
        return "wrote " + path.filename().string();
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace lumi
