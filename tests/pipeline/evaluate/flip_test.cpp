#include "pipeline/evaluate/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "pipeline/evaluate/opponent_color.h"
#include "tests/calib/photographs.h"

namespace lumi {
namespace {

constexpr double kPi = std::numbers::pi;

ColorImage smooth_noise(int width, int height, std::uint32_t seed) {
    std::mt19937 random(seed);
    ColorImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto wave = [&](double period) {
                const double value = 0.5 + 0.4 * std::sin(2 * kPi * (x + 0.7 * y) / period);
                return static_cast<std::uint8_t>(255 * value + static_cast<double>(random() % 20));
            };
            image(x, y) = {wave(17), wave(29), wave(11)};
        }
    }
    return image;
}

/// A kernel with weights for every place of a square.
struct SquareKernel {
    int radius = 0;
    std::vector<double> weights;
};

double convolved(const Image<double>& image, const SquareKernel& kernel, int x, int y) {
    double sum = 0.0;
    std::size_t k = 0;
    for (int v = -kernel.radius; v <= kernel.radius; ++v) {
        for (int u = -kernel.radius; u <= kernel.radius; ++u) {
            sum += kernel.weights[k++] * image(std::clamp(x + u, 0, image.width() - 1),
                                               std::clamp(y + v, 0, image.height() - 1));
        }
    }
    return sum;
}

/// The paper's equation 3 sampled on the full square, weights summing to 1.
SquareKernel sensitivity(double a1, double b1, double a2, double b2, double ppd) {
    SquareKernel kernel;
    kernel.radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd));
    double sum = 0.0;
    for (int v = -kernel.radius; v <= kernel.radius; ++v) {
        for (int u = -kernel.radius; u <= kernel.radius; ++u) {
            const double z = (u * u + v * v) / (ppd * ppd);
            kernel.weights.push_back(a1 * std::sqrt(kPi / b1) * std::exp(-kPi * kPi * z / b1) +
                                     a2 * std::sqrt(kPi / b2) * std::exp(-kPi * kPi * z / b2));
            sum += kernel.weights.back();
        }
    }
    for (double& weight : kernel.weights) weight /= sum;
    return kernel;
}

/// The paper's equations 6 and 7: derivatives of a Gaussian; `transposed` is the one along y.
SquareKernel feature(bool is_edge, bool transposed, double ppd) {
    const double sd = 0.5 * 0.082 * ppd;
    SquareKernel kernel;
    kernel.radius = static_cast<int>(std::ceil(3 * sd));
    double positive = 0.0;
    double negative = 0.0;
    for (int v = -kernel.radius; v <= kernel.radius; ++v) {
        for (int u = -kernel.radius; u <= kernel.radius; ++u) {
            const double x = transposed ? v : u;
            const double gaussian = std::exp(-(u * u + v * v) / (2 * sd * sd));
            kernel.weights.push_back((is_edge ? -x : x * x / (sd * sd) - 1) * gaussian);
            (kernel.weights.back() > 0 ? positive : negative) += std::abs(kernel.weights.back());
        }
    }
    for (double& weight : kernel.weights) weight /= weight > 0 ? positive : negative;
    return kernel;
}

/// One channel of the opponent picture.
Image<double> channel(const ColorImage& image, std::size_t index) {
    Image<double> result(image.width(), image.height());
    for (std::size_t i = 0; i < result.pixels().size(); ++i) {
        result.pixels()[i] =
            static_cast<double>(opponent_from_linear(linear_from_srgb(image.pixels()[i]))[index]);
    }
    return result;
}

