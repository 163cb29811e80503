#pragma once

#include <cstdint>
#include <filesystem>

#include "render/lumigraph/manifest.h"
#include "render/lumigraph/package.h"

namespace lumi {

/// The most pixels that a picture in a package may have.
inline constexpr std::uint64_t kMaxPixelsPerPicture = std::uint64_t{1} << 28;

/// The most bytes that reading a package takes on `threads` threads, as its manifest announces
/// them: decoded photographs, depth and triangles, which stay, and the largest of the files and
/// codes that they are decoded from, as many at a time as there are threads. No claim is too large
/// to be counted: sums end at the largest number.
[[nodiscard]] std::uint64_t memory_to_read(const Manifest& manifest, int threads);

/// Before any file that the manifest lists is read, and before a package is put in place. Throws
/// Error (E-PACKAGE-BUDGET) where a picture has too many pixels or reading takes more than the
/// limits allow.
void expect_readable(const Manifest& manifest, const std::filesystem::path& folder,
                     const PackageLimits& limits);

}  // namespace lumi
