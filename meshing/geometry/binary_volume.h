#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <vector>

namespace lumi {

/// Scene geometry as solid cells of a grid, in the world of the poses. Cell (i, j, k) fills i..i+1,
/// j..j+1, k..k+1 in coordinates of the grid.
struct BinaryVolume {
    Eigen::Vector3i size = Eigen::Vector3i::Zero();  ///< Cells along each axis.
    Eigen::Affine3d world_from_grid = Eigen::Affine3d::Identity();
    std::vector<bool> solid;  ///< First axis fastest.

    [[nodiscard]] bool is_solid(const Eigen::Vector3i& cell) const {
        const auto nx = static_cast<std::size_t>(size.x());
        const auto ny = static_cast<std::size_t>(size.y());
        return solid[static_cast<std::size_t>(cell.x()) +
                     nx * (static_cast<std::size_t>(cell.y()) +
                           ny * static_cast<std::size_t>(cell.z()))];
    }
};

/// A NRRD file (.nrrd, or .nhdr beside its data; encoding raw or gzip) or a MetaImage (.mha, or
/// .mhd beside its data; compressed or not) of three dimensions and one number a cell, whole or
/// floating, of at most 2^30 cells. A cell is solid where its number is at least `threshold`.
///
/// Both formats give the place of the first cell (NRRD "space origin", its centre, or "axis mins",
/// its border where "centers" does not say that samples are nodes; MetaImage Offset, its centre)
/// and the steps from cell to cell (NRRD "space directions", "spacings" or "axis maxs"; MetaImage
/// ElementSpacing or ElementSize, and TransformMatrix): these are taken as coordinates and units of
/// the poses' world, whatever the file calls its space. Without them a cell is one unit wide and
/// the centre of the first at 0.
///
/// Throws Error: E-VOLUME-READ (header that is not of these kinds, or at odds with the size of the
/// data), E-VOLUME-EMPTY (no cell reaches the threshold), E-VOLUME-FULL (every cell does).
[[nodiscard]] BinaryVolume read_binary_volume(const std::filesystem::path& path, double threshold);

/// The files that a volume is read from: the named one, and that of its data where they lie beside
/// it. The named one alone where it cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> files_of_volume(const std::filesystem::path& path);

}  // namespace lumi
