#include "calib/pictures/webp_decoder.h"

#include <webp/decode.h>

#include <algorithm>
#include <new>
#include <optional>
#include <string_view>
#include <vector>

#include "calib/pictures/before_black.h"
#include "calib/pictures/image_format.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

using ByteSpan = std::span<const std::uint8_t>;

WebPBitstreamFeatures features_of(ByteSpan bytes, const std::filesystem::path& path) {
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK) {
        refuse_truncated_image(path, "the header of the WebP is damaged");
    }
    return features;
}

/// The content of the first chunk of that name (WebP container specification: RIFF).
std::optional<Bytes> chunk_of(ByteSpan bytes, std::string_view name) {
    constexpr std::size_t kFirst = 12;
    constexpr std::size_t kHeader = 8;
    for (std::size_t offset = kFirst; offset + kHeader <= bytes.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            length |= static_cast<std::size_t>(bytes[offset + 4 + i]) << (8 * i);
        }
        const ByteSpan content = bytes.subspan(offset + kHeader);
        if (length > content.size()) break;
        if (std::equal(name.begin(), name.end(),
                       bytes.begin() + static_cast<std::ptrdiff_t>(offset))) {
            return Bytes(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(length));
        }
        offset += kHeader + length + length % 2;
    }
    return std::nullopt;
}

void decode_into(ByteSpan bytes, const SampleLayout& layout, std::vector<std::uint8_t>& samples,
                 const std::filesystem::path& path) {
    WebPDecoderConfig config;
    WebPInitDecoderConfig(&config);
    config.output.colorspace = layout.channels == 4 ? MODE_RGBA : MODE_RGB;
    config.output.is_external_memory = 1;
    config.output.u.RGBA = {samples.data(), layout.channels * layout.width_px, samples.size()};
    const VP8StatusCode status = WebPDecode(bytes.data(), bytes.size(), &config);
    WebPFreeDecBuffer(&config.output);
    if (status == VP8_STATUS_OUT_OF_MEMORY) throw std::bad_alloc();
    if (status != VP8_STATUS_OK) refuse_truncated_image(path, "the WebP ends early or is damaged");
}

}  // namespace

ImageSize webp_size(ByteSpan bytes, const std::filesystem::path& path) {
    const WebPBitstreamFeatures features = features_of(bytes, path);
    return {features.width, features.height};
}

StoredPicture decode_webp(ByteSpan bytes, std::size_t max_pixels,
                          const std::filesystem::path& path) {
    const WebPBitstreamFeatures features = features_of(bytes, path);
    if (features.has_animation != 0) {
        throw Error(ErrorKind::kBadInput, "E-IMAGE-FORMAT", path.string() + ": an animation",
                    "export its frames as JPEG or PNG, or give a video");
    }
    check_image_size({features.width, features.height}, max_pixels, path);
    const bool has_alpha = features.has_alpha != 0;
    const SampleLayout layout{.width_px = features.width,
                              .height_px = features.height,
                              .channels = has_alpha ? 4 : 3,
                              .alpha_channel = has_alpha ? 3 : -1,
                              .is_premultiplied = false};
    std::vector<std::uint8_t> samples(static_cast<std::size_t>(layout.channels) *
                                      static_cast<std::size_t>(layout.width_px) *
                                      static_cast<std::size_t>(layout.height_px));
    decode_into(bytes, layout, samples, path);
    StoredPicture stored;
    stored.raster = before_black<Rgb8, std::uint8_t>(samples, layout, stored.shown);
    stored.tags.icc_profile = chunk_of(bytes, "ICCP");
    return stored;
}

Bytes webp_exif(ByteSpan bytes) {
    using namespace std::string_view_literals;
    Bytes exif = chunk_of(bytes, "EXIF").value_or(Bytes());
    // Some writers keep the header that it has in JPEG files.
    constexpr std::string_view kHeader = "Exif\0\0"sv;
    if (exif.size() > kHeader.size() && std::equal(kHeader.begin(), kHeader.end(), exif.begin())) {
        exif.erase(exif.begin(), exif.begin() + static_cast<std::ptrdiff_t>(kHeader.size()));
    }
    return exif;
}

}  // namespace lumi
