#pragma once

#include <filesystem>
#include <string>

#include "calib/capture/camera.h"

namespace lumi {

/// Each reads one family of formats; `where` begins every message. See read_lens_file.
[[nodiscard]] Camera read_lens_toml(const std::filesystem::path& path);
[[nodiscard]] Camera read_lens_colmap(const std::filesystem::path& path);
/// OpenCV, Kalibr and ROS: told apart by their keys.
[[nodiscard]] Camera read_lens_yaml(const std::string& text, const std::string& where);

}  // namespace lumi
