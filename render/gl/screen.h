#pragma once

#include "render/gl/vertex_buffer.h"

namespace lumi {

/// All of the viewport, for programs of which shaders/screen.glsl is a part. A context must be
/// current.
class Screen {
 public:
    Screen();
    void draw() const;

 private:
    VertexBuffer corners_;
};

}  // namespace lumi
