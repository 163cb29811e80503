#include "meshing/agreement/visual_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "meshing/depth/subject.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

constexpr float kCardInverseDepth = 0.5F;
constexpr int kCardX = 120;
constexpr int kCardY = 90;

/// A card before nothing, and the masks that are left of it. In all views but the first `exact`
/// ones all counts as the scene.
struct Card {
    explicit Card(std::size_t exact = 5)
        : known(known_depth_scene({{{0, 0, 2},
                                    {0, 0, 1},
                                    [](const Eigen::Vector3d& at) {
                                        return std::abs(at.x()) < 0.2 && std::abs(at.y()) < 0.2;
                                    },
                                    noise_texture(0.03, 5)}},
                                  cross_of_centres(0.5), {0.1, 1.0})) {
        for (std::size_t i = 0; i < known.inverse_depths.size(); ++i) {
            GrayImage& mask = masks.emplace_back(240, 180, 255);
            for (std::size_t at = 0; at < mask.pixels().size(); ++at) {
                if (i < exact && known.inverse_depths[i].pixels()[at] == 0) mask.pixels()[at] = 0;
            }
        }
    }

    /// What the first view may say: the same everywhere.
    [[nodiscard]] static DepthMap saying(float inverse_depth, std::uint8_t confidence) {
        return {FloatImage(240, 180, inverse_depth), GrayImage(240, 180, confidence)};
    }

    KnownDepthScene known;
    std::vector<GrayImage> masks;
};

TEST(VisualHull, TakesClaimsThatTwoViewsSeeTheBackgroundAt) {
    const Card card;
    const VisualHull hull(card.known.scene, card.masks);
    for (const float wrong : {0.15F, 0.95F}) {
        DepthMap map = Card::saying(wrong, 255);
        hull.take_claims_outside(0, map);
        EXPECT_EQ(map.confidence(kCardX, kCardY), 0) << wrong;
        EXPECT_EQ(map.inverse_depth(kCardX, kCardY), wrong);
    }
}

TEST(VisualHull, LeavesEveryTrueClaim) {
    const Card card;
    const VisualHull hull(card.known.scene, card.masks);
    for (int view = 0; view < 5; ++view) {
        const FloatImage& truth = card.known.inverse_depths[static_cast<std::size_t>(view)];
        DepthMap map{truth, card.masks[static_cast<std::size_t>(view)]};
        hull.take_claims_outside(view, map);
        EXPECT_EQ(map.confidence.pixels(), card.masks[static_cast<std::size_t>(view)].pixels());
    }
}

TEST(VisualHull, AsksForTwoViewsAsOneMaskMayBeWrong) {
    for (const std::size_t exact : {std::size_t{2}, std::size_t{3}}) {
        const Card card(exact);  // The first view's own mask is no witness.
        const VisualHull hull(card.known.scene, card.masks);
        DepthMap map = Card::saying(0.95F, 255);
        hull.take_claims_outside(0, map);
        EXPECT_EQ(map.confidence(kCardX, kCardY) == 0, exact == 3);
    }
}

TEST(VisualHull, MovesWhatWasFilledToTheNearestDepthInside) {
    const Card card;
    const VisualHull hull(card.known.scene, card.masks);
    const DepthView& view = card.known.scene.views[0];
    ASSERT_GT(view.disparity_px_per_inverse_depth, 0);
    const double one_pixel = 1 / view.disparity_px_per_inverse_depth;
    // The brute-force twin: true depths of the card that its outlines leave at this pixel.
    const auto is_inside = [&](double inverse_depth) {
        DepthMap map = Card::saying(static_cast<float>(inverse_depth), 255);
        hull.take_claims_outside(0, map);
        return map.confidence(kCardX, kCardY) != 0;
    };
    double nearest_inside = 1.0;
    while (!is_inside(nearest_inside)) nearest_inside -= 0.05 * one_pixel;
    DepthMap map = Card::saying(0.95F, 0);
    hull.move_fills_inside(0, map);
    EXPECT_NEAR(map.inverse_depth(kCardX, kCardY), nearest_inside, one_pixel);
    EXPECT_LE(map.inverse_depth(kCardX, kCardY), nearest_inside + 1e-6);
    EXPECT_GE(map.inverse_depth(kCardX, kCardY), kCardInverseDepth);
    EXPECT_EQ(map.confidence(kCardX, kCardY), 0);
    EXPECT_EQ(map.inverse_depth(3, 3), 0.95F) << "does not belong to the scene";
}

