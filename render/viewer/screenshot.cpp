#include "render/viewer/screenshot.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "calib/capture/image_io.h"
#include "calib/work/printable.h"
#include "calib/work/whole_file.h"

namespace lumi {

void write_screenshot(const std::filesystem::path& path, const Frame& frame, const Eye& eye,
                      const RenderOptions& options, const std::string& lumigraph_name) {
    const Eigen::Quaterniond& q = eye.cam_from_world.rotation;
    const Eigen::Vector3d& t = eye.cam_from_world.translation;
    const nlohmann::ordered_json pose = {{"lumigraph", printable(lumigraph_name)},
                                         {"mode", name_of(options.mode)},
                                         {"debug_picture", name_of(options.debug_picture)},
                                         {"correct_occlusion", options.correct_occlusion},
                                         {"occlusion_tolerance_px", options.occlusion_tolerance_px},
                                         {"camera",
                                          {{"model", name_of(eye.camera.model)},
                                           {"width_px", eye.camera.width_px},
                                           {"height_px", eye.camera.height_px},
                                           {"parameters", eye.camera.parameters}}},
                                         {"cam_from_world",
                                          {{"rotation_wxyz", {q.w(), q.x(), q.y(), q.z()}},
                                           {"translation", {t.x(), t.y(), t.z()}}}}};
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
