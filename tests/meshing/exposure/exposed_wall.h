#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "calib/capture/light_left.h"
#include "calib/pictures/srgb_curve.h"
#include "meshing/surface/pictured_view.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {

/// Photographs of a textured wall with exact depth, each exposed in its own way.
class ExposedWall {
 public:
    explicit ExposedWall(int views) {
        std::vector<Eigen::Vector3d> centres;
        for (int i = 0; i < views; ++i) centres.emplace_back(0.35 * (i % 3), 0.3 * (i / 3), 0.0);
        const TexturedPlane wall{{0, 0, 3},
                                 Eigen::Vector3d(0.1, 0.05, -1).normalized(),
                                 [](const Eigen::Vector3d&) { return true; },
                                 noise_texture(0.05, 7)};
        known_ = known_depth_scene({wall}, centres, {0.1, 1.0});
        for (const FloatImage& inverse_depth : known_.inverse_depths) {
            depths_.push_back(
                {inverse_depth, GrayImage(inverse_depth.width(), inverse_depth.height(), 255)});
        }
    }

    void expose(int view, const Eigen::Array3d& factors) {
        for (Rgb8& pixel : photograph(view).pixels()) {
            pixel = {exposed(pixel.r, factors[0]), exposed(pixel.g, factors[1]),
                     exposed(pixel.b, factors[2])};
        }
    }
    void add_noise(double sigma) {
        std::mt19937 random(11);
        std::normal_distribution<double> noise(0.0, sigma);
        for (std::size_t i = 0; i < depths_.size(); ++i) {
            for (Rgb8& pixel : photograph(static_cast<int>(i)).pixels()) {
                for (std::uint8_t* value : {&pixel.r, &pixel.g, &pixel.b}) {
                    *value = static_cast<std::uint8_t>(
                        std::lround(std::clamp(*value + noise(random), 0.0, 255.0)));
                }
            }
        }
    }
    /// Light that falls on the wall differently from where a view stands: so much more of it per
    /// width of the picture, and as much as ever in the middle.
    void shade(int view, double slope) {
        ColorImage& picture = photograph(view);
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const double factor = 1 + slope * ((x + 0.5) / picture.width() - 0.5);
                Rgb8& pixel = picture(x, y);
                pixel = {exposed(pixel.r, factor), exposed(pixel.g, factor),
                         exposed(pixel.b, factor)};
            }
        }
    }
    /// A highlight that stands elsewhere in each photograph.
    void add_highlights() {
        for (std::size_t i = 0; i < depths_.size(); ++i) {
            ColorImage& picture = photograph(static_cast<int>(i));
            const int left = 20 + static_cast<int>(23 * i) % 150;
            for (int y = 40; y < 80; ++y) {
                for (int x = left; x < left + 40; ++x) picture(x, y) = {240, 235, 230};
            }
        }
    }

    /// Depth that is not seen but filled, all over the wall.
    void forget_depth(std::uint8_t confidence) {
        for (DepthMap& depth : depths_)
            std::fill(depth.confidence.pixels().begin(), depth.confidence.pixels().end(),
                      confidence);
    }

    /// As a lens of such a falloff does (light_left.h).
    void darken_corners(double falloff) {
        for (std::size_t i = 0; i < depths_.size(); ++i) {
            const Camera& camera = known_.scene.views[i].camera;
            ColorImage& picture = photograph(static_cast<int>(i));
            for (int y = 0; y < picture.height(); ++y) {
                for (int x = 0; x < picture.width(); ++x) {
                    const double left = light_left(falloff, camera, {x + 0.5, y + 0.5});
                    Rgb8& pixel = picture(x, y);
                    pixel = {exposed(pixel.r, left), exposed(pixel.g, left),
                             exposed(pixel.b, left)};
                }
            }
        }
    }

    [[nodiscard]] std::vector<PicturedView> views() {
        std::vector<PicturedView> views;
        for (std::size_t i = 0; i < depths_.size(); ++i) {
            const DepthView& view = known_.scene.views[i];
            views.push_back({&view.photograph, view.camera, view.cam_from_world, &depths_[i]});
        }
        return views;
    }
    [[nodiscard]] ColorImage& photograph(int view) {
        return known_.scene.views[static_cast<std::size_t>(view)].photograph;
    }

 private:
    static std::uint8_t exposed(std::uint8_t value, double factor) {
        return static_cast<std::uint8_t>(
            std::lround(255.0 * srgb_of_light(factor * light_of_srgb(value / 255.0))));
    }

    KnownDepthScene known_;
    std::vector<DepthMap> depths_;
};

}  // namespace lumi
