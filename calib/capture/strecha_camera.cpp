#include "calib/capture/strecha_camera.h"

#include <Eigen/Geometry>
#include <cmath>
#include <sstream>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

/// COLMAP's pixels are half a pixel further than those of files that count from pixel centres.
constexpr double kHalfPixel = 0.5;
constexpr double kRotationTolerance = 1e-3;

Eigen::Matrix3d next_matrix(std::istream& stream) {
    Eigen::Matrix3d matrix;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) stream >> matrix(row, column);
    }
    return matrix;
}

}  // namespace

StrechaCamera read_strecha_camera(const std::filesystem::path& path) {
    std::istringstream stream(read_whole_text(path, std::size_t{1} << 16));
    const Eigen::Matrix3d calibration = next_matrix(stream);
    Eigen::Vector3d distortion;
    stream >> distortion.x() >> distortion.y() >> distortion.z();
    const Eigen::Matrix3d world_from_cam = next_matrix(stream);
    Eigen::Vector3d centre;
    stream >> centre.x() >> centre.y() >> centre.z();
    int width_px = 0;
    int height_px = 0;
    stream >> width_px >> height_px;

    const auto refuse = [&](const std::string& what) {
        throw Error(ErrorKind::kBadInput, "E-IMPORT-STRECHA", path.string() + ": " + what,
                    "expected K, a distortion line, a rotation, a centre and a size");
    };
    if (!stream) refuse("ends early, or holds something that is not a number");
    if (!distortion.isZero()) refuse("has lens distortion, which this format does not define");
    if (!(world_from_cam.transpose() * world_from_cam).isIdentity(kRotationTolerance)) {
        refuse("its rotation is not orthonormal");
    }

    StrechaCamera result;
    result.camera = {width_px,
                     height_px,
                     LensModel::kPinhole,
                     {calibration(0, 0), calibration(1, 1), calibration(0, 2) + kHalfPixel,
                      calibration(1, 2) + kHalfPixel}};
    validate(result.camera, path.string());
    result.cam_from_world.rotation = Eigen::Quaterniond(world_from_cam).normalized().conjugate();
    result.cam_from_world.translation = -(result.cam_from_world.rotation * centre);
    return result;
}

}  // namespace lumi
