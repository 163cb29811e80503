#pragma once

#include "render/gl/program.h"
#include "render/gl/vertex_buffer.h"
#include "render/modes/frame.h"
#include "render/modes/uploaded_lumigraph.h"

namespace lumi {

/// Draws the faces of the camera mesh as polygons of the picture, with what shaders/face.glsl
/// needs of the three views of each.
class FacePainter {
 public:
    explicit FacePainter(const UploadedLumigraph& uploaded);

    /// Draws with `program`, which is in use and made from face.glsl.
    void draw(const Eye& eye, const RenderOptions& options, const Program& program);

 private:
    const UploadedLumigraph& uploaded_;
    VertexBuffer polygons_;
};

}  // namespace lumi
