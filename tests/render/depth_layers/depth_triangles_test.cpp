#include "render/depth_layers/depth_triangles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <random>

namespace lumi {
namespace {

constexpr int kWidth = 61;
constexpr int kHeight = 43;
constexpr int kCells = 14;  // Of the mesh, along each side.

/// Inverse depth does not matter here: depth is given where the window is.
using WindowFromView = Eigen::Matrix4f;

/// The square from -1 to 1 as triangles whose corners are anywhere near a lattice's nodes.
struct Square {
    std::vector<Eigen::Vector3f> vertices;
    std::vector<std::uint32_t> indices;
};

Square uneven_square(std::mt19937& random) {
    Square square;
    std::uniform_real_distribution<float> moved(-0.3F, 0.3F);
    for (int row = 0; row <= kCells; ++row) {
        for (int column = 0; column <= kCells; ++column) {
            const bool is_border = row == 0 || column == 0 || row == kCells || column == kCells;
            const auto at = [&](int cell) {
                return 2.0F * (static_cast<float>(cell) + (is_border ? 0.0F : moved(random))) /
                           kCells -
                       1.0F;
            };
            square.vertices.emplace_back(at(column), at(row), 0.0F);
        }
    }
    for (std::uint32_t row = 0; row < kCells; ++row) {
        for (std::uint32_t column = 0; column < kCells; ++column) {
            const std::uint32_t a = row * (kCells + 1) + column;
            const std::uint32_t c = a + kCells + 1;
            square.indices.insert(square.indices.end(), {a, a + 1, c, a + 1, c + 1, c});
        }
    }
    return square;
}

/// A plane: depth is affine in the window, rising from near 0 to near 1 over it.
WindowFromView plane_seen_by(const Eigen::Matrix3f& window_from_square) {
    WindowFromView matrix = WindowFromView::Zero();
    for (Eigen::Index row = 0; row < 3; ++row)
        matrix.row(row) << window_from_square(row, 0), window_from_square(row, 1),
            window_from_square(row, 2), 0.0F;
    matrix.row(3) =
        (0.4F / kWidth) * matrix.row(0) + (0.4F / kHeight) * matrix.row(1) + 0.1F * matrix.row(2);
    return matrix;
}

float depth_of_plane(int x, int y) {
    return 0.4F * (static_cast<float>(x) + 0.5F) / kWidth +
           0.4F * (static_cast<float>(y) + 0.5F) / kHeight + 0.1F;
}

std::vector<float> drawn(const Square& square, const WindowFromView& window_from_view,
                         const std::vector<DepthBufferBox>& boxes = {{0, 0, kWidth, kHeight}}) {
    std::vector<float> texels(static_cast<std::size_t>(kWidth) * kHeight, 1.0F);
    std::vector<WindowVertex> in_window;
    for (const Eigen::Vector3f& vertex : square.vertices)
        in_window.push_back(window_vertex(window_from_view, vertex));
    for (const DepthBufferBox& box : boxes)
        draw_depth_triangles({square.vertices, square.indices, in_window, window_from_view}, 0,
                             square.indices.size(), 0.0F, 1.0F, box, {texels, kWidth});
    return texels;
}

/// Whether the square has the texel's centre: 1 or 0, or -1 where rounding decides.
int is_within(const Eigen::Matrix3f& window_from_square, int x, int y) {
    const Eigen::Vector3d on_square =
        window_from_square.cast<double>().inverse() * Eigen::Vector3d(x + 0.5, y + 0.5, 1);
    // Of the point whose W is 1: W has the sign of this.
    const double in_front = on_square.z();
    const double farthest = std::max(std::abs(on_square.x()), std::abs(on_square.y()));
    if (std::abs(in_front) < 1e-3) return -1;
    if (in_front < 0) return 0;
    const double beyond = farthest / in_front - 1;
    if (std::abs(beyond) < 1e-3) return -1;
    return beyond < 0 ? 1 : 0;
}

void expect_plane(const std::vector<float>& texels, const Eigen::Matrix3f& window_from_square) {
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const int within = is_within(window_from_square, x, y);
            const float texel = texels[static_cast<std::size_t>(y * kWidth + x)];
            if (within == 1) {
                ASSERT_NEAR(texel, depth_of_plane(x, y), 2e-4F) << x << ", " << y;
            } else if (within == 0) {
                ASSERT_EQ(texel, 1.0F) << x << ", " << y;
            }
        }
    }
}

