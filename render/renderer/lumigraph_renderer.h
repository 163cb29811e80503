#pragma once

#include <cstddef>
#include <memory>

#include "render/frame/frame.h"
#include "render/frame/viewport.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Draws a Lumigraph with OpenGL 3.3 core or OpenGL ES 3.0 into whatever framebuffer is bound, so
/// that a window and a file hold the same picture.
///
/// A context must be current whenever a member, the destructor included, is called; it must be the
/// same one each time. Everything is uploaded by the constructor, which keeps no reference to the
/// Lumigraph. Views without depth among others get what these know (depth_of_others.h). Throws
/// Error: E-GL-CONTEXT (the context is too old), E-GL-LIMIT (the photographs do not fit the texture
/// limits of this GL).
class LumigraphRenderer {
 public:
    explicit LumigraphRenderer(const Lumigraph& lumigraph);
    ~LumigraphRenderer();
    LumigraphRenderer(LumigraphRenderer&& other) noexcept;
    LumigraphRenderer& operator=(LumigraphRenderer&& other) noexcept;

    /// Fills the viewport: alpha is the frame's coverage (frame.h). Colours are encoded sRGB, as in
    /// the photographs, and are blended as such.
    /// An eye of another size than the viewport is resized to it. Throws Error: E-EYE-LENS
    /// (the eye's camera is not a pinhole), E-GL-LIMIT (what the frame takes does not fit this GL).
    ///
    /// Leaves the framebuffer binding as it was; blending, depth test, face culling and scissor
    /// test are off afterwards, no program and no vertex array are bound.
    DrawStatistics draw(const Eye& eye, const RenderOptions& options, const Viewport& viewport);

    /// Makes the next frame cost what a moving eye's does: an eye that stands still is drawn from
    /// what the frame before took, which is the same picture for less. Whoever times frames forgets
    /// each before the next.
    void forget_frame();

    /// Draws from now on as if the Lumigraph had come with these choices, which must be within
    /// their limits. Photographs and depth maps stay uploaded; what a mode makes of the choices is
    /// made anew by the next frame. Where this throws, nothing has changed.
    void choose(const DrawingChoices& drawing);

    /// The size of the photographs and depth maps in textures, at their finest level.
    [[nodiscard]] std::size_t texture_bytes() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace lumi
