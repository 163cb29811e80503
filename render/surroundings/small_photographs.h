#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/capture/image.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Photographs so small that only the colours of their regions are left: what surroundings are made
/// of. Where a photograph shows its subject alone, before what is infinitely far (a plain
/// background, or what masks leave out), they are the background's, also where the subject hides
/// it: what no photograph shows lies behind the subject or beside it.
struct SmallPhotographs {
    std::vector<ColorImage> of_views;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();  ///< Of all their pixels, 0 to 255.
};
[[nodiscard]] SmallPhotographs small_photographs(const Lumigraph& lumigraph);

}  // namespace lumi
