#pragma once

#include <cstdint>
#include <string>

#include "calib/work/whole_file.h"

namespace lumi {

/// The bytes in less room (zlib, RFC 1950).
[[nodiscard]] Bytes deflated(const Bytes& bytes);

/// The `size` bytes that were deflated. Takes no more memory than that, whatever it is given.
/// Throws Error (E-PACKAGE-MESH), which `where` begins, where there are not exactly so many.
[[nodiscard]] Bytes inflated(const Bytes& deflated, std::uint64_t size, const std::string& where);

}  // namespace lumi
