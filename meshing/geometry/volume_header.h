#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace lumi {

enum class CellType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };
[[nodiscard]] std::size_t bytes_of(CellType type);

/// What the header of a volume file says of the data that follow.
struct VolumeHeader {
    Eigen::Vector3i size = Eigen::Vector3i::Zero();
    CellType type = CellType::kUint8;
    bool is_big_endian = false;
    bool is_compressed = false;  ///< As a stream of zlib or gzip.
    Eigen::Vector3d centre_of_first_cell = Eigen::Vector3d::Zero();
    Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();  ///< A column an axis of the grid.
    std::filesystem::path data_file;                      ///< Empty: the data follow the header.
    std::size_t header_size = 0;                          ///< Bytes.
};

/// Of a NRRD file or of a MetaImage, by its first bytes. Throws Error (E-VOLUME-READ).
[[nodiscard]] VolumeHeader parse_volume_header(std::string_view text,
                                               const std::filesystem::path& path);

/// Throws Error (E-VOLUME-READ).
[[noreturn]] void refuse_volume(const std::filesystem::path& path, const std::string& what);

}  // namespace lumi