/// The paper to the letter at one pixel: full kernels, nothing separated.
double flip_at(const ColorImage& reference, const ColorImage& test, int x, int y, double ppd) {
    const std::array<SquareKernel, 3> csf{sensitivity(1, 0.0047, 0, 1e-5, ppd),
                                          sensitivity(1, 0.0053, 0, 1e-5, ppd),
                                          sensitivity(34.1, 0.04, 13.5, 0.025, ppd)};
    std::array<Color3, 2> lab;
    std::array<double, 2> edge;
    std::array<double, 2> point;
    const std::array<const ColorImage*, 2> pictures{&reference, &test};
    for (std::size_t p = 0; p < 2; ++p) {
        Color3 seen;
        for (std::size_t k = 0; k < 3; ++k) {
            seen[k] = static_cast<float>(convolved(channel(*pictures[p], k), csf[k], x, y));
        }
        lab[p] = hunt_adjusted_lab(clamped(linear_from_opponent(seen)));
        Image<double> luminance = channel(*pictures[p], 0);
        for (double& value : luminance.pixels()) value = (value + 16) / 116;
        edge[p] = std::hypot(convolved(luminance, feature(true, false, ppd), x, y),
                             convolved(luminance, feature(true, true, ppd), x, y));
        point[p] = std::hypot(convolved(luminance, feature(false, false, ppd), x, y),
                              convolved(luminance, feature(false, true, ppd), x, y));
    }
    const auto hyab = [](const Color3& a, const Color3& b) {
        return static_cast<double>(std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]));
    };
    const double largest =
        std::pow(hyab(hunt_adjusted_lab({0, 1, 0}), hunt_adjusted_lab({0, 0, 1})), 0.7);
    const double power = std::pow(hyab(lab[0], lab[1]), 0.7);
    const double knee = 0.4 * largest;
    const double color =
        power < knee ? 0.95 / knee * power : 0.95 + (power - knee) / (largest - knee) * 0.05;
    const double features = std::sqrt(
        std::max(std::abs(edge[0] - edge[1]), std::abs(point[0] - point[1])) / std::sqrt(2.0));
    return std::pow(color, 1 - features);
}

TEST(Flip, EqualPicturesHaveNoError) {
    const ColorImage picture = smooth_noise(60, 40, 1);
    EXPECT_EQ(mean_error(flip_error_map(picture, picture)), 0.0);
}

TEST(Flip, PureGreenAgainstPureBlueIsTheLargestError) {
    const ColorImage green(30, 30, {0, 255, 0});
    const ColorImage blue(30, 30, {0, 0, 255});
    EXPECT_NEAR(mean_error(flip_error_map(green, blue)), 1.0, 1e-5);
}

TEST(Flip, BlackAgainstWhiteFollowsFromTheirLightness) {
    // Lightness differs by 100, chroma by nothing, no features: eq. 4, 5 and 9 by hand.
    const ColorImage black(30, 30, {0, 0, 0});
    const ColorImage white(30, 30, {255, 255, 255});
    const Color3 green = hunt_adjusted_lab({0, 1, 0});
    const Color3 blue = hunt_adjusted_lab({0, 0, 1});
    const double largest = std::pow(
        std::abs(green[0] - blue[0]) + std::hypot(green[1] - blue[1], green[2] - blue[2]), 0.7);
    const double expected = 0.95 + (std::pow(100.0, 0.7) - 0.4 * largest) / (0.6 * largest) * 0.05;
    EXPECT_NEAR(mean_error(flip_error_map(black, white)), expected, 1e-4);
}

TEST(Flip, EqualsThePaperWithoutSeparatedFilters) {
    const ColorImage reference = smooth_noise(48, 36, 1);
    ColorImage test = smooth_noise(48, 36, 2);
    for (int y = 10; y < 20; ++y) {
        for (int x = 8; x < 30; ++x) test(x, y) = {200, 30, 90};
    }
    const FloatImage map = flip_error_map(reference, test);
    for (const auto& [x, y] : {std::pair{0, 0}, {47, 35}, {8, 10}, {20, 15}, {29, 20}, {40, 5}}) {
        EXPECT_NEAR(static_cast<double>(map(x, y)),
                    flip_at(reference, test, x, y, kFlipPixelsPerDegree), 2e-4)
            << x << ", " << y;
    }
}

/// A ramp that wraps around, in checks of 8 x 8 pixels that are `lift` apart, moved by `shift_px`.
ColorImage checked_ramp(int shift_px, int lift) {
    ColorImage image(96, 64);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const int raised = lift * (((x / 8) ^ (y / 8)) & 1);
            const auto channel = [&](int index) {
                const int value = 2 * (x + shift_px) + 3 * y + 40 * index + raised;
                return static_cast<std::uint8_t>(value % 256);
            };
            image(x, y) = {channel(0), channel(1), channel(2)};
        }
    }
    return image;
}

