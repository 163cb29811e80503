#include "render/viewer/screenshot.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "calib/pictures/image_io.h"
#include "calib/work/printable.h"
#include "calib/work/whole_file.h"
#include "render/viewer/eye_json.h"

namespace lumi {

void write_screenshot(const std::filesystem::path& path, const Frame& frame, const Eye& eye,
                      const RenderOptions& options, Exposures exposures,
                      const std::string& lumigraph_name) {
    nlohmann::ordered_json pose = {{"lumigraph", printable(lumigraph_name)},
                                   {"mode", name_of(options.mode)},
                                   {"debug_picture", name_of(options.debug_picture)},
                                   {"correct_occlusion", options.correct_occlusion},
                                   {"fade_beyond_capture", options.fade_beyond_capture},
                                   {"guess_surroundings", options.guess_surroundings},
                                   {"as_taken", exposures == Exposures::kAsTaken}};
    pose.update(eye_json(eye));
    write_png(path, frame.color);
    write_whole_text(std::filesystem::path(path).replace_extension(".json"), pose.dump(2) + "\n");
}

std::filesystem::path next_screenshot_path(const std::filesystem::path& folder) {
    for (int number = 1;; ++number) {
        char name[32];
        std::snprintf(name, sizeof(name), "lumi-%04d.png", number);
        if (!std::filesystem::exists(folder / name)) return folder / name;
    }
}

}  // namespace lumi
