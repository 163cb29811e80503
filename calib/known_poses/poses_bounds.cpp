#include "calib/known_poses/poses_bounds.h"

#include <cmath>

#include "calib/known_poses/camera_axes.h"
#include "calib/known_poses/npy.h"

namespace lumi {
namespace {

constexpr std::size_t kColumns = 17;

KnownLens lens_of(double height, double width, double focal_length_px, const std::string& where) {
    constexpr double kMaxSide = 1 << 20;
    const bool sensible = width >= 1 && height >= 1 && width <= kMaxSide && height <= kMaxSide &&
                          focal_length_px > 0 && std::isfinite(focal_length_px);
    if (!sensible) refuse_poses(where, "its size or focal length is not positive");
    return {pinhole_camera(static_cast<int>(std::lround(width)),
                           static_cast<int>(std::lround(height)), focal_length_px),
            std::nullopt};
}

}  // namespace

KnownPoses read_poses_bounds(const std::filesystem::path& path) {
    const NpyMatrix rows = read_npy_matrix(path);
    if (rows.columns != kColumns) {
        refuse_poses(path.string(),
                     "expected 17 numbers a photograph, found " + std::to_string(rows.columns));
    }
    KnownPoses known;
    known.format = "poses_bounds.npy";
    known.has_names = false;
    for (std::size_t i = 0; i < rows.rows; ++i) {
        const std::string where = path.string() + ": row " + std::to_string(i + 1);
        Eigen::Matrix<double, 3, 5> matrix;
        for (std::size_t k = 0; k < 15; ++k) {
            matrix(static_cast<Eigen::Index>(k / 5), static_cast<Eigen::Index>(k % 5)) = rows(i, k);
        }
        Eigen::Matrix3d world_from_cam;
        world_from_cam << matrix.col(1), matrix.col(0), -matrix.col(2);
        const KnownLens lens = lens_of(matrix(0, 4), matrix(1, 4), matrix(2, 4), where);
        known.views.push_back({std::to_string(i + 1), index_of_lens(known.lenses, lens),
                               pose_from_axes(world_from_cam, matrix.col(3), where)});
    }
    return known;
}

}  // namespace lumi
