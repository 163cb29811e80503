#include "meshing/selection/view_worth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <set>

#include "meshing/selection/enclosing_views.h"
#include "meshing/selection/thumbnail_prediction.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

/// Photographs of a wall with a card before it, with exact depth.
class PhotographedWall {
 public:
    explicit PhotographedWall(const std::vector<Eigen::Vector3d>& centres) {
        const auto texture = noise_texture(0.08, 3);
        const TexturedPlane wall{{0, 0, 4}, {0, 0, -1}, [](const auto&) { return true; }, texture};
        const TexturedPlane card{{0, 0, 3},
                                 {0, 0, -1},
                                 [](const Eigen::Vector3d& p) { return p.head<2>().norm() < 0.5; },
                                 texture};
        known_ = known_depth_scene({wall, card}, centres, {0.1, 1.0});
        for (std::size_t i = 0; i < centres.size(); ++i) {
            const FloatImage& inverse_depth = known_.inverse_depths[i];
            depths_.push_back(
                {inverse_depth, GrayImage(inverse_depth.width(), inverse_depth.height(), 255)});
            axes_.push_back({static_cast<int>(i), centres[i], Eigen::Vector3d::UnitZ(), 4.0});
        }
    }

    [[nodiscard]] std::vector<PicturedView> views() const {
        std::vector<PicturedView> result;
        for (std::size_t i = 0; i < depths_.size(); ++i) {
            const DepthView& view = known_.scene.views[i];
            result.push_back({&view.photograph, view.camera, view.cam_from_world, &depths_[i]});
        }
        return result;
    }
    [[nodiscard]] std::vector<int> by_worth() const {
        const SilentProgress progress;
        return views_by_worth(views(), axes_, {0, 0, 4}, progress);
    }
    [[nodiscard]] DepthView& view(int index) {
        return known_.scene.views[static_cast<std::size_t>(index)];
    }
    [[nodiscard]] DepthMap& depth(int index) { return depths_[static_cast<std::size_t>(index)]; }

 private:
    KnownDepthScene known_;
    std::vector<DepthMap> depths_;
    std::vector<OpticalAxis> axes_;
};

std::vector<Eigen::Vector3d> grid_of_centres() {
    std::vector<Eigen::Vector3d> centres;
    for (int i = 0; i < 12; ++i) centres.emplace_back(0.3 * (i % 4) - 0.45, 0.3 * (i / 4) - 0.3, 0);
    return centres;
}

TEST(ViewsByWorth, NameAViewWithAWrongPoseLast) {
    PhotographedWall wall(grid_of_centres());
    const int wrong = 5;
    wall.view(wrong).cam_from_world.rotation =
        Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()) * wall.view(wrong).cam_from_world.rotation;
    EXPECT_EQ(wall.by_worth().back(), wrong);
}

TEST(ViewsByWorth, NameOneOfTwoNearDuplicatesLate) {
    std::vector<Eigen::Vector3d> centres = grid_of_centres();
    for (int i = 0; i < 4; ++i) {
        centres.push_back(centres[static_cast<std::size_t>(3 * i)] +
                          Eigen::Vector3d(0.004, 0.002, 0));
    }
    const std::vector<int> order = PhotographedWall(centres).by_worth();
    std::set<int> places;
    for (int i = 0; i < 12; ++i) {
        const int view = order[static_cast<std::size_t>(i)];
        places.insert(view < 12 ? view : 3 * (view - 12));
    }
    EXPECT_EQ(places.size(), 12U);
}

TEST(ViewsByWorth, AreAllViewsOnceWhateverIsKnown) {
    PhotographedWall one_spot(std::vector<Eigen::Vector3d>(4, Eigen::Vector3d::Zero()));
    PhotographedWall without_depth(grid_of_centres());
    for (int i = 0; i < 12; ++i) without_depth.depth(i) = {};
    PhotographedWall one_without(grid_of_centres());
    one_without.depth(3) = {};
    PhotographedWall single({Eigen::Vector3d::Zero()});
    for (const PhotographedWall* wall : {&one_spot, &without_depth, &one_without, &single}) {
        const std::vector<int> order = wall->by_worth();
        EXPECT_EQ(order.size(), wall->views().size());
        EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), order.size());
    }
}

TEST(ThumbnailPrediction, ASecondPhotographOfEachPlaceChangesNoPrediction) {
    std::vector<Eigen::Vector3d> singles = grid_of_centres();
    for (Eigen::Vector3d& centre : singles) centre *= 2;  // Card and wall are told apart.
    std::vector<Eigen::Vector3d> doubled = singles;
    for (const Eigen::Vector3d& centre : singles) {
        doubled.push_back(centre + Eigen::Vector3d(1e-4, 0, 0));
    }
    const EnclosingViews from{{4, 6}, {0.5, 0.5}};
    EXPECT_NEAR(ThumbnailPrediction(PhotographedWall(doubled).views()).loss_db(5, from),
                ThumbnailPrediction(PhotographedWall(singles).views()).loss_db(5, from), 1e-6);
}

