#include "meshing/agreement/depth_of_others.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calib/capture/inverse_depth_warp.h"
#include "meshing/agreement/seen_past.h"
#include "meshing/depth/finished_depth.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

constexpr float kRods = 0.5F;  // Inverse depths.
constexpr float kWall = 0.25F;

/// Upright rods before a wall, from the given places; the first view knows the rods alone, all
/// others know everything.
struct RodsBeforeWall {
    explicit RodsBeforeWall(const std::vector<Eigen::Vector3d>& centres)
        : known(known_depth_scene(
              {{{0, 0, 4}, {0, 0, 1}, [](const auto&) { return true; }, noise_texture(0.3, 5)},
               {{0, 0, 2},
                {0, 0, 1},
                [](const Eigen::Vector3d& p) {
                    return p.x() - 0.4 * std::floor(p.x() / 0.4) < 0.2;
                },
                noise_texture(0.2, 8)}},
              centres, {0.1, 1.0})) {
        for (const FloatImage& truth : known.inverse_depths) {
            maps.push_back({truth, GrayImage(truth.width(), truth.height(), 255)});
        }
        for (int y = 0; y < truth().height(); ++y) {
            for (int x = 0; x < truth().width(); ++x) {
                if (is_wall(x, y)) maps[0].confidence(x, y) = 0;
            }
        }
    }

    [[nodiscard]] const FloatImage& truth() const { return known.inverse_depths[0]; }
    [[nodiscard]] bool is_wall(int x, int y) const { return truth()(x, y) < 0.3F; }

    /// Whether a rod is as near as colours are averaged and gaps are closed.
    [[nodiscard]] bool is_beside_rod(int x, int y) const {
        for (int column = x - 2; column <= x + 2; ++column) {
            if (truth().contains(column, y) && !is_wall(column, y)) return true;
        }
        return false;
    }

    /// How many of the others see what the first view sees there.
    [[nodiscard]] int others_that_see(int x, int y) const {
        return others_that_see_at(x, y, truth()(x, y));
    }

    /// How many of the others see the point at an inverse depth along the first view's ray.
    [[nodiscard]] int others_that_see_at(int x, int y, float inverse_depth) const {
        const auto& views = known.scene.views;
        int count = 0;
        for (std::size_t j = 1; j < views.size(); ++j) {
            const auto there = warp_from(views[0]).to(views[j]).at(
                {x + 0.5, y + 0.5}, static_cast<double>(inverse_depth));
            const Eigen::Vector2i pixel = there->pixel.array().floor().cast<int>();
            const FloatImage& seen = known.inverse_depths[j];
            if (!seen.contains(pixel.x(), pixel.y())) continue;
            if (std::abs(seen(pixel.x(), pixel.y()) - inverse_depth) < 0.01F) ++count;
        }
        return count;
    }

    /// Every view knows the wall and nothing else, of which the first shows blue rods.
    void forget_rods() {
        ColorImage& picture = known.scene.views[0].photograph;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                if (!is_wall(x, y)) picture(x, y) = {20, 60, 255};
            }
        }
        for (DepthMap& map : maps) {
            for (std::size_t i = 0; i < map.confidence.pixels().size(); ++i) {
                const bool is_of_wall = map.inverse_depth.pixels()[i] < 0.3F;
                map.confidence.pixels()[i] = is_of_wall ? 255 : 0;
            }
        }
    }

    KnownDepthScene known;
    std::vector<DepthMap> maps;
};

int count_of(const GrayImage& confidence) {
    return static_cast<int>(confidence.pixels().size() -
                            static_cast<std::size_t>(std::count(confidence.pixels().begin(),
                                                                confidence.pixels().end(), 0)));
}

TEST(DepthOfOthers, KnowsBehindRodsWhatThreeOtherViewsSee) {
    const RodsBeforeWall scene(cross_of_centres(0.3));
    const DepthOfOthers others = depth_of_others(scene.known.scene, scene.maps, 0);
    int seen_by_three = 0;
    int agreed = 0;
    for (int y = 4; y < 176; ++y) {
        for (int x = 4; x < 236; ++x) {
            if (!scene.is_wall(x, y)) continue;
            if (scene.others_that_see(x, y) >= 3 && !scene.is_beside_rod(x, y)) ++seen_by_three;
            if (others.agreed.confidence(x, y) == 0) continue;
            if (!scene.is_beside_rod(x, y)) ++agreed;
            ASSERT_NEAR(others.agreed.inverse_depth(x, y), kWall, 1e-3F) << x << " " << y;
        }
    }
    ASSERT_GT(seen_by_three, 4000);
    // The colours of nine of ten surfaces pass in each of three views.
    EXPECT_GT(agreed, std::pow(0.9, 3) * seen_by_three);
    EXPECT_LT(agreed, 1.1 * seen_by_three) << "what two views see is not agreed upon";
    for (const DepthOfOthers::Claim& claim : others.doubtful) {
        ASSERT_EQ(others.agreed.confidence(claim.x, claim.y), 0);
        ASSERT_EQ(scene.maps[0].confidence(claim.x, claim.y), 0);
    }
}

