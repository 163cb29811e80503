#pragma once

#include <gtest/gtest.h>
#include <libheif/heif.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "calib/capture/image.h"
#include "calib/pictures/stored_picture.h"
#include "calib/work/whole_file.h"

namespace lumi {

struct HeifOptions {
    heif_compression_format codec = heif_compression_HEVC;
    int bits = 8;
    bool has_alpha = false;  ///< Opaque on the left half.
    heif_orientation turned = heif_orientation_normal;
    Bytes exif = {};  ///< From the TIFF header on.
    Bytes icc_profile = {};
    std::optional<CodedColors> coded = std::nullopt;
};

/// The stored size is that before turning (ISO/IEC 23008-12, 6.5.3.1), as telephones write it;
/// libheif 1.15 writes the other.
inline void swap_stored_size(Bytes& heif) {
    constexpr std::string_view kBox = "ispe";
    const auto box = std::search(heif.begin(), heif.end(), kBox.begin(), kBox.end());
    ASSERT_NE(box, heif.end());
    std::swap_ranges(box + 8, box + 12, box + 12);
}

inline void expect_heif_ok(const heif_error& error) {
    EXPECT_EQ(error.code, heif_error_Ok) << error.message;
}

/// What libheif makes of a picture at its best quality.
[[nodiscard]] inline Bytes heif_of(const ColorImage& picture, const HeifOptions& options = {}) {
    heif_image* image = nullptr;
    const bool is_deep = options.bits > 8;
    const int channels = options.has_alpha ? 4 : 3;
    const heif_chroma chroma = is_deep             ? heif_chroma_interleaved_RRGGBB_LE
                               : options.has_alpha ? heif_chroma_interleaved_RGBA
                                                   : heif_chroma_interleaved_RGB;
    expect_heif_ok(
        heif_image_create(picture.width(), picture.height(), heif_colorspace_RGB, chroma, &image));
    expect_heif_ok(heif_image_add_plane(image, heif_channel_interleaved, picture.width(),
                                        picture.height(), options.bits));
    int stride = 0;
    std::uint8_t* plane = heif_image_get_plane(image, heif_channel_interleaved, &stride);
    const unsigned most = (1U << static_cast<unsigned>(options.bits)) - 1;
    for (int y = 0; y < picture.height(); ++y) {
        std::uint8_t* row = plane + static_cast<std::ptrdiff_t>(y) * stride;
        for (int x = 0; x < picture.width(); ++x) {
            const Rgb8& pixel = picture(x, y);
            const std::uint8_t alpha = x < picture.width() / 2 ? 255 : 0;
            const std::uint8_t values[4] = {pixel.r, pixel.g, pixel.b, alpha};
            for (int channel = 0; channel < channels; ++channel) {
                const unsigned deep = values[channel] * most / 255;
                if (is_deep) {
                    *row++ = static_cast<std::uint8_t>(deep & 255U);
                    *row++ = static_cast<std::uint8_t>(deep >> 8U);
                } else {
                    *row++ = values[channel];
                }
            }
        }
    }
    if (!options.icc_profile.empty()) {
        expect_heif_ok(heif_image_set_raw_color_profile(image, "prof", options.icc_profile.data(),
                                                        options.icc_profile.size()));
    }
    heif_color_profile_nclx* coded = heif_nclx_color_profile_alloc();
    heif_encoding_options* encoding = heif_encoding_options_alloc();
    encoding->image_orientation = options.turned;
    if (options.coded) {
        heif_nclx_color_profile_set_color_primaries(
            coded, static_cast<std::uint16_t>(options.coded->primaries));
        heif_nclx_color_profile_set_transfer_characteristics(
            coded, static_cast<std::uint16_t>(options.coded->transfer));
        expect_heif_ok(heif_image_set_nclx_color_profile(image, coded));
        encoding->output_nclx_profile = coded;
        encoding->macOS_compatibility_workaround_no_nclx_profile = 0;
    }
    heif_context* context = heif_context_alloc();
    heif_encoder* encoder = nullptr;
    expect_heif_ok(heif_context_get_encoder_for_format(context, options.codec, &encoder));
    heif_encoder_set_lossy_quality(encoder, 100);
    if (options.codec == heif_compression_HEVC) {
        heif_encoder_set_parameter_string(encoder, "chroma", "444");
    }
    heif_image_handle* handle = nullptr;
    expect_heif_ok(heif_context_encode_image(context, image, encoder, encoding, &handle));
    if (!options.exif.empty()) {
        expect_heif_ok(heif_context_add_exif_metadata(context, handle, options.exif.data(),
                                                      static_cast<int>(options.exif.size())));
    }
    Bytes bytes;
    heif_writer writer{1, [](heif_context*, const void* data, std::size_t size, void* to) {
                           const auto* first = static_cast<const std::uint8_t*>(data);
                           static_cast<Bytes*>(to)->assign(first, first + size);
                           return heif_error{heif_error_Ok, heif_suberror_Unspecified, ""};
                       }};
    expect_heif_ok(heif_context_write(context, &writer, &bytes));
    heif_image_handle_release(handle);
    heif_encoder_release(encoder);
    heif_encoding_options_free(encoding);
    heif_nclx_color_profile_free(coded);
    heif_image_release(image);
    heif_context_free(context);
    return bytes;
}

}  // namespace lumi
