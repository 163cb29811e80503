#include "render/gl/drawing_threads.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "calib/work/parallel_for.h"
#include "render/gl/capabilities.h"
#include "render/gl/framebuffer.h"
#include "render/gl/headless_context.h"
#include "render/gl/texture.h"

namespace lumi {
namespace {

constexpr int kSide_px = 8;
constexpr int kMostThreads = 3;

/// The first byte of a texel of a layer.
int red_of(const TextureArray& layers, int layer) {
    Framebuffer framebuffer;
    framebuffer.attach_color_layer(layers, layer);
    return framebuffer.read_rgba_bottom_up(kSide_px, kSide_px).front();
}

void clear_layer(const TextureArray& layers, int layer, int red) {
    Framebuffer framebuffer;
    framebuffer.attach_color_layer(layers, layer);
    glClearColor(static_cast<float>(red) / 255.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
}

class DrawingThreadsTest : public testing::TestWithParam<GlApi> {
 protected:
    HeadlessContext context_{GetParam()};
};

TEST_P(DrawingThreadsTest, EachDrawsIntoALayerOfItsOwn) {
    DrawingThreads threads(kMostThreads);
    const int count = static_cast<int>(threads.size());
    const TextureArray layers(TexelFormat::kColor, TexelFilter::kNearest, kSide_px, kSide_px,
                              count);
    for (int round = 1; round <= 20; ++round) {
        threads.run([&](std::size_t thread) {
            const int layer = static_cast<int>(thread);
            clear_layer(layers, layer, 10 * round + layer);
        });
        for (int layer = 0; layer < count; ++layer)
            EXPECT_EQ(red_of(layers, layer), 10 * round + layer) << "round " << round;
    }
}

TEST_P(DrawingThreadsTest, TheCallerIsTheFirstOfThem) {
    DrawingThreads threads(kMostThreads);
    ASSERT_GE(threads.size(), 1U);
    ASSERT_LE(threads.size(), static_cast<std::size_t>(kMostThreads));
    std::vector<std::thread::id> ids(threads.size());
    threads.run([&](std::size_t thread) { ids[thread] = std::this_thread::get_id(); });
    EXPECT_EQ(ids.front(), std::this_thread::get_id());
    for (std::size_t i = 1; i < ids.size(); ++i) EXPECT_NE(ids[i], ids.front());
}

TEST_P(DrawingThreadsTest, ThereAreSeveralWhereOpenGlWorksOnSeveralCores) {
    const bool has_use_for_others = query_capabilities().works_on_cpu && resolve_threads(0) > 1;
    EXPECT_EQ(DrawingThreads(kMostThreads).size() > 1, has_use_for_others);
}

TEST_P(DrawingThreadsTest, WhatATaskThrowsIsThrownWhenAllHaveEnded) {
    DrawingThreads threads(kMostThreads);
    for (std::size_t thrower = 0; thrower < threads.size(); ++thrower) {
        std::atomic<std::size_t> ended = 0;
        EXPECT_THROW(threads.run([&](std::size_t thread) {
            ++ended;
            if (thread == thrower) throw std::runtime_error("as asked");
        }),
                     std::runtime_error);
        EXPECT_EQ(ended, threads.size());
    }
    std::atomic<std::size_t> ended = 0;
    threads.run([&](std::size_t) { ++ended; });
    EXPECT_EQ(ended, threads.size());
}

TEST_P(DrawingThreadsTest, OneOfThemIsTheCallerAlone) {
    DrawingThreads threads(1);
    ASSERT_EQ(threads.size(), 1U);
    int calls = 0;
    threads.run([&](std::size_t) { ++calls; });
    EXPECT_EQ(calls, 1);
}

INSTANTIATE_TEST_SUITE_P(InEitherApi, DrawingThreadsTest, testing::Values(GlApi::kCore, GlApi::kEs),
                         [](const auto& api) { return api.param == GlApi::kCore ? "Core" : "Es"; });

}  // namespace
}  // namespace lumi