TEST(DepthOfOthers, IsNotOfAnotherColourThanThePhotograph) {
    RodsBeforeWall scene(cross_of_centres(0.3));
    const int before =
        count_of(depth_of_others(scene.known.scene, scene.maps, 0).agreed.confidence);
    ColorImage& picture = scene.known.scene.views[0].photograph;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            if (scene.is_wall(x, y)) picture(x, y) = {20, 60, 255};
        }
    }
    const DepthOfOthers others = depth_of_others(scene.known.scene, scene.maps, 0);
    EXPECT_LT(count_of(others.agreed.confidence), before / 50);
    EXPECT_LT(static_cast<int>(others.doubtful.size()), before / 10);
}

TEST(DepthOfOthers, StandsADarkerExposure) {
    RodsBeforeWall scene(cross_of_centres(0.3));
    const int before =
        count_of(depth_of_others(scene.known.scene, scene.maps, 0).agreed.confidence);
    for (std::size_t j = 1; j < scene.maps.size(); ++j) {
        for (Rgb8& color : scene.known.scene.views[j].photograph.pixels()) {
            color.r = static_cast<std::uint8_t>(color.r * 6 / 10);
            color.g = static_cast<std::uint8_t>(color.g * 8 / 10);
        }
    }
    const int darker =
        count_of(depth_of_others(scene.known.scene, scene.maps, 0).agreed.confidence);
    EXPECT_GT(darker, 0.95 * before);
}

TEST(DepthOfOthers, OfOneViewIsDoubtfulAndTakesWhatThatViewSeesPast) {
    const RodsBeforeWall scene({{0, 0, 0}, {0.3, 0, 0}});
    const DepthOfOthers others = depth_of_others(scene.known.scene, scene.maps, 0);
    EXPECT_EQ(count_of(others.agreed.confidence), 0);
    ASSERT_GT(others.doubtful.size(), 3000U);
    DepthMap map = scene.maps[0];
    map.inverse_depth = FloatImage(240, 180, kRods);  // Continued from the rods.
    FloatImage distance_px(240, 180, 3.0F);
    take_claims_against(scene.known.scene, scene.maps, 0, others.doubtful, map, distance_px);
    int taken = 0;
    for (const DepthOfOthers::Claim& claim : others.doubtful) {
        if (distance_px(claim.x, claim.y) > 0) continue;
        ++taken;
        ASSERT_NEAR(map.inverse_depth(claim.x, claim.y), kWall, 1e-3F);
    }
    // Behind some of the places that are continued the other view sees a rod before them.
    EXPECT_GT(taken, static_cast<int>(others.doubtful.size()) / 2);
}

TEST(DepthOfOthers, LeavesWhatIsContinuedAlikeWhereTheClaimIsDoubtful) {
    const RodsBeforeWall scene({{0, 0, 0}, {0.3, 0, 0}});
    const DepthOfOthers others = depth_of_others(scene.known.scene, scene.maps, 0);
    const float beside = kWall + 0.005F;  // A third of a pixel of disparity.
    DepthMap map = scene.maps[0];
    map.inverse_depth = FloatImage(240, 180, beside);
    FloatImage distance_px(240, 180, 3.0F);
    take_claims_against(scene.known.scene, scene.maps, 0, others.doubtful, map, distance_px);
    int left = 0;
    for (const DepthOfOthers::Claim& claim : others.doubtful) {
        if (map.inverse_depth(claim.x, claim.y) == beside) ++left;
    }
    EXPECT_GT(left, static_cast<int>(0.9 * static_cast<double>(others.doubtful.size())));
}

TEST(DepthOfOthers, CountsAsConfirmedByOneWhereTheyAgree) {
    const RodsBeforeWall scene(cross_of_centres(0.3));
    const DepthOfOthers others = depth_of_others(scene.known.scene, scene.maps, 0);
    DepthMap map = scene.maps[0];
    Continuation continuation{FloatImage(240, 180), GrayImage(240, 180)};
    for (std::size_t i = 0; i < continuation.told.pixels().size(); ++i) {
        if (others.agreed.confidence.pixels()[i] != 0)
            continuation.told.pixels()[i] = Continuation::kAgreed;
    }
    finish_continued_depth(scene.known.scene.views[0], continuation, 0.0, map);
    int agreed = 0;
    int trusted = 0;
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 240; ++x) {
            if (scene.maps[0].confidence(x, y) != 0) continue;
            if (others.agreed.confidence(x, y) != 0) ++agreed;
            if (map.confidence(x, y) == 128) ++trusted;
        }
    }
    ASSERT_GT(agreed, 4000);
    EXPECT_NEAR(trusted, agreed, 0.1 * agreed) << "but for edges that were moved";
}

