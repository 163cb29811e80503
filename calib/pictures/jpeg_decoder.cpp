#include "calib/pictures/jpeg_decoder.h"

#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <memory>
#include <new>
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

TurboJpeg new_decoder() {
    TurboJpeg decoder(tjInitDecompress());
    if (!decoder) throw std::bad_alloc();
    return decoder;
}

/// By what the decoder says, in the words of libjpeg and TurboJPEG.
[[noreturn]] void refuse_jpeg(const std::filesystem::path& path, const std::string& fault) {
    if (fault.starts_with("Insufficient memory") || fault.ends_with("Memory allocation failure")) {
        throw std::bad_alloc();
    }
    if (fault.starts_with("Unsupported JPEG process") ||
        fault.starts_with("Unsupported JPEG data precision")) {
        refuse_unsupported_image(path, fault);
    }
    refuse_truncated_image(path, fault);
}

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
    // TurboJPEG has no name for every subsampling that it decodes, and has read the rest by then.
    const bool is_only_unnamed = subsampling < 0 && header.color_space >= 0 &&
                                 header.size.width_px > 0 && header.size.height_px > 0;
    if (failed != 0 && !is_only_unnamed) refuse_jpeg(path, tjGetErrorStr2(decoder));
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

/// A JPEG whose scan does not say that it holds all coefficients, as it must where it is not
/// progressive (ITU-T T.81, B.2.3): some telephones leave these bytes at 0. Here it says so.
Bytes with_all_coefficients(std::span<const std::uint8_t> bytes) {
    Bytes repaired(bytes.begin(), bytes.end());
    constexpr std::array<std::uint8_t, 2> kStartOfScan{0xff, 0xda};
    constexpr std::array<std::uint8_t, 3> kUnsaid{0, 0, 0};
    constexpr std::array<std::uint8_t, 3> kAll{0, 63, 0};
    auto scan = repaired.begin();
    while (true) {
        scan = std::search(scan, repaired.end(), kStartOfScan.begin(), kStartOfScan.end());
        if (repaired.end() - scan < 4) return repaired;
        const std::ptrdiff_t end = 2 + (scan[2] << 8 | scan[3]);
        if (end >= 7 && end <= repaired.end() - scan &&
            std::equal(kUnsaid.begin(), kUnsaid.end(), scan + end - 3)) {
            std::copy(kAll.begin(), kAll.end(), scan + end - 3);
        }
        scan += 2;
    }
}

bool is_about_scan_header(const std::string& warning) {
    return warning.starts_with("Invalid SOS parameters for sequential JPEG");
}

/// Empty where every pixel is there, else what is wrong.
std::string decode_into(void* decoder, std::span<const std::uint8_t> bytes,
                        const JpegHeader& header, TJPF pixel_format, std::uint8_t* pixels) {
    const auto decode = [&](int flags) {
        return tjDecompress2(decoder, bytes.data(), bytes.size(), pixels, header.size.width_px, 0,
                             header.size.height_px, pixel_format, TJFLAG_ACCURATEDCT | flags);
    };
    if (decode(TJFLAG_STOPONWARNING) == 0) return {};
    const std::string warning = tjGetErrorStr2(decoder);
    if (tjGetErrorCode(decoder) != TJERR_WARNING || !is_about_padding(warning, bytes)) {
        return warning;
    }
    // Padding is the last thing in a file: no other warning can follow this one.
    const bool is_decoded = decode(0) == 0 || tjGetErrorCode(decoder) == TJERR_WARNING;
    return is_decoded ? std::string() : tjGetErrorStr2(decoder);
}

void decode_or_refuse(void* decoder, std::span<const std::uint8_t> bytes, const JpegHeader& header,
                      TJPF pixel_format, std::uint8_t* pixels, const std::filesystem::path& path) {
    std::string fault = decode_into(decoder, bytes, header, pixel_format, pixels);
    if (is_about_scan_header(fault)) {
        fault = decode_into(decoder, with_all_coefficients(bytes), header, pixel_format, pixels);
    }
    if (!fault.empty()) refuse_jpeg(path, fault);
}

}  // namespace

ImageSize jpeg_size(std::span<const std::uint8_t> bytes, const std::filesystem::path& path) {
    const TurboJpeg decoder = new_decoder();
    return read_header(decoder.get(), bytes, path).size;
}

StoredPicture decode_jpeg(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                          const std::filesystem::path& path) {
    static_assert(sizeof(Rgb8) == 3 && sizeof(InvertedCmyk8) == 4);
    const TurboJpeg decoder = new_decoder();
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
