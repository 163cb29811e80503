#pragma once

#include <optional>
#include <vector>

#include "render/faces/face_polygons.h"
#include "render/gl/program.h"
#include "render/gl/vertex_buffer.h"
#include "render/subdivision/blend_triangles.h"

namespace lumi {

/// Draws what a picture was put together from as lines over it (the paper, figure 9).
class GridPainter {
 public:
    void draw(const BlendTriangles& triangles, const Eye& eye);
    void draw(const std::vector<FacePolygon>& polygons, const Eye& eye);

 private:
    void draw_lines(const std::vector<float>& pixels, const std::vector<std::uint32_t>& ends,
                    const Eye& eye);

    std::optional<Program> program_;  ///< Made when it is first asked for.
    VertexBuffer lines_;
};

}  // namespace lumi
