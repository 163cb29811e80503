#include "render/depth_mesh/depth_triangulation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/depth_mesh/halved_depth.h"
#include "render/depth_mesh/split_errors.h"
#include "render/depth_mesh/view_depth_mesh.h"
#include "render/lumigraph/coded_depth_mesh.h"
#include "render/reference/depth_raster.h"
#include "render/transfer/view_geometry.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr double kDisparity_px = 100;
const Camera kCamera = pinhole_camera(61, 47, 50);

template <class InverseDepth>
DepthMap depth_map(int width, int height, const InverseDepth& inverse_depth) {
    DepthMap depth{FloatImage(width, height), GrayImage(width, height, 255)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            depth.inverse_depth(x, y) = static_cast<float>(inverse_depth(x + 0.5, y + 0.5));
    return depth;
}

std::size_t triangle_count(const DepthMesh& mesh, DepthKind kind) {
    const auto index = static_cast<std::size_t>(kind);
    return (mesh.kind_begin[index + 1] - mesh.kind_begin[index]) / 3;
}

/// Sum of the areas in pixels of the triangles that are seen or filled, or else stretched; each
/// must turn the same way.
double covered_area(const DepthMesh& mesh, bool stretched) {
    double area = 0;
    const std::size_t begin = stretched ? mesh.kind_begin[2] : 0;
    const std::size_t end = stretched ? mesh.kind_begin[3] : mesh.kind_begin[2];
    for (std::size_t i = begin; i < end; i += 3) {
        const Eigen::Vector3f& a = mesh.vertices[mesh.indices[i]];
        const Eigen::Vector3f& b = mesh.vertices[mesh.indices[i + 1]];
        const Eigen::Vector3f& c = mesh.vertices[mesh.indices[i + 2]];
        const Eigen::Vector2f ab = (b - a).head<2>();
        const Eigen::Vector2f ac = (c - a).head<2>();
        const float doubled = ab.x() * ac.y() - ab.y() * ac.x();
        EXPECT_LT(doubled, 0);
        area -= 0.5 * static_cast<double>(doubled);
    }
    return area;
}

/// The mesh's depth at the samples of a map of the photograph's size, seen from the view itself.
Image<EyeDepth> at_samples(const DepthMesh& mesh) {
    LumigraphView view;
    view.camera = kCamera;
    return rasterise(mesh, view, {kCamera, {}});
}

TEST(DepthMesh, APlaneNeedsFewTrianglesAndIsExact) {
    const auto plane = [](double x, double y) { return 0.2 + 0.003 * x - 0.001 * y; };
    const DepthMesh mesh = triangulate(depth_map(61, 47, plane), kCamera, kDisparity_px);
    EXPECT_LT(mesh.indices.size() / 3, 100U);  // The outermost samples lie half a pitch inside.
    const Image<EyeDepth> drawn = at_samples(mesh);
    for (int y = 0; y < 47; ++y) {
        for (int x = 0; x < 61; ++x) {
            ASSERT_TRUE(drawn(x, y).is_known()) << x << ' ' << y;
            EXPECT_EQ(drawn(x, y).kind, DepthKind::kSeen);
            EXPECT_NEAR(drawn(x, y).inverse_depth, plane(x + 0.5, y + 0.5), 1e-6);
        }
    }
}

TEST(DepthMesh, CoversThePhotographWhateverTheSizeOfTheDepthMap) {
    for (const auto& [width, height] : {std::pair{61, 47}, {30, 24}, {7, 5}, {1, 1}, {2, 64}}) {
        const DepthMap depth = depth_map(width, height, [&](double x, double y) {
            return 0.3 + 0.1 * std::sin(x / width) + (x + y > 0.8 * width ? 0.4 : 0.0);
        });
        for (const double decimated_share : {0.0, 0.5}) {
            const DepthMesh mesh =
                triangulate(depth, kCamera, kDisparity_px, {.decimated_share = decimated_share});
            // What is stretched lies under the ends of the surfaces on both of its sides, which
            // overlap no more than vertices were left out of each on its own.
            EXPECT_LE(covered_area(mesh, false), 61 * 47 * (1 + 0.01 * decimated_share) + 0.01)
                << width << 'x' << height << ' ' << decimated_share;
            EXPECT_GE(covered_area(mesh, false) + covered_area(mesh, true), 61 * 47 - 0.01)
                << width << 'x' << height << ' ' << decimated_share;
        }
    }
}

TEST(DepthMesh, OfALongStripIsMadeInARowOfSquaresAndNotInOneOfItsLength) {
    for (const auto& [width, height] : {std::pair{1500, 3}, {3, 1500}}) {
        const bool is_wide = width > height;
        // Two planes, one behind the other from the 700th sample on.
        const auto planes = [&](double x, double y) {
            const double along = is_wide ? x : y;
            return 0.3 + 0.0001 * along - (along > 700 ? 0.1 : 0.0);
        };
        const DepthMap depth = depth_map(width, height, planes);
        const Camera camera = pinhole_camera(width, height, 600);
        const DepthLattice lattice(depth, camera, kDisparity_px);
        const SplitErrors errors(lattice, 8.0);
        EXPECT_LE(errors.side(), 32) << "not 2048";
        EXPECT_GE(errors.squares_in_row() * errors.side(), width + 1);
        EXPECT_GE(errors.squares_in_column() * errors.side(), height + 1);

        const DepthMesh mesh = triangulate(depth, camera, kDisparity_px, {.decimated_share = 0});
        LumigraphView view;
        view.camera = camera;
        const Image<EyeDepth> drawn = rasterise(mesh, view, {camera, {}});
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                EXPECT_EQ(drawn(x, y).kind, DepthKind::kSeen) << x << ' ' << y;
                EXPECT_NEAR(drawn(x, y).inverse_depth, planes(x + 0.5, y + 0.5),
                            0.1 / kDisparity_px)
                    << x << ' ' << y;
            }
        }
    }
}

