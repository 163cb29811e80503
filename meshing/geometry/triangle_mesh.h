#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// Scene geometry as triangles, in the world of the poses.
struct TriangleMesh {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> faces;  ///< Indices into `vertices`.
    std::vector<Eigen::Vector3f> normals = {};        ///< One a vertex, or none.
    std::vector<Rgb8> colors = {};                    ///< sRGB, one a vertex, or none.
};

/// A PLY file (text or binary, little- or big-endian) or an OBJ file, by its first bytes and its
/// extension; polygons are cut into fans. Everything but places and faces is skipped. Throws Error
/// (E-GEOMETRY-READ) naming what was expected when a count, an index or a number is out of range,
/// and E-GEOMETRY-EMPTY without a triangle.
[[nodiscard]] TriangleMesh read_triangle_mesh(const std::filesystem::path& path);

}  // namespace lumi
