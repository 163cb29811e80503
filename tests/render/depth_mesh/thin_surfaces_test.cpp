#include "render/depth_mesh/thin_surfaces.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace lumi {
namespace {

constexpr int kThinWidth_px = 240;
constexpr int kThinHeight_px = 180;
constexpr double kThinDisparity_px = 100.0;
constexpr float kGround = 0.2F;
constexpr float kThing = 0.5F;  // 30 px before it.

/// A rectangle of samples.
struct Box {
    int left, top, right, bottom;
};

/// A view of a slope with things before it.
LumigraphView view_of(const std::vector<Box>& things) {
    LumigraphView view;
    view.camera = pinhole_camera(kThinWidth_px, kThinHeight_px, 200);
    view.depth = {FloatImage(kThinWidth_px, kThinHeight_px),
                  GrayImage(kThinWidth_px, kThinHeight_px, 255)};
    for (int y = 0; y < kThinHeight_px; ++y)
        for (int x = 0; x < kThinWidth_px; ++x)
            view.depth.inverse_depth(x, y) = kGround + 0.0005F * static_cast<float>(x);
    for (const Box& box : things)
        for (int y = box.top; y < box.bottom; ++y)
            for (int x = box.left; x < box.right; ++x) view.depth.inverse_depth(x, y) = kThing;
    return view;
}

double area_px2(const ThinSurfaces& thin) {
    double area = 0;
    for (std::size_t i = 0; i < thin.indices.size(); i += 3) {
        const Eigen::Vector3f& a = thin.vertices[thin.indices[i]];
        const Eigen::Vector3f ab = thin.vertices[thin.indices[i + 1]] - a;
        const Eigen::Vector3f ac = thin.vertices[thin.indices[i + 2]] - a;
        area += 0.5 * std::abs(static_cast<double>(ab.x() * ac.y() - ab.y() * ac.x()));
    }
    return area;
}

TEST(ThinSurfaces, AreABarAndNothingOfWhatIsBehind) {
    const Box bar{100, 20, 104, 160};
    const ThinSurfaces thin = thin_surfaces(view_of({bar}), kThinDisparity_px, {});
    ASSERT_FALSE(thin.indices.empty());
    for (const std::uint32_t index : thin.indices) {
        const Eigen::Vector3f& vertex = thin.vertices[index];
        EXPECT_NEAR(vertex.z(), kThing, 0.016) << vertex.transpose();
        EXPECT_GE(vertex.x(), bar.left - 1);
        EXPECT_LE(vertex.x(), bar.right + 1);
        EXPECT_GE(vertex.y(), bar.top - 1);
        EXPECT_LE(vertex.y(), bar.bottom + 1);
    }
    // A bar as wide as four samples, its ends moved by up to one.
    EXPECT_NEAR(area_px2(thin), 4 * 140, 140);
}

TEST(ThinSurfaces, AreDrawnWithFewTriangles) {
    const ThinSurfaces thin = thin_surfaces(view_of({{100, 20, 104, 160}}), kThinDisparity_px, {});
    EXPECT_LE(thin.indices.size() / 3, 20U);
}

TEST(ThinSurfaces, AreAnythingLongInAnyDirection) {
    EXPECT_FALSE(
        thin_surfaces(view_of({{20, 90, 220, 93}}), kThinDisparity_px, {}).indices.empty());
    std::vector<Box> steps;
    for (int i = 0; i < 100; ++i) steps.push_back({60 + i, 40 + i, 62 + i, 42 + i});
    EXPECT_FALSE(thin_surfaces(view_of(steps), kThinDisparity_px, {}).indices.empty());
}

TEST(ThinSurfaces, AreNoWideThingsNorSpecks) {
    EXPECT_TRUE(thin_surfaces(view_of({}), kThinDisparity_px, {}).indices.empty());
    EXPECT_TRUE(
        thin_surfaces(view_of({{80, 40, 140, 120}}), kThinDisparity_px, {}).indices.empty());
    EXPECT_TRUE(thin_surfaces(view_of({{80, 40, 82, 42}}), kThinDisparity_px, {}).indices.empty());
}

TEST(ThinSurfaces, AreNothingThatHardlyStandsOutOrThatIsGuessed) {
    const LumigraphView view = view_of({{100, 20, 104, 160}});
    EXPECT_TRUE(thin_surfaces(view, 0.1 * kThinDisparity_px, {}).indices.empty());
    LumigraphView guessed = view;
    for (std::uint8_t& confidence : guessed.depth.confidence.pixels()) confidence = 0;
    EXPECT_TRUE(thin_surfaces(guessed, kThinDisparity_px, {}).indices.empty());
    LumigraphView without_depth = view;
    without_depth.depth = {};
    EXPECT_TRUE(thin_surfaces(without_depth, kThinDisparity_px, {}).indices.empty());
}

}  // namespace
}  // namespace lumi
