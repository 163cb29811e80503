#include "render/subdivision/patch_sample.h"

namespace lumi {

BlendVertex blend_vertex(const PatchSample& sample, const FacePolygon& polygon, VertexDepth depth) {
    BlendVertex corner;
    corner.pixel = {static_cast<float>(sample.pixel.x()), static_cast<float>(sample.pixel.y())};
    corner.depth =
        static_cast<float>(depth == VertexDepth::kTrue ? sample.depth : sample.affine_depth);
    for (std::size_t k = 0; k < 3; ++k) {
        corner.view_pixels[k] = {static_cast<float>(sample.view_pixels[k].x()),
                                 static_cast<float>(sample.view_pixels[k].y())};
        corner.weights[k] = static_cast<float>(sample.weights[k]);
        corner.view_layers[k] = static_cast<float>(polygon.view_indices[k]);
        corner.depth_ratios[k] = static_cast<float>(sample.depth_ratios[k]);
    }
    corner.inverse_depth = static_cast<float>(sample.inverse_depth);
    corner.confidence = static_cast<float>(sample.confidence);
    corner.occluded = static_cast<float>(sample.occluded);
    corner.face_index = static_cast<float>(polygon.face_index);
    corner.opacity = static_cast<float>(sample.opacity);
    return corner;
}

}  // namespace lumi
