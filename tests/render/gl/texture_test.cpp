#include "render/gl/texture.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "calib/work/error.h"
#include "render/gl/capabilities.h"
#include "render/gl/headless_context.h"

namespace lumi {
namespace {

void expect_refused(int width_px, int height_px, int layers) {
    try {
        const TextureArray array(TexelFormat::kFourFloats, TexelFilter::kNearest, width_px,
                                 height_px, layers);
        FAIL() << "expected E-GL-LIMIT";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-GL-LIMIT");
    }
}

TEST(TextureArrayGl, RefusesWhatTheDriverHasNoMemoryFor) {
    const HeadlessContext context;
    const Capabilities capabilities = query_capabilities();
    const int size_px = capabilities.max_texture_size_px;
    // Hundreds of gibibytes.
    expect_refused(size_px, size_px, capabilities.max_array_layers);
    const TextureArray small(TexelFormat::kFourFloats, TexelFilter::kNearest, 8, 8, 1);
    EXPECT_EQ(small.layers(), 1);
}

TEST(TextureArrayGl, RefusesMoreThanThisGlHolds) {
    const HeadlessContext context;
    const Capabilities capabilities = query_capabilities();
    expect_refused(capabilities.max_texture_size_px + 1, 1, 1);
    expect_refused(1, capabilities.max_texture_size_px + 1, 1);
    expect_refused(1, 1, capabilities.max_array_layers + 1);
}

TEST(TextureArrayGl, IsNotRefusedForWhatElseGlComplainedOf) {
    const HeadlessContext context;
    glEnable(GL_NONE);
    const TextureArray array(TexelFormat::kColor, TexelFilter::kLinear, 8, 8, 1);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace lumi
