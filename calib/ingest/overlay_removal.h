#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/ingest/ingest.h"

namespace lumi {

/// Takes what was laid over the photographs of one size and EXIF orientation, eight or more
/// (overlay.h), out of their working copies: cuts bars off, where the options allow it, and paints
/// over stamps, logos, watermarks and black corners with the colours around them (Telea, An image
/// inpainting technique based on the fast marching method, 2004). Then cuts bars off that some
/// photographs of a size have and others have not (own_bars.h), those that two have alike. Rewrites
/// these copies and their sizes, and writes the masks beside them. The centre of what is left
/// counts as the lens's. Throws Error where a copy cannot be read or written (E-IMAGE-...,
/// E-FILE-...), and Interrupted.
[[nodiscard]] std::vector<RemovedOverlay> remove_overlays(
    std::vector<Photograph>& photographs, const IngestOptions& options,
    const std::filesystem::path& copies_folder, int threads, Progress& progress);

/// What was taken out, and how to leave it in.
[[nodiscard]] std::string text_of(const RemovedOverlay& overlay);

}  // namespace lumi
