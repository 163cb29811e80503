#include "calib/known_poses/middlebury_par.h"

#include <cmath>
#include <sstream>

#include "calib/known_poses/camera_axes.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

Eigen::Matrix3d next_matrix(std::istream& stream) {
    Eigen::Matrix3d matrix;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) stream >> matrix(row, column);
    }
    return matrix;
}

KnownLens lens_of(const Eigen::Matrix3d& calibration, const std::string& where) {
    constexpr double kMaxSkew = 1e-3;
    const double focal_x = calibration(0, 0);
    const bool is_upper_triangular = calibration(1, 0) == 0 && calibration(2, 0) == 0 &&
                                     calibration(2, 1) == 0 && calibration(2, 2) == 1;
    if (!calibration.allFinite() || !is_upper_triangular || focal_x <= 0 ||
        calibration(1, 1) <= 0) {
        refuse_poses(where, "K is not a calibration matrix");
    }
    if (std::abs(calibration(0, 1)) > kMaxSkew * focal_x) refuse_poses(where, "K has a skew");
    constexpr double kHalfPixel = 0.5;
    KnownLens lens;
    lens.size_is_stated = false;
    lens.camera.parameters = {focal_x, calibration(1, 1), calibration(0, 2) + kHalfPixel,
                              calibration(1, 2) + kHalfPixel};
    return lens;
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
