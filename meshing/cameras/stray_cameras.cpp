#include "meshing/cameras/stray_cameras.h"

#include <algorithm>

namespace lumi {

std::vector<OpticalAxis> without_strays(const std::vector<OpticalAxis>& axes) {
    constexpr double kTooFar = 2.0;
    constexpr std::size_t kLeastOthers = 3;
    const Eigen::Vector3d centre = estimate_scene_centre(axes);
    const double usual = median_distance(axes, centre);
    std::vector<OpticalAxis> others = axes;
    std::erase_if(others, [&](const OpticalAxis& axis) {
        const double distance = (axis.centre_in_world - centre).norm();
        return distance > kTooFar * usual || kTooFar * distance < usual;
    });
    const std::size_t strays = axes.size() - others.size();
    const bool are_few = strays <= std::max<std::size_t>(1, axes.size() / 10);
    return are_few && others.size() >= kLeastOthers ? others : axes;
}

}  // namespace lumi
