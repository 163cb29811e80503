#include "calib/pictures/heif_decoder.h"

#include <libheif/heif.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "calib/pictures/before_black.h"
#include "calib/pictures/color_tags.h"
#include "calib/pictures/image_format.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

using Context = std::unique_ptr<heif_context, void (*)(heif_context*)>;
using Handle = std::unique_ptr<const heif_image_handle, void (*)(const heif_image_handle*)>;
using Decoded = std::unique_ptr<const heif_image, void (*)(const heif_image*)>;

void expect_ok(const heif_error& error, const std::filesystem::path& path) {
    if (error.code == heif_error_Ok) return;
    // The other error of this code is that a file asks for absurdly much.
    if (error.code == heif_error_Memory_allocation_error &&
        error.subcode != heif_suberror_Security_limit_exceeded)
        throw std::bad_alloc();
    if (error.code == heif_error_Unsupported_filetype ||
        error.code == heif_error_Unsupported_feature) {
        refuse_unsupported_image(path, error.message);
    }
    refuse_truncated_image(path, error.message);
}

/// The primary picture; the bytes must outlive it.
struct Primary {
    Context context{nullptr, heif_context_free};
    Handle handle{nullptr, heif_image_handle_release};

    [[nodiscard]] ImageSize size() const {
        return {heif_image_handle_get_ispe_width(handle.get()),
                heif_image_handle_get_ispe_height(handle.get())};
    }
};

heif_error open_primary(std::span<const std::uint8_t> bytes, Primary& primary) {
    primary.context.reset(heif_context_alloc());
    heif_error error = heif_context_read_from_memory_without_copy(
        primary.context.get(), bytes.data(), bytes.size(), nullptr);
    if (error.code != heif_error_Ok) return error;
    heif_image_handle* handle = nullptr;
    error = heif_context_get_primary_image_handle(primary.context.get(), &handle);
    primary.handle.reset(handle);
    return error;
}

/// Of a raster in rows of interleaved samples.
struct Samples {
    const std::uint8_t* first = nullptr;
    int bytes_a_row = 0;
    SampleLayout layout;
    int bits = 8;
};

/// Without what fills up its rows; samples of more than 8 bits stretched over 16.
template <class Sample>
std::vector<Sample> packed(const Samples& samples) {
    const auto a_row = static_cast<std::size_t>(samples.layout.width_px) *
                       static_cast<std::size_t>(samples.layout.channels);
    std::vector<Sample> result;
    result.reserve(a_row * static_cast<std::size_t>(samples.layout.height_px));
    const unsigned most = (1U << static_cast<unsigned>(samples.bits)) - 1;
    for (int y = 0; y < samples.layout.height_px; ++y) {
        const std::uint8_t* row =
            samples.first + static_cast<std::ptrdiff_t>(y) * samples.bytes_a_row;
        if constexpr (sizeof(Sample) == 1) {
            result.insert(result.end(), row, row + a_row);
        } else {
            for (std::size_t i = 0; i < a_row; ++i) {
                const unsigned value = row[2 * i] | static_cast<unsigned>(row[2 * i + 1]) << 8U;
                result.push_back(static_cast<Sample>((value * 65535ULL + most / 2) / most));
            }
        }
    }
    return result;
}

Decoded decoded(const Primary& primary, bool is_deep, bool has_alpha,
                const std::filesystem::path& path) {
    const std::unique_ptr<heif_decoding_options, void (*)(heif_decoding_options*)> options(
        heif_decoding_options_alloc(), heif_decoding_options_free);
    options->ignore_transformations = 1;
    options->strict_decoding = 1;
    const heif_chroma chroma =
        is_deep
            ? (has_alpha ? heif_chroma_interleaved_RRGGBBAA_LE : heif_chroma_interleaved_RRGGBB_LE)
            : (has_alpha ? heif_chroma_interleaved_RGBA : heif_chroma_interleaved_RGB);
    heif_image* image = nullptr;
    const heif_error error =
        heif_decode_image(primary.handle.get(), &image, heif_colorspace_RGB, chroma, options.get());
    Decoded result(image, heif_image_release);
    expect_ok(error, path);
    std::array<heif_error, 1> warning{};
    if (heif_image_get_decoding_warnings(image, 0, warning.data(), 1) > 0) {
        refuse_truncated_image(path, warning[0].message);
    }
    return result;
}

