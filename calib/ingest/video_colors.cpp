#include "calib/ingest/video_colors.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace lumi {
namespace {

std::uint64_t big_endian(std::string_view bytes) {
    std::uint64_t value = 0;
    for (const char byte : bytes) value = value << 8U | static_cast<unsigned char>(byte);
    return value;
}

struct Box {
    std::string type;
    std::uint64_t content_bytes = 0;
};

/// The header of the next box; empty at the end, and where none can be.
std::optional<Box> next_box(std::ifstream& file, std::uint64_t bytes_left) {
    constexpr std::uint64_t kLongSize = 1;
    std::array<char, 16> header{};
    if (!file.read(header.data(), 8)) return std::nullopt;
    const std::string_view text(header.data(), header.size());
    std::uint64_t size = big_endian(text.substr(0, 4));
    std::uint64_t header_bytes = 8;
    if (size == kLongSize) {
        if (!file.read(header.data() + 8, 8)) return std::nullopt;
        size = big_endian(text.substr(8, 8));
        header_bytes = 16;
    } else if (size == 0) {
        size = bytes_left;  // To the end of the file.
    }
    if (size < header_bytes || size > bytes_left) return std::nullopt;
    return Box{std::string(text.substr(4, 4)), size - header_bytes};
}

/// The first one in the headers of tracks.
std::optional<CodedColors> coded_colors_in(const std::string& movie) {
    constexpr std::size_t kCodes = 8;
    for (const std::string_view box : {"colrnclx", "colrnclc"}) {
        const std::size_t found = movie.find(box);
        if (found == std::string::npos || movie.size() - found < kCodes + 4) continue;
        const std::string_view codes = std::string_view(movie).substr(found + kCodes);
        return CodedColors{static_cast<int>(big_endian(codes.substr(0, 2))),
                           static_cast<int>(big_endian(codes.substr(2, 2)))};
    }
    return std::nullopt;
}

}  // namespace

std::optional<CodedColors> coded_colors_of_video(const std::filesystem::path& video) {
    constexpr std::uint64_t kMostHeaders = std::uint64_t{1} << 28;
    std::error_code ignored;
    std::uint64_t bytes_left = std::filesystem::file_size(video, ignored);
    if (ignored) return std::nullopt;
    std::ifstream file(video, std::ios::binary);
    while (const std::optional<Box> box = next_box(file, bytes_left)) {
        if (box->type == "moov" && box->content_bytes < kMostHeaders) {
            std::string movie(box->content_bytes, '\0');
            if (!file.read(movie.data(), static_cast<std::streamsize>(movie.size()))) break;
            if (const auto coded = coded_colors_in(movie)) return coded;
        } else {
            file.seekg(static_cast<std::streamoff>(box->content_bytes), std::ios::cur);
        }
        const auto place = file.tellg();
        if (place < 0) break;
        bytes_left = std::filesystem::file_size(video, ignored) - static_cast<std::uint64_t>(place);
    }
    return std::nullopt;
}

}  // namespace lumi
