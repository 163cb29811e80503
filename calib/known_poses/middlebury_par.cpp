#include "calib/known_poses/middlebury_par.h"

#include <sstream>

#include "calib/known_poses/calibration_matrix.h"
#include "calib/known_poses/camera_axes.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

KnownLens lens_of(const Eigen::Matrix3d& calibration, const std::string& where) {
    const std::vector<double> pinhole = pinhole_parameters(calibration, where);
    StatedLens lens;
    lens.focal_x_px = pinhole[0];
    lens.focal_y_px = pinhole[1];
    lens.centre_x_px = pinhole[2];
    lens.centre_y_px = pinhole[3];
    return {{}, lens};
}

}  // namespace

KnownPoses read_middlebury_par(const std::filesystem::path& path) {
    std::istringstream file(read_whole_text(path, std::size_t{64} << 20));
    KnownPoses known;
    known.format = "Middlebury par file";
    std::string line;
    std::getline(file, line);
    std::size_t count = 0;
    std::istringstream(line) >> count;
    std::size_t line_number = 1;
    while (std::getline(file, line)) {
        const std::string where = path.string() + ":" + std::to_string(++line_number);
        std::istringstream stream(line);
        std::string name;
        if (!(stream >> name)) continue;
        const Eigen::Matrix3d calibration = next_matrix(stream);
        const Eigen::Matrix3d cam_from_world = next_matrix(stream);
        Eigen::Vector3d translation;
        stream >> translation.x() >> translation.y() >> translation.z();
        if (!stream) refuse_poses(where, "expected a name and 21 numbers");
        const Eigen::Matrix3d world_from_cam = cam_from_world.transpose();
        const Eigen::Vector3d centre = -(world_from_cam * translation);
        known.views.push_back({name, index_of_lens(known.lenses, lens_of(calibration, where)),
                               pose_from_axes(world_from_cam, centre, where)});
    }
    if (known.views.size() != count) {
        refuse_poses(path.string() + ":1", "expected " + std::to_string(count) +
                                               " photographs, found " +
                                               std::to_string(known.views.size()));
    }
    return known;
}

}  // namespace lumi
