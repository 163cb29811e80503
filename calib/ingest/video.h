#pragma once

#include <filesystem>
#include <vector>

#include "calib/ingest/working_copies.h"
#include "calib/work/progress.h"

namespace lumi {

/// The sharpest frame of each 1 / `options.video_fps` seconds, named after its number in the video
/// (`frame-000042.png`). Frames are as stored, but that their pixels are made square; the video's
/// rotation goes into the EXIF orientation. What a video says of its colours, such as the HLG of
/// telephones, becomes sRGB. A last candidate that is left out tells when the video ends early.
/// Throws Error (E-INGEST-NOVIDEO, E-INGEST-HDR).
[[nodiscard]] std::vector<Candidate> ingest_video(const std::filesystem::path& video,
                                                  const IngestOptions& options,
                                                  const std::filesystem::path& copies_folder,
                                                  Progress& progress);

}  // namespace lumi
