#include "calib/known_poses/strecha_camera.h"

#include <sstream>

#include "calib/known_poses/calibration_matrix.h"
#include "calib/known_poses/camera_axes.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {

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

    StrechaCamera result;
    result.camera = {width_px, height_px, LensModel::kPinhole,
                     pinhole_parameters(calibration, path.string())};
    validate(result.camera, path.string());
    result.cam_from_world = pose_from_axes(world_from_cam, centre, path.string());
    return result;
}

}  // namespace lumi