TEST(DepthMesh, EndsASurfaceHalfwayToTheFirstSampleBeyond) {
    const DepthMap depth =
        depth_map(61, 47, [](double x, double y) { return x > 20 && y > 11 ? 0.8 : 0.2; });
    LumigraphView view;
    view.camera = kCamera;
    const Image<EyeDepth> drawn =
        rasterise(triangulate(depth, kCamera, kDisparity_px, {.decimated_share = 0}), view,
                  {resized(kCamera, 2 * 61, 2 * 47), {}});
    for (int y = 0; y < 94; ++y) {
        for (int x = 0; x < 122; ++x) {
            if (std::abs(x - 40) < 3 && std::abs(y - 22) < 3) continue;  // The corner is cut.
            EXPECT_EQ(drawn(x, y).kind, DepthKind::kSeen) << x << ' ' << y;
            EXPECT_NEAR(drawn(x, y).inverse_depth, depth.inverse_depth(x / 2, y / 2), 1e-6)
                << x << ' ' << y;
        }
    }
}

TEST(DepthMesh, StaysWithinItsErrorOnACurvedSurface) {
    const auto surface = [](double x, double y) {
        return 0.3 + 0.05 * std::sin(0.2 * x) * std::cos(0.15 * y);
    };
    for (const double error_px : {0.05, 0.2, 0.5}) {
        const DepthMesh mesh =
            triangulate(depth_map(61, 47, surface), kCamera, kDisparity_px,
                        {.max_error_px = error_px, .max_triangles = 100'000, .decimated_share = 0});
        const Image<EyeDepth> drawn = at_samples(mesh);
        double worst_px = 0;
        for (int y = 0; y < 47; ++y)
            for (int x = 0; x < 61; ++x)
                worst_px = std::max(worst_px, kDisparity_px * std::abs(drawn(x, y).inverse_depth -
                                                                       surface(x + 0.5, y + 0.5)));
        // Errors of nested triangles add up, at most as a geometric series.
        EXPECT_LT(worst_px, 2 * error_px);
        EXPECT_LT(mesh.indices.size() / 3, error_px < 0.1 ? 5700U : 2500U);
    }
}

TEST(DepthMesh, TearsBetweenForegroundAndBackgroundAndOnlyThere) {
    const DepthMap depth =
        depth_map(61, 47, [](double x, double y) { return x > 20 && y > 11 ? 0.8 : 0.2; });
    const DepthMesh mesh = triangulate(depth, kCamera, kDisparity_px, {.decimated_share = 0});
    // Two triangles for each lattice cell that the outline passes through: 41 + 36 of them, and
    // one at the corner where they meet that is counted once.
    EXPECT_EQ(triangle_count(mesh, DepthKind::kStretched), 2U * (41 + 36) + 1);
    for (std::size_t i = 0; i < mesh.kind_begin[1]; i += 3) {
        const float a = mesh.vertices[mesh.indices[i]].z();
        EXPECT_FLOAT_EQ(mesh.vertices[mesh.indices[i + 1]].z(), a);
        EXPECT_FLOAT_EQ(mesh.vertices[mesh.indices[i + 2]].z(), a);
    }
}

TEST(DepthMesh, StretchesNothingToInfinity) {
    const DepthMap depth =
        depth_map(61, 47, [](double x, double y) { return x > 20 && y > 11 ? 0.8 : 0.0; });
    const DepthMesh mesh = triangulate(depth, kCamera, kDisparity_px, {.decimated_share = 0});
    EXPECT_EQ(triangle_count(mesh, DepthKind::kStretched), 0U);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const float a = mesh.vertices[mesh.indices[i]].z();
        EXPECT_FLOAT_EQ(mesh.vertices[mesh.indices[i + 1]].z(), a);
        EXPECT_FLOAT_EQ(mesh.vertices[mesh.indices[i + 2]].z(), a);
    }
}

TEST(DepthMesh, DoesNotTearASteepPlaneOrACrease) {
    const DepthMap steep = depth_map(61, 47, [](double x, double) { return 0.1 + 0.013 * x; });
    const DepthMap crease =
        depth_map(61, 47, [](double x, double) { return 0.1 + 0.009 * std::abs(x - 30.2); });
    for (const DepthMap& depth : {steep, crease})
        EXPECT_EQ(triangle_count(triangulate(depth, kCamera, kDisparity_px), DepthKind::kStretched),
                  0U);
}

TEST(DepthMesh, KeepsFilledSamplesApart) {
    DepthMap depth = depth_map(61, 47, [](double, double) { return 0.2; });
    for (int y = 10; y < 20; ++y)
        for (int x = 30; x < 40; ++x) depth.confidence(x, y) = 0;
    const Image<EyeDepth> drawn =
        at_samples(triangulate(depth, kCamera, kDisparity_px, {.decimated_share = 0}));
    for (int y = 0; y < 47; ++y) {
        for (int x = 0; x < 61; ++x) {
            if (depth.confidence(x, y) == 0)
                EXPECT_EQ(drawn(x, y).kind, DepthKind::kFilled) << x << ' ' << y;
            else
                EXPECT_EQ(drawn(x, y).kind, DepthKind::kSeen) << x << ' ' << y;
        }
    }
}

TEST(DepthMesh, FollowsWhatIsFilledLessCloselyThanWhatIsSeen) {
    DepthMap depth = depth_map(61, 47, [](double x, double y) {
        return 0.3 + 0.02 * std::sin(0.4 * x) * std::cos(0.5 * y);
    });
    for (int y = 0; y < 47; ++y)
        for (int x = 30; x < 61; ++x) depth.confidence(x, y) = 0;
    const DepthMeshOptions alike{.max_triangles = 100'000, .guess_error_ratio = 1.0};
    DepthMeshOptions less = alike;
    less.guess_error_ratio = 4.0;
    const DepthMesh close = triangulate(depth, kCamera, kDisparity_px, alike);
    const DepthMesh mesh = triangulate(depth, kCamera, kDisparity_px, less);
    EXPECT_LT(2 * triangle_count(mesh, DepthKind::kFilled),
              triangle_count(close, DepthKind::kFilled));
    EXPECT_LE(triangle_count(mesh, DepthKind::kSeen), triangle_count(close, DepthKind::kSeen));
    EXPECT_DOUBLE_EQ(mesh.error_px, close.error_px);
    const Image<EyeDepth> drawn = at_samples(mesh);
    for (int y = 0; y < 47; ++y) {
        for (int x = 0; x < 61; ++x) {
            const bool is_filled = drawn(x, y).kind == DepthKind::kFilled;
            const double error_px =
                kDisparity_px * std::abs(drawn(x, y).inverse_depth -
                                         static_cast<double>(depth.inverse_depth(x, y)));
            EXPECT_LE(error_px, (is_filled ? 4.0 : 1.0) * mesh.error_px + 1e-3) << x << ' ' << y;
        }
    }
}

TEST(DepthMesh, TradesErrorForTrianglesWhenThereAreTooMany) {
    const DepthMap noisy = depth_map(61, 47, [](double x, double y) {
        return 0.3 + 0.002 * std::sin(12.9898 * x + 78.233 * y);
    });
    const auto size_with = [&](const DepthMeshOptions& options) {
        return triangulate(noisy, kCamera, kDisparity_px, options).indices.size();
    };
    const std::size_t fine = size_with({.decimated_share = 0});
    const std::size_t coarse = size_with({.max_triangles = 1000, .decimated_share = 0});
    EXPECT_GT(fine, 3 * 4000U);
    EXPECT_LT(coarse, 3 * 1000U);
}

TEST(DepthMesh, DrawsNoisyPairsOfRowsAndColumnsAsOneAndKeepsTheEdge) {
    const auto noise = [](double x, double y) { return std::sin(12.9898 * x + 78.233 * y); };
    const auto noisy = [&](double x, double y) {
        return (x > 30 ? 0.8 : 0.2) + 0.01 * noise(std::floor(x), std::floor(y));
    };
    const DepthMap depth = depth_map(61, 47, noisy);
    const DepthMesh mesh = triangulate(depth, kCamera, kDisparity_px, {.max_triangles = 100});
    EXPECT_LT(mesh.indices.size() / 3, 61U * 47U / 2);
    const Image<EyeDepth> drawn = at_samples(mesh);
    for (int y = 0; y < 47; ++y) {
        for (int x = 0; x < 61; ++x) {
            if (std::abs(x - 30) < 3) continue;
            EXPECT_EQ(drawn(x, y).kind, DepthKind::kSeen);
            EXPECT_NEAR(drawn(x, y).inverse_depth, x > 30 ? 0.8 : 0.2, 0.02) << x << ' ' << y;
        }
    }
}

TEST(DepthMesh, LeavesVerticesOutWithinItsError) {
    const auto surface = [](double x, double y) {
        return 0.3 + 0.05 * std::sin(0.2 * x) * std::cos(0.15 * y);
    };
    constexpr double kError_px = 0.2;
    const auto mesh_with = [&](double share) {
        return triangulate(
            depth_map(61, 47, surface), kCamera, kDisparity_px,
            {.max_error_px = kError_px, .max_triangles = 100'000, .decimated_share = share});
    };
    const DepthMesh all = mesh_with(0);
    const DepthMesh fewer = mesh_with(0.5);
    EXPECT_LT(fewer.indices.size(), 9 * all.indices.size() / 10);
    EXPECT_NEAR(covered_area(fewer, false), 61 * 47, 0.01);
    const Image<EyeDepth> before = at_samples(all);
    const Image<EyeDepth> after = at_samples(fewer);
    double sum_px = 0;
    for (int y = 0; y < 47; ++y) {
        for (int x = 0; x < 61; ++x) {
            const double moved_px =
                kDisparity_px * std::abs(after(x, y).inverse_depth - before(x, y).inverse_depth);
            // Vertices that are gone keep to half the error, what was between them to the whole.
            EXPECT_LT(moved_px, kError_px) << x << ' ' << y;
            sum_px += moved_px;
        }
    }
    EXPECT_LT(sum_px / (61 * 47), 0.5 * kError_px);
}

TEST(DepthMesh, DrawsASlantedSilhouetteWithFewTriangles) {
    const auto edge_at = [](double y) { return 20 + 0.37 * y; };
    const DepthMap depth =
        depth_map(61, 47, [&](double x, double y) { return x > edge_at(y) ? 0.8 : 0.2; });
    const DepthMesh mesh = triangulate(depth, kCamera, kDisparity_px);
    EXPECT_LT(mesh.indices.size() / 3, 250U);
    EXPECT_GT(triangulate(depth, kCamera, kDisparity_px, {.decimated_share = 0}).indices.size() / 3,
              600U);
    LumigraphView view;
    view.camera = kCamera;
    const Image<EyeDepth> drawn = rasterise(mesh, view, {resized(kCamera, 122, 94), {}});
    for (int y = 0; y < 94; ++y) {
        for (int x = 0; x < 122; ++x) {
            // Half a sample as ever, and half a sample more.
            if (std::abs(0.5 * (x + 0.5) - edge_at(0.5 * (y + 0.5))) < 1.1) continue;
            EXPECT_EQ(drawn(x, y).kind, DepthKind::kSeen) << x << ' ' << y;
            EXPECT_NEAR(drawn(x, y).inverse_depth, depth.inverse_depth(x / 2, y / 2), 1e-5)
                << x << ' ' << y;
        }
    }
}

TEST(DepthMesh, MovesEndsOfWhatIsFilledByAsMuchMoreAndNotThoseOfWhatIsSeen) {
    constexpr double kTeeth_px = 2;
    const auto ragged = [&](double x, double y) {
        const bool is_tooth = static_cast<int>(y / 3) % 2 == 1;
        return x < 30 + (is_tooth ? kTeeth_px : 0.0) ? 0.4 : 0.2;
    };
    DepthMap depth = depth_map(61, 47, ragged);
    const DepthMeshOptions alike{.max_triangles = 100'000, .guess_error_ratio = 1.0};
    DepthMeshOptions less = alike;
    less.guess_error_ratio = 8.0;
    const auto triangles = [&](const DepthMeshOptions& options, DepthKind kind) {
        return triangle_count(triangulate(depth, kCamera, kDisparity_px, options), kind);
    };
    EXPECT_EQ(triangles(less, DepthKind::kSeen), triangles(alike, DepthKind::kSeen));
    depth.confidence = GrayImage(61, 47, 0);
    EXPECT_LT(triangles(less, DepthKind::kFilled), triangles(alike, DepthKind::kFilled));
    const Image<EyeDepth> drawn = at_samples(triangulate(depth, kCamera, kDisparity_px, less));
    const double moved_px = 8 * 0.5 + 1;  // Of a sample; ends lie between two of them.
    for (int y = 0; y < 47; ++y) {
        for (int x = 0; x < 61; ++x) {
            if (x > 30 - moved_px && x < 30 + kTeeth_px + moved_px) continue;
            EXPECT_NEAR(drawn(x, y).inverse_depth, depth.inverse_depth(x, y), 1e-6)
                << x << ' ' << y;
        }
    }
}

TEST(DepthMesh, TakesSpecksOfFilledSamplesForSeen) {
    DepthMap depth = depth_map(61, 47, [](double, double) { return 0.2; });
    for (int y = 10; y < 14; ++y)
        for (int x = 30; x < 34; ++x) depth.confidence(x, y) = 0;
    EXPECT_EQ(triangle_count(triangulate(depth, kCamera, kDisparity_px), DepthKind::kFilled), 0U);
    depth.confidence(34, 13) = 0;
    EXPECT_GT(triangle_count(triangulate(depth, kCamera, kDisparity_px), DepthKind::kFilled), 0U);
}

TEST(HalvedDepth, AveragesTheMoreNumerousSurfaceOfEachFourSamples) {
    DepthMap depth{FloatImage(4, 2, 0.2F), GrayImage(4, 2, 255)};
    depth.inverse_depth(0, 0) = 0.3F;
    depth.inverse_depth(3, 0) = 0.8F;
    depth.inverse_depth(3, 1) = 0.9F;
    depth.inverse_depth(2, 1) = 0.8F;
    const DepthMap half = halved(depth, 0.15);
    ASSERT_EQ(half.inverse_depth.width(), 2);
    ASSERT_EQ(half.inverse_depth.height(), 1);
    EXPECT_FLOAT_EQ(half.inverse_depth(0, 0), 0.225F);
    EXPECT_FLOAT_EQ(half.inverse_depth(1, 0), 2.5F / 3);
}

TEST(HalvedDepth, PrefersSeenSamplesAndKeepsTheFieldOfViewOfAnOddCount) {
    DepthMap depth = depth_map(7, 5, [](double x, double) { return 0.1 * x; });
    const DepthMap half = halved(depth, 1.0);
    ASSERT_EQ(half.inverse_depth.width(), 4);
    ASSERT_EQ(half.inverse_depth.height(), 3);
    for (int x = 0; x < 4; ++x)  // Within half a sample of the middle of its share of the picture.
        EXPECT_NEAR(half.inverse_depth(x, 1), 0.1 * (x + 0.5) * 7 / 4, 0.05);
    depth.confidence(0, 0) = 0;
    depth.inverse_depth(0, 0) = 5.0F;
    EXPECT_LT(halved(depth, 1.0).inverse_depth(0, 0), 0.2F);
    for (const int x : {0, 1}) depth.confidence(x, 1) = 0;
    EXPECT_EQ(halved(depth, 1.0).confidence(0, 0), 0);
}

TEST(DepthMesh, IsEmptyWithoutDepth) {
    EXPECT_TRUE(triangulate({}, kCamera, kDisparity_px).indices.empty());
}

TEST(CodedDepthMesh, RoundsPlacesOnlyAtThePhotographsBorderAndDepthToA128thOfAPixel) {
    // 30 samples over 61 pixels: places are not whole, and the network reaches beyond the border.
    const DepthMap depth = depth_map(30, 24, [](double x, double y) {
        return 0.3 + 0.05 * std::sin(0.4 * x) * std::cos(0.3 * y) + (x + y > 24 ? 0.3 : 0.0);
    });
    const DepthMesh mesh = triangulate(depth, kCamera, kDisparity_px);
    const CodedDepthMesh coded = encode(mesh, kCamera);
    const DepthMesh decoded = decode(coded, kCamera, "mesh");
    EXPECT_EQ(encode(decoded, kCamera).bytes, coded.bytes);
    EXPECT_LT(coded.bytes.size(), 8 * mesh.indices.size() / 3);
    EXPECT_EQ(decoded.kind_begin, mesh.kind_begin);
    ASSERT_EQ(decoded.indices.size(), mesh.indices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const Eigen::Vector3f& was = mesh.vertices[mesh.indices[i]];
        const Eigen::Vector3f& is = decoded.vertices[decoded.indices[i]];
        EXPECT_LE(std::abs(static_cast<double>(was.z() - is.z())) * kDisparity_px,
                  1.0 / 128 + 1e-4);
        const bool at_border = was.x() > 60 || was.y() > 46;
        EXPECT_LE((was - is).head<2>().cwiseAbs().maxCoeff(), at_border ? 61.0F / 240 : 1e-5F);
    }
}

TEST(ViewDepthMesh, IsTheOneThatCameWithTheViewIfItIsAsItIsWanted) {
    Lumigraph lumigraph = card_before_wall();
    SilentProgress progress;
    make_depth_meshes(lumigraph, 1, progress);
    const LumigraphView& view = lumigraph.views[0];
    const double disparity_px = max_disparity_px(view_geometries(lumigraph)[0]);
    ASSERT_TRUE(view.depth_mesh);
    EXPECT_EQ(depth_mesh_of(view, disparity_px, {}), view.depth_mesh);
    EXPECT_EQ(depth_mesh_of(view, 1.4 * disparity_px, {}), view.depth_mesh);
    EXPECT_EQ(depth_mesh_of(view, disparity_px / 1.4, {}), view.depth_mesh);
    const auto coarser = depth_mesh_of(view, disparity_px, {.max_error_px = 0.4});
    EXPECT_EQ(coarser->wanted_error_px, 0.4);
    EXPECT_EQ(depth_mesh_of(view, 2 * disparity_px, {})->disparity_px, 2 * disparity_px);
    LumigraphView without = view;
    without.depth_mesh = nullptr;
    const auto made = depth_mesh_of(without, disparity_px, {});
    EXPECT_EQ(made->indices, view.depth_mesh->indices);
    EXPECT_EQ(made->vertices, view.depth_mesh->vertices);
    without.depth = {};
    EXPECT_TRUE(depth_mesh_of(without, disparity_px, {})->indices.empty());
}

LumigraphView noisy_view() {
    LumigraphView noisy;
    noisy.camera = pinhole_camera(128, 96, 128);
    noisy.depth = depth_map(128, 96, [](double x, double y) {
        return 0.3 + 0.02 * std::sin(12.9898 * std::floor(x) + 78.233 * std::floor(y));
    });
    return noisy;
}

TEST(ViewDepthMesh, IsMadeAnewWhereItIsCoarserThanWanted) {
    LumigraphView view = noisy_view();
    view.depth_mesh =
        depth_mesh_of(view, kDisparity_px, {.max_triangles = 100, .max_noisy_error_px = 1.6});
    ASSERT_TRUE(is_of_noise(*view.depth_mesh, view.depth));
    for (const double error_px : {0.4, 0.1}) {
        const DepthMeshOptions closer{.max_triangles = 100, .max_noisy_error_px = error_px};
        const auto finer = depth_mesh_of(view, kDisparity_px, closer);
        EXPECT_GT(finer->indices.size(), view.depth_mesh->indices.size());
        EXPECT_LE(finer->error_px, 2 * error_px + 1e-6);
        view.depth_mesh = finer;
        EXPECT_EQ(depth_mesh_of(view, kDisparity_px, closer), finer);
    }
}

TEST(ViewDepthMesh, IsKeptWhereItIsFinerThanWanted) {
    LumigraphView view = noisy_view();
    view.depth_mesh =
        depth_mesh_of(view, kDisparity_px, {.max_triangles = 100, .max_noisy_error_px = 0.4});
    EXPECT_EQ(depth_mesh_of(view, kDisparity_px, {.max_triangles = 100, .max_noisy_error_px = 1.6}),
              view.depth_mesh);
}

TEST(ViewDepthMesh, FollowsNoiseAsCloselyAsItsLumigraphSays) {
    Lumigraph lumigraph = card_before_wall();
    EXPECT_EQ(depth_mesh_options(lumigraph).max_noisy_error_px, kNoisyDepthError_px);
    lumigraph.noisy_depth_error_px = 0.3;
    EXPECT_EQ(depth_mesh_options(lumigraph).max_noisy_error_px, 0.3);
    EXPECT_EQ(depth_mesh_options(without_its_views(lumigraph)).max_noisy_error_px, 0.3);
}

TEST(ViewDepthMesh, IsTheSameForAnyNumberOfThreads) {
    Lumigraph alone = card_before_wall();
    Lumigraph together = alone;
    SilentProgress progress;
    make_depth_meshes(alone, 1, progress);
    make_depth_meshes(together, 3, progress);
    for (std::size_t i = 0; i < alone.views.size(); ++i) {
        EXPECT_EQ(alone.views[i].depth_mesh->indices, together.views[i].depth_mesh->indices);
        EXPECT_EQ(alone.views[i].depth_mesh->vertices, together.views[i].depth_mesh->vertices);
        EXPECT_GT(alone.views[i].depth_mesh->error_px, 0);
    }
}

}  // namespace
}  // namespace lumi
