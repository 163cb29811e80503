#include "calib/pictures/jpeg_decoder.h"

#include <turbojpeg.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "calib/pictures/color_tags.h"
#include "calib/pictures/image_format.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

struct CloseTurboJpeg {
    void operator()(void* handle) const { tjDestroy(handle); }
};
using TurboJpeg = std::unique_ptr<void, CloseTurboJpeg>;

struct JpegHeader {
    ImageSize size;
    int color_space = 0;
};

JpegHeader read_header(void* decoder, std::span<const std::uint8_t> bytes,
                       const std::filesystem::path& path) {
    JpegHeader header;
    int subsampling = 0;
    const int failed =
        tjDecompressHeader3(decoder, bytes.data(), bytes.size(), &header.size.width_px,
                            &header.size.height_px, &subsampling, &header.color_space);
    if (failed != 0) refuse_truncated_image(path, tjGetErrorStr2(decoder));
    return header;
}

/// True where some end marker has `count` equal bytes before it.
bool is_padded_before_end(std::span<const std::uint8_t> bytes, std::size_t count) {
    for (std::size_t end = count; end + 1 < bytes.size(); ++end) {
        if (bytes[end] != 0xff || bytes[end + 1] != 0xd9) continue;
        const auto before = bytes.subspan(end - count, count);
        if (std::adjacent_find(before.begin(), before.end(), std::not_equal_to<>()) == before.end())
            return true;
    }
    return false;
}

/// Some cameras pad their files before the end marker; every pixel is there all the same. Bytes
/// that are not padding are a part of the picture that the decoder lost its way to.
bool is_about_padding(const std::string& warning, std::span<const std::uint8_t> bytes) {
    unsigned count = 0;
    return std::sscanf(warning.c_str(), "Corrupt JPEG data: %u extraneous bytes before marker 0xd9",
                       &count) == 1 &&
           warning.ends_with("0xd9") && is_padded_before_end(bytes, count);
}

void decode_or_refuse(void* decoder, std::span<const std::uint8_t> bytes, const JpegHeader& header,
                      TJPF pixel_format, std::uint8_t* pixels, const std::filesystem::path& path) {
    const auto decode = [&](int flags) {
        return tjDecompress2(decoder, bytes.data(), bytes.size(), pixels, header.size.width_px, 0,
                             header.size.height_px, pixel_format, TJFLAG_ACCURATEDCT | flags);
    };
    if (decode(TJFLAG_STOPONWARNING) == 0) return;
    const std::string first_warning = tjGetErrorStr2(decoder);
    if (tjGetErrorCode(decoder) != TJERR_WARNING || !is_about_padding(first_warning, bytes)) {
        refuse_truncated_image(path, first_warning);
    }
    // The decoder remembers its last warning only: when that is the first one, there was no other.
    if (decode(0) == 0 || tjGetErrorStr2(decoder) == first_warning) return;
    refuse_truncated_image(path, tjGetErrorStr2(decoder));
}

}  // namespace

ImageSize jpeg_size(std::span<const std::uint8_t> bytes, const std::filesystem::path& path) {
    const TurboJpeg decoder(tjInitDecompress());
    return read_header(decoder.get(), bytes, path).size;
}

StoredPicture decode_jpeg(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                          const std::filesystem::path& path) {
    static_assert(sizeof(Rgb8) == 3 && sizeof(InvertedCmyk8) == 4);
    const TurboJpeg decoder(tjInitDecompress());
    const JpegHeader header = read_header(decoder.get(), bytes, path);
    check_image_size(header.size, max_pixels, path);
    StoredPicture stored;
    if (header.color_space == TJCS_CMYK || header.color_space == TJCS_YCCK) {
        Image<InvertedCmyk8> inks(header.size.width_px, header.size.height_px);
        decode_or_refuse(decoder.get(), bytes, header, TJPF_CMYK, &inks.pixels()[0].c, path);
        stored.raster = std::move(inks);
    } else {
        ColorImage image(header.size.width_px, header.size.height_px);
        decode_or_refuse(decoder.get(), bytes, header, TJPF_RGB, &image.pixels()[0].r, path);
        stored.raster = std::move(image);
    }
    stored.is_grey = header.color_space == TJCS_GRAY;
    stored.tags = jpeg_color_tags(bytes);
    return stored;
}

std::vector<std::uint8_t> encode_jpeg(const ColorImage& image, int quality) {
    const TurboJpeg encoder(tjInitCompress());
    unsigned char* buffer = nullptr;
    unsigned long size = 0;
    const int failed =
        tjCompress2(encoder.get(), &image.pixels()[0].r, image.width(), 0, image.height(), TJPF_RGB,
                    &buffer, &size, TJSAMP_444, quality, TJFLAG_ACCURATEDCT);
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owner(buffer, tjFree);
    if (failed != 0) {
        throw Error(ErrorKind::kResources, "E-IMAGE-ENCODE", tjGetErrorStr2(encoder.get()),
                    "free some memory and try again");
    }
    return {buffer, buffer + size};
}

}  // namespace lumi
