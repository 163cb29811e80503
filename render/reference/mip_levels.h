#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace lumi {

/// The mip levels of a picture of four bytes a texel, as glGenerateMipmap makes them: each level
/// has half as many rows and columns, rounded down, read between the texels of the one before. Of
/// all but the finest alpha is 0 along the borders (TextureArray::make_mip_levels).
class MipLevels {
 public:
    MipLevels(std::vector<unsigned char> rgba, int width_px, int height_px);

    /// Trilinear, 0 to 255; `place` runs from 0 to 1 over the picture.
    [[nodiscard]] Eigen::Vector4d at(const Eigen::Vector2d& place, double lod) const;

 private:
    struct Level {
        std::vector<unsigned char> rgba;
        int width_px = 0;
        int height_px = 0;

        [[nodiscard]] Eigen::Vector4d at(const Eigen::Vector2d& place) const;
        void end_at_borders();
    };
    std::vector<Level> levels_;
};

}  // namespace lumi
