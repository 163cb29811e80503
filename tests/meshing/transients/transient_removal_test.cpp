#include "meshing/transients/transient_removal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "calib/capture/inverse_depth_warp.h"
#include "calib/pictures/image_io.h"
#include "calib/work/progress.h"
#include "meshing/transients/transients.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

constexpr Rgb8 kRed{200, 30, 30};
constexpr Rgb8 kBlue{30, 40, 210};

/// In pixels of one picture.
struct Block {
    int left, top, right, bottom;

    [[nodiscard]] bool contains(int x, int y) const {
        return x >= left && x < right && y >= top && y < bottom;
    }
};

constexpr Block kBlock{90, 60, 140, 110};

/// Photographs of a textured wall from nine places, with exact depth that all views know.
class Wall {
 public:
    explicit Wall(int views = 9, const std::vector<TexturedPlane>& before = {}) {
        std::vector<Eigen::Vector3d> centres;
        for (int i = 0; i < views; ++i) {
            centres.emplace_back(0.3 * (i % 3) - 0.3, 0.25 * (i / 3) - 0.25, 0.0);
        }
        std::vector<TexturedPlane> planes = before;
        planes.push_back({{0, 0, kDistance},
                          {0, 0, 1},
                          [](const Eigen::Vector3d&) { return true; },
                          noise_texture(0.3, 5)});
        known_ = known_depth_scene(planes, centres, {0.1, 1.0});
        for (const FloatImage& truth : known_.inverse_depths) {
            depths_.push_back({truth, GrayImage(truth.width(), truth.height(), 255)});
        }
    }

    [[nodiscard]] ColorImage& photograph(int view) {
        return known_.scene.views[static_cast<std::size_t>(view)].photograph;
    }
    [[nodiscard]] DepthMap& depth(int view) { return depths_[static_cast<std::size_t>(view)]; }

    /// Something before the wall that the view alone shows, and whose depth nobody knows.
    void walk_through(int view, const Block& block, const Rgb8& color) {
        for (int y = block.top; y < block.bottom; ++y) {
            for (int x = block.left; x < block.right; ++x) {
                photograph(view)(x, y) = color;
                depth(view).inverse_depth(x, y) = 0.6F;
                depth(view).confidence(x, y) = 0;
            }
        }
    }

    /// Where a view has the point of the wall that another shows at a pixel.
    [[nodiscard]] Eigen::Vector2i place_in(int view, int other,
                                           const Eigen::Vector2d& pixel) const {
        const DepthView& from = known_.scene.views[static_cast<std::size_t>(other)];
        const DepthView& to = known_.scene.views[static_cast<std::size_t>(view)];
        const auto there = warp_from(from).to(to).at(pixel, 1 / kDistance);
        return there->pixel.array().floor().cast<int>();
    }

    /// Photographs of so many times as many pixels across; depth as it is.
    void enlarge(int times) {
        for (DepthView& view : known_.scene.views) {
            const int width = times * view.camera.width_px;
            const int height = times * view.camera.height_px;
            view.photograph = resized(view.photograph, width, height);
            view.camera = resized(view.camera, width, height);
        }
    }

    /// A disc of this colour at the same place in space in all photographs, of which no depth map
    /// says anything but what lies behind it.
    void hang_up(const Eigen::Vector3d& middle_in_world, double radius_px, const Rgb8& color) {
        for (const DepthView& view : known_.scene.views) {
            const Eigen::Vector2d middle =
                *project(view.camera, view.cam_from_world * middle_in_world);
            ColorImage& picture = photograph(static_cast<int>(&view - &known_.scene.views[0]));
            for (int y = 0; y < picture.height(); ++y) {
                for (int x = 0; x < picture.width(); ++x) {
                    if ((Eigen::Vector2d(x + 0.5, y + 0.5) - middle).norm() < radius_px) {
                        picture(x, y) = color;
                    }
                }
            }
        }
    }

