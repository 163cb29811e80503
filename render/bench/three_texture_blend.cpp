#include "render/bench/three_texture_blend.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "render/shaders/shader_sources.h"

namespace lumi {
namespace {

constexpr int kTextures = 3;

const ColorImage& photograph(const Lumigraph& lumigraph, int layer) {
    return lumigraph.views[static_cast<std::size_t>(layer) % lumigraph.views.size()].photograph;
}

}  // namespace

ThreeTextureBlend::ThreeTextureBlend(const Lumigraph& lumigraph)
    : program_("three_texture_blend",
               {shader_source("screen"), shader_source("three_texture_blend")}) {
    int width = 0;
    int height = 0;
    for (int layer = 0; layer < kTextures; ++layer) {
        width = std::max(width, photograph(lumigraph, layer).width());
        height = std::max(height, photograph(lumigraph, layer).height());
    }
    photographs_ =
        TextureArray(TexelFormat::kColor, TexelFilter::kLinear, width, height, kTextures);
    for (int layer = 0; layer < kTextures; ++layer) {
        photographs_.upload(layer, photograph(lumigraph, layer));
    }
    const ColorImage& first = photograph(lumigraph, 0);
    width_share_ = static_cast<float>(first.width()) / static_cast<float>(width);
    height_share_ = static_cast<float>(first.height()) / static_cast<float>(height);
}

void ThreeTextureBlend::draw(const Viewport& viewport) const {
    glViewport(viewport.x_px, viewport.y_px, viewport.width_px, viewport.height_px);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    program_.use();
    photographs_.bind(0);
    program_.set("photographs", 0);
    program_.set("photograph_share", glm::vec2(width_share_, height_share_));
    screen_.draw();
}

}  // namespace lumi
