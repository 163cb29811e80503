#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <string>
#include <string_view>

#include "render/depth_layers/depth_kind_ranges.h"
#include "render/lumigraph/drawing_choices.h"
#include "render/shaders/shader_sources.h"
#include "render/subdivision/blend_triangles.h"

namespace lumi {
namespace {

/// The first number in a shader's text that the pattern captures; NaN where it captures none.
float number_in(std::string_view shader, const std::string& pattern) {
    const std::string text(shader_source(shader));
    std::smatch found;
    if (!std::regex_search(text, found, std::regex(pattern))) return std::nanf("");
    return std::stof(found[1]);
}

float constant_in(std::string_view shader, const std::string& name) {
    return number_in(shader, "const float " + name + " = ([0-9.]+);");
}

TEST(ShaderConstants, KindsOfDepthHaveTheRangesOfPlainCode) {
    EXPECT_EQ(constant_in("agreed_depth", "kKindStep"), static_cast<float>(kDepthKindStep));
    EXPECT_EQ(constant_in("agreed_depth", "kKindWidth"), static_cast<float>(kDepthKindWidth));
    EXPECT_EQ(constant_in("depth_layer", "kStretchedBegins"),
              static_cast<float>(2 * kDepthKindStep));
}

TEST(ShaderConstants, ThereIsRoomForAsManyViewsAsMayBeAskedForDepth) {
    EXPECT_EQ(number_in("agreed_depth", R"(uniform vec4 layer_views\[([0-9]+)\];)"),
              4.0F * kMaxDepthViews);
}

TEST(ShaderConstants, ConfidenceHasTheScaleOfPlainCode) {
    EXPECT_EQ(constant_in("per_pixel", "kSeenByOne"), kSeenByOne);
    EXPECT_EQ(constant_in("per_pixel", "kFilledConfidence"), kFilledConfidence);
    EXPECT_EQ(constant_in("per_pixel", "kStretchedConfidence"), kStretchedConfidence);
}

}  // namespace
}  // namespace lumi
