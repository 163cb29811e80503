#include "meshing/agreement/seen_past.h"

#include "meshing/depth_scene/views_around.h"
#include "meshing/warp/pixel_in_picture.h"

namespace lumi {
namespace {

/// Takes away from `pixels` where the other view sees past what `map` has there.
void leave_what_is_seen_past(const DepthView& view, const DepthMap& map, const DepthView& other,
                             const DepthMap& known, GrayImage& pixels) {
    if (other.disparity_px_per_inverse_depth <= 0) return;
    const InverseDepthWarp other_from_own = warp_from(view).to(other);
    const double clearly = kClearlyApartPx / other.disparity_px_per_inverse_depth;
    for (int y = 0; y < pixels.height(); ++y) {
        for (int x = 0; x < pixels.width(); ++x) {
            if (pixels(x, y) == 0) continue;
            const auto there = place_in_view(known, other_from_own, x, y, map.inverse_depth(x, y));
            if (there && there->ahead > clearly) pixels(x, y) = 0;
        }
    }
}

}  // namespace

std::optional<PlaceInView> place_in_view(const DepthMap& known,
                                         const InverseDepthWarp& view_from_own, int x, int y,
                                         float inverse_depth) {
    const auto there = view_from_own.at({x + 0.5, y + 0.5}, static_cast<double>(inverse_depth));
    const auto pixel = pixel_in_picture(there, known.confidence.width(), known.confidence.height());
    if (!pixel) return std::nullopt;
    PlaceInView place{pixel->x(), pixel->y(), 0.0};
    if (known.confidence(place.x, place.y) != 0) {
        place.ahead =
            there->inverse_depth - static_cast<double>(known.inverse_depth(place.x, place.y));
    }
    return place;
}

GrayImage continued_before_hidden(const DepthScene& scene, const std::vector<DepthMap>& maps,
                                  int view_index, const DepthMap& map, const DepthMap& hidden) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    GrayImage before = hidden.confidence;
    if (view.disparity_px_per_inverse_depth <= 0) return GrayImage(before.width(), before.height());
    const auto clearly = static_cast<float>(kClearlyApartPx / view.disparity_px_per_inverse_depth);
    for (std::size_t i = 0; i < before.pixels().size(); ++i) {
        const float ahead = map.inverse_depth.pixels()[i] - hidden.inverse_depth.pixels()[i];
        if (map.confidence.pixels()[i] != 0 || ahead <= clearly) before.pixels()[i] = 0;
    }
    for (const int other : views_around(scene, view_index)) {
        leave_what_is_seen_past(view, map, scene.views[static_cast<std::size_t>(other)],
                                maps[static_cast<std::size_t>(other)], before);
    }
    return before;
}

}  // namespace lumi
