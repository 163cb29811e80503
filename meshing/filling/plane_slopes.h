#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshing/surface/depth_map.h"

namespace lumi {

/// How the surface slopes around each pixel, by planes fitted to squares of pixels.
class PlaneSlopes {
 public:
    PlaneSlopes() = default;
    struct Slope {
        Eigen::Vector2f per_pixel = Eigen::Vector2f::Zero();  ///< Inverse depth, right and down.
        bool is_plane = false;                                ///< Else the slope is zero.
    };
    PlaneSlopes(int tile_side, int tiles_across, std::vector<Slope> slopes)
        : tile_side_(tile_side), tiles_across_(tiles_across), slopes_(std::move(slopes)) {}

    [[nodiscard]] const Slope& at(int x, int y) const {
        return slopes_[static_cast<std::size_t>(y / tile_side_ * tiles_across_ + x / tile_side_)];
    }

 private:
    int tile_side_ = 1;
    int tiles_across_ = 0;
    std::vector<Slope> slopes_;
};

/// Least-squares planes through the known pixels of each square of 16 pixels and 16 around it. A
/// square of which less than a third is known, or whose pixels lie off the plane by more than
/// `one_pixel` (root mean square), is no plane.
[[nodiscard]] PlaneSlopes plane_slopes(const DepthMap& map, double one_pixel);

}  // namespace lumi
