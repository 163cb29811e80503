#include "meshing/geometry/binary_volume.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "meshing/geometry/volume_header.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
static_assert(std::endian::native == std::endian::little);

/// Turns the bytes of a volume's numbers into solid cells, a piece at a time.
class CellReader {
 public:
    CellReader(const VolumeHeader& header, double threshold, std::vector<bool>& solid)
        : header_(header), threshold_(threshold), solid_(solid), width_(bytes_of(header.type)) {}

    void take(std::span<const std::uint8_t> bytes) {
        taken_ += bytes.size();
        for (const std::uint8_t byte : bytes) {
            number_[filled_++] = byte;
            if (filled_ == width_) finish_cell();
        }
    }
    /// Bytes so far.
    [[nodiscard]] std::uint64_t taken() const { return taken_; }

 private:
    void finish_cell() {
        filled_ = 0;
        if (next_ >= solid_.size()) return;  // More than there should be is refused by its count.
        if (header_.is_big_endian) std::reverse(number_.begin(), number_.begin() + width_);
        solid_[next_++] = value() >= threshold_;  // Not a number is not solid.
    }
    template <class Number>
    [[nodiscard]] double as() const {
        Number value;
        std::memcpy(&value, number_.data(), sizeof(value));
        return static_cast<double>(value);
    }
    [[nodiscard]] double value() const {
        switch (header_.type) {
            case CellType::kInt8:
                return as<std::int8_t>();
            case CellType::kUint8:
                return as<std::uint8_t>();
            case CellType::kInt16:
                return as<std::int16_t>();
            case CellType::kUint16:
                return as<std::uint16_t>();
            case CellType::kInt32:
                return as<std::int32_t>();
            case CellType::kUint32:
                return as<std::uint32_t>();
            case CellType::kFloat:
                return as<float>();
            case CellType::kDouble:
                break;
        }
        return as<double>();
    }

    const VolumeHeader& header_;
    double threshold_;
    std::vector<bool>& solid_;
    std::size_t width_;
    std::array<std::uint8_t, 8> number_{};
    std::size_t filled_ = 0;
    std::size_t next_ = 0;
    std::uint64_t taken_ = 0;
};

/// Unpacks a stream of zlib or gzip in pieces, and no more than `expected` bytes and one piece.
void inflate_into(std::span<const std::uint8_t> packed, std::uint64_t expected, CellReader& cells,
                  const fs::path& path) {
    z_stream stream{};
    constexpr int kZlibOrGzip = 32;
    if (inflateInit2(&stream, MAX_WBITS + kZlibOrGzip) != Z_OK) {
        refuse_volume(path, "its data cannot be unpacked");
    }
    const std::unique_ptr<z_stream, int (*)(z_stream*)> at_end(&stream, inflateEnd);
    std::vector<std::uint8_t> piece(1 << 16);
    std::size_t fed = 0;
    for (int state = Z_OK; state != Z_STREAM_END;) {
        if (stream.avail_in == 0) {
            const std::size_t more = std::min<std::size_t>(packed.size() - fed, 1 << 20);
            stream.next_in = const_cast<Bytef*>(packed.data() + fed);
            stream.avail_in = static_cast<uInt>(more);
            fed += more;
        }
        stream.next_out = piece.data();
        stream.avail_out = static_cast<uInt>(piece.size());
        state = inflate(&stream, Z_NO_FLUSH);
        if (state != Z_OK && state != Z_STREAM_END) {
            refuse_volume(path, "its data are damaged or end early");
        }
        cells.take(std::span(piece).first(piece.size() - stream.avail_out));
        if (cells.taken() > expected) return;
    }
}

std::string cells_text(const Eigen::Vector3i& size) {
    return std::to_string(size.x()) + "x" + std::to_string(size.y()) + "x" +
           std::to_string(size.z());
}

void read_cells(const VolumeHeader& header, std::span<const std::uint8_t> data,
                const fs::path& data_path, double threshold, std::vector<bool>& solid) {
    const std::uint64_t expected = solid.size() * bytes_of(header.type);
    CellReader cells(header, threshold, solid);
    if (header.is_compressed) {
        inflate_into(data, expected, cells, data_path);
    } else {
        cells.take(data);
    }
    if (cells.taken() == expected) return;
    refuse_volume(data_path, cells_text(header.size) + " cells take " + std::to_string(expected) +
                                 " bytes, found " + (cells.taken() > expected ? "more: " : "") +
                                 std::to_string(cells.taken()));
}

VolumeHeader header_of(const Bytes& bytes, const fs::path& path) {
    return parse_volume_header({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

}  // namespace

std::vector<fs::path> files_of_volume(const fs::path& path) {
    std::vector<fs::path> files{path};
    try {
        const VolumeHeader header = header_of(read_whole_file(path), path);
        if (!header.data_file.empty()) files.push_back(path.parent_path() / header.data_file);
    } catch (const Error&) {
        // Whoever reads the volume says why.
    }
    return files;
}

BinaryVolume read_binary_volume(const fs::path& path, double threshold) {
    Bytes bytes = read_whole_file(path);
    const VolumeHeader header = header_of(bytes, path);
    std::size_t begin = std::min(header.header_size, bytes.size());
    fs::path data_path = path;
    if (!header.data_file.empty()) {
        data_path = path.parent_path() / header.data_file;
        bytes = read_whole_file(data_path);
        begin = 0;
    }
    BinaryVolume volume;
    volume.size = header.size;
    volume.solid.resize(static_cast<std::size_t>(header.size.cast<std::int64_t>().prod()));
    read_cells(header, std::span(bytes).subspan(begin), data_path, threshold, volume.solid);
    volume.world_from_grid.linear() = header.steps;
    volume.world_from_grid.translation() =
        header.centre_of_first_cell - header.steps * Eigen::Vector3d::Constant(0.5);

    const auto count =
        static_cast<std::size_t>(std::count(volume.solid.begin(), volume.solid.end(), true));
    if (count > 0 && count < volume.solid.size()) return volume;
    throw Error(ErrorKind::kBadInput, count == 0 ? "E-VOLUME-EMPTY" : "E-VOLUME-FULL",
                path.string() + ": " + (count == 0 ? "no cell" : "every cell") + " is at least " +
                    std::to_string(threshold),
                "set import_volume_threshold under [depth] between what is empty and what is "
                "solid");
}

}  // namespace lumi