TEST(ThumbnailPrediction, LosesLittleFromNeighboursAndMuchFromNothing) {
    PhotographedWall wall(grid_of_centres());
    ThumbnailPrediction prediction(wall.views());
    const double near = prediction.loss_db(5, {{4, 6}, {0.5, 0.5}});
    const double far = prediction.loss_db(5, {{3, 8}, {0.5, 0.5}});
    const double from_nothing = prediction.loss_db(5, {});
    EXPECT_LT(near, far);
    EXPECT_LT(far, from_nothing);
    EXPECT_NEAR(from_nothing, 20 * std::log10(80.0), 1e-9);
    prediction.forget(4);
    EXPECT_EQ(prediction.loss_db(5, {{4, 6}, {0.5, 0.5}}), near);
}

TEST(ThumbnailPrediction, IsTheSameOfPhotographsThatAreThumbnailsAlready) {
    const PhotographedWall wall(grid_of_centres());
    std::vector<PicturedView> views = wall.views();
    std::vector<ColorImage> thumbnails;
    for (const PicturedView& view : views)
        thumbnails.push_back(thumbnail_of(*view.photograph, view.camera));
    ASSERT_LT(thumbnails[0].width(), views[0].photograph->width());
    const EnclosingViews from{{4, 6}, {0.5, 0.5}};
    const double of_photographs = ThumbnailPrediction(views).loss_db(5, from);
    for (std::size_t i = 0; i < views.size(); ++i) views[i].photograph = &thumbnails[i];
    EXPECT_EQ(ThumbnailPrediction(views).loss_db(5, from), of_photographs);
}

TEST(EnclosingViews, AreTheDelaunayTriangleWithBarycentricWeights) {
    const auto towards = [](double x, double y) { return Eigen::Vector3d(x, y, 1).normalized(); };
    const std::vector<Eigen::Vector3d> directions{towards(-0.1, -0.1), towards(0.1, -0.1),
                                                  towards(0.0, 0.12),  towards(0.5, 0.5),
                                                  towards(-0.6, 0.4),  towards(0.0, -0.7)};
    const auto found = enclosing_views(towards(0, 0), directions, {0, 1, 2, 3, 4, 5});
    EXPECT_EQ(std::set<int>(found.views.begin(), found.views.end()), (std::set<int>{0, 1, 2}));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GE(found.weights[i], 0.0);
        sum += found.weights[i] * directions[static_cast<std::size_t>(found.views[i])];
    }
    EXPECT_LT(sum.normalized().head<2>().norm(), 2e-3);
    // Beyond the border: the nearest edge.
    const auto beyond = enclosing_views(towards(0, -0.3), directions, {0, 1, 2});
    EXPECT_EQ(std::set<int>(beyond.views.begin(), beyond.views.end()), (std::set<int>{0, 1}));
    EXPECT_NEAR(beyond.weights[0], 0.5, 1e-9);
    EXPECT_EQ(enclosing_views(towards(0, 0), directions, {3}).views, std::vector<int>{3});
    EXPECT_TRUE(enclosing_views(towards(0, 0), directions, {}).views.empty());
}

TEST(ThumbnailPrediction, BlendsWhatIsWithinTwoPixelsOfItsThumbnailsWhateverTheirPhotographsSizes) {
    constexpr std::array<std::uint8_t, 3> kGrays{100, 110, 120};
    std::vector<ColorImage> photographs;
    std::vector<DepthMap> depths;
    std::vector<PicturedView> views;
    for (std::size_t i = 0; i < kGrays.size(); ++i) {
        const int times = i == 1 ? 1 : 16;  // A small photograph between two large ones.
        const std::uint8_t gray = kGrays[i];
        photographs.emplace_back(80 * times, 60 * times, Rgb8{gray, gray, gray});
        // Half a pixel apart, as far as the next camera.
        depths.push_back({FloatImage(80, 60, i == 0 ? 0.25F : 0.3F), GrayImage(80, 60, 255)});
        PicturedView& view = views.emplace_back();
        view.camera = pinhole_camera(80 * times, 60 * times, 80.0 * times);
        view.cam_from_world.translation = {-0.1 * static_cast<double>(i), 0, 0};
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
        views[i].photograph = &photographs[i];
        views[i].depth = &depths[i];
    }
    ThumbnailPrediction prediction(views);
    // In the mean of both but for a column or two at either side; of the nearer alone it would
    // be 20.
    EXPECT_LT(prediction.loss_db(1, {{0, 2}, {0.5, 0.5}}), 10);
}

}  // namespace
}  // namespace lumi
