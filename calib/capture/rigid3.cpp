#include "calib/capture/rigid3.h"

namespace lumi {

// Not inline: for opposite directions Eigen decomposes a matrix, which costs every file that says
// so seconds of compiling.
Eigen::Quaterniond turn_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return Eigen::Quaterniond::FromTwoVectors(from, to);
}

}  // namespace lumi
