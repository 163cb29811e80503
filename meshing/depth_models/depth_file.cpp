#include "meshing/depth_models/depth_file.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "calib/work/without_plus.h"
#include "meshing/surface/file_ending.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxSide = 1 << 16;
constexpr std::size_t kMaxPixels = std::size_t{1} << 28;

static_assert(std::endian::native == std::endian::little);

[[noreturn]] void refuse(const fs::path& path, const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-DEPTH-FORMAT", path.string() + ": " + what,
                "export depth as float TIFF, OpenEXR, PFM, 16-bit PNG or COLMAP's dense maps");
}

void check_size(int width, int height, const fs::path& path) {
    if (width > 0 && height > 0 && width <= kMaxSide && height <= kMaxSide &&
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) <= kMaxPixels) {
        return;
    }
    refuse(path, "a size of " + std::to_string(width) + "x" + std::to_string(height));
}

/// Text fields at the beginning of a file, each ended by one character.
class HeaderReader {
 public:
    HeaderReader(const Bytes& bytes, const fs::path& path)
        : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()), path_(path) {}

    [[nodiscard]] std::string_view field(std::string_view ends) {
        constexpr std::size_t kMaxField = 64;
        const std::size_t end = text_.substr(at_, kMaxField).find_first_of(ends);
        if (end == std::string_view::npos) refuse(path_, "its header is not that of its format");
        const std::string_view found = text_.substr(at_, end);
        at_ += end + 1;
        return found;
    }
    void skip(std::string_view characters) {
        at_ = std::min(text_.find_first_not_of(characters, at_), text_.size());
    }
    template <class Number>
    [[nodiscard]] Number number(std::string_view ends) {
        const std::string_view text = field(ends);
        Number value{};
        const std::string_view digits = without_plus(text);
        const char* const behind = digits.data() + digits.size();
        const auto [end, error] = std::from_chars(digits.data(), behind, value);
        if (error != std::errc{} || end != behind) {
            refuse(path_, "expected a number in its header, found \"" + std::string(text) + "\"");
        }
        return value;
    }
    [[nodiscard]] std::size_t position() const { return at_; }

 private:
    std::string_view text_;
    std::size_t at_ = 0;
    const fs::path& path_;
};

std::size_t bytes_of_floats(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * sizeof(float);
}

/// The floats after a header, which must be all that is left.
FloatImage floats_after(std::size_t position, int width, int height, const Bytes& bytes,
                        const fs::path& path) {
    check_size(width, height, path);
    FloatImage image(width, height);
    const std::size_t needed = bytes_of_floats(width, height);
    if (bytes.size() - position != needed) {
        refuse(path, "expected " + std::to_string(needed) + " bytes after its header, found " +
                         std::to_string(bytes.size() - position));
    }
    std::memcpy(image.pixels().data(), bytes.data() + position, needed);
    return image;
}

/// Debevec's portable float map: rows from the bottom up; a negative scale means little-endian.
FloatImage read_pfm(const fs::path& path) {
    const Bytes bytes = read_whole_file(path);
    HeaderReader header(bytes, path);
    constexpr std::string_view kSpace = " \t\n\r";
    if (header.field(kSpace) != "Pf") refuse(path, "expected a PFM file of one channel (\"Pf\")");
    header.skip(kSpace);
    const int width = header.number<int>(kSpace);
    header.skip(kSpace);
    const int height = header.number<int>(kSpace);
    header.skip(kSpace);
    const double scale = header.number<double>(kSpace);
    check_size(width, height, path);
    std::size_t begin = header.position();
    // A line may end in two characters; but after one the second may be the picture's first byte.
    const bool is_one_longer = bytes.size() - begin == bytes_of_floats(width, height) + 1;
    if (is_one_longer && bytes[begin - 1] == '\r' && bytes[begin] == '\n') ++begin;
    const FloatImage upside_down = floats_after(begin, width, height, bytes, path);
    FloatImage image(width, height);
    for (int y = 0; y < height; ++y) {
        std::copy_n(upside_down.row(height - 1 - y), width, image.row(y));
    }
    if (scale > 0) {
        for (float& value : image.pixels()) {
            value = std::bit_cast<float>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
        }
    }
    return image;
}

/// COLMAP's Mat: "width&height&channels&" and floats (mvs/mat.h).
FloatImage read_colmap_dense(const fs::path& path) {
    const Bytes bytes = read_whole_file(path);
    HeaderReader header(bytes, path);
    const int width = header.number<int>("&");
    const int height = header.number<int>("&");
    if (header.number<int>("&") != 1) refuse(path, "expected one channel: depth, not normals");
    return floats_after(header.position(), width, height, bytes, path);
}

int depth_channel(const OIIO::ImageSpec& spec, const fs::path& path) {
    for (const char* name : {"Z", "Y"}) {
        const int channel = spec.channelindex(name);
        if (channel >= 0) return channel;
    }
    if (spec.nchannels != 1) refuse(path, "expected a channel Z");
    return 0;
}

/// OpenEXR stores the part of a picture that is not empty, if its writer wants so.
void require_whole_picture(const OIIO::ImageSpec& spec, const fs::path& path) {
    if (spec.x == spec.full_x && spec.y == spec.full_y && spec.width == spec.full_width &&
        spec.height == spec.full_height) {
        return;
    }
    refuse(path,
           "its data window is not its display window: it holds another part of the scene "
           "than the whole photograph");
}

FloatImage read_exr(const fs::path& path) {
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("openexr");
    OIIO::ImageSpec spec;
    if (!input || !input->open(path.string(), spec)) {
        refuse(path, input ? input->geterror() : OIIO::geterror());
    }
    check_size(spec.width, spec.height, path);
    require_whole_picture(spec, path);
    const int channel = depth_channel(spec, path);
    FloatImage image(spec.width, spec.height);
    const bool read =
        input->read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::FLOAT, image.pixels().data());
    if (!read || input->has_error()) refuse(path, input->geterror());
    return image;
}

FloatImage read_png(const fs::path& path, double unit) {
    const Image<std::uint16_t> levels = read_gray16_png(path);
    FloatImage image(levels.width(), levels.height());
    std::transform(levels.pixels().begin(), levels.pixels().end(), image.pixels().begin(),
                   [unit](std::uint16_t level) { return static_cast<float>(unit * level); });
    return image;
}

}  // namespace

const std::vector<std::string>& depth_file_endings() {
    static const std::vector<std::string> endings{
        ".tiff", ".tif", ".exr", ".pfm", ".png", ".geometric.bin", ".photometric.bin"};
    return endings;
}

FloatImage read_depth_file(const fs::path& path, double png_unit) {
    const std::string extension = lower_case_ending(path);
    if (extension == ".tiff" || extension == ".tif") return read_float_tiff(path);
    if (extension == ".exr") return read_exr(path);
    if (extension == ".pfm") return read_pfm(path);
    if (extension == ".png") return read_png(path, png_unit);
    if (extension == ".bin") return read_colmap_dense(path);
    refuse(path, "no depth map by its name");
}

}  // namespace lumi
