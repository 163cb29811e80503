#pragma once

#include <cstddef>
#include <filesystem>

#include "calib/work/progress.h"
#include "calib/work/whole_folder.h"

namespace lumi {

/// To be called before anything is drawn: whether the programs that write_video runs are there and
/// start. Throws Error: E-CHILD-MISSING, E-VIDEO-WRITE, E-INTERRUPTED.
void check_video_programs(const std::filesystem::path& video, const Progress& progress);

/// Makes an MP4 (H.264, 4:2:0, odd sides longer by their last pixels once more) of `count` frames
/// of one size that lie in `frames.staging()` under their sequence names (frame_files.h). Colours
/// are coded by the matrix of BT.709, which players of today take where nothing is said, and the
/// file says so, with the primaries and the curve of sRGB. Runs ffmpeg; the frames of what it made
/// are counted before the file is put in place, whole or not at all. Where that fails, the frames
/// are put in place instead, as drawing them may have taken hours, and the error says where; not
/// where the user asked to stop. Throws Error: E-CHILD-..., E-VIDEO-WRITE, E-FILE-WRITE,
/// E-INTERRUPTED, and what read_image_size throws.
void write_video(WholeFolder& frames, std::size_t count, double frames_per_second,
                 const std::filesystem::path& video, const Progress& progress);

}  // namespace lumi
