#include "meshing/transients/transient_removal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "calib/capture/bilinear.h"
#include "calib/capture/nearest_byte.h"
#include "calib/pictures/inpainting.h"
#include "calib/work/parallel_for.h"
#include "calib/work/process_memory.h"
#include "meshing/agreement/gap_closing.h"
#include "meshing/transients/known_view.h"
#include "meshing/transients/transients.h"
#include "meshing/transients/unlike_others.h"
#include "meshing/warp/pixel_in_picture.h"

namespace lumi {
namespace {

/// Whether the mask, perhaps a coarser one, has the sample of the raster.
bool is_in(const GrayImage& mask, const Eigen::Vector2i& sample, const GrayImage& raster) {
    return !mask.empty() && mask(sample.x() * mask.width() / raster.width(),
                                 sample.y() * mask.height() / raster.height()) != 0;
}

/// Views know nothing where they show transients.
void forget(const GrayImage& transients, KnownView& view) {
    GrayImage& confidence = view.known.confidence;
    for (int y = 0; y < confidence.height(); ++y) {
        for (int x = 0; x < confidence.width(); ++x) {
            if (is_in(transients, {x, y}, confidence)) confidence(x, y) = 0;
        }
    }
}

/// The views with transients and those near to them, in full; the others are empty.
std::vector<KnownView> views_around_transients(const std::vector<PicturedView>& views,
                                               const std::vector<KnownView>& coarse,
                                               const std::vector<GrayImage>& transients,
                                               int threads) {
    const DepthMap none;
    std::vector<PicturedView> asked = views;
    for (PicturedView& view : asked) view.depth = &none;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (transients[i].empty()) continue;
        asked[i].depth = views[i].depth;
        for (const int near : coarse[i].near) {
            asked[static_cast<std::size_t>(near)].depth =
                views[static_cast<std::size_t>(near)].depth;
        }
    }
    std::vector<KnownView> known = known_views(asked, std::numeric_limits<int>::max(), threads);
    for (std::size_t i = 0; i < known.size(); ++i) forget(transients[i], known[i]);
    return known;
}

/// Gives each pixel that is not known (255) the number of the nearest one that is.
void continue_nearest(GrayImage& is_unknown, FloatImage& numbers) {
    const cv::Mat unknown(is_unknown.height(), is_unknown.width(), CV_8U,
                          is_unknown.pixels().data());
    cv::Mat distances;
    cv::Mat labels;  // Of the nearest known pixel, each with one of its own.
    cv::distanceTransform(unknown, distances, labels, cv::DIST_L2, cv::DIST_MASK_5,
                          cv::DIST_LABEL_PIXEL);
    FloatImage number_of_label(numbers.width() + 1, numbers.height() + 1);
    for (int y = 0; y < numbers.height(); ++y) {
        for (int x = 0; x < numbers.width(); ++x) {
            const auto label = static_cast<std::size_t>(labels.at<int>(y, x));
            if (is_unknown(x, y) == 0) number_of_label.pixels()[label] = numbers(x, y);
        }
    }
    for (int y = 0; y < numbers.height(); ++y) {
        for (int x = 0; x < numbers.width(); ++x) {
            const auto label = static_cast<std::size_t>(labels.at<int>(y, x));
            if (is_unknown(x, y) != 0) numbers(x, y) = number_of_label.pixels()[label];
        }
    }
}

/// What others agree upon along the rays of transients, with confidence as if one neighbour had
/// confirmed it; where they do not, the nearest of all that is known, with confidence 0. Elsewhere
/// as it is.
void move_back(const std::vector<KnownView>& known, int view_index, const GrayImage& transients,
               DepthMap& depth) {
    const DepthMap agreed =
        with_gaps_closed(others_agree(known, witnesses_of(known, view_index), view_index).agreed);
    GrayImage is_unknown(depth.confidence.width(), depth.confidence.height());
    for (int y = 0; y < depth.confidence.height(); ++y) {
        for (int x = 0; x < depth.confidence.width(); ++x) {
            if (!is_in(transients, {x, y}, depth.confidence)) continue;
            if (agreed.confidence(x, y) != 0) {
                depth.inverse_depth(x, y) = agreed.inverse_depth(x, y);
                depth.confidence(x, y) = kConfirmedByOne;
            } else {
                is_unknown(x, y) = 255;
                depth.confidence(x, y) = 0;
            }
        }
    }
    continue_nearest(is_unknown, depth.inverse_depth);
}

/// Another view's photograph, asked for what lies behind a transient.
struct Painter {
    const PicturedView* view;
    const KnownView* known;
    InverseDepthWarp other_from_own;  ///< At the size of the photographs.
    InverseDepthWarp known_from_own;  ///< From the photograph to the other's depth map.
    double one_pixel;                 ///< In the other's inverse depth.
    ColorMatch match;
};

std::vector<Painter> painters_of(const std::vector<PicturedView>& views,
                                 const std::vector<KnownView>& known, int view_index) {
    const PicturedView& own = views[static_cast<std::size_t>(view_index)];
    std::vector<Painter> painters;
    for (const Witness& witness : witnesses_of(known, view_index)) {
        const auto other = static_cast<std::size_t>(witness.view);
        const double disparity = known[other].disparity_px_per_inverse_depth;
        if (disparity <= 0) continue;
        painters.push_back({&views[other], &known[other], warp_from(own).to(views[other]),
                            warp_from(own).to(known[other]), 1 / disparity, witness.match});
    }
    return painters;
}

Rgb8 color_between(const ColorImage& picture, const Eigen::Vector2d& place) {
    const Eigen::Vector3d mean = bilinear(picture, place);
    return {nearest_byte(mean.x()), nearest_byte(mean.y()), nearest_byte(mean.z())};
}

/// The surface as the other photograph shows it, in the view's own colours; empty where it does
/// not see it.
std::optional<Rgb8> color_from(const Painter& painter, const Eigen::Vector2d& pixel,
                               double inverse_depth) {
    constexpr double kSameSurfacePx = 1.5;
    const auto there = painter.known_from_own.at(pixel, inverse_depth);
    const auto at = painter.other_from_own.at(pixel, inverse_depth);
    const DepthMap& known = painter.known->known;
    const auto sample =
        pixel_in_picture(there, known.confidence.width(), known.confidence.height());
    if (!sample || !at || known.confidence(sample->x(), sample->y()) == 0) return std::nullopt;
    const double apart =
        there->inverse_depth - static_cast<double>(known.inverse_depth(sample->x(), sample->y()));
    if (std::abs(apart) > kSameSurfacePx * painter.one_pixel) return std::nullopt;
    const Rgb8 color = color_between(*painter.view->photograph, at->pixel);
    return painter.match.in_own_colors(color);
}

/// Of each channel the median of three, the mean of two.
Rgb8 middle_of(const std::array<Rgb8, 3>& colors, std::size_t count) {
    const auto middle = [&](auto channel) {
        std::array<int, 3> levels{};
        for (std::size_t i = 0; i < count; ++i) levels[i] = channel(colors[i]);
        if (count == 3) std::sort(levels.begin(), levels.end());
        return static_cast<std::uint8_t>(count == 2 ? (levels[0] + levels[1]) / 2
                                                    : levels[count / 2]);
    };
    return {middle([](const Rgb8& c) { return c.r; }), middle([](const Rgb8& c) { return c.g; }),
            middle([](const Rgb8& c) { return c.b; })};
}

std::optional<Rgb8> color_behind(const std::vector<Painter>& painters, const Eigen::Vector2d& pixel,
                                 double inverse_depth) {
    std::array<Rgb8, 3> colors;
    std::size_t count = 0;
    for (const Painter& painter : painters) {
        const auto color = color_from(painter, pixel, inverse_depth);
        if (color) colors[count++] = *color;
        if (count == colors.size()) break;
    }
    return count == 0 ? std::nullopt : std::optional(middle_of(colors, count));
}

/// Returns the share of the picture that was painted.
double paint(const std::vector<Painter>& painters, const GrayImage& transients,
             const DepthMap& depth, ColorImage& picture) {
    GrayImage is_known(picture.width(), picture.height(), 255);
    std::size_t painted = 0;
    std::size_t unknown = 0;
    for (int y = 0; y < picture.height(); ++y) {
        const int row = y * depth.confidence.height() / picture.height();
        for (int x = 0; x < picture.width(); ++x) {
            const int column = x * depth.confidence.width() / picture.width();
            if (!is_in(transients, {column, row}, depth.confidence)) continue;
            ++painted;
            const auto color = color_behind(painters, {x + 0.5, y + 0.5},
                                            static_cast<double>(depth.inverse_depth(column, row)));
            if (color) {
                picture(x, y) = *color;
            } else {
                is_known(x, y) = 0;
                ++unknown;
            }
        }
    }
    if (unknown > 0) paint_from_rim(is_known, picture);
    return static_cast<double>(painted) / static_cast<double>(picture.pixels().size());
}

/// By the largest of them.
int views_at_one_time(const std::vector<PicturedView>& views,
                      const std::vector<ViewWithoutTransients>& changed, int threads,
                      std::uint64_t max_bytes) {
    // Of each pixel of a depth map: what eight others see there, what they agree upon, and how far
    // it is from what is known.
    constexpr double kOfEachPixel = 130;
    std::size_t largest = 0;
    for (const ViewWithoutTransients& clean : changed) {
        const DepthMap& depth = *views[static_cast<std::size_t>(clean.view)].depth;
        largest = std::max(largest, depth.confidence.pixels().size());
    }
    release_free_memory();
    const std::uint64_t budget = std::min(max_bytes, memory_available().value_or(max_bytes));
    return pieces_within(static_cast<double>(budget), 0,
                         kOfEachPixel * static_cast<double>(largest), threads);
}

}  // namespace

