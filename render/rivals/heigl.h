#pragma once

#include "render/modes/light_field.h"
#include "render/modes/paper2001.h"

namespace lumi {

/// Polygons of the picture as Heigl, Pollefeys, Denzler and van Gool (1999) choose the views of
/// each pixel: the optical centres are projected into the eye's picture and triangulated there
/// anew for each frame; within a triangle the views of its corners are blended with barycentric
/// weights. What lies outside of all triangles is not drawn. The same ray seen from another place
/// may be blended from other views, which the paper's static mesh avoids. Views that look
/// elsewhere are left out (kHeiglLeastCosine). Where the eye is at a camera, which has no place in
/// the picture, all of it is that camera's. An eye in a camera's plane is taken to be a millionth
/// of the scene's distance beside it.
[[nodiscard]] std::vector<FacePolygon> heigl_polygons(const Lumigraph& lumigraph, const Eye& eye);

/// Whether depth corrects these polygons: where there is some, and no focal surface is asked for.
[[nodiscard]] bool corrects_depth_of_heigl(const Lumigraph& lumigraph,
                                           const RenderOptions& options);

/// What the paper does, with these polygons in the place of the camera mesh: "used in very much the
/// same way" (section 2). With depth its adaptive depth and occlusion correction (`paper2001`);
/// without, or on a focal surface, the light field on one plane.
class Heigl : public DrawingMode {
 public:
    explicit Heigl(const UploadedLumigraph& uploaded);
    DrawStatistics draw(const Eye& eye, const RenderOptions& options,
                        const Viewport& viewport) override;

 private:
    const UploadedLumigraph& uploaded_;
    LightField light_field_;
    Paper2001 with_depth_;
};

}  // namespace lumi