/// So near to each other that two on either side see the wall behind most of a rod.
std::vector<Eigen::Vector3d> centres_in_a_row() {
    return {{0, 0, 0}, {0.15, 0, 0}, {0.25, 0.1, 0}, {-0.15, 0, 0}, {-0.25, 0.1, 0}};
}

/// Of the rods' pixels behind which two others see the wall, those whose `hidden` is the wall.
double share_known_to_hide(const RodsBeforeWall& scene, const DepthMap& hidden) {
    int hiding = 0;
    int told = 0;
    for (int y = 4; y < 176; ++y) {
        for (int x = 4; x < 236; ++x) {
            if (scene.is_wall(x, y) || scene.others_that_see_at(x, y, kWall) < 2) continue;
            ++hiding;
            if (hidden.confidence(x, y) != 0) ++told;
        }
    }
    EXPECT_GT(hiding, 2000);
    return told / static_cast<double>(std::max(1, hiding));
}

TEST(DepthOfOthers, KnowsWhatIsHiddenBehindRodsThatNobodyKnows) {
    RodsBeforeWall scene(centres_in_a_row());
    scene.forget_rods();
    const DepthOfOthers others = depth_of_others(scene.known.scene, scene.maps, 0);
    EXPECT_GT(share_known_to_hide(scene, others.hidden), 0.9);
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 240; ++x) {
            if (others.hidden.confidence(x, y) == 0) continue;
            ASSERT_FALSE(scene.is_wall(x, y)) << "which the view knows";
            ASSERT_NEAR(others.hidden.inverse_depth(x, y), kWall, 1e-3F);
        }
    }
}

TEST(DepthOfOthers, HidesNothingWhereItShowsWhatOthersKnow) {
    RodsBeforeWall scene(cross_of_centres(0.3));
    const DepthOfOthers others = depth_of_others(scene.known.scene, scene.maps, 0);
    int walls = 0;
    int hidden = 0;
    for (int y = 4; y < 176; ++y) {
        for (int x = 4; x < 236; ++x) {
            if (!scene.is_wall(x, y) || scene.is_beside_rod(x, y)) continue;
            ++walls;
            if (others.hidden.confidence(x, y) != 0) ++hidden;
        }
    }
    // One view in ten denies the colour of a surface by chance, and of those that see one most do
    // not.
    EXPECT_LT(hidden, 0.02 * walls);
}

TEST(DepthOfOthers, TrustsWhatIsContinuedBeforeSomethingHidden) {
    RodsBeforeWall scene(centres_in_a_row());
    scene.forget_rods();
    const DepthOfOthers others = depth_of_others(scene.known.scene, scene.maps, 0);
    const auto trusted_if_continued_at = [&](float inverse_depth) {
        DepthMap map = scene.maps[0];
        for (std::size_t i = 0; i < map.confidence.pixels().size(); ++i) {
            if (map.confidence.pixels()[i] == 0) map.inverse_depth.pixels()[i] = inverse_depth;
        }
        Continuation continuation{FloatImage(240, 180), GrayImage(240, 180)};
        const GrayImage hides =
            continued_before_hidden(scene.known.scene, scene.maps, 0, map, others.hidden);
        for (std::size_t i = 0; i < hides.pixels().size(); ++i) {
            if (hides.pixels()[i] != 0) continuation.told.pixels()[i] = Continuation::kHides;
        }
        finish_continued_depth(scene.known.scene.views[0], continuation, 0.0, map);
        return static_cast<int>(
            std::count(map.confidence.pixels().begin(), map.confidence.pixels().end(), 128));
    };
    const int at_rods = trusted_if_continued_at(kRods);
    EXPECT_GT(at_rods, 2000);
    EXPECT_EQ(trusted_if_continued_at(kWall), 0) << "hides nothing where it is itself";
    // Nearer than the rods, where other views see past it.
    EXPECT_LT(trusted_if_continued_at(0.9F), at_rods / 4);
}

TEST(DepthOfOthers, RodsThatAreHalfKnownAreContinuedAndTrusted) {
    RodsBeforeWall scene(centres_in_a_row());
    scene.forget_rods();
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 240; ++x) scene.maps[0].confidence(x, y) = 255;
    }
    const DepthOfOthers others = depth_of_others(scene.known.scene, scene.maps, 0);
    // What hides something does not recede into that.
    for (const double recession_px : {0.0, 1.0}) {
        DepthMap map = scene.maps[0];
        fill_unknown_depth(scene.known.scene, scene.maps, 0, recession_px, map);
        int hiding = 0;
        int right = 0;
        for (int y = 64; y < 120; ++y) {
            for (int x = 4; x < 236; ++x) {
                if (others.hidden.confidence(x, y) == 0) continue;
                ++hiding;
                const bool is_rod = std::abs(map.inverse_depth(x, y) - kRods) < 0.03F;
                if (is_rod && map.confidence(x, y) == 128) ++right;
            }
        }
        ASSERT_GT(hiding, 1000);
        EXPECT_GT(right, 0.9 * hiding) << recession_px;
    }
}

}  // namespace
}  // namespace lumi
