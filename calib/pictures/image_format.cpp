#include "calib/pictures/image_format.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "calib/work/error.h"

namespace lumi {
namespace {

bool begins_with(std::span<const std::uint8_t> bytes, std::string_view magic) {
    return bytes.size() >= magic.size() &&
           std::equal(magic.begin(), magic.end(), bytes.begin(),
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

/// By the brands of still pictures (ISO/IEC 23008-12; AVIF 1.1): films begin alike.
bool is_heif(std::span<const std::uint8_t> bytes) {
    constexpr std::array<std::string_view, 9> kBrands{"heic", "heix", "heim", "heis", "hevc",
                                                      "hevx", "mif1", "avif", "miaf"};
    return bytes.size() >= 12 && begins_with(bytes.subspan(4), "ftyp") &&
           std::any_of(kBrands.begin(), kBrands.end(), [&](std::string_view brand) {
               return begins_with(bytes.subspan(8), brand);
           });
}

constexpr std::string_view kPngMagic("\x89PNG\r\n\x1a\n", 8);

std::uint32_t big_endian(std::span<const std::uint8_t> bytes, std::size_t offset) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | bytes[offset + i];
    return value;
}

constexpr std::array<std::uint32_t, 256> crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t value = byte;
        for (int bit = 0; bit < 8; ++bit)
            value = (value & 1) ? 0xedb88320U ^ value >> 1 : value >> 1;
        table[byte] = value;
    }
    return table;
}

/// The checksum of PNG chunks (PNG specification, annex D).
std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
    static constexpr std::array<std::uint32_t, 256> kTable = crc_table();
    std::uint32_t crc = 0xffffffffU;
    for (const std::uint8_t byte : bytes) crc = kTable[(crc ^ byte) & 0xff] ^ crc >> 8;
    return ~crc;
}

}  // namespace

std::optional<ImageFormat> image_format_of(std::span<const std::uint8_t> bytes) {
    if (begins_with(bytes, "\xff\xd8\xff")) return ImageFormat::kJpeg;
    if (begins_with(bytes, kPngMagic)) return ImageFormat::kPng;
    if (begins_with(bytes, std::string_view("II*\0", 4)) ||
        begins_with(bytes, std::string_view("MM\0*", 4))) {
        return ImageFormat::kTiff;
    }
    if (is_heif(bytes)) return ImageFormat::kHeif;
    if (begins_with(bytes, "RIFF") && bytes.size() >= 12 && begins_with(bytes.subspan(8), "WEBP")) {
        return ImageFormat::kWebp;
    }
    return std::nullopt;
}

std::optional<ImageFormat> image_format_of(const std::filesystem::path& file) {
    std::array<char, 16> first{};
    std::ifstream stream(file, std::ios::binary);
    stream.read(first.data(), first.size());
    return image_format_of(std::span(reinterpret_cast<const std::uint8_t*>(first.data()),
                                     static_cast<std::size_t>(stream.gcount())));
}

ImageSize check_png(std::span<const std::uint8_t> bytes, const std::filesystem::path& path) {
    constexpr std::size_t kChunkOverhead = 12;  // Length, type and checksum.
    std::size_t offset = kPngMagic.size();
    ImageSize size;
    while (offset + kChunkOverhead <= bytes.size()) {
        const std::uint32_t length = big_endian(bytes, offset);
        if (length > bytes.size() - offset - kChunkOverhead) break;
        // Checked here because libpng prints what it finds and some readers show the rest.
        if (crc32(bytes.subspan(offset + 4, 4 + std::size_t{length})) !=
            big_endian(bytes, offset + 8 + length)) {
            refuse_truncated_image(path, "a checksum of the PNG is wrong");
        }
        const std::string_view type(reinterpret_cast<const char*>(&bytes[offset + 4]), 4);
        if (type == "IHDR" && length >= 8) {
            size.width_px = static_cast<int>(big_endian(bytes, offset + 8) & 0x7fffffff);
            size.height_px = static_cast<int>(big_endian(bytes, offset + 12) & 0x7fffffff);
        }
        if (type == "IEND") return size;
        offset += kChunkOverhead + length;
    }
    refuse_truncated_image(path, "the PNG ends before its last chunk");
}

void check_image_size(ImageSize size, std::size_t max_pixels, const std::filesystem::path& path) {
    if (size.width_px <= 0 || size.height_px <= 0) {
        refuse_truncated_image(path, "the header has no picture size");
    }
    const auto pixels =
        static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px);
    if (pixels > max_pixels) {
        throw Error(ErrorKind::kBadInput, "E-IMAGE-TOOBIG",
                    path.string() + ": " + std::to_string(size.width_px) + "x" +
                        std::to_string(size.height_px) + " pixels, expected at most " +
                        std::to_string(max_pixels),
                    "scale the picture down first");
    }
}

void refuse_truncated_image(const std::filesystem::path& path, const std::string& reason) {
    throw Error(ErrorKind::kBadInput, "E-IMAGE-TRUNCATED", path.string() + ": " + reason,
                "copy the picture again from the camera; this file is damaged");
}

void refuse_unsupported_image(const std::filesystem::path& path, const std::string& reason) {
    throw Error(ErrorKind::kBadInput, "E-IMAGE-FORMAT",
                path.string() + ": coded in a way that lumi does not read (" + reason + ")",
                "export the picture as 8-bit JPEG");
}

}  // namespace lumi
