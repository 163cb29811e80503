#include "meshing/cameras/mesh_picture.h"

#include <gtest/gtest.h>

#include "meshing/cameras/camera_mesh_builder.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(CameraMeshPicture, ShowsEveryFaceAndFrustumInBothViews) {
    std::mt19937 random(1);
    Capture capture = capture_of(sphere_directions(10, -1), Eigen::Vector3d::Zero(),
                                 points_in_ball(30, Eigen::Vector3d::Zero(), 0.3, random));
    capture.views[3].name = "a<b>&c.jpg";
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
    const std::string svg = camera_mesh_svg(capture, all_views(capture), built.mesh);
    EXPECT_EQ(occurrences(svg, "fill-opacity"), 2 * built.mesh.faces.size());
    EXPECT_EQ(occurrences(svg, "<path fill=\"none\" stroke=\"#c0392b\""), 20U);
    EXPECT_EQ(occurrences(svg, "r=\"1\""), 60U);
    EXPECT_EQ(occurrences(svg, "a&lt;b&gt;&amp;c.jpg"), 2U);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(CameraMeshPicture, NamesDoNotLieOverOneAnother) {
    Capture capture =
        capture_of({{0, 0, -3}, {0.001, 0, -3}, {1, 0, -3}}, Eigen::Vector3d::Zero(), {});
    for (std::size_t i = 0; i < 3; ++i) capture.views[i].name = "photo" + std::to_string(i);
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
    const std::string svg = camera_mesh_svg(capture, all_views(capture), built.mesh);
    EXPECT_EQ(occurrences(svg, ">photo0<"), 2U);
    EXPECT_EQ(occurrences(svg, ">photo1<"), 0U);
    EXPECT_EQ(occurrences(svg, ">photo2<"), 1U) << "from the side it hides behind the first";
}

TEST(CameraMeshPicture, ShowsWhoIsNearWhomOnAWalkForward) {
    const Capture capture =
        capture_of({{0, 0, -3}, {0, 0, -4}, {0, 0, -5}}, Eigen::Vector3d::Zero(), {});
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
    const std::string svg = camera_mesh_svg(capture, all_views(capture), built.mesh);
    EXPECT_EQ(occurrences(svg, "stroke-opacity=\"0.5\" d=\"M"), 6U);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(CameraMeshPicture, OfOneCameraOrAnyUnitOfLengthIsFinite) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        const Capture capture = capture_of({{0, 0, -scale}}, Eigen::Vector3d::Zero(), {});
        const BuiltCameraMesh built = build_camera_mesh(capture, {0}, {});
        const std::string svg = camera_mesh_svg(capture, {0}, built.mesh);
        EXPECT_EQ(svg.find("nan"), std::string::npos);
        EXPECT_EQ(svg.find("inf"), std::string::npos);
    }
}

}  // namespace
}  // namespace lumi
