#pragma once

#include <optional>

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

 private:
    const UploadedLumigraph& uploaded_;
    std::optional<Program> program_;
    VertexBuffer triangles_;
};

}  // namespace lumi