TEST(VisualHull, MovesNeitherWhatIsKnownNorWhatIsInside) {
    const Card card;
    const VisualHull hull(card.known.scene, card.masks);
    DepthMap known = Card::saying(0.95F, 128);
    hull.move_fills_inside(0, known);
    EXPECT_EQ(known.inverse_depth(kCardX, kCardY), 0.95F);
    DepthMap inside = Card::saying(kCardInverseDepth, 0);
    hull.move_fills_inside(0, inside);
    EXPECT_EQ(inside.inverse_depth(kCardX, kCardY), kCardInverseDepth);
}

TEST(VisualHull, ALookoutOverAnUnboundedRangeEnds) {
    // Two views farther back on the axis have nothing but background all along the ray of one
    // pixel.
    DepthScene scene;
    for (const double back : {0.0, 1.0, 2.0}) {
        DepthView& view = scene.views.emplace_back();
        view.camera = small_camera();
        view.cam_from_world = looking_ahead_from({0, 0, -back});
        view.disparity_px_per_inverse_depth = 40;
        view.range = {0, 1e12};
    }
    scene.views[0].neighbours = {1, 2};
    std::vector<GrayImage> masks(3, GrayImage(240, 180, 0));
    masks[0](kCardX, kCardY) = 255;
    DepthMap map = Card::saying(0.1F, 0);
    VisualHull(scene, masks).move_fills_inside(0, map);
    EXPECT_EQ(map.inverse_depth(kCardX, kCardY), 0.1F) << "there is no place inside";
}

TEST(VisualHull, ChangesNothingInAViewWithoutAMask) {
    Card card;
    card.masks[0] = {};
    const VisualHull hull(card.known.scene, card.masks);
    DepthMap claimed = Card::saying(0.95F, 255);
    hull.take_claims_outside(0, claimed);
    EXPECT_EQ(claimed.confidence(kCardX, kCardY), 255);
    DepthMap filled = Card::saying(0.95F, 0);
    hull.move_fills_inside(0, filled);
    EXPECT_EQ(filled.inverse_depth(kCardX, kCardY), 0.95F);
}

TEST(Subject, TakesBackWhatIsBeyondItOrOutsideUnlessTheClaimIsFinal) {
    const Card card;
    const Subject subject(card.known.scene, card.masks);
    for (const bool needs_confirmation : {true, false}) {
        DepthEstimate estimate{Card::saying(0.95F, 255), "", needs_confirmation, false};
        subject.leave_claims_within(0, estimate);
        EXPECT_EQ(estimate.map.confidence(3, 3), 0);
        EXPECT_EQ(estimate.map.confidence(kCardX, kCardY) == 0, needs_confirmation);
    }
}

TEST(Subject, IsWithinItsOutlinesAndBeforeTheBackgroundWhenItIsFilled) {
    const Card card;
    const Subject subject(card.known.scene, card.masks);
    for (const bool is_complete : {true, false}) {
        DepthMap map = Card::saying(0.95F, 0);
        const double background =
            subject.separate_from_background(0, {{}, "", true, is_complete}, map);
        EXPECT_NEAR(background, 1 - 44.0 * 44 / (240 * 180), 0.001);
        EXPECT_EQ(map.inverse_depth(3, 3), 0.0F);
        EXPECT_EQ(map.confidence(3, 3), 255);
        EXPECT_EQ(map.confidence(kCardX, kCardY), 1);
        EXPECT_EQ(map.inverse_depth(kCardX, kCardY) < 0.9F, !is_complete);
    }
}

}  // namespace
}  // namespace lumi