    [[nodiscard]] std::vector<ViewWithoutTransients> cleaned(int threads = 2) const {
        std::vector<PicturedView> views;
        for (std::size_t i = 0; i < depths_.size(); ++i) {
            const DepthView& view = known_.scene.views[i];
            views.push_back({&view.photograph, view.camera, view.cam_from_world, &depths_[i]});
        }
        SilentProgress progress;
        return without_transients(views, threads, UINT64_MAX, progress);
    }

    static constexpr double kDistance = 4.0;

 private:
    KnownDepthScene known_;
    std::vector<DepthMap> depths_;
};

/// Of all channels, 8-bit levels, over the block.
double mean_difference(const ColorImage& a, const ColorImage& b, const Block& block) {
    double sum = 0;
    for (int y = block.top; y < block.bottom; ++y) {
        for (int x = block.left; x < block.right; ++x) {
            sum += std::abs(a(x, y).r - b(x, y).r) + std::abs(a(x, y).g - b(x, y).g) +
                   std::abs(a(x, y).b - b(x, y).b);
        }
    }
    return sum / (3.0 * (block.right - block.left) * (block.bottom - block.top));
}

TEST(TransientRemoval, PaintsOverWhatOnePhotographAloneShows) {
    Wall wall;
    const ColorImage truth = wall.photograph(4);
    wall.walk_through(4, kBlock, kRed);
    const auto cleaned = wall.cleaned();
    ASSERT_EQ(cleaned.size(), 1U);
    EXPECT_EQ(cleaned[0].view, 4);
    EXPECT_LT(mean_difference(cleaned[0].photograph, truth, kBlock), 4.0);
    const double share = 50.0 * 50.0 / (240.0 * 180.0);
    EXPECT_GT(cleaned[0].share, share);
    EXPECT_LT(cleaned[0].share, 1.4 * share);
}

TEST(TransientRemoval, KnowsTheDepthOfWhatItHid) {
    Wall wall;
    wall.walk_through(4, kBlock, kRed);
    const auto cleaned = wall.cleaned();
    ASSERT_EQ(cleaned.size(), 1U);
    for (int y = kBlock.top; y < kBlock.bottom; ++y) {
        for (int x = kBlock.left; x < kBlock.right; ++x) {
            EXPECT_NEAR(cleaned[0].depth.inverse_depth(x, y), 1 / Wall::kDistance, 1e-3);
            EXPECT_EQ(cleaned[0].depth.confidence(x, y), 128);
        }
    }
}

TEST(TransientRemoval, LeavesAllElseAsItWas) {
    Wall wall;
    wall.walk_through(4, kBlock, kRed);
    const ColorImage before = wall.photograph(4);
    const auto cleaned = wall.cleaned();
    ASSERT_EQ(cleaned.size(), 1U);
    const Block reached{kBlock.left - 6, kBlock.top - 6, kBlock.right + 6, kBlock.bottom + 6};
    for (int y = 0; y < before.height(); ++y) {
        for (int x = 0; x < before.width(); ++x) {
            if (reached.contains(x, y)) continue;
            EXPECT_EQ(cleaned[0].photograph(x, y), before(x, y));
            EXPECT_EQ(cleaned[0].depth.confidence(x, y), 255);
        }
    }
}

TEST(TransientRemoval, PaintsToTheBorderOfThePicture) {
    Wall wall;
    const ColorImage truth = wall.photograph(4);
    constexpr Block kInTheCorner{0, 120, 50, 180};
    wall.walk_through(4, kInTheCorner, kRed);
    const auto cleaned = wall.cleaned();
    ASSERT_EQ(cleaned.size(), 1U);
    EXPECT_LT(mean_difference(cleaned[0].photograph, truth, kInTheCorner), 2.0);
}

