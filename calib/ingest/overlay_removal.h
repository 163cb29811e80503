#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/ingest/ingest.h"

namespace lumi {

/// Takes what was laid over all photographs of a size and orientation out of their working copies:
/// cuts bars off, if wished, and paints over stamps, logos and watermarks with the colours around
/// them (Telea, An image inpainting technique based on the fast marching method, 2004). The centre
/// of what is left counts as the lens's. Where bars have to stay, so does all else that is theirs.
/// Writes the masks beside the copies.
[[nodiscard]] std::vector<RemovedOverlay> remove_overlays(
    std::vector<Photograph>& photographs, bool crop_bars,
    const std::filesystem::path& copies_folder, int threads, Progress& progress);

/// What was taken out, and how to leave it in.
[[nodiscard]] std::string text_of(const RemovedOverlay& overlay);

}  // namespace lumi
