#include "calib/ingest/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>

namespace lumi {
namespace {

constexpr int kStillWidth = 120;
constexpr int kStillHeight = 90;

/// Noise, blurred to the size of things, that the eye moves over.
class Scene {
 public:
    explicit Scene(int contrast = 90) {
        constexpr int kSize = 400;
        std::mt19937 random(3);
        Image<float> noise(kSize, kSize);
        for (float& value : noise.pixels()) {
            value = static_cast<float>(random() % 1000) / 500.0F - 1.0F;
        }
        levels_ = GrayImage(kSize - 4, kSize - 4);
        for (int y = 0; y < levels_.height(); ++y) {
            for (int x = 0; x < levels_.width(); ++x) {
                float sum = 0;
                for (int dy = 0; dy < 5; ++dy) {
                    for (int dx = 0; dx < 5; ++dx) sum += noise(x + dx, y + dy);
                }
                const float level = 120.0F + static_cast<float>(contrast) * 0.25F * sum;
                levels_(x, y) = static_cast<std::uint8_t>(std::clamp(level, 0.0F, 255.0F));
            }
        }
    }

    [[nodiscard]] ColorImage photograph(int left, int top) const {
        ColorImage picture(kStillWidth, kStillHeight);
        for (int y = 0; y < kStillHeight; ++y) {
            for (int x = 0; x < kStillWidth; ++x) {
                const std::uint8_t level = levels_(left + x, top + y);
                picture(x, y) = {level, level, level};
            }
        }
        return picture;
    }

