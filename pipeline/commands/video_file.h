#pragma once

#include <cstddef>
#include <filesystem>

#include "calib/work/progress.h"

namespace lumi {

/// Makes an MP4 (H.264, 4:2:0, odd sizes padded by a pixel) of `count` frames that lie in a folder
/// under their sequence names (frame_files.h). Runs ffmpeg; the frames of what it made are counted
/// before the file is put in place, whole or not at all. Leaves files in the folder. Throws Error:
/// E-CHILD-MISSING, E-VIDEO-WRITE, E-FILE-WRITE, E-INTERRUPTED.
void write_video(const std::filesystem::path& frames_folder, std::size_t count,
                 double frames_per_second, const std::filesystem::path& video,
                 const Progress& progress);

}  // namespace lumi
