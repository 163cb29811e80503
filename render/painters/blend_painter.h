#pragma once

#include <array>

#include "render/gl/vertex_buffer.h"
#include "render/painters/blend_lookups.h"
#include "render/painters/grid_painter.h"
#include "render/painters/picture_program.h"
#include "render/subdivision/blend_triangles.h"

namespace lumi {

/// The attributes of a BlendVertex as shaders/blend.glsl reads them.
[[nodiscard]] const std::vector<VertexAttribute>& blend_vertex_attributes();

/// What lies behind triangles.
enum class Behind {
    kNothing,       ///< What no photograph shows stays as it was.
    kSurroundings,  ///< What no photograph shows gets the surroundings of the vertices.
    kBlack,         ///< The triangles fade into it as far as the vertices are not opaque.
    kPicture,       ///< The same into the picture. What they cover counts as covered, guess or not.
    kGuesses,       ///< The triangles replace the picture where it is a guess and they are not.
};

/// Draws triangles that blend three photographs each (shaders/blend.glsl), in one pass.
class BlendPainter {
 public:
    /// Less confidence than `least_confidence` does not count as covered.
    explicit BlendPainter(const UploadedLumigraph& uploaded, float least_confidence = 0.0F);

    void draw(const BlendTriangles& triangles, const Eye& eye, const RenderOptions& options,
              Behind behind = Behind::kNothing);

 private:
    [[nodiscard]] PictureProgram& program_for(const LookupRun& run, Behind behind);

    const UploadedLumigraph& uploaded_;
    float least_confidence_;
    /// The programs by the number of photographs that they look up.
    std::array<PictureProgram, 3> programs_;
    std::array<PictureProgram, 3> discarding_;  ///< Where photographs may end.
    std::array<PictureProgram, 3> filling_;     ///< There, too, where there are surroundings.
    std::array<PictureProgram, 3> fading_;
    std::array<PictureProgram, 3> known_alone_;  ///< Over guesses.
    VertexBuffer triangles_;
    GridPainter grid_;
};

}  // namespace lumi
