#include "render/viewer/path_recording.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "calib/work/whole_file.h"
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

}  // namespace lumi
