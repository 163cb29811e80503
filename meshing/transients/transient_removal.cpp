#include "meshing/transients/transient_removal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "calib/capture/inpainting.h"
#include "calib/work/parallel_for.h"
#include "meshing/depth/gap_closing.h"
#include "meshing/transients/known_view.h"
#include "meshing/transients/transients.h"
#include "meshing/transients/unlike_others.h"

namespace lumi {
namespace {

/// Whether the mask, perhaps a coarser one, has the sample of the raster.
bool is_in(const GrayImage& mask, const Eigen::Vector2i& sample, const GrayImage& raster) {
    return !mask.empty() && mask(sample.x() * mask.width() / raster.width(),
                                 sample.y() * mask.height() / raster.height()) != 0;
}

/// What others agree upon where a view shows transients; confidence 0 elsewhere.
DepthMap behind_transients(const std::vector<KnownView>& known, int view_index,
                           const GrayImage& transients) {
    DepthMap behind =
        with_gaps_closed(others_agree(known, witnesses_of(known, view_index), view_index).agreed);
    GrayImage& confidence = behind.confidence;
    for (int y = 0; y < confidence.height(); ++y) {
        for (int x = 0; x < confidence.width(); ++x) {
            if (!is_in(transients, {x, y}, confidence)) confidence(x, y) = 0;
        }
    }
    return behind;
}

/// Another view's photograph, asked for what lies behind a transient.
struct Painter {
    const PicturedView* view;
    const KnownView* known;
    const GrayImage* transients;      ///< Its own, perhaps coarser; empty without any.
    InverseDepthWarp other_from_own;  ///< At the size of the photographs.
    InverseDepthWarp known_from_own;  ///< From the photograph to the other's depth map.
    double one_pixel;                 ///< In the other's inverse depth.
    ColorMatch match;
};

std::vector<Painter> painters_of(const std::vector<PicturedView>& views,
                                 const std::vector<KnownView>& known,
                                 const std::vector<GrayImage>& transients, int view_index) {
    const PicturedView& own = views[static_cast<std::size_t>(view_index)];
    std::vector<Painter> painters;
    for (const Witness& witness : witnesses_of(known, view_index)) {
        const auto other = static_cast<std::size_t>(witness.view);
        const double disparity = known[other].disparity_px_per_inverse_depth;
        if (disparity <= 0) continue;
        painters.push_back({&views[other], &known[other], &transients[other],
                            warp_b_from_a(own.camera, own.cam_from_world, views[other].camera,
                                          views[other].cam_from_world),
                            warp_b_from_a(own.camera, own.cam_from_world, known[other].camera,
                                          known[other].cam_from_world),
                            1 / disparity, witness.match});
    }
    return painters;
}

/// Between the middles of four pixels.
Rgb8 color_between(const ColorImage& picture, const Eigen::Vector2d& place) {
    const double left = std::clamp(place.x() - 0.5, 0.0, picture.width() - 1.0);
    const double top = std::clamp(place.y() - 0.5, 0.0, picture.height() - 1.0);
    const int x = std::min(static_cast<int>(left), std::max(0, picture.width() - 2));
    const int y = std::min(static_cast<int>(top), std::max(0, picture.height() - 2));
    const int right = std::min(x + 1, picture.width() - 1);
    const int below = std::min(y + 1, picture.height() - 1);
    const double u = left - x;
    const double v = top - y;
    const auto mean = [&](auto channel) {
        const double upper = (1 - u) * channel(picture(x, y)) + u * channel(picture(right, y));
        const double lower =
            (1 - u) * channel(picture(x, below)) + u * channel(picture(right, below));
        return static_cast<std::uint8_t>(std::lround((1 - v) * upper + v * lower));
    };
    return {mean([](const Rgb8& c) { return c.r; }), mean([](const Rgb8& c) { return c.g; }),
            mean([](const Rgb8& c) { return c.b; })};
}

/// The surface as the other photograph shows it, in the view's own colours; empty where it does
/// not see it.
std::optional<Rgb8> color_from(const Painter& painter, const Eigen::Vector2d& pixel,
                               double inverse_depth) {
    constexpr double kSameSurfacePx = 1.5;
    const Eigen::Vector3d there = painter.known_from_own(pixel, inverse_depth);
    const Eigen::Vector3d at = painter.other_from_own(pixel, inverse_depth);
    if (there.z() <= 0 || at.z() <= 0) return std::nullopt;
    const Eigen::Vector2i sample = there.hnormalized().array().floor().cast<int>();
    const DepthMap& known = painter.known->known;
    if (!known.confidence.contains(sample.x(), sample.y())) return std::nullopt;
    if (known.confidence(sample.x(), sample.y()) == 0) return std::nullopt;
    const double apart = inverse_depth / there.z() -
                         static_cast<double>(known.inverse_depth(sample.x(), sample.y()));
    if (std::abs(apart) > kSameSurfacePx * painter.one_pixel) return std::nullopt;
    if (is_in(*painter.transients, sample, known.confidence)) return std::nullopt;
    const Rgb8 color = color_between(*painter.view->photograph, at.hnormalized());
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
double paint(const std::vector<Painter>& painters, const DepthMap& behind, ColorImage& picture) {
    GrayImage painted(picture.width(), picture.height(), 255);
    std::size_t pixels = 0;
    bool is_all_known = true;
    for (int y = 0; y < picture.height(); ++y) {
        const int row = y * behind.confidence.height() / picture.height();
        for (int x = 0; x < picture.width(); ++x) {
            const int column = x * behind.confidence.width() / picture.width();
            if (behind.confidence(column, row) == 0) continue;
            ++pixels;
            const auto color = color_behind(painters, {x + 0.5, y + 0.5},
                                            static_cast<double>(behind.inverse_depth(column, row)));
            if (color) {
                picture(x, y) = *color;
            } else {
                painted(x, y) = 0;
                is_all_known = false;
            }
        }
    }
    if (!is_all_known) paint_from_rim(painted, picture);
    return static_cast<double>(pixels) / static_cast<double>(picture.pixels().size());
}

/// As one neighbour confirms it.
void move_back(const DepthMap& behind, DepthMap& depth) {
    for (std::size_t i = 0; i < behind.confidence.pixels().size(); ++i) {
        if (behind.confidence.pixels()[i] == 0) continue;
        depth.inverse_depth.pixels()[i] = behind.inverse_depth.pixels()[i];
        depth.confidence.pixels()[i] = kConfirmedByOne;
    }
}

}  // namespace

std::vector<ViewWithoutTransients> without_transients(const std::vector<PicturedView>& views,
                                                      int threads, Progress& progress) {
    constexpr int kCoarsePx = 400;
    const std::vector<GrayImage> transients =
        transients_of(known_views(views, kCoarsePx, threads), threads, progress);
    std::vector<ViewWithoutTransients> changed;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (!transients[i].empty()) changed.push_back({static_cast<int>(i), 0.0, {}, {}});
    }
    if (changed.empty()) return changed;
    progress.begin("painting over what moved between photographs", changed.size());
    const std::vector<KnownView> known =
        known_views(views, std::numeric_limits<int>::max(), threads);
    parallel_for(static_cast<int>(changed.size()), threads, [&](int i) {
        progress.throw_if_interrupted();
        ViewWithoutTransients& clean = changed[static_cast<std::size_t>(i)];
        const auto index = static_cast<std::size_t>(clean.view);
        const DepthMap behind = behind_transients(known, clean.view, transients[index]);
        clean.photograph = *views[index].photograph;
        clean.depth = *views[index].depth;
        clean.share =
            paint(painters_of(views, known, transients, clean.view), behind, clean.photograph);
        move_back(behind, clean.depth);
        progress.advance();
    });
    return changed;
}

}  // namespace lumi
