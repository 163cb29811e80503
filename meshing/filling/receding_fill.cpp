#include "meshing/filling/receding_fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "calib/capture/inverse_depth_warp.h"
#include "calib/pictures/image_io.h"
#include "meshing/exposure/color_match.h"
#include "meshing/warp/pixel_in_picture.h"

namespace lumi {
namespace {

constexpr int kCell = 4;  // Pixels of the depth map a side.

/// Pixels of disparity a pixel. The first is no recession.
constexpr std::array<double, 4> kSlopes{0.0, 0.3, 0.6, 1.0};

/// Sums over what was compared.
struct Differences {
    std::array<double, kSlopes.size()> sums{};
    int count = 0;
};

ColorImage small_picture(const ColorImage& picture) {
    return resized(picture, std::max(1, picture.width() / kCell),
                   std::max(1, picture.height() / kCell));
}

/// A neighbour that is asked.
struct Witness {
    InverseDepthWarp there;
    ColorImage picture;  ///< Small.
    const DepthMap* map;
    double tolerance;  ///< Inverse depth within which surfaces are the same.
};

/// How far the colour of a pixel is from what the neighbour sees at this inverse depth, in 8-bit
/// levels; empty where it cannot tell. What it knows to be empty there is another colour.
std::optional<double> difference_in(const Witness& witness, const Eigen::Vector2d& pixel,
                                    const Rgb8& color, double inverse_depth) {
    constexpr double kOtherColor = 40;
    const auto there = witness.there.at(pixel, inverse_depth);
    const GrayImage& confidence = witness.map->confidence;
    const auto found = pixel_in_picture(there, confidence.width(), confidence.height());
    if (!found) return std::nullopt;
    if (confidence(found->x(), found->y()) != 0) {
        const auto known = static_cast<double>(witness.map->inverse_depth(found->x(), found->y()));
        const double nearer = there->inverse_depth - known;
        if (nearer < -witness.tolerance) return std::nullopt;
        if (nearer > witness.tolerance) return kOtherColor;
    }
    const int x = std::min(found->x() / kCell, witness.picture.width() - 1);
    const int y = std::min(found->y() / kCell, witness.picture.height() - 1);
    return std::min(kOtherColor, 1.0 * largest_difference(color, witness.picture(x, y)));
}

/// Adds the differences in one neighbour, if it can tell at every slope.
void add_differences(const Witness& witness, const Eigen::Vector2d& pixel, const Rgb8& color,
                     double inverse_depth, double recession, Differences& total) {
    std::array<double, kSlopes.size()> differences;
    for (std::size_t k = 0; k < kSlopes.size(); ++k) {
        const auto difference = difference_in(
            witness, pixel, color, std::max(0.0, inverse_depth - kSlopes[k] * recession));
        if (!difference) return;
        differences[k] = *difference;
    }
    for (std::size_t k = 0; k < kSlopes.size(); ++k) total.sums[k] += differences[k];
    ++total.count;
}

std::vector<Witness> witnesses_of(const DepthScene& scene,
                                  const std::vector<DepthMap>& confirmed_maps,
                                  const DepthView& view) {
    std::vector<Witness> witnesses;
    for (const int j : view.neighbours) {
        const auto index = static_cast<std::size_t>(j);
        const DepthView& other = scene.views[index];
        if (other.disparity_px_per_inverse_depth <= 0) continue;
        witnesses.push_back({warp_from(view).to(other), small_picture(other.photograph),
                             &confirmed_maps[index], 2.0 / other.disparity_px_per_inverse_depth});
    }
    return witnesses;
}

}  // namespace

std::vector<double> recession_differences(const DepthScene& scene,
                                          const std::vector<DepthMap>& confirmed_maps,
                                          int view_index, const DepthMap& continued,
                                          const FloatImage& distance_px) {
    constexpr int kLeastCount = 200;
    constexpr double kNoise = 1.0;  // 8-bit levels: less is no difference.
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    if (view.disparity_px_per_inverse_depth <= 0) return {};
    const double one_pixel = 1.0 / view.disparity_px_per_inverse_depth;
    const std::vector<Witness> witnesses = witnesses_of(scene, confirmed_maps, view);
    const ColorImage picture = small_picture(view.photograph);
    Differences total;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const int column = kCell * x + kCell / 2;
            const int row = kCell * y + kCell / 2;
            if (!distance_px.contains(column, row) || distance_px(column, row) <= 0) continue;
            for (const Witness& witness : witnesses) {
                add_differences(witness, {column + 0.5, row + 0.5}, picture(x, y),
                                static_cast<double>(continued.inverse_depth(column, row)),
                                one_pixel * static_cast<double>(distance_px(column, row)), total);
            }
        }
    }
    if (total.count < kLeastCount) return {};
    std::vector<double> differences;
    for (const double sum : total.sums) differences.push_back(sum + kNoise * total.count);
    return differences;
}

std::optional<double> chosen_recession(const std::vector<std::vector<double>>& differences) {
    constexpr std::size_t kLeastViews = 4;
    constexpr double kStandardErrors = 2.0;
    const std::size_t telling =
        differences.size() - static_cast<std::size_t>(std::count(
                                 differences.begin(), differences.end(), std::vector<double>{}));
    if (telling < kLeastViews) return std::nullopt;
    double least = 0;
    double chosen = kSlopes.front();
    for (std::size_t k = 1; k < kSlopes.size(); ++k) {
        double sum = 0;
        double squares = 0;
        double count = 0;
        for (const std::vector<double>& view : differences) {
            if (view.empty()) continue;
            const double change = std::log(view[k] / view.front());
            sum += change;
            squares += change * change;
            ++count;
        }
        const double mean = sum / count;
        const double variance = std::max(0.0, squares / count - mean * mean) / (count - 1);
        if (mean >= least || mean > -kStandardErrors * std::sqrt(variance)) continue;
        least = mean;
        chosen = kSlopes[k];
    }
    return chosen;
}

void recede(double slope_px, double one_pixel, const FloatImage& distance_px, DepthMap& map) {
    const auto recession = static_cast<float>(slope_px * one_pixel);
    for (std::size_t i = 0; i < map.inverse_depth.pixels().size(); ++i) {
        float& inverse_depth = map.inverse_depth.pixels()[i];
        inverse_depth = std::max(0.0F, inverse_depth - recession * distance_px.pixels()[i]);
    }
}

}  // namespace lumi
