#pragma once

#include "render/gl/vertex_buffer.h"
#include "render/modes/blend_triangles.h"
#include "render/modes/picture_program.h"

namespace lumi {

/// The attributes of a BlendVertex as shaders/blend.glsl reads them.
[[nodiscard]] const std::vector<VertexAttribute>& blend_vertex_attributes();

/// Draws triangles that blend three photographs each (shaders/blend.glsl), in one pass.
class BlendPainter {
 public:
    explicit BlendPainter(const UploadedLumigraph& uploaded);

    void draw(const BlendTriangles& triangles, const Eye& eye, const RenderOptions& options);

 private:
    const UploadedLumigraph& uploaded_;
    PictureProgram program_;
    VertexBuffer triangles_;
};

}  // namespace lumi
