#pragma once

#include <vector>

#include "render/faces/face_polygons.h"
#include "render/frame/drawing_mode.h"
#include "render/gl/vertex_buffer.h"
#include "render/painters/grid_painter.h"
#include "render/painters/picture_program.h"
#include "render/subdivision/blend_triangles.h"

namespace lumi {

/// The paper to the letter (section 4): adaptive depth correction of each camera patch
/// (paper_subdivision.h) with occlusion correction at its vertices, drawn as three projective
/// textures whose weights are alphas that add up.
class Paper2001 : public DrawingMode {
 public:
    explicit Paper2001(const UploadedLumigraph& uploaded);
    DrawStatistics draw(const Eye& eye, const RenderOptions& options,
                        const Viewport& viewport) override;

    /// The same for other polygons than those of the camera mesh.
    DrawStatistics draw_polygons(const std::vector<FacePolygon>& polygons, const Eye& eye,
                                 const RenderOptions& options);

    /// Adds up the three passes over such triangles.
    void draw_passes(const BlendTriangles& triangles, const Eye& eye, const RenderOptions& options);

 private:
    const UploadedLumigraph& uploaded_;
    PictureProgram program_;
    VertexBuffer triangles_;
    GridPainter grid_;
};

}  // namespace lumi
