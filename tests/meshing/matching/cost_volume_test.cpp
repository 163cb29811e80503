#include "meshing/matching/cost_volume.h"

#include <gtest/gtest.h>

#include "calib/capture/gray.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

SweepView sweep_view(const DepthView& view) {
    return {view.camera, view.cam_from_world, gray_of(view.photograph)};
}

std::vector<TilePlanes> same_for_all(const TilePlanes& planes) {
    const Camera camera = small_camera();
    return std::vector<TilePlanes>(
        static_cast<std::size_t>(tiles_along(camera.width_px) * tiles_along(camera.height_px)),
        planes);
}

/// Share of the pixels away from the border whose cheapest plane is `plane`.
double share_cheapest_at(const CostVolume& volume, int plane) {
    int right = 0;
    int all = 0;
    for (int y = 40; y < volume.height() - 40; ++y) {
        for (int x = 40; x < volume.width() - 40; ++x) {
            const std::uint8_t* cost = volume.costs().data() + volume.offset(x, y);
            const int count = volume.tile(x, y).count;
            ++all;
            if (cost[plane] == *std::min_element(cost, cost + count)) ++right;
        }
    }
    return static_cast<double>(right) / all;
}

TEST(CostVolume, TheTruePlaneOfAFrontalWallCostsLeast) {
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0, 2}, {0, 0, 1}, [](const auto&) { return true; }, noise_texture(0.03, 5)}},
        cross_of_centres(0.1), {});
    const auto& views = known.scene.views;
    // Steps of one pixel of disparity; the wall at inverse depth 0.5 is plane 6.
    const double step = 1.0 / (220.0 * 0.1);
    const SweepPlanes planes{0.5 - 6 * step, step, 16};
    const CostVolume volume =
        sweep_costs(sweep_view(views[0]), {sweep_view(views[1]), sweep_view(views[4])}, planes,
                    same_for_all({0, 16}));
    EXPECT_GT(share_cheapest_at(volume, 6), 0.99);
}

TEST(CostVolume, SlopingPlanesFitAFloor) {
    // Inverse depth of the plane y = 0.5 at pixel row v (from the centre) is v / (0.5 * 220).
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0.5, 0}, {0, 1, 0}, [](const auto&) { return true; }, noise_texture(0.03, 5)},
         {{0, -0.5, 0}, {0, 1, 0}, [](const auto&) { return true; }, noise_texture(0.03, 9)}},
        cross_of_centres(0.05), {});
    const auto& views = known.scene.views;
    const double step = 0.5 / (220.0 * 0.05);
    const double slope = 1.0 / (0.5 * 220.0);
    // The tile of rows 144 to 159 has its centre 62 rows below the horizon: plane 8 there.
    const SweepPlanes planes{62 * slope - 8 * step, step, 16};
    const std::vector<SweepView> others{sweep_view(views[1]), sweep_view(views[2])};
    const CostVolume sloping =
        sweep_costs(sweep_view(views[0]), others, planes, same_for_all({0, 16, {0, slope / step}}));
    for (int y = 144; y < 160; ++y) {
        int right = 0;
        for (int x = 40; x < 200; ++x) {
            const std::uint8_t* cost = sloping.costs().data() + sloping.offset(x, y);
            if (cost[8] == *std::min_element(cost, cost + 16)) ++right;
        }
        EXPECT_GT(right, 145) << "row " << y;
    }
}

TEST(CostVolume, AnotherExposureCostsNothing) {
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0, 2}, {0, 0, 1}, [](const auto&) { return true; }, noise_texture(0.03, 5)}},
        cross_of_centres(0.1), {});
    const SweepView own = sweep_view(known.scene.views[0]);
    const SweepView other = sweep_view(known.scene.views[1]);
    SweepView brighter = other;
    for (std::uint8_t& value : brighter.gray.pixels()) {
        value = static_cast<std::uint8_t>(value + 30);
    }
    const SweepPlanes planes{0.3, 0.02, 16};
    EXPECT_EQ(sweep_costs(own, {other}, planes, same_for_all({0, 16})).costs(),
              sweep_costs(own, {brighter}, planes, same_for_all({0, 16})).costs());
}

TEST(CostVolume, APixelThatNoNeighbourSeesCostsTheSameEverywhere) {
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0, 2}, {0, 0, 1}, [](const auto&) { return true; }, noise_texture(0.03, 5)}},
        {{0, 0, 0}, {40, 0, 0}}, {});
    const CostVolume volume =
        sweep_costs(sweep_view(known.scene.views[0]), {sweep_view(known.scene.views[1])},
                    {0.3, 0.02, 16}, same_for_all({0, 16}));
    for (const std::uint8_t cost : volume.costs()) ASSERT_EQ(cost, kMaxMatchingCost / 2);
}

}  // namespace
}  // namespace lumi
