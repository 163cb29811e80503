#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/paths/timed_path.h"

namespace lumi {

/// How a frame was drawn, as far as the file beside a screenshot says.
struct DrawnAlike {
    std::optional<RenderMode> mode;
    std::optional<DebugPicture> debug_picture;
    std::optional<bool> correct_occlusion;
    std::optional<bool> fade_beyond_capture;
    std::optional<bool> guess_surroundings;
    std::optional<bool> as_taken;  ///< Exposures and white balance as photographed.
};

struct EyeFile {
    Eye eye;
    DrawnAlike drawn;
};

/// An eye from a JSON file, as the window writes beside a screenshot (write_screenshot):
///
///     {"camera": {"model": "PINHOLE", "width_px": 640, "height_px": 480,
///                 "parameters": [fx, fy, cx, cy]},
///      "cam_from_world": {"rotation_wxyz": [1, 0, 0, 0], "translation": [0, 0, 0]},
///      "mode": "perpixel", "debug_picture": "none", "correct_occlusion": true,
///      "fade_beyond_capture": false, "guess_surroundings": true, "as_taken": false}
///
/// Pixels as everywhere: (0.5, 0.5) is the centre of the top-left one. What stands behind the pose
/// may be missing, and other keys are passed over. Throws Error (E-JSON-READ, E-CAMERA-INVALID)
/// naming the file.
[[nodiscard]] EyeFile read_eye_file(const std::filesystem::path& path);

/// Of a path without times, where nothing else is asked for.
inline constexpr double kUsualEyesPerSecond = 30.0;

/// A path of eyes of one size, as the window records: {"eyes": [ ... ]}, each a camera and a pose
/// as above with its "time_s"; the path begins with the first eye, at time 0. Two eyes at one time
/// are a jump. Where no eye has a time, as in files of early versions, so many pass a second. What
/// a screenshot's eye says besides is passed over. Throws Error (E-JSON-READ: unknown keys, too;
/// E-CAMERA-INVALID) naming the file and, as "eyes[7]", counted from 0, the eye.
[[nodiscard]] std::vector<TimedEye> read_path_file(const std::filesystem::path& path,
                                                   double eyes_per_second_without_times);

/// What a window wrote: a screenshot's eye, then alone and at time 0, or a path. Of a screenshot's
/// PNG file the eye in the JSON file beside it. Throws Error (E-FILE-READ, E-JSON-READ,
/// E-CAMERA-INVALID).
[[nodiscard]] std::vector<TimedEye> read_eyes_of_window(const std::filesystem::path& path);

}  // namespace lumi
