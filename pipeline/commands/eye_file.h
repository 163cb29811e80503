#pragma once

#include <filesystem>
#include <vector>

#include "render/lumigraph/lumigraph.h"
#include "render/paths/timed_path.h"

namespace lumi {

/// An eye from a JSON file, as the window writes beside a screenshot:
///
///     {"camera": {"model": "PINHOLE", "width_px": 640, "height_px": 480,
///                 "parameters": [fx, fy, cx, cy]},
///      "cam_from_world": {"rotation_wxyz": [1, 0, 0, 0], "translation": [0, 0, 0]}}
///
/// Pixels as everywhere: (0.5, 0.5) is the centre of the top-left one. Throws Error (E-JSON-READ,
/// E-CAMERA-INVALID) naming the file.
[[nodiscard]] Eye read_eye_file(const std::filesystem::path& path);

/// A path of eyes of one size, as the window records: {"eyes": [ ... ]}, each as above with its
/// "time_s" since the first. Where no eye has a time, as in files of early versions, so many pass a
/// second. Throws Error (E-JSON-READ, E-CAMERA-INVALID) naming the file.
[[nodiscard]] std::vector<TimedEye> read_path_file(const std::filesystem::path& path,
                                                   double eyes_per_second_without_times);

}  // namespace lumi
