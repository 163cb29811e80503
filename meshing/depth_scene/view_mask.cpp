#include "meshing/depth_scene/view_mask.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "calib/pictures/drawn_mask.h"
#include "calib/work/parallel_for.h"
#include "meshing/exposure/color_match.h"

namespace lumi {
namespace {

constexpr int kSimilar = 14;  // 8-bit levels: sensor noise and the falling off of a flash.

/// Pixels of the frame along the border, a fiftieth of the picture wide.
std::vector<Rgb8> border_pixels(const ColorImage& picture) {
    const int margin = std::max(1, std::min(picture.width(), picture.height()) / 50);
    std::vector<Rgb8> pixels;
    for (int y = 0; y < picture.height(); ++y) {
        const bool whole_row = y < margin || y >= picture.height() - margin;
        for (int x = 0; x < picture.width(); ++x) {
            if (whole_row || x < margin || x >= picture.width() - margin) {
                pixels.push_back(picture(x, y));
            }
        }
    }
    return pixels;
}

/// The median of each channel.
Rgb8 median_color(const std::vector<Rgb8>& pixels) {
    const auto median = [&](auto channel) {
        std::array<std::size_t, 256> counts{};
        for (const Rgb8& pixel : pixels) ++counts[channel(pixel)];
        std::size_t below = 0;
        for (std::size_t level = 0; level < counts.size(); ++level) {
            below += counts[level];
            if (2 * below >= pixels.size()) return static_cast<std::uint8_t>(level);
        }
        return std::uint8_t{255};
    };
    return {median([](const Rgb8& p) { return p.r; }), median([](const Rgb8& p) { return p.g; }),
            median([](const Rgb8& p) { return p.b; })};
}

double similar_share(const std::vector<Rgb8>& pixels, Rgb8 color) {
    const auto similar = std::count_if(pixels.begin(), pixels.end(), [&](const Rgb8& pixel) {
        return largest_difference(pixel, color) <= kSimilar;
    });
    return static_cast<double>(similar) / std::max<double>(1, static_cast<double>(pixels.size()));
}

}  // namespace

std::optional<Rgb8> plain_background(const DepthScene& scene) {
    constexpr double kBorderShare = 0.9;
    constexpr double kViewShare = 0.9;
    std::vector<Rgb8> colors;
    for (const DepthView& view : scene.views) {
        const std::vector<Rgb8> border = border_pixels(view.photograph);
        const Rgb8 color = median_color(border);
        if (similar_share(border, color) >= kBorderShare) colors.push_back(color);
    }
    const auto views = static_cast<double>(scene.views.size());
    if (colors.empty() || static_cast<double>(colors.size()) < kViewShare * views) {
        return std::nullopt;
    }
    const Rgb8 color = median_color(colors);
    if (similar_share(colors, color) * static_cast<double>(colors.size()) < kViewShare * views) {
        return std::nullopt;
    }
    // Photographs of a plain wall have no background: they have no scene.
    constexpr double kSceneShare = 0.02;
    const bool shows_scene =
        std::any_of(scene.views.begin(), scene.views.end(), [&](const DepthView& view) {
            return 1 - similar_share(view.photograph.pixels(), color) >= kSceneShare;
        });
    return shows_scene ? std::optional(color) : std::nullopt;
}

GrayImage mask_of_background(const ColorImage& picture, Rgb8 background) {
    const int width = picture.width();
    GrayImage mask(width, picture.height(), 255);
    std::vector<int> front;
    const auto reach = [&](int x, int y) {
        if (!mask.contains(x, y) || mask(x, y) == 0) return;
        if (largest_difference(picture(x, y), background) > kSimilar) return;
        mask(x, y) = 0;
        front.push_back(y * width + x);
    };
    for (int x = 0; x < width; ++x) {
        reach(x, 0);
        reach(x, picture.height() - 1);
    }
    for (int y = 0; y < picture.height(); ++y) {
        reach(0, y);
        reach(width - 1, y);
    }
    while (!front.empty()) {
        const int x = front.back() % width;
        const int y = front.back() / width;
        front.pop_back();
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            reach(x + dx, y + dy);
        }
    }
    return mask;
}

bool holds_the_scene(const std::vector<GrayImage>& masks, const DepthScene& scene) {
    constexpr double kBackdropDensity = 0.2;
    double points_beyond = 0;
    double points = 0;
    double pixels_beyond = 0;
    double pixels = 0;
    for (std::size_t i = 0; i < masks.size(); ++i) {
        const GrayImage& mask = masks[i];
        const auto beyond = std::count(mask.pixels().begin(), mask.pixels().end(), 0);
        pixels_beyond += static_cast<double>(beyond);
        pixels += static_cast<double>(mask.pixels().size());
        for (const SparsePoint& point : scene.views[i].points) {
            const Eigen::Vector2i pixel = point.pixel.array().floor().cast<int>();
            if (!mask.contains(pixel.x(), pixel.y())) continue;
            ++points;
            if (mask(pixel.x(), pixel.y()) == 0) ++points_beyond;
        }
    }
    const double points_before = points - points_beyond;
    // Densities compared, without a quotient that may be none.
    return points_beyond * (pixels - pixels_beyond) >
           kBackdropDensity * points_before * pixels_beyond;
}

SceneMasks scene_masks(const DepthScene& scene, const std::filesystem::path& folder,
                       bool looks_for_background, int threads) {
    const bool is_drawn = !folder.empty();
    SceneMasks masks{std::vector<GrayImage>(scene.views.size()),
                     !is_drawn && looks_for_background ? plain_background(scene) : std::nullopt};
    if (!is_drawn && !masks.background) return masks;
    parallel_for(static_cast<int>(scene.views.size()), threads, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        const DepthView& view = scene.views[index];
        masks.of_views[index] =
            is_drawn ? drawn_mask(view.name, view.camera.width_px, view.camera.height_px, folder)
                     : mask_of_background(view.photograph, *masks.background);
    });
    if (!is_drawn && holds_the_scene(masks.of_views, scene))
        return {std::vector<GrayImage>(scene.views.size()), std::nullopt};
    return masks;
}

void claim_nothing_beyond(const GrayImage& mask, DepthMap& map) {
    for (std::size_t i = 0; i < mask.pixels().size(); ++i) {
        if (mask.pixels()[i] == 0) map.confidence.pixels()[i] = 0;
    }
}

double separate_background(const GrayImage& mask, DepthMap& map) {
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < mask.pixels().size(); ++i) {
        std::uint8_t& confidence = map.confidence.pixels()[i];
        if (mask.pixels()[i] != 0) {
            confidence = std::max(confidence, kFilledBeforeBackground);
            continue;
        }
        map.inverse_depth.pixels()[i] = 0.0F;
        confidence = kKnown;
        ++beyond;
    }
    return static_cast<double>(beyond) /
           static_cast<double>(std::max<std::size_t>(1, map.confidence.pixels().size()));
}

}  // namespace lumi
