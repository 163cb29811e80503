#include "meshing/transients/known_view.h"

#include <algorithm>
#include <utility>

#include "calib/pictures/image_io.h"
#include "calib/work/median.h"
#include "calib/work/parallel_for.h"
#include "meshing/exposure/shared_colors.h"
#include "meshing/warp/disparity.h"
#include "meshing/warp/parallax.h"
#include "meshing/warp/pixel_in_picture.h"

namespace lumi {
namespace {

constexpr int kSightsAcross = 24;  // Places in a row by which near views are found.

/// The sample in the middle of each pixel, where one other view confirmed it, others agree upon it,
/// or it hides something from the view (finished_depth.h).
DepthMap known_of(const DepthMap& depth, int width, int height) {
    DepthMap known{FloatImage(width, height), GrayImage(width, height)};
    for (int y = 0; y < height; ++y) {
        const int row = (2 * y + 1) * depth.confidence.height() / (2 * height);
        for (int x = 0; x < width; ++x) {
            const int column = (2 * x + 1) * depth.confidence.width() / (2 * width);
            if (depth.confidence(column, row) < kConfirmedByOne) continue;
            known.inverse_depth(x, y) = depth.inverse_depth(column, row);
            known.confidence(x, y) = depth.confidence(column, row);
        }
    }
    return known;
}

KnownView known_view(const PicturedView& view, int max_side_px) {
    const DepthMap& depth = *view.depth;
    const int side = std::max(depth.confidence.width(), depth.confidence.height());
    if (side == 0) return {view.camera, view.cam_from_world, {}, {}, {}, 0.0};
    const int kept = std::min(max_side_px, side);
    const int width = std::max(1, depth.confidence.width() * kept / side);
    const int height = std::max(1, depth.confidence.height() * kept / side);
    return {resized(view.camera, width, height),
            view.cam_from_world,
            known_of(depth, width, height),
            averaged(resized(*view.photograph, width, height)),
            {},
            0.0};
}

/// Calls `take(pixel, inverse depth)` for places that the view knows, all over its picture.
template <typename Take>
void for_known_places(const KnownView& view, const Take& take) {
    const GrayImage& confidence = view.known.confidence;
    const int step = std::max(1, confidence.width() / kSightsAcross);
    for (int y = step / 2; y < confidence.height(); y += step) {
        for (int x = step / 2; x < confidence.width(); x += step) {
            if (confidence(x, y) == 0) continue;
            take(Eigen::Vector2d(x + 0.5, y + 0.5),
                 static_cast<double>(view.known.inverse_depth(x, y)));
        }
    }
}

/// The share of a view's places that another view has in its picture.
double shared_sight(const KnownView& view, const KnownView& other) {
    const InverseDepthWarp warp = warp_from(view).to(other);
    int known = 0;
    int seen = 0;
    for_known_places(view, [&](const Eigen::Vector2d& pixel, double inverse_depth) {
        ++known;
        const ColorImage& picture = other.picture;
        if (pixel_in_picture(warp.at(pixel, inverse_depth), picture.width(), picture.height()))
            ++seen;
    });
    return known == 0 ? 0.0 : static_cast<double>(seen) / known;
}

std::vector<int> views_near(const std::vector<KnownView>& views, std::size_t view_index) {
    constexpr std::size_t kMostNear = 12;
    constexpr double kLeastShare = 0.3;
    const KnownView& view = views[view_index];
    std::vector<std::pair<double, int>> by_distance;
    for (std::size_t j = 0; j < views.size(); ++j) {
        if (j == view_index || shared_sight(view, views[j]) < kLeastShare) continue;
        const double distance =
            (centre_in_world(view.cam_from_world) - centre_in_world(views[j].cam_from_world))
                .norm();
        by_distance.emplace_back(distance, static_cast<int>(j));
    }
    std::sort(by_distance.begin(), by_distance.end());
    by_distance.resize(std::min(by_distance.size(), kMostNear));
    std::vector<int> near;
    for (const auto& [distance, other] : by_distance) near.push_back(other);
    return near;
}

/// For the fastest of the nearest that have parallax.
double disparity_of(const std::vector<KnownView>& views, const KnownView& view) {
    constexpr std::size_t kNearest = 4;
    std::vector<double> parallaxes;
    for (const int j : view.near) {
        const InverseDepthWarp warp = warp_from(view).to(views[static_cast<std::size_t>(j)]);
        std::vector<double> disparities;
        for_known_places(view, [&](const Eigen::Vector2d& pixel, double inverse_depth) {
            disparities.push_back(disparity_per_inverse_depth(warp, pixel, inverse_depth));
        });
        parallaxes.push_back(median_of(std::move(disparities)));
    }
    double fastest = 0.0;
    for (const std::size_t k : with_parallax(parallaxes, kNearest)) {
        fastest = std::max(fastest, parallaxes[k]);
    }
    return fastest;
}

}  // namespace

std::vector<KnownView> known_views(const std::vector<PicturedView>& views, int max_side_px,
                                   int threads) {
    std::vector<KnownView> known(views.size());
    parallel_for(static_cast<int>(views.size()), threads, [&](int i) {
        known[static_cast<std::size_t>(i)] =
            known_view(views[static_cast<std::size_t>(i)], max_side_px);
    });
    parallel_for(static_cast<int>(views.size()), threads, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        known[index].near = views_near(known, index);
        known[index].disparity_px_per_inverse_depth = disparity_of(known, known[index]);
    });
    return known;
}

std::vector<Witness> witnesses_of(const std::vector<KnownView>& views, int view_index) {
    const KnownView& own = views[static_cast<std::size_t>(view_index)];
    std::vector<Witness> witnesses;
    if (own.disparity_px_per_inverse_depth <= 0) return witnesses;
    const auto one_pixel = static_cast<float>(1 / own.disparity_px_per_inverse_depth);
    for (const int other_index : own.near) {
        const KnownView& other = views[static_cast<std::size_t>(other_index)];
        const int step = std::max(1, other.picture.width() / 100);  // It is asked pixel by pixel.
        const InverseDepthWarp own_from_other = warp_from(other).to(own);
        const auto match =
            color_match(shared_colors({own.known, own.picture}, {other.known, other.picture},
                                      own_from_other, one_pixel, step));
        if (match)
            witnesses.push_back({other_index, own_from_other, warp_from(own).to(other), *match});
    }
    return witnesses;
}

}  // namespace lumi