TEST(Flip, EqualsTheAuthorsProgram) {
    // flip_api.py of github.com/NVlabs/flip (commit 313517b), with NumPy 1.24 and OpenCV 4.6.
    const FloatImage map = flip_error_map(checked_ramp(0, 0), checked_ramp(2, 40));
    EXPECT_NEAR(mean_error(map), 0.621846, 1e-4);
    EXPECT_NEAR(map(20, 10), 0.564866, 5e-4);
    EXPECT_NEAR(map(70, 40), 0.490953, 5e-4);
}

TEST(Flip, EqualsThePublishedFigureOfTheAuthorsPair) {
    const std::filesystem::path pair = photographs_folder() / "flip";
    if (!std::filesystem::exists(pair / "reference.png")) {
        GTEST_SKIP() << pair / "reference.png"
                     << " and test.png of github.com/NVlabs/flip (images)"
                     << " are not there; set LUMI_PHOTOS";
    }
    const FloatImage map = flip_error_map(read_color_image(pair / "reference.png"),
                                          read_color_image(pair / "test.png"));
    EXPECT_NEAR(mean_error(map), 0.159691, 1e-3);
}

TEST(Flip, DoesNotMindWhichPictureIsTheReference) {
    const ColorImage a = smooth_noise(50, 30, 1);
    const ColorImage b = smooth_noise(50, 30, 5);
    EXPECT_NEAR(mean_error(flip_error_map(a, b)), mean_error(flip_error_map(b, a)), 1e-6);
}

TEST(Flip, SeesLessFromFurtherAway) {
    ColorImage checkered(64, 64, {100, 100, 100});
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            if ((x + y) % 2 == 0) checkered(x, y) = {156, 156, 156};
        }
    }
    const ColorImage grey(64, 64, {130, 130, 130});
    EXPECT_LT(mean_error(flip_error_map(grey, checkered, 120.0)),
              mean_error(flip_error_map(grey, checkered, 20.0)));
}

TEST(Flip, CoveredMeanLooksAtCoveredPixelsAlone) {
    FloatImage map(2, 1);
    map(0, 0) = 0.5F;
    map(1, 0) = 0.1F;
    GrayImage coverage(2, 1, 0);
    EXPECT_FALSE(mean_error(map, coverage).has_value());
    coverage(0, 0) = 255;
    EXPECT_DOUBLE_EQ(*mean_error(map, coverage), 0.5);
}

TEST(Flip, RefusesPicturesOfDifferentSize) {
    EXPECT_THROW(static_cast<void>(flip_error_map(ColorImage(4, 4), ColorImage(5, 4))), Error);
}

TEST(OpponentColor, WhiteIsWhiteAndTheWayBackIsTheWayThere) {
    const Color3 white = opponent_from_linear({1, 1, 1});
    EXPECT_NEAR(white[0], 100.0F, 1e-3F);
    EXPECT_NEAR(white[1], 0.0F, 1e-3F);
    EXPECT_NEAR(white[2], 0.0F, 1e-3F);
    const Color3 back = linear_from_opponent(opponent_from_linear({0.2F, 0.7F, 0.05F}));
    EXPECT_NEAR(back[0], 0.2F, 1e-5F);
    EXPECT_NEAR(back[1], 0.7F, 1e-5F);
    EXPECT_NEAR(back[2], 0.05F, 1e-5F);
}

TEST(OpponentColor, LabOfPureRedIsThePublishedOne) {
    // CIE L*a*b* of sRGB red under D65: 53.24, 80.09, 67.20; Hunt's factor is L / 100.
    const Color3 red = hunt_adjusted_lab({1, 0, 0});
    EXPECT_NEAR(red[0], 53.24F, 0.02F);
    EXPECT_NEAR(red[1] / (0.01F * red[0]), 80.09F, 0.1F);
    EXPECT_NEAR(red[2] / (0.01F * red[0]), 67.20F, 0.1F);
}

}  // namespace
}  // namespace lumi
