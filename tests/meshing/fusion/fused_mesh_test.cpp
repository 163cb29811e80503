#include "meshing/fusion/fused_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "calib/work/error.h"
#include "meshing/geometry/mesh_depth.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

/// A slanted wall and a board before it, seen by five cameras, the depth of each wrong by waves of
/// its own of up to `error_px` of disparity to the next camera.
class WallAndBoard : public testing::Test {
 protected:
    static constexpr double kBaseline = 0.12;

    void see(double error_px) {
        const auto board = [](const Eigen::Vector3d& p) {
            return std::abs(p.x()) < 0.3 && std::abs(p.y()) < 0.2;
        };
        known_ = known_depth_scene(
            {{{0, 0, 3}, {0.4, 0, 1}, [](const auto&) { return true; }, noise_texture(0.1, 5)},
             {{0, 0, 1.8}, {0, 0, 1}, board, noise_texture(0.1, 8)}},
            cross_of_centres(kBaseline), {});
        const double pixel = 1 / (focal_length_px(small_camera()).x() * kBaseline);
        maps_.clear();
        for (const FloatImage& truth : known_.inverse_depths) {
            DepthMap map{truth, GrayImage(truth.width(), truth.height(), 255)};
            const auto phase = 2.4 * static_cast<double>(maps_.size());
            for (int y = 0; y < truth.height(); ++y) {
                for (int x = 0; x < truth.width(); ++x) {
                    const double wave = std::sin(x / 15.0 + phase) * std::cos(y / 11.0 + phase);
                    map.inverse_depth(x, y) += static_cast<float>(error_px * pixel * wave);
                }
            }
            maps_.push_back(std::move(map));
        }
    }
    [[nodiscard]] std::vector<PicturedView> views() const {
        std::vector<PicturedView> views;
        for (std::size_t i = 0; i < maps_.size(); ++i) {
            const DepthView& view = known_.scene.views[i];
            views.push_back({&view.photograph, view.camera, view.cam_from_world, &maps_[i]});
        }
        return views;
    }
    [[nodiscard]] FusedMesh fuse(int threads = 2) const {
        SilentProgress progress;
        return fused_mesh(views(), {}, threads, progress);
    }
    /// World units from the nearest of the two surfaces.
    [[nodiscard]] static double error_of(const Eigen::Vector3d& p) {
        const Eigen::Vector3d normal = Eigen::Vector3d(0.4, 0, 1).normalized();
        const double to_wall = std::abs(normal.dot(p - Eigen::Vector3d(0, 0, 3)));
        const bool is_before_board = std::abs(p.x()) < 0.31 && std::abs(p.y()) < 0.21;
        return is_before_board ? std::min(to_wall, std::abs(p.z() - 1.8)) : to_wall;
    }
    [[nodiscard]] static double share_within(const TriangleMesh& mesh, double distance) {
        const auto close = std::count_if(mesh.vertices.begin(), mesh.vertices.end(),
                                         [&](const auto& v) { return error_of(v) <= distance; });
        return static_cast<double>(close) / static_cast<double>(mesh.vertices.size());
    }
    /// Of all pixels: the mesh is there, within a pixel of disparity of the truth.
    [[nodiscard]] double matching_share(const TriangleMesh& mesh) const {
        std::size_t matching = 0;
        std::size_t all = 0;
        for (std::size_t i = 0; i < maps_.size(); ++i) {
            const DepthView& view = known_.scene.views[i];
            const DepthMap drawn = mesh_depth(view, mesh);
            const FloatImage errors = errors_px(drawn, known_.inverse_depths[i], view);
            for (std::size_t at = 0; at < errors.pixels().size(); ++at, ++all) {
                if (drawn.confidence.pixels()[at] != 0 && errors.pixels()[at] <= 1) ++matching;
            }
        }
        return static_cast<double>(matching) / static_cast<double>(all);
    }

    void move_cameras_by(const Eigen::Vector3d& shift_in_world) {
        for (DepthView& view : known_.scene.views) {
            Rigid3& pose = view.cam_from_world;
            pose.translation -= pose.rotation * shift_in_world;
        }
    }

