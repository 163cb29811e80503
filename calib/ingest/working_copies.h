#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/image.h"
#include "calib/ingest/ingest.h"
#include "calib/pictures/image_io.h"

namespace lumi {

/// A photograph on its way in: its working copy is written, and others are still to be compared.
struct Candidate {
    Photograph photograph;
    std::string pixels_sha256;  ///< Of the raster as stored, with its size.
    ColorImage thumbnail;
    ColorConversion conversion;
    bool has_color = true;            ///< The copy (lost_color.h).
    std::optional<LeftOut> left_out;  ///< Then nothing else counts.
};

/// What the names of masks beside working copies begin with (overlay_removal.h).
inline constexpr const char* kOverlayPrefix = "overlay-";

/// As many threads, at least one, as hold a photograph each in 2 GiB.
[[nodiscard]] int threads_within_memory(std::size_t bytes_of_photograph, int threads);

/// Removes the working copies of an earlier run and makes the folder.
void clear_working_copies(const std::filesystem::path& folder);

/// Scales `raster` down as the options ask and writes it as copy `number` (from 1), unless it is
/// tiny (E-INGEST-TINY).
[[nodiscard]] Candidate make_working_copy(const ColorImage& raster, const std::string& name,
                                          const IngestOptions& options,
                                          const std::filesystem::path& folder, std::size_t number);

/// Renames the copies of those that were not left out to 000001.png, 000002.png ... without a gap,
/// in the order given, and removes the others.
[[nodiscard]] std::vector<Photograph> number_working_copies(
    const std::vector<Candidate>& candidates, const std::filesystem::path& folder);

}  // namespace lumi
