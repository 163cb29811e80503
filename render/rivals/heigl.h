#pragma once

#include "render/modes/light_field.h"

namespace lumi {

/// Polygons of the picture as Heigl, Pollefeys, Denzler and van Gool (1999) choose the views of
/// each pixel: the optical centres are projected into the eye's picture and triangulated there
/// anew for each frame; within a triangle the views of its corners are blended with barycentric
/// weights. What lies outside of all triangles is not drawn. The same ray seen from another place
/// may be blended from other views, which the paper's static mesh avoids. Views that face the other
/// way are left out. Where the eye is at a camera, which has no place in the picture, all of it is
/// that camera's. An eye in a camera's plane is taken to be a millionth of the scene's distance
/// beside it.
[[nodiscard]] std::vector<FacePolygon> heigl_polygons(const Lumigraph& lumigraph, const Eye& eye);

/// The light field on the scene plane, or on a focal surface, with these polygons in the place of
/// the camera mesh.
class Heigl : public DrawingMode {
 public:
    explicit Heigl(const UploadedLumigraph& uploaded);
    DrawStatistics draw(const Eye& eye, const RenderOptions& options,
                        const Viewport& viewport) override;

 private:
    const UploadedLumigraph& uploaded_;
    LightField light_field_;
};

}  // namespace lumi