    KnownDepthScene known_;
    std::vector<DepthMap> maps_;
};

TEST_F(WallAndBoard, ExactDepthBecomesAnExactMesh) {
    see(0.0);
    const FusedMesh fused = fuse();
    EXPECT_GT(fused.mesh.faces.size(), fused.mesh.vertices.size());
    EXPECT_GE(share_within(fused.mesh, 0.002), 0.99);
    EXPECT_GE(matching_share(fused.mesh), 0.92);
    ASSERT_EQ(fused.mesh.colors.size(), fused.mesh.vertices.size());
    for (const Eigen::Vector3f& normal : fused.mesh.normals) {
        ASSERT_NEAR(normal.norm(), 1.0F, 1e-4F);
        ASSERT_LT(normal.z(), 0.0F) << "towards the cameras";
    }
}

TEST_F(WallAndBoard, WhereViewsDifferTheMeshLiesBetweenThem) {
    see(0.3);
    const FusedMesh fused = fuse();
    // 0.15 px of disparity are 0.06 units of depth at the wall.
    EXPECT_GE(share_within(fused.mesh, 0.06), 0.95);
    EXPECT_GE(matching_share(fused.mesh), 0.9);
}

TEST_F(WallAndBoard, TheMeshIsTheSameFarFromTheOrigin) {
    see(0.3);
    const FusedMesh home = fuse();
    // As far as national grids put their places, in whole cells of any size.
    const Eigen::Vector3d shift_in_world(1 << 19, 5 << 20, 1 << 8);
    move_cameras_by(shift_in_world);
    FusedMesh far = fuse();
    const auto vertices = static_cast<double>(home.mesh.vertices.size());
    EXPECT_NEAR(static_cast<double>(far.mesh.vertices.size()), vertices, 1e-3 * vertices);
    EXPECT_GE(matching_share(far.mesh), 0.9);
    for (Eigen::Vector3d& vertex : far.mesh.vertices) vertex -= shift_in_world;
    EXPECT_NEAR(share_within(far.mesh, 0.02), share_within(home.mesh, 0.02), 1e-3);
}

TEST_F(WallAndBoard, TheSamePointsForAnyNumberOfThreads) {
    see(0.3);
    SilentProgress progress;
    const auto points_with = [&](int threads) {
        std::vector<double> numbers;
        for (const SurfacePoint& p : surface_points(views(), {}, threads, progress).points) {
            for (const float number : {p.normal.x(), p.normal.y(), p.normal.z(), p.spacing}) {
                numbers.push_back(static_cast<double>(number));
            }
            numbers.insert(numbers.end(), {p.position.x(), p.position.y(), p.position.z(),
                                           static_cast<double>(p.color.g)});
        }
        return numbers;
    };
    EXPECT_EQ(points_with(1), points_with(3));
}

TEST_F(WallAndBoard, PointsAreSpacedWiderRatherThanTooMany) {
    see(0.0);
    SilentProgress progress;
    const SurfacePoints points =
        surface_points(views(), {.spacing_px = 2.0, .max_points = 1000}, 2, progress);
    EXPECT_LE(points.points.size(), 1000U);
    EXPECT_GT(points.points.size(), 100U);
    EXPECT_GT(points.spacing_px, 2.0);
}

TEST_F(WallAndBoard, RefusesWhatViewsDoNotAgreeOn) {
    see(0.0);
    for (std::size_t i = 0; i < maps_.size(); ++i) {
        const auto scale = 1.0F + 0.3F * static_cast<float>(i);
        for (float& value : maps_[i].inverse_depth.pixels()) value *= scale;
    }
    try {
        (void)fuse();
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-FUSE-FEW") << error.what();
    }
    SilentProgress progress;
    EXPECT_THROW((void)fused_mesh(views(), {.spacing_px = 0.5}, 1, progress), Error);
    EXPECT_THROW((void)fused_mesh({}, {}, 1, progress), Error);
}

}  // namespace
}  // namespace lumi