std::vector<ViewWithoutTransients> without_transients(const std::vector<PicturedView>& views,
                                                      int threads, std::uint64_t max_bytes,
                                                      Progress& progress) {
    constexpr int kCoarse_px = 400;
    const std::vector<KnownView> coarse = known_views(views, kCoarse_px, threads);
    const std::vector<GrayImage> transients = transients_of(coarse, threads, progress);
    std::vector<ViewWithoutTransients> changed;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (!transients[i].empty()) changed.push_back({static_cast<int>(i), 0.0, {}, {}});
    }
    if (changed.empty()) return changed;
    progress.begin("painting over what moved between photographs", changed.size());
    const std::vector<KnownView> known =
        views_around_transients(views, coarse, transients, threads);
    const int at_one_time = views_at_one_time(views, changed, resolve_threads(threads), max_bytes);
    parallel_for(static_cast<int>(changed.size()), at_one_time, [&](int i) {
        progress.throw_if_interrupted();
        ViewWithoutTransients& clean = changed[static_cast<std::size_t>(i)];
        const auto index = static_cast<std::size_t>(clean.view);
        clean.photograph = *views[index].photograph;
        clean.depth = *views[index].depth;
        move_back(known, clean.view, transients[index], clean.depth);
        clean.share = paint(painters_of(views, known, clean.view), transients[index], clean.depth,
                            clean.photograph);
        progress.advance();
    });
    return changed;
}

}  // namespace lumi