/// Turned, of any size from a tenth of the window to forty times the window, anywhere around it.
Eigen::Matrix3f similarity(std::mt19937& random) {
    std::uniform_real_distribution<float> any(-1.0F, 1.0F);
    const float size = 20.0F * std::pow(10.0F, 1.0F + any(random));
    Eigen::Matrix3f window = Eigen::Matrix3f::Identity();
    window.topLeftCorner<2, 2>() = size * Eigen::Rotation2Df(3.2F * any(random)).toRotationMatrix();
    window(0, 2) = kWidth * (0.5F + any(random));
    window(1, 2) = kHeight * (0.5F + any(random));
    return window;
}

TEST(DepthTriangles, OfAPlaneLeaveNoGapsAndHaveItsDepth) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 60; ++trial) {
        const Eigen::Matrix3f window = similarity(random);
        expect_plane(drawn(uneven_square(random), plane_seen_by(window)), window);
    }
}

TEST(DepthTriangles, OfAPlaneThatReachesBehindTheEyeAreDrawnWhereTheyAreBeforeIt) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> any(-1.0F, 1.0F);
    for (int trial = 0; trial < 60; ++trial) {
        Eigen::Matrix3f window = similarity(random);
        window.row(2) << 1.5F * any(random), 1.5F * any(random), 1.0F;
        if (window.determinant() <= 0) continue;  // Seen from behind.
        expect_plane(drawn(uneven_square(random), plane_seen_by(window)), window);
    }
}

std::size_t count_drawn(const std::vector<float>& texels) {
    return texels.size() - static_cast<std::size_t>(std::count(texels.begin(), texels.end(), 1.0F));
}

TEST(DepthTriangles, SeenFromBehindAreNotDrawn) {
    std::mt19937 random(3);
    Square square = uneven_square(random);
    Eigen::Matrix3f window = similarity(random);
    window(0, 2) = 0.5F * kWidth;
    window(1, 2) = 0.5F * kHeight;
    EXPECT_GT(count_drawn(drawn(square, plane_seen_by(window))), 10U) << "seen from before";
    for (std::size_t i = 0; i < square.indices.size(); i += 3)
        std::swap(square.indices[i], square.indices[i + 1]);
    EXPECT_EQ(count_drawn(drawn(square, plane_seen_by(window))), 0U);
}

TEST(DepthTriangles, AreTheSameInOneBoxAndInSeveral) {
    std::mt19937 random(4);
    for (int trial = 0; trial < 20; ++trial) {
        const Square square = uneven_square(random);
        const WindowFromView matrix = plane_seen_by(similarity(random));
        const std::vector<float> whole = drawn(square, matrix);
        const std::vector<float> parts = drawn(square, matrix,
                                               {{0, 0, kWidth, 10},
                                                {0, 10, 30, kHeight},
                                                {30, 10, kWidth, 11},
                                                {30, 11, kWidth, kHeight}});
        for (std::size_t i = 0; i < whole.size(); ++i) ASSERT_NEAR(parts[i], whole[i], 1e-5F);
    }
}

/// Triangles whose corners lie nearly on a line, at any depth.
Square slivers(std::mt19937& random) {
    std::uniform_real_distribution<float> any(-1.0F, 1.0F);
    const auto anywhere = [&] {
        const float x = any(random);
        return Eigen::Vector2f(x, any(random));
    };
    Square made;
    for (std::uint32_t i = 0; i < 3000; i += 3) {
        const Eigen::Vector2f a = anywhere();
        const Eigen::Vector2f b = anywhere();
        for (const float share : {0.0F, 0.5F, 1.0F}) {
            const Eigen::Vector2f at = a + share * (b - a) + 1e-6F * anywhere();
            made.vertices.emplace_back(at.x(), at.y(), any(random));
        }
        made.indices.insert(made.indices.end(), {i, i + 1, i + 2});
    }
    return made;
}

TEST(DepthTriangles, AsThinAsTheyMayBeHaveNoDepthBeyondThatOfTheirCorners) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> any(-1.0F, 1.0F);
    std::size_t count = 0;
    for (int trial = 0; trial < 200; ++trial) {
        WindowFromView matrix = plane_seen_by(similarity(random));
        matrix(0, 2) = kWidth * (0.5F + 0.3F * any(random));
        matrix(1, 2) = kHeight * (0.5F + 0.3F * any(random));
        matrix.row(3) << 0.0F, 0.0F, 0.5F, 0.25F;  // Depth from 0.25 to 0.75.
        const std::vector<float> texels = drawn(slivers(random), matrix);
        count += count_drawn(texels);
        for (const float texel : texels)
            EXPECT_TRUE(texel == 1.0F || (texel > 0.2499F && texel < 0.7501F)) << texel;
    }
    EXPECT_GT(count, 100U);
}

}  // namespace
}  // namespace lumi
