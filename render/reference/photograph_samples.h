#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/lumigraph/lumigraph.h"
#include "render/reference/mip_levels.h"

namespace lumi {

/// Photographs and how much they count, looked up between pixels and from far away at a mip level,
/// as a GL does.
class PhotographSamples {
 public:
    /// The Lumigraph must outlive it. `opacities` say how much each pixel of its photographs counts
    /// (photograph_opacities); none: as much as any.
    PhotographSamples(const Lumigraph& lumigraph, const Eye& eye, std::vector<GrayImage> opacities);

    /// Red, green and blue, 0 to 255.
    [[nodiscard]] Eigen::Vector3d color(int view_index, const Eigen::Vector2d& pixel) const;
    /// How much the photograph counts there (photograph_opacity.h), 0 to 255.
    [[nodiscard]] double opacity(int view_index, const Eigen::Vector2d& pixel) const;

 private:
    void make_mip_levels();
    [[nodiscard]] Eigen::Vector4d at_mip_level(int view_index, const Eigen::Vector2d& pixel) const;

    const Lumigraph& lumigraph_;
    std::vector<GrayImage> opacities_;
    double lod_;
    Eigen::Vector2d layer_size_px_ = Eigen::Vector2d::Zero();
    std::vector<MipLevels> mip_levels_;  ///< Of the photographs; without at the finest level.
};

}  // namespace lumi