TEST(TransientRemoval, PaintsFromTheRimWhatNobodyKnows) {
    Wall wall;
    const ColorImage truth = wall.photograph(4);
    wall.walk_through(4, kBlock, kRed);
    for (int view = 0; view < 9; ++view) {
        if (view == 4) continue;
        // The same part of the wall in each, about the middle of the block.
        for (int y = 70; y < 100; ++y) {
            for (int x = 100; x < 130; ++x) {
                const Eigen::Vector2i place = wall.place_in(view, 4, {x + 0.5, y + 0.5});
                GrayImage& confidence = wall.depth(view).confidence;
                if (confidence.contains(place.x(), place.y())) confidence(place.x(), place.y()) = 0;
            }
        }
    }
    const auto cleaned = wall.cleaned();
    ASSERT_EQ(cleaned.size(), 1U);
    for (int y = kBlock.top; y < kBlock.bottom; ++y) {
        for (int x = kBlock.left; x < kBlock.right; ++x) {
            EXPECT_NEAR(cleaned[0].depth.inverse_depth(x, y), 1 / Wall::kDistance, 1e-2);
        }
    }
    EXPECT_LT(mean_difference(cleaned[0].photograph, truth, kBlock), 4.0);
    EXPECT_EQ(cleaned[0].depth.confidence(115, 85), 0);
}

TEST(TransientRemoval, PaintsPhotographsThatAreFinerThanDepth) {
    Wall wall;
    const ColorImage truth = resized(wall.photograph(4), 480, 360);
    wall.walk_through(4, kBlock, kRed);
    wall.enlarge(2);
    const auto cleaned = wall.cleaned();
    ASSERT_EQ(cleaned.size(), 1U);
    EXPECT_LT(mean_difference(cleaned[0].photograph, truth, {180, 120, 280, 220}), 5.0);
}

TEST(TransientRemoval, LeavesPhotographsThatAgree) { EXPECT_TRUE(Wall().cleaned().empty()); }

TEST(TransientRemoval, LeavesWhatStandsStillThoughNoDepthKnowsIt) {
    Wall wall;
    wall.hang_up({0, 0, 2.5}, 20, kRed);
    EXPECT_TRUE(wall.cleaned().empty());
}

TEST(TransientRemoval, LeavesWhatStandsStillNearerThanAllThatIsKnown) {
    Wall wall;
    wall.hang_up({0, 0, 1.0}, 20, kRed);
    EXPECT_TRUE(wall.cleaned().empty());
}

TEST(TransientRemoval, LeavesWhatTheWallMirrors) {
    Wall wall;
    wall.hang_up({0, 0, 9}, 20, kRed);
    EXPECT_TRUE(wall.cleaned().empty());
}

TEST(TransientRemoval, LeavesWhatTwoOthersConfirmBeforeTheWall) {
    Wall wall;
    wall.walk_through(4, kBlock, kRed);
    for (std::uint8_t& confidence : wall.depth(4).confidence.pixels()) confidence = 255;
    EXPECT_TRUE(wall.cleaned().empty());
}