 private:
    GrayImage levels_;
};

using Print = std::function<void(ColorImage&)>;

/// Of a camera that a hand moves.
Overlay overlay_printed(const Print& print, int photographs = 24, int contrast = 90) {
    const Scene scene(contrast);
    std::mt19937 random(5);
    StandingPixels standing(kStillWidth, kStillHeight);
    for (int i = 0; i < photographs; ++i) {
        ColorImage picture =
            scene.photograph(static_cast<int>(random() % 200), static_cast<int>(random() % 200));
        print(picture);
        standing.add(picture);
    }
    return overlay_of(standing);
}

void fill(ColorImage& picture, const ImageRectangle& area, Rgb8 color, double opacity = 1.0) {
    const auto mixed = [&](std::uint8_t below, std::uint8_t above) {
        return static_cast<std::uint8_t>(std::lround(opacity * above + (1 - opacity) * below));
    };
    for (int y = area.top; y < area.top + area.height_px; ++y) {
        for (int x = area.left; x < area.left + area.width_px; ++x) {
            const Rgb8 below = picture(x, y);
            picture(x, y) = {mixed(below.r, color.r), mixed(below.g, color.g),
                             mixed(below.b, color.b)};
        }
    }
}

constexpr Rgb8 kBlack{0, 0, 0};
constexpr Rgb8 kWhite{255, 255, 255};
constexpr Rgb8 kGrey{120, 120, 120};
constexpr ImageRectangle kWhole{0, 0, kStillWidth, kStillHeight};

/// Whether the mask covers the area, and nothing that lies further from it than its margins.
void expect_covers_just(const Overlay& overlay, const ImageRectangle& area) {
    ASSERT_FALSE(overlay.mask.empty());
    constexpr int kMargins_px = 10;
    for (int y = 0; y < overlay.mask.height(); ++y) {
        for (int x = 0; x < overlay.mask.width(); ++x) {
            const int beyond_x = std::max(area.left - x, x - area.left - area.width_px + 1);
            const int beyond_y = std::max(area.top - y, y - area.top - area.height_px + 1);
            const int beyond = std::max(beyond_x, beyond_y);
            const bool is_between = beyond > 0 && beyond <= kMargins_px;
            if (is_between) continue;
            EXPECT_EQ(overlay.mask(x, y), beyond <= 0 ? 0 : 255) << x << ", " << y;
        }
    }
}

TEST(Overlay, ThereIsNoneInPhotographsOfAMovingCamera) {
    const Overlay overlay = overlay_printed([](ColorImage&) {});
    EXPECT_EQ(overlay.picture, kWhole);
    EXPECT_TRUE(overlay.mask.empty());
    EXPECT_EQ(overlay.share, 0.0);
}

TEST(Overlay, ALabelIsCovered) {
    constexpr ImageRectangle kLabel{80, 60, 24, 12};
    const Overlay overlay =
        overlay_printed([&](ColorImage& picture) { fill(picture, kLabel, kWhite); });
    EXPECT_EQ(overlay.picture, kWhole);
    expect_covers_just(overlay, kLabel);
}

TEST(Overlay, ALabelOfTheScenesMeanColourIsCovered) {
    constexpr ImageRectangle kLabel{80, 60, 24, 12};
    const Overlay overlay =
        overlay_printed([&](ColorImage& picture) { fill(picture, kLabel, kGrey); });
    expect_covers_just(overlay, kLabel);
}

TEST(Overlay, ALabelThatTheSceneShinesThroughIsCovered) {
    constexpr ImageRectangle kLabel{40, 30, 30, 14};
    const Overlay overlay =
        overlay_printed([&](ColorImage& picture) { fill(picture, kLabel, kWhite, 0.75); }, 24, 40);
    expect_covers_just(overlay, kLabel);
}

TEST(Overlay, StrokesOfAWatermarkAreCovered) {
    constexpr ImageRectangle kStroke{20, 40, 70, 3};
    const Overlay overlay =
        overlay_printed([&](ColorImage& picture) { fill(picture, kStroke, kWhite, 0.5); }, 24, 40);
    expect_covers_just(overlay, kStroke);
}

/// Its luma is the scene's mean, and through it the scene changes more than print does.
TEST(Overlay, AStrokeThatOnlyItsColourTellsIsCovered) {
    constexpr ImageRectangle kStroke{20, 40, 70, 3};
    const Overlay overlay = overlay_printed([&](ColorImage& picture) {
        fill(picture, kStroke, {200, 105, 20}, 0.7);
    });
    expect_covers_just(overlay, kStroke);
}

/// How much light a round hood leaves: 0 to 1.
double light_in_hood(int x, int y) {
    constexpr double kSoft_px = 6;
    const double radius_px = 0.85 * std::hypot(0.5 * kStillWidth, 0.5 * kStillHeight);
    const double from_middle_px =
        std::hypot(x + 0.5 - 0.5 * kStillWidth, y + 0.5 - 0.5 * kStillHeight);
    return std::clamp((radius_px - from_middle_px) / kSoft_px + 0.5, 0.0, 1.0);
}

TEST(Overlay, CornersThatAHoodHidesAreCovered) {
    const auto hide_corners = [](ColorImage& picture) {
        for (int y = 0; y < kStillHeight; ++y)
            for (int x = 0; x < kStillWidth; ++x)
                fill(picture, {x, y, 1, 1}, kBlack, 1 - light_in_hood(x, y));
    };
    const Overlay overlay = overlay_printed(hide_corners, 24, 40);
    EXPECT_EQ(overlay.picture, kWhole);
    ASSERT_FALSE(overlay.mask.empty());
    for (int y = 0; y < kStillHeight; ++y) {
        for (int x = 0; x < kStillWidth; ++x) {
            if (light_in_hood(x, y) > 0.5) continue;
            EXPECT_EQ(overlay.mask(x, y), 0) << x << ", " << y;
        }
    }
    EXPECT_EQ(overlay.mask(0, kStillHeight / 2), 255);
    EXPECT_EQ(overlay.mask(kStillWidth / 2, 0), 255);
    EXPECT_LT(overlay.share, 0.2);
}

TEST(Overlay, BarsAreNoneOfThePicture) {
    const Overlay overlay = overlay_printed([](ColorImage& picture) {
        fill(picture, {0, 0, kStillWidth, 11}, kBlack);
        fill(picture, {0, kStillHeight - 7, kStillWidth, 7}, kBlack);
    });
    EXPECT_EQ(overlay.picture, (ImageRectangle{0, 13, kStillWidth, kStillHeight - 22}));
    EXPECT_TRUE(overlay.mask.empty());
}

TEST(Overlay, BarsAtTheSidesAreNoneOfThePicture) {
    const Overlay overlay = overlay_printed([](ColorImage& picture) {
        fill(picture, {0, 0, 20, kStillHeight}, kWhite);
        fill(picture, {kStillWidth - 20, 0, 20, kStillHeight}, kWhite);
    });
    EXPECT_EQ(overlay.picture, (ImageRectangle{22, 0, kStillWidth - 44, kStillHeight}));
}

TEST(Overlay, BarsOnAllSidesAreNoneOfThePicture) {
    const Overlay overlay = overlay_printed([](ColorImage& picture) {
        fill(picture, {0, 0, kStillWidth, 12}, kBlack);
        fill(picture, {0, kStillHeight - 12, kStillWidth, 12}, kBlack);
        fill(picture, {0, 0, 16, kStillHeight}, kBlack);
        fill(picture, {kStillWidth - 16, 0, 16, kStillHeight}, kBlack);
    });
    EXPECT_EQ(overlay.picture, (ImageRectangle{18, 14, kStillWidth - 36, kStillHeight - 28}));
    EXPECT_TRUE(overlay.mask.empty());
}

TEST(Overlay, BarsThatLeaveTooFewPixelsAreNone) {
    const Scene scene;
    std::mt19937 random(5);
    StandingPixels standing(kStillWidth, kStillHeight);
    for (int i = 0; i < 24; ++i) {
        ColorImage picture =
            scene.photograph(static_cast<int>(random() % 200), static_cast<int>(random() % 200));
        fill(picture, {0, 0, kStillWidth, 30}, kBlack);
        standing.add(picture);
    }
    EXPECT_EQ(overlay_of(standing, 50).picture.height_px, kStillHeight - 32);
    EXPECT_EQ(overlay_of(standing, 64).picture, kWhole);
}

TEST(Overlay, ALogoBesideABarIsFoundInWhatTheBarLeaves) {
    const Overlay overlay = overlay_printed([](ColorImage& picture) {
        fill(picture, {0, 0, kStillWidth, 10}, kBlack);
        fill(picture, {80, 60, 20, 10}, kWhite);
    });
    EXPECT_EQ(overlay.picture, (ImageRectangle{0, 12, kStillWidth, kStillHeight - 12}));
    expect_covers_just(overlay, {80, 48, 20, 10});
}

TEST(Overlay, FewPhotographsSayNothing) {
    const Overlay overlay = overlay_printed(
        [](ColorImage& picture) {
            fill(picture, {80, 60, 24, 12}, kWhite);
            fill(picture, {0, 0, kStillWidth, 10}, kBlack);
        },
        kFewestForOverlay - 1);
    EXPECT_EQ(overlay.picture, kWhole);
    EXPECT_TRUE(overlay.mask.empty());
}

TEST(Overlay, ALabelThatAFewPhotographsLackIsLeftIn) {
    int photograph = 0;
    const Overlay overlay = overlay_printed([&](ColorImage& picture) {
        if (photograph++ % 8 != 0) fill(picture, {80, 60, 24, 12}, kWhite);
    });
    EXPECT_TRUE(overlay.mask.empty());
}

TEST(Overlay, BarsThatLeaveLessThanAQuarterAreNone) {
    const Overlay overlay = overlay_printed([](ColorImage& picture) {
        fill(picture, {0, 0, kStillWidth, 70}, kBlack);
    });
    EXPECT_EQ(overlay.picture, kWhole);
}

/// As a plain sky over a scene that moves: it ends where the scene has it, not along a line.
TEST(Overlay, APlainPartOfTheSceneIsNone) {
    int photograph = 0;
    const Overlay overlay = overlay_printed([&](ColorImage& picture) {
        fill(picture, {0, 0, kStillWidth, 20 + (7 * photograph) % 25}, kWhite);
        ++photograph;
    });
    EXPECT_EQ(overlay.picture, kWhole);
    EXPECT_TRUE(overlay.mask.empty());
}

/// Of a turntable: only the middle of the picture changes.
TEST(Overlay, APlainBackgroundIsNone) {
    const Overlay overlay = overlay_printed([](ColorImage& picture) {
        fill(picture, {0, 0, kStillWidth, 20}, kBlack);
        fill(picture, {0, 70, kStillWidth, 20}, kBlack);
        fill(picture, {0, 0, 40, kStillHeight}, kBlack);
        fill(picture, {80, 0, 40, kStillHeight}, kBlack);
    });
    EXPECT_TRUE(overlay.mask.empty());
}

/// Of a turntable on a tripod: what turns stands before something that does not.
ImageRectangle picture_of_turntable(const Scene& backdrop, const ImageRectangle& turning) {
    const Scene scene;
    StandingPixels standing(kStillWidth, kStillHeight);
    for (int i = 0; i < 16; ++i) {
        ColorImage picture = backdrop.photograph(200, 100);
        const ColorImage subject = scene.photograph(11 * i, 50);
        for (int y = turning.top; y < turning.top + turning.height_px; ++y)
            for (int x = turning.left; x < turning.left + turning.width_px; ++x)
                picture(x, y) = subject(x, y);
        standing.add(picture);
    }
    return overlay_of(standing).picture;
}

TEST(Overlay, AStillBackdropWithAPatternIsNoBar) {
    EXPECT_EQ(picture_of_turntable(Scene(), {35, 30, 60, 48}), kWhole);
    EXPECT_EQ(picture_of_turntable(Scene(), {30, 20, 60, 50}), kWhole) << "in the middle";
}

TEST(Overlay, APlainBackdropBesideWhatTurnsIsNoBar) {
    const Scene plain(0);
    EXPECT_EQ(picture_of_turntable(plain, {35, 30, 60, 48}), kWhole);
    EXPECT_EQ(picture_of_turntable(plain, {30, 30, 60, 48}), kWhole) << "below the middle";
}

/// On all four sides, of these widths.
void frame(ColorImage& picture, int above, int below, int beside, Rgb8 color) {
    fill(picture, {0, 0, kStillWidth, above}, color);
    fill(picture, {0, kStillHeight - below, kStillWidth, below}, color);
    fill(picture, {0, 0, beside, kStillHeight}, color);
    fill(picture, {kStillWidth - beside, 0, beside, kStillHeight}, color);
}

/// Amid a wheel that turns, the backdrop may always be seen.
TEST(Overlay, APieceOfThePlainBackdropAmidWhatTurnsIsNone) {
    constexpr double kRadius_px = 40;
    constexpr double kSoft_px = 10;
    const Scene scene(40);
    StandingPixels standing(kStillWidth, kStillHeight);
    for (int i = 0; i < 16; ++i) {
        ColorImage picture = scene.photograph(11 * i, 50);
        for (int y = 0; y < kStillHeight; ++y) {
            for (int x = 0; x < kStillWidth; ++x) {
                const double inside_px = kRadius_px - std::hypot(x - 60, y - 45);
                const double scene_share = std::clamp(inside_px / kSoft_px, 0.0, 1.0);
                fill(picture, {x, y, 1, 1}, kWhite, 1 - scene_share);
            }
        }
        fill(picture, {55, 40, 10, 10}, kWhite);
        standing.add(picture);
    }
    const Overlay overlay = overlay_of(standing);
    EXPECT_EQ(overlay.picture, kWhole);
    EXPECT_TRUE(overlay.mask.empty());
}

/// A subject that stands on a straight edge, with its plain backdrop below that, too.
TEST(Overlay, ThePlainBackdropBelowAStraightEdgeIsNoBar) {
    constexpr int kEdge = 78;
    const Scene scene;
    StandingPixels standing(kStillWidth, kStillHeight);
    for (int i = 0; i < 16; ++i) {
        ColorImage picture = scene.photograph(11 * i, 50);
        for (int y = 0; y < kStillHeight; ++y) {
            const int beside = y >= 26 && y < kEdge ? kEdge - y + 3 : kStillWidth / 2;
            fill(picture, {0, y, beside, 1}, kWhite);
            fill(picture, {kStillWidth - beside, y, beside, 1}, kWhite);
        }
        standing.add(picture);
    }
    EXPECT_EQ(overlay_of(standing).picture, kWhole);
}

TEST(Overlay, AFrameMayBeWiderBelowWhereItIsBlackOrWhiteButNotGrey) {
    const auto picture_in_frame_of = [](Rgb8 color) {
        return overlay_printed([&](ColorImage& picture) { frame(picture, 8, 24, 8, color); })
            .picture;
    };
    const ImageRectangle inside{10, 10, kStillWidth - 20, kStillHeight - 36};
    EXPECT_EQ(picture_in_frame_of(kWhite), inside);
    EXPECT_EQ(picture_in_frame_of(kBlack), inside);
    EXPECT_EQ(picture_in_frame_of(kGrey), kWhole);
}

TEST(Overlay, AFrameThatIsBlackAboveAndWhiteBesideIsAFrameOnlyInTheMiddle) {
    const auto picture_with_margin_above = [](int above) {
        return overlay_printed([&](ColorImage& picture) {
                   frame(picture, above, 8, 8, kWhite);
                   fill(picture, {0, 0, kStillWidth, above}, kBlack);
               })
            .picture;
    };
    EXPECT_EQ(picture_with_margin_above(8),
              (ImageRectangle{10, 10, kStillWidth - 20, kStillHeight - 20}));
    EXPECT_EQ(picture_with_margin_above(24), kWhole);
}

TEST(Overlay, ABarMayHaveACaptionOverMostOfItsWidth) {
    const Overlay overlay = overlay_printed([](ColorImage& picture) {
        fill(picture, {0, 66, kStillWidth, 24}, kBlack);
        for (int x = 10; x < 110; x += 4) fill(picture, {x, 74, 2, 8}, kWhite);
    });
    EXPECT_EQ(overlay.picture, (ImageRectangle{0, 0, kStillWidth, 64}));
    EXPECT_TRUE(overlay.mask.empty());
}

TEST(Overlay, ABarMayHaveALineOfTextInIt) {
    const Overlay overlay = overlay_printed([](ColorImage& picture) {
        fill(picture, {0, 70, kStillWidth, 20}, kBlack);
        for (int x = 20; x < 40; x += 4) fill(picture, {x, 77, 2, 6}, kWhite);
    });
    EXPECT_EQ(overlay.picture, (ImageRectangle{0, 0, kStillWidth, 68}));
}

TEST(Overlay, NothingIsWhereTheCameraStoodStill) {
    const Scene scene;
    StandingPixels standing(kStillWidth, kStillHeight);
    for (int i = 0; i < 16; ++i) standing.add(scene.photograph(50, 50));
    const Overlay overlay = overlay_of(standing);
    EXPECT_EQ(overlay.picture, kWhole);
    EXPECT_TRUE(overlay.mask.empty());
}

/// Three depths: what is far stands still, what is nearer moves by up to three pixels, and what is
/// near by many.
TEST(Overlay, TheFarEndOfAStraightRailIsNone) {
    const Scene scene;
    StandingPixels standing(kStillWidth, kStillHeight);
    for (int i = 0; i < 16; ++i) {
        const ColorImage far = scene.photograph(50, 50);
        const ColorImage nearer = scene.photograph(50 + i / 5, 50);
        ColorImage picture = scene.photograph(50 + 9 * i, 50);
        for (int y = 0; y < kStillHeight; ++y) {
            for (int x = 0; x < kStillWidth; ++x) {
                if (x < 15) picture(x, y) = far(x, y);
                if (x >= 15 && x < 60) picture(x, y) = nearer(x, y);
            }
        }
        standing.add(picture);
    }
    EXPECT_TRUE(overlay_of(standing).mask.empty());
}

}  // namespace
}  // namespace lumi
