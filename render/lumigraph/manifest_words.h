#pragma once

#include <cstddef>

namespace lumi {

/// The words of a manifest that its writer and its reader must agree on.
inline constexpr const char* kPackageFormat = "lumi package";
inline constexpr const char* kBlendingSpace = "srgb";
inline constexpr const char* kManifestChecksumKey = "manifest_sha256";
inline constexpr std::size_t kChecksumDigits = 64;

}  // namespace lumi
