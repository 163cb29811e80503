#include "render/surroundings/small_photographs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "calib/pictures/image_io.h"

namespace lumi {
namespace {

/// Of the longer side.
constexpr double kSmallPhotograph_px = 16.0;
/// Of a photograph's border, so much shows what is infinitely far where a subject stands alone. A
/// sky has less.
constexpr double kLeastBorderShare = 2.0 / 3.0;

Eigen::Vector3d mean_of(const std::vector<ColorImage>& images) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double count = 0;
    for (const ColorImage& image : images) {
        for (const Rgb8& pixel : image.pixels()) sum += Eigen::Vector3d(pixel.r, pixel.g, pixel.b);
        count += static_cast<double>(image.pixels().size());
    }
    return sum / std::max(count, 1.0);
}

bool is_subject_alone(const FloatImage& inverse_depth) {
    int far = 0;
    int all = 0;
    const auto count = [&](int x, int y) {
        ++all;
        if (inverse_depth(x, y) == 0.0F) ++far;
    };
    for (int x = 0; x < inverse_depth.width(); ++x)
        for (const int y : {0, inverse_depth.height() - 1}) count(x, y);
    for (int y = 0; y < inverse_depth.height(); ++y)
        for (const int x : {0, inverse_depth.width() - 1}) count(x, y);
    return all > 0 && far >= kLeastBorderShare * all;
}

/// Mean colours of what is infinitely far, and how many pixels of it there were.
struct FarColors {
    int width = 0;
    int height = 0;
    std::vector<Eigen::Vector3d> means;
    std::vector<int> counts;

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
    [[nodiscard]] bool is_known(int x, int y) const {
        return x >= 0 && y >= 0 && x < width && y < height && counts[index(x, y)] > 0;
    }
};

FarColors far_colors(const LumigraphView& view, int width, int height) {
    const ColorImage& photograph = view.photograph;
    const FloatImage& inverse_depth = view.depth.inverse_depth;
    const auto cells = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    FarColors colors{width, height, std::vector<Eigen::Vector3d>(cells, Eigen::Vector3d::Zero()),
                     std::vector<int>(cells)};
    for (int y = 0; y < photograph.height(); ++y) {
        for (int x = 0; x < photograph.width(); ++x) {
            if (inverse_depth(x * inverse_depth.width() / photograph.width(),
                              y * inverse_depth.height() / photograph.height()) > 0.0F)
                continue;
            const std::size_t cell =
                colors.index(x * width / photograph.width(), y * height / photograph.height());
            const Rgb8& pixel = photograph(x, y);
            colors.means[cell] += Eigen::Vector3d(pixel.r, pixel.g, pixel.b);
            ++colors.counts[cell];
        }
    }
    for (std::size_t cell = 0; cell < cells; ++cell)
        colors.means[cell] /= std::max(colors.counts[cell], 1);
    return colors;
}

/// From the rim of what is unknown inwards, each cell gets the mean of its known neighbours.
void close_gaps(FarColors& colors) {
    constexpr std::array<std::pair<int, int>, 4> kNeighbours{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    for (int round = 0; round < colors.width + colors.height; ++round) {
        FarColors next = colors;
        for (int y = 0; y < colors.height; ++y) {
            for (int x = 0; x < colors.width; ++x) {
                if (colors.is_known(x, y)) continue;
                Eigen::Vector3d sum = Eigen::Vector3d::Zero();
                int known = 0;
                for (const auto& [right, down] : kNeighbours) {
                    if (!colors.is_known(x + right, y + down)) continue;
                    sum += colors.means[colors.index(x + right, y + down)];
                    ++known;
                }
                next.means[colors.index(x, y)] = sum / std::max(known, 1);
                next.counts[colors.index(x, y)] = known;
            }
        }
        colors = std::move(next);
    }
}

ColorImage picture_of(const FarColors& colors) {
    ColorImage picture(colors.width, colors.height);
    const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(value)); };
    for (int y = 0; y < colors.height; ++y) {
        for (int x = 0; x < colors.width; ++x) {
            const Eigen::Vector3d& mean = colors.means[colors.index(x, y)];
            picture(x, y) = {byte(mean.x()), byte(mean.y()), byte(mean.z())};
        }
    }
    return picture;
}

ColorImage small_photograph(const LumigraphView& view) {
    const ColorImage& photograph = view.photograph;
    const double scale =
        std::min(1.0, kSmallPhotograph_px / std::max(photograph.width(), photograph.height()));
    const auto scaled = [scale](int size_px) {
        return std::max(1, static_cast<int>(std::lround(scale * size_px)));
    };
    const int width = scaled(photograph.width());
    const int height = scaled(photograph.height());
    if (!is_subject_alone(view.depth.inverse_depth)) return resized(photograph, width, height);
    FarColors colors = far_colors(view, width, height);
    close_gaps(colors);
    return picture_of(colors);
}

}  // namespace

SmallPhotographs small_photographs(const Lumigraph& lumigraph) {
    SmallPhotographs small;
    for (const LumigraphView& view : lumigraph.views)
        small.of_views.push_back(small_photograph(view));
    small.mean = mean_of(small.of_views);
    return small;
}

}  // namespace lumi
