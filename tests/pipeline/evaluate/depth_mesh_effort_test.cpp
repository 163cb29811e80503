#include "pipeline/evaluate/depth_mesh_effort.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numeric>

#include "pipeline/stages/chosen_views.h"
#include "pipeline/synth/hand_held_path.h"
#include "render/depth_mesh/view_depth_mesh.h"

namespace lumi {
namespace {

constexpr int kWidth_px = 240;
constexpr int kHeight_px = 180;
constexpr double kFocal_px = 240;
constexpr double kDistance = 2.6;
constexpr double kCell = 0.05;  ///< Four to five pixels.

/// A number from 0 to 1 for a pair of integers.
double hashed(int a, int b) {
    std::uint64_t state = static_cast<std::uint32_t>(a) * 0x9e3779b97f4a7c15ULL ^
                          (static_cast<std::uint32_t>(b) + 0x7f4a7c15ULL) * 0xbf58476d1ce4e5b9ULL;
    state = (state ^ (state >> 30U)) * 0x94d049bb133111ebULL;
    return static_cast<double>((state ^ (state >> 31U)) >> 40U) / static_cast<double>(1U << 24U);
}

int cell_of(double place, double size) { return static_cast<int>(std::floor(place / size)); }

/// Blocks of one width side by side, each of another height and painted in a chequer of greys.
struct Relief {
    double highest = 0.0;

    [[nodiscard]] double height_at(const Eigen::Vector3d& p) const {
        return highest * hashed(cell_of(p.x(), kCell), cell_of(p.y(), kCell));
    }

    /// Where a ray from above meets it.
    [[nodiscard]] Eigen::Vector3d hit_by(const Eigen::Vector3d& from,
                                         const Eigen::Vector3d& direction) const {
        constexpr double kStep = 0.008;
        double t = (highest - from.z()) / direction.z();
        while (from.z() + t * direction.z() > height_at(from + t * direction)) t += kStep;
        return from + t * direction;
    }

    [[nodiscard]] static double brightness_at(const Eigen::Vector3d& p) {
        return 40 + 180 * hashed(cell_of(p.x(), kCell / 2) + 7, cell_of(p.y(), kCell / 2) - 3);
    }
};

LumigraphView photograph_of(const Relief& relief, const Eigen::Vector3d& place, int index) {
    LumigraphView view;
    view.name = "view" + std::to_string(100 + index);
    view.camera = pinhole_camera(kWidth_px, kHeight_px, kFocal_px);
    view.cam_from_world = looking_at(place, Eigen::Vector3d(place.x(), place.y() + 1e-6, 0));
    view.photograph = ColorImage(kWidth_px, kHeight_px);
    view.depth = {FloatImage(kWidth_px, kHeight_px), GrayImage(kWidth_px, kHeight_px, 255)};
    const auto hit = [&](double x, double y) {
        return relief.hit_by(place, view.cam_from_world.rotation.conjugate() *
                                        unproject(view.camera, Eigen::Vector2d(x, y)));
    };
    for (int y = 0; y < kHeight_px; ++y) {
        for (int x = 0; x < kWidth_px; ++x) {
            double sum = 0;
            for (const double dy : {0.25, 0.75})
                for (const double dx : {0.25, 0.75})
                    sum += Relief::brightness_at(hit(x + dx, y + dy));
            const auto grey = static_cast<std::uint8_t>(std::lround(sum / 4));
            view.photograph(x, y) = {grey, grey, grey};
            view.depth.inverse_depth(x, y) =
                static_cast<float>(1 / (view.cam_from_world * hit(x + 0.5, y + 0.5)).z());
        }
    }
    return view;
}

struct RoughCapture {
    Lumigraph lumigraph;
    Capture capture;
};

RoughCapture photographed(const Relief& relief, int count = 18) {
    RoughCapture result;
    Lumigraph& lumigraph = result.lumigraph;
    result.capture.cameras.push_back(pinhole_camera(kWidth_px, kHeight_px, kFocal_px));
    for (int i = 0; i < count; ++i) {
        const double radius = 0.7 * std::sqrt((i + 0.5) / count);
        const Eigen::Vector3d place(radius * std::cos(2.4 * i), radius * std::sin(2.4 * i),
                                    kDistance);
        lumigraph.views.push_back(photograph_of(relief, place, i));
        const LumigraphView& view = lumigraph.views.back();
        result.capture.views.push_back({view.name, 0, view.cam_from_world});
    }
    for (int i = 0; i < 100; ++i) {
        ScenePoint point;
        point.position_in_world = {2 * hashed(i, 1) - 1, 2 * hashed(i, 2) - 1, 0};
        result.capture.points.push_back(point);
    }
    lumigraph.near_depth = kDistance - relief.highest - 0.1;
    lumigraph.far_depth = kDistance + 0.1;
    std::vector<int> all(static_cast<std::size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    lumigraph = lumigraph_of_views(lumigraph, result.capture, all, {});
    return result;
}

DepthMeshEffort effort_of(RoughCapture& rough) {
    SilentProgress progress;
    make_depth_meshes(rough.lumigraph, 0, progress);
    return sufficient_depth_mesh_effort(rough.lumigraph, rough.capture, {}, 0.0, progress);
}

TEST(DepthMeshEffort, FollowsASurfaceThatIsAsRoughAsNoise) {
    RoughCapture rough = photographed({0.5});
    const DepthMeshEffort effort = effort_of(rough);
    EXPECT_EQ(effort.pictures, 9);
    EXPECT_GT(effort.coarsest_lose_db, 0.2);
    EXPECT_LT(effort.noisy_error_px, kNoisyDepthError_px);
    EXPECT_LE(effort.loses_db, 0.1);
}

TEST(DepthMeshEffort, AsksNobodyForFewerThanEightViews) {
    RoughCapture rough = photographed({0.5}, 7);
    const DepthMeshEffort effort = effort_of(rough);
    EXPECT_EQ(effort.pictures, 0);
    EXPECT_EQ(effort.noisy_error_px, kNoisyDepthError_px);
}

TEST(DepthMeshEffort, DoesNotFollowNoise) {
    RoughCapture flat = photographed({0.0});
    for (LumigraphView& view : flat.lumigraph.views)
        for (int y = 0; y < kHeight_px; ++y)
            for (int x = 0; x < kWidth_px; ++x)
                view.depth.inverse_depth(x, y) +=
                    static_cast<float>(0.03 * (hashed(x, 1000 + y) - 0.5));
    const DepthMeshEffort effort = effort_of(flat);
    EXPECT_EQ(effort.pictures, 9);
    EXPECT_EQ(effort.noisy_error_px, kNoisyDepthError_px);
    EXPECT_LE(effort.coarsest_lose_db, 0.1);
}

TEST(DepthMeshEffort, AsksNobodyWhereDepthIsWithoutNoise) {
    RoughCapture flat = photographed({0.0});
    const DepthMeshEffort effort = effort_of(flat);
    EXPECT_EQ(effort.pictures, 0);
    EXPECT_EQ(effort.noisy_error_px, kNoisyDepthError_px);
}

}  // namespace
}  // namespace lumi
