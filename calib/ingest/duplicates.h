#pragma once

#include <string>
#include <vector>

#include "calib/capture/image.h"

namespace lumi {

struct Candidate;

/// SHA-256 of the size and the pixels: equal for the same picture in two files or formats.
[[nodiscard]] std::string pixels_sha256(const ColorImage& raster);

/// The picture averaged down to at most 128 pixels on its longer side.
[[nodiscard]] ColorImage thumbnail_of(const ColorImage& picture);

/// True when two thumbnails differ by no more than sensor noise and JPEG do: on average and at
/// every single pixel. A movement of a few pixels of a working copy already shows at an edge.
[[nodiscard]] bool hardly_differ(const ColorImage& a, const ColorImage& b);

/// Leaves out (E-INGEST-DUPLICATE) all but one of the candidates with the same pixels, of which the
/// one is kept whose name is like most others but for its digits, or else the first; and whatever
/// hardly differs from the last one kept: the camera did not move, so nothing is gained.
void leave_out_duplicates(std::vector<Candidate>& candidates);

}  // namespace lumi
