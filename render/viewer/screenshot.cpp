#include "render/viewer/screenshot.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "calib/work/whole_file.h"
#include "render/viewer/eye_json.h"

namespace lumi {
namespace {

constexpr std::size_t kMaxPoseBytes = std::size_t{1} << 20;

std::filesystem::path pose_beside(std::filesystem::path picture) {
    return picture.replace_extension(".json");
}

bool holds_pose(const std::filesystem::path& file) {
    try {
        const auto json = nlohmann::json::parse(read_whole_text(file, kMaxPoseBytes), nullptr,
                                                /*allow_exceptions=*/false);
        return json.is_object() && json.contains("cam_from_world");
    } catch (const Error&) {
        return false;  // What cannot be read is somebody's.
    }
}

}  // namespace

void check_screenshot_out(const std::filesystem::path& path) {
    const std::filesystem::path pose = pose_beside(path);
    std::error_code status;
    if (!std::filesystem::exists(pose, status) || holds_pose(pose)) return;
    throw Error(ErrorKind::kUsage, "E-SCREENSHOT-OUT",
                pose.string() + ": is no screenshot's pose, which would take its place",
                "give the screenshot another name");
}

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
    check_screenshot_out(path);
    write_png(path, frame.color);
    write_whole_text(pose_beside(path), pose.dump(2) + "\n");
}

std::filesystem::path next_screenshot_path(const std::filesystem::path& folder) {
    for (int number = 1;; ++number) {
        char name[32];
        std::snprintf(name, sizeof(name), "lumi-%04d.png", number);
        const std::filesystem::path path = folder / name;
        if (!std::filesystem::exists(path) && !std::filesystem::exists(pose_beside(path)))
            return path;
    }
}

}  // namespace lumi
