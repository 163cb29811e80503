#pragma once

#include <string>
#include <vector>

#include "render/depth_layers/depth_eye.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/gl/screen.h"
#include "render/surroundings/picture_cells.h"

namespace lumi {

/// Finds the cells of a picture that none of the views that were asked for depth sees
/// (holes/hole_cells.h), in the layers that these were drawn to (shaders/holes.glsl).
class HoleFinder {
 public:
    /// `layer_definitions` say how many layers there are, and how they lie in the texture.
    explicit HoleFinder(std::vector<std::string> layer_definitions);

    /// `layers` hold the depth of `depth_eye` for the eye with this camera, in which depths of one
    /// surface differ by at most `agreeing_depth`. Waits until they are drawn; leaves the
    /// framebuffer bound that was.
    [[nodiscard]] PictureCells find(const TextureArray& layers, float agreeing_depth,
                                    const DepthEye& depth_eye, const Camera& camera);

 private:
    Program program_;
    Screen screen_;
    Framebuffer framebuffer_;
    int columns_ = 0;  ///< Of the framebuffer.
    int rows_ = 0;
};

}  // namespace lumi
