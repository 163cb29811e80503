#pragma once

#include <webp/encode.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "calib/capture/image.h"
#include "calib/work/whole_file.h"

namespace lumi {

/// Without loss.
[[nodiscard]] inline Bytes webp_of(const ColorImage& picture) {
    std::uint8_t* encoded = nullptr;
    const std::size_t size = WebPEncodeLosslessRGB(&picture.pixels()[0].r, picture.width(),
                                                   picture.height(), 3 * picture.width(), &encoded);
    Bytes bytes(encoded, encoded + size);
    WebPFree(encoded);
    return bytes;
}

inline void append_little_endian(Bytes& bytes, std::size_t number, int count) {
    for (int i = 0; i < count; ++i)
        bytes.push_back(static_cast<std::uint8_t>(number >> (8 * static_cast<unsigned>(i))));
}

inline void append_chunk(Bytes& bytes, std::string_view name, const Bytes& content) {
    bytes.insert(bytes.end(), name.begin(), name.end());
    append_little_endian(bytes, content.size(), 4);
    bytes.insert(bytes.end(), content.begin(), content.end());
    if (content.size() % 2 == 1) bytes.push_back(0);
}

/// The extended file format: a profile before the picture and EXIF behind it (WebP container
/// specification).
[[nodiscard]] inline Bytes webp_with(const Bytes& simple, int width_px, int height_px,
                                     const Bytes& profile, const Bytes& exif) {
    constexpr std::size_t kRiffHeader = 12;
    Bytes features;
    append_little_endian(features, (profile.empty() ? 0U : 0x20U) | (exif.empty() ? 0U : 0x08U), 4);
    append_little_endian(features, static_cast<std::size_t>(width_px - 1), 3);
    append_little_endian(features, static_cast<std::size_t>(height_px - 1), 3);
    Bytes chunks;
    append_chunk(chunks, "VP8X", features);
    if (!profile.empty()) append_chunk(chunks, "ICCP", profile);
    chunks.insert(chunks.end(), simple.begin() + kRiffHeader, simple.end());
    if (!exif.empty()) append_chunk(chunks, "EXIF", exif);
    Bytes bytes{'R', 'I', 'F', 'F'};
    append_little_endian(bytes, chunks.size() + 4, 4);
    for (const char letter : std::string_view("WEBP")) {
        bytes.push_back(static_cast<std::uint8_t>(letter));
    }
    bytes.insert(bytes.end(), chunks.begin(), chunks.end());
    return bytes;
}

}  // namespace lumi