ColorTags color_tags_of(const heif_image_handle* handle) {
    ColorTags tags;
    if (const std::size_t size = heif_image_handle_get_raw_color_profile_size(handle); size > 0) {
        tags.icc_profile.emplace(size);
        heif_image_handle_get_raw_color_profile(handle, tags.icc_profile->data());
    }
    heif_color_profile_nclx* coded = nullptr;
    if (heif_image_handle_get_nclx_color_profile(handle, &coded).code == heif_error_Ok) {
        tags.coded = CodedColors{coded->color_primaries, coded->transfer_characteristics};
    }
    heif_nclx_color_profile_free(coded);
    return tags;
}

}  // namespace

ImageSize heif_size(std::span<const std::uint8_t> bytes, const std::filesystem::path& path) {
    Primary primary;
    expect_ok(open_primary(bytes, primary), path);
    return primary.size();
}

StoredPicture decode_heif(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                          const std::filesystem::path& path) {
    Primary primary;
    expect_ok(open_primary(bytes, primary), path);
    check_image_size(primary.size(), max_pixels, path);
    const heif_image_handle* handle = primary.handle.get();
    const bool is_deep = heif_image_handle_get_luma_bits_per_pixel(handle) > 8;
    const bool has_alpha = heif_image_handle_has_alpha_channel(handle) != 0;
    const Decoded image = decoded(primary, is_deep, has_alpha, path);

    Samples samples;
    samples.first =
        heif_image_get_plane_readonly(image.get(), heif_channel_interleaved, &samples.bytes_a_row);
    if (samples.first == nullptr) refuse_truncated_image(path, "it has no picture");
    samples.layout = {.width_px = heif_image_get_width(image.get(), heif_channel_interleaved),
                      .height_px = heif_image_get_height(image.get(), heif_channel_interleaved),
                      .channels = has_alpha ? 4 : 3,
                      .alpha_channel = has_alpha ? 3 : -1,
                      .is_premultiplied = heif_image_handle_is_premultiplied_alpha(handle) != 0};
    samples.bits = heif_image_get_bits_per_pixel_range(image.get(), heif_channel_interleaved);
    StoredPicture stored;
    if (is_deep) {
        stored.raster = before_black<Rgb16, std::uint16_t>(packed<std::uint16_t>(samples),
                                                           samples.layout, stored.shown);
    } else {
        stored.raster = before_black<Rgb8, std::uint8_t>(packed<std::uint8_t>(samples),
                                                         samples.layout, stored.shown);
    }
    stored.tags = color_tags_of(handle);
    refuse_pq(stored.tags, path);
    return stored;
}

Bytes heif_exif(std::span<const std::uint8_t> bytes) {
    Primary primary;
    if (open_primary(bytes, primary).code != heif_error_Ok) return {};
    heif_item_id id = 0;
    if (heif_image_handle_get_list_of_metadata_block_IDs(primary.handle.get(), "Exif", &id, 1) !=
        1) {
        return {};
    }
    Bytes block(heif_image_handle_get_metadata_size(primary.handle.get(), id));
    if (heif_image_handle_get_metadata(primary.handle.get(), id, block.data()).code !=
        heif_error_Ok) {
        return {};
    }
    // Its first four bytes say where the TIFF header begins behind them.
    if (block.size() < 4) return {};
    std::size_t start = 4;
    for (int i = 0; i < 4; ++i)
        start += static_cast<std::size_t>(block[static_cast<std::size_t>(i)]) << (24 - 8 * i);
    if (start >= block.size()) return {};
    return {block.begin() + static_cast<std::ptrdiff_t>(start), block.end()};
}

}  // namespace lumi
