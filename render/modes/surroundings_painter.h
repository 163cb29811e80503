#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/gl/program.h"
#include "render/gl/vertex_buffer.h"
#include "render/modes/picture_cells.h"
#include "render/modes/uploaded_lumigraph.h"

namespace lumi {

/// Draws what lies beyond the capture (surroundings.h), before anything is drawn over it: as much
/// as most blends cost, were it the whole picture.
class SurroundingsPainter {
 public:
    explicit SurroundingsPainter(const UploadedLumigraph& uploaded) : uploaded_(uploaded) {}

    /// In the marked cells of the eye's picture.
    void draw(const PictureCells& cells, const Eye& eye);
    /// The same into the rasters of its blocks (pixel_blocks.h).
    void draw_in_blocks(const PictureCells& cells, const Eye& eye);

 private:
    /// Over a picture that is the eye's, or reaches as far beyond it as its blocks do.
    void draw_over(const Camera& picture, const PictureCells& cells, const Eye& eye,
                   const std::vector<std::string>& definitions, std::optional<Program>& program);

    const UploadedLumigraph& uploaded_;
    std::optional<Program> in_pixels_;
    std::optional<Program> in_blocks_;
    std::optional<VertexBuffer> triangles_;
};

}  // namespace lumi
