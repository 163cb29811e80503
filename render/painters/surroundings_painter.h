#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/gl/program.h"
#include "render/gl/vertex_buffer.h"
#include "render/surroundings/picture_cells.h"
#include "render/uploaded/uploaded_lumigraph.h"

namespace lumi {

/// Draws what lies beyond the capture (surroundings.h), before anything is drawn over it: as much
/// as most blends cost, were it the whole picture.
class SurroundingsPainter {
 public:
    explicit SurroundingsPainter(const UploadedLumigraph& uploaded) : uploaded_(uploaded) {}

    /// In the marked cells of the eye's picture.
    void draw(const PictureCells& cells, const Eye& eye);
    /// The same into the rasters of blocks (pixel_blocks.h), of which `eye` is the covering one.
    void draw_in_blocks(const PictureCells& cells, const Eye& eye);

 private:
    void draw_with(std::optional<Program>& program, const std::vector<std::string>& definitions,
                   const PictureCells& cells, const Eye& eye);

    const UploadedLumigraph& uploaded_;
    std::optional<Program> in_pixels_;
    std::optional<Program> in_blocks_;
    std::optional<VertexBuffer> triangles_;
};

}  // namespace lumi
