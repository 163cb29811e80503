#include "calib/pictures/color_tags.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>

#include "calib/work/error.h"

namespace lumi {
namespace {

using ByteSpan = std::span<const std::uint8_t>;

std::uint32_t number_at(ByteSpan bytes, std::size_t offset, std::size_t length) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < length; ++i) number = number << 8 | bytes[offset + i];
    return number;
}

std::string_view characters_of(ByteSpan bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The entries of EXIF, in either byte order, by which DCF marks Adobe RGB. Found as they stand:
/// no twelve bytes of anything else are likely to be the same.
bool marks_adobe_rgb(std::string_view exif) {
    using namespace std::string_view_literals;
    constexpr std::array<std::array<std::string_view, 2>, 2> kEntries{
        {{"\x01\xa0\x03\x00\x01\x00\x00\x00\xff\xff"sv,
          "\x01\x00\x02\x00\x04\x00\x00\x00R03\x00"sv},
         {"\xa0\x01\x00\x03\x00\x00\x00\x01\xff\xff"sv,
          "\x00\x01\x00\x02\x00\x00\x00\x04R03\x00"sv}}};
    return std::any_of(kEntries.begin(), kEntries.end(), [&](const auto& entries) {
        return exif.find(entries[0]) != std::string_view::npos &&
               exif.find(entries[1]) != std::string_view::npos;
    });
}

/// Longer ones than any profile for pictures are cut, and so damaged.
Bytes inflated(ByteSpan compressed) {
    constexpr std::size_t kMaxBytes = std::size_t{1} << 24;
    constexpr std::size_t kStep = std::size_t{1} << 16;
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) return {};
    stream.next_in = const_cast<std::uint8_t*>(compressed.data());
    stream.avail_in = static_cast<unsigned>(compressed.size());
    Bytes bytes;
    int status = Z_OK;
    while (status == Z_OK && bytes.size() < kMaxBytes) {
        bytes.resize(bytes.size() + kStep);
        stream.next_out = bytes.data() + bytes.size() - kStep;
        stream.avail_out = kStep;
        status = inflate(&stream, Z_NO_FLUSH);
        bytes.resize(bytes.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    return bytes;
}

/// Its name, which ends at a zero, the method of compression, and the compressed profile.
Bytes profile_of_chunk(ByteSpan chunk) {
    const auto end_of_name = std::find(chunk.begin(), chunk.end(), std::uint8_t{0});
    const auto start = static_cast<std::size_t>(end_of_name - chunk.begin()) + 2;
    return start < chunk.size() ? inflated(chunk.subspan(start)) : Bytes();
}

}  // namespace

ColorTags jpeg_color_tags(ByteSpan bytes) {
    constexpr std::string_view kIccHeader("ICC_PROFILE\0", 12);
    constexpr std::string_view kExifHeader("Exif\0\0", 6);
    constexpr std::uint8_t kApp1 = 0xe1;
    constexpr std::uint8_t kApp2 = 0xe2;
    constexpr std::uint8_t kStartOfScan = 0xda;
    ColorTags tags;
    std::map<std::uint8_t, ByteSpan> parts;  // By their number.
    for (std::size_t offset = 2; offset + 4 <= bytes.size() && bytes[offset] == 0xff;) {
        const std::uint8_t marker = bytes[offset + 1];
        if (marker == 0xff) {  // Padding.
            ++offset;
            continue;
        }
        const std::size_t length = number_at(bytes, offset + 2, 2);
        if (marker == kStartOfScan || length < 2 || length + 2 > bytes.size() - offset) break;
        const ByteSpan segment = bytes.subspan(offset + 4, length - 2);
        if (marker == kApp2 && characters_of(segment).starts_with(kIccHeader) &&
            segment.size() > kIccHeader.size() + 2) {
            parts[segment[kIccHeader.size()]] = segment.subspan(kIccHeader.size() + 2);
        } else if (marker == kApp1 && characters_of(segment).starts_with(kExifHeader)) {
            tags.is_adobe_rgb = tags.is_adobe_rgb || marks_adobe_rgb(characters_of(segment));
        }
        offset += 2 + length;
    }
    if (!parts.empty()) tags.icc_profile.emplace();
    for (const auto& [number, part] : parts) {
        tags.icc_profile->insert(tags.icc_profile->end(), part.begin(), part.end());
    }
    return tags;
}

ColorTags png_color_tags(ByteSpan bytes) {
    constexpr std::size_t kMagic = 8;
    constexpr std::size_t kChunkOverhead = 12;  // Length, type and checksum.
    constexpr std::int64_t kLinearGamma = 100000;
    ColorTags tags;
    bool is_srgb = false;
    for (std::size_t offset = kMagic; offset + kChunkOverhead <= bytes.size();) {
        const std::size_t length = number_at(bytes, offset, 4);
        if (length > bytes.size() - offset - kChunkOverhead) break;
        const std::string_view type = characters_of(bytes.subspan(offset + 4, 4));
        const ByteSpan chunk = bytes.subspan(offset + 8, length);
        if (type == "IDAT") break;
        if (type == "iCCP") tags.icc_profile = profile_of_chunk(chunk);
        if (type == "cICP" && length == 4) tags.coded = CodedColors{chunk[0], chunk[1]};
        if (type == "sRGB") is_srgb = true;
        if (type == "gAMA" && length == 4) {
            const std::int64_t gamma = number_at(chunk, 0, 4);
            tags.is_linear = std::abs(gamma - kLinearGamma) <= kLinearGamma / 100;
        }
        offset += kChunkOverhead + length;
    }
    tags.is_linear = tags.is_linear && !is_srgb;
    if (tags.coded) tags.icc_profile.reset();
    return tags;
}

void refuse_pq(const ColorTags& tags, const std::filesystem::path& path) {
    if (!tags.coded || tags.coded->transfer != kPqTransfer) return;
    throw Error(ErrorKind::kBadInput, "E-IMAGE-FORMAT",
                path.string() + ": coded for HDR by PQ (SMPTE ST 2084)",
                "export it for ordinary screens, as JPEG");
}

}  // namespace lumi