/// A box before a wall far away. Of its bright side, which the last view alone sees, no view knows
/// the depth.
TEST(TransientRemoval, LeavesWhatOthersCannotSee) {
    constexpr float kBox = 0.2F;
    std::vector<Eigen::Vector3d> centres{{0.9, 0, 0}};
    for (int i = 0; i < 9; ++i) centres.emplace_back(0.15 * (i % 3) - 0.3, 0.1 * (i / 3) - 0.1, 0);
    const auto is_high = [](const Eigen::Vector3d& p) { return std::abs(p.y()) < 0.3; };
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0, 20}, {0, 0, 1}, [](const auto&) { return true; }, noise_texture(1.5, 5)},
         {{0, 0, 2.5},
          {0, 0, 1},
          [=](const Eigen::Vector3d& p) { return is_high(p) && std::abs(p.x()) < 0.3; },
          noise_texture(0.2, 8)},
         {{0.3, 0, 0},
          {1, 0, 0},
          [=](const Eigen::Vector3d& p) { return is_high(p) && p.z() > 2.5 && p.z() < 3.2; },
          [](const auto&) { return 255.0; }}},
        centres, {0.01, 1.0});
    std::vector<DepthMap> depths;
    for (const FloatImage& truth : known.inverse_depths) {
        depths.push_back({truth, GrayImage(truth.width(), truth.height(), 255)});
    }
    int side_px = 0;
    for (std::size_t i = 0; i < depths[0].confidence.pixels().size(); ++i) {
        const float inverse_depth = known.inverse_depths[0].pixels()[i];
        if (inverse_depth < kBox || inverse_depth > 0.399F) continue;
        depths[0].confidence.pixels()[i] = 0;
        ++side_px;
    }
    ASSERT_GT(side_px, kLeastTransientShare * 240 * 180);
    std::vector<PicturedView> views;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const DepthView& view = known.scene.views[i];
        views.push_back({&view.photograph, view.camera, view.cam_from_world, &depths[i]});
    }
    SilentProgress progress;
    EXPECT_TRUE(without_transients(views, 2, UINT64_MAX, progress).empty());
}

TEST(TransientRemoval, LeavesPatchesThatAreTooSmall) {
    Wall wall;
    wall.walk_through(4, {100, 80, 106, 86}, kRed);
    EXPECT_TRUE(wall.cleaned().empty());
}

TEST(TransientRemoval, LeavesAllWhereTooFewViewsCouldTell) {
    Wall wall(3);
    wall.walk_through(1, kBlock, kRed);
    EXPECT_TRUE(wall.cleaned().empty());
}

TEST(TransientRemoval, PaintsInThePhotographsOwnExposure) {
    Wall wall;
    for (Rgb8& pixel : wall.photograph(4).pixels()) {
        pixel.r = static_cast<std::uint8_t>(pixel.r * 4 / 5);
        pixel.g = static_cast<std::uint8_t>(pixel.g * 4 / 5);
        pixel.b = static_cast<std::uint8_t>(pixel.b * 4 / 5);
    }
    const ColorImage truth = wall.photograph(4);
    wall.walk_through(4, kBlock, kRed);
    const auto cleaned = wall.cleaned();
    ASSERT_EQ(cleaned.size(), 1U);
    EXPECT_LT(mean_difference(cleaned[0].photograph, truth, kBlock), 4.0);
}

TEST(TransientRemoval, PaintsNothingFromOtherTransients) {
    Wall wall;
    const ColorImage truth = wall.photograph(4);
    wall.walk_through(4, kBlock, kRed);
    // Before the same part of the wall, in what is asked first.
    wall.walk_through(3, {100, 50, 160, 120}, kBlue);
    wall.walk_through(5, {70, 60, 120, 110}, {60, 160, 60});
    const auto cleaned = wall.cleaned();
    ASSERT_EQ(cleaned.size(), 3U);
    EXPECT_EQ(cleaned[1].view, 4);
    EXPECT_LT(mean_difference(cleaned[1].photograph, truth, kBlock), 4.0);
}

TEST(TransientRemoval, DoesTheSameWithAnyNumberOfThreads) {
    Wall wall;
    wall.walk_through(4, kBlock, kRed);
    wall.walk_through(7, kBlock, kBlue);
    const auto one = wall.cleaned(1);
    const auto four = wall.cleaned(4);
    ASSERT_EQ(one.size(), 2U);
    ASSERT_EQ(four.size(), 2U);
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].photograph, four[i].photograph);
        EXPECT_EQ(one[i].depth.inverse_depth, four[i].depth.inverse_depth);
    }
}

TEST(TransientRemoval, LeavesViewsWithoutDepth) {
    Wall wall;
    wall.walk_through(4, kBlock, kRed);
    for (int view = 0; view < 9; ++view) wall.depth(view) = {};
    EXPECT_TRUE(wall.cleaned().empty());
}

}  // namespace
}  // namespace lumi
