#include "render/lumigraph/even_exposure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "calib/capture/light_left.h"
#include "calib/pictures/srgb_curve.h"
#include "render/reference/reference_renderer.h"
#include "tests/render/analytic_scene.h"
#include "tests/render/frame_difference.h"

namespace lumi {
namespace {

std::uint8_t exposed(std::uint8_t value, double factor) {
    return static_cast<std::uint8_t>(
        std::lround(255.0 * srgb_of_light(factor * light_of_srgb(value / 255.0))));
}

TEST(EvenExposures, DrawWronglyExposedPhotographsAsIfTheyWereNot) {
    const Lumigraph truth = card_before_wall();
    Lumigraph wrong = truth;
    for (std::size_t i = 0; i < wrong.views.size(); ++i) {
        LumigraphView& view = wrong.views[i];
        for (std::size_t channel = 0; channel < 3; ++channel) {
            // Darker, so that nothing is lost to saturation.
            const double factor = 1.0 - 0.1 * static_cast<double>((3 * i + channel) % 5);
            view.exposure_gain[channel] = 1.0 / factor;
        }
        for (Rgb8& pixel : view.photograph.pixels()) {
            pixel = {exposed(pixel.r, 1.0 / view.exposure_gain[0]),
                     exposed(pixel.g, 1.0 / view.exposure_gain[1]),
                     exposed(pixel.b, 1.0 / view.exposure_gain[2])};
        }
    }
    Lumigraph evened = wrong;
    even_exposures(evened);
    const Eye eye = eye_at({0.2, 0.1, 0.1}, {0, 0, 4}, pinhole_camera(64, 48, 60));
    const ColorImage drawn = draw_reference(truth, eye, {}).color;
    const FrameDifference after = difference_between(drawn, draw_reference(evened, eye, {}).color);
    EXPECT_LT(after.mean, 0.5);
    EXPECT_LE(after.largest, 2);
    EXPECT_GT(difference_between(drawn, draw_reference(wrong, eye, {}).color).mean, 4.0);
}

TEST(EvenExposures, KeepBlackBlackAndWhiteWhiteAndTheOrderOfAllBetween) {
    for (const double gain : {0.25, 0.8, 1.0, 1.3, 4.0}) {
        Lumigraph lumigraph;
        lumigraph.views.resize(1);
        LumigraphView& view = lumigraph.views.front();
        view.exposure_gain = {gain, gain, gain};
        view.camera = pinhole_camera(256, 1, 200);
        view.photograph = ColorImage(256, 1);
        for (int x = 0; x < 256; ++x) {
            const auto value = static_cast<std::uint8_t>(x);
            view.photograph(x, 0) = {value, value, value};
        }
        even_exposures(lumigraph);
        EXPECT_EQ(view.exposure_gain, kNoExposureGain);
        EXPECT_EQ(view.photograph(0, 0).g, 0);
        EXPECT_EQ(view.photograph(255, 0).g, 255);
        EXPECT_EQ(view.photograph(120, 0).b, exposed(120, gain));
        for (int x = 1; x < 256; ++x) {
            EXPECT_GE(view.photograph(x, 0).r, view.photograph(x - 1, 0).r);
        }
    }
}

/// All 8-bit values, one a row.
ColorImage ramp(int width_px) {
    ColorImage picture(width_px, 256);
    for (int y = 0; y < 256; ++y) {
        const auto value = static_cast<std::uint8_t>(y);
        for (int x = 0; x < width_px; ++x) picture(x, y) = {value, value, value};
    }
    return picture;
}

TEST(EvenExposures, TakeOutWhatALensDarkens) {
    const Lumigraph truth = card_before_wall();
    Lumigraph dark = truth;
    for (LumigraphView& view : dark.views)
        for (int y = 0; y < view.photograph.height(); ++y)
            for (int x = 0; x < view.photograph.width(); ++x) {
                const double left = light_left(-1.5, view.camera, {x + 0.5, y + 0.5});
                Rgb8& pixel = view.photograph(x, y);
                pixel = {exposed(pixel.r, left), exposed(pixel.g, left), exposed(pixel.b, left)};
            }
    dark.light_falloff = -1.5;
    Lumigraph evened = dark;
    even_exposures(evened);
    EXPECT_EQ(evened.light_falloff, 0.0);
    EXPECT_EQ(evened.evened_falloff, -1.5);
    for (std::size_t i = 0; i < truth.views.size(); ++i) {
        const ColorImage& wanted = truth.views[i].photograph;
        EXPECT_GT(difference_between(wanted, dark.views[i].photograph).mean, 4.0);
        EXPECT_LT(difference_between(wanted, evened.views[i].photograph).mean, 0.6);
        EXPECT_LE(difference_between(wanted, evened.views[i].photograph).largest, 2);
    }
}

TEST(EvenExposures, AreUndoneByTheLensThatTheyWereMadeFor) {
    constexpr double kFalloff = -2.0;
    const Camera camera = pinhole_camera(64, 256, 160);
    const ColorImage taken = ramp(64);
    const ColorImage evened = without_falloff(taken, camera, kFalloff);
    const FrameDifference back =
        difference_between(taken, darkened_by_lens(evened, camera, kFalloff));
    EXPECT_LE(back.largest, 2) << "nothing is lost, also next to white";
    for (int y = 1; y < 256; ++y) ASSERT_GE(evened(0, y).g, evened(0, y - 1).g);
    const Eigen::Vector2d corner(0.5, 60.5);
    EXPECT_NEAR(evened(0, 60).g, exposed(60, 1 / light_left(kFalloff, camera, corner)), 1);
    EXPECT_EQ(evened(32, 128).g, taken(32, 128).g) << "the middle stays";
}

}  // namespace
}  // namespace lumi
