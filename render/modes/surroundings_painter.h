#pragma once

#include <optional>

#include "render/gl/program.h"
#include "render/gl/vertex_buffer.h"
#include "render/modes/surroundings.h"

namespace lumi {

/// Fills the viewport with a grid of colours (surroundings.h), before anything is drawn over it.
class SurroundingsPainter {
 public:
    /// `colors` are those of the eye's picture.
    void draw(const ColorGrid& colors, const Eye& eye);

 private:
    std::optional<Program> program_;
    VertexBuffer triangles_;
};

}  // namespace lumi
