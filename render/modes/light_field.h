#pragma once

#include "render/frame/drawing_mode.h"
#include "render/painters/blend_painter.h"
#include "render/painters/face_painter.h"
#include "render/painters/grid_painter.h"
#include "render/painters/picture_program.h"
#include "render/painters/surroundings_painter.h"

namespace lumi {

/// The paper without geometry (sections 3 and 4): each face of the camera mesh blends its three
/// photographs, looked up where the ray meets the scene plane (scene_plane.h) or another that the
/// options name. Of depth it knows nothing but which pixels of photographs are mixed of two
/// surfaces (photograph_opacity.h): without that, held-out photographs are drawn as well to 0.1 dB.
///
/// The paper fixes each camera's plane, so that a ray is looked up alike by every eye. The scene
/// plane turns as the eye moves: of a ray that two eyes share the weights are the same, but where
/// photographs are looked up off the scene's surface moves by some pixels. On a plane that stands
/// fixed (FocalPlane::cam_from_world) it does not.
///
/// Most of the picture is drawn as pieces on which the lookup is affine (affine_pieces.h), for
/// little more than the blend itself; pixel by pixel only where a photograph's border runs.
class LightField : public DrawingMode {
 public:
    explicit LightField(const UploadedLumigraph& uploaded);
    DrawStatistics draw(const Eye& eye, const RenderOptions& options,
                        const Viewport& viewport) override;

    /// The same for other polygons than those of the camera mesh.
    DrawStatistics draw_polygons(std::vector<FacePolygon> polygons, const Eye& eye,
                                 const RenderOptions& options);

 private:
    std::size_t draw_fading(const CameraMesh& mesh, const Eye& eye, const RenderOptions& options,
                            bool is_shell);
    [[nodiscard]] Eigen::Vector3d plane_of(const Eye& eye, const RenderOptions& options) const;

    const UploadedLumigraph& uploaded_;
    SurroundingsPainter surroundings_;
    BlendPainter blend_;
    FacePainter faces_;
    GridPainter grid_;
    PictureProgram program_;
    PictureProgram fading_;
    BlendTriangles affine_;
    std::vector<FacePolygon> exact_;
};

}  // namespace lumi
