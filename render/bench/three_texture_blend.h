#pragma once

#include "render/frame/viewport.h"
#include "render/gl/program.h"
#include "render/gl/screen.h"
#include "render/gl/texture.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The full screen blended from three photographs: what frame times are a ratio of, so that they
/// can be compared between machines.
class ThreeTextureBlend {
 public:
    /// Uses the first three views, again from the first when there are fewer. A context must be
    /// current.
    explicit ThreeTextureBlend(const Lumigraph& lumigraph);
    void draw(const Viewport& viewport) const;

 private:
    TextureArray photographs_;
    Screen screen_;
    Program program_;
    float width_share_ = 1.0F;
    float height_share_ = 1.0F;
};

}  // namespace lumi
