#include "meshing/transients/unlike_others.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "meshing/agreement/seen_past.h"
#include "meshing/surface/depth_map.h"
#include "meshing/warp/warped_rows.h"

namespace lumi {
namespace {

/// What one view has along the ray of a pixel.
struct Sight {
    float inverse_depth = 0.0F;
    Rgb8 color;                  ///< In the asking view's colours.
    std::uint8_t witness = 0;    ///< Its place in the order of asking.
    std::uint8_t tolerance = 0;  ///< Of colours.
};

/// What the first views that have anything there see along the ray of a pixel, at most one each.
class PixelSights {
 public:
    void add(const Sight& sight) {
        if (count_ > 0 && sights_[count_ - 1U].witness == sight.witness) {
            // Of one view what is nearer hides the rest.
            if (sight.inverse_depth > sights_[count_ - 1U].inverse_depth) {
                sights_[count_ - 1U] = sight;
            }
            return;
        }
        if (count_ < sights_.size()) sights_[count_++] = sight;
    }

    [[nodiscard]] const Sight* begin() const { return sights_.data(); }
    [[nodiscard]] const Sight* end() const { return sights_.data() + count_; }

 private:
    std::array<Sight, 8> sights_{};
    std::uint8_t count_ = 0;
};

/// Sights of one surface.
class Surface {
 public:
    /// Those that lie within `thickness` behind the nearest.
    Surface(const PixelSights& sights, float nearest, float thickness) {
        for (const Sight& sight : sights) {
            const float behind = nearest - sight.inverse_depth;
            if (behind >= 0 && behind <= thickness) members_[count_++] = &sight;
        }
    }

    [[nodiscard]] int views() const { return static_cast<int>(count_); }

    [[nodiscard]] float inverse_depth() const {
        float sum = 0;
        for (std::size_t i = 0; i < count_; ++i) sum += members_[i]->inverse_depth;
        return sum / static_cast<float>(count_);
    }

    /// How many show it in a colour that may be this one.
    [[nodiscard]] int views_with(const Rgb8& color) const {
        int views = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            if (largest_difference(color, members_[i]->color) <= members_[i]->tolerance) ++views;
        }
        return views;
    }

    /// The median of each channel.
    [[nodiscard]] Rgb8 color() const {
        const auto median = [&](auto channel) {
            std::array<std::uint8_t, 8> levels{};
            for (std::size_t i = 0; i < count_; ++i) levels[i] = channel(members_[i]->color);
            const auto middle = levels.begin() + static_cast<std::ptrdiff_t>(count_ / 2);
            std::nth_element(levels.begin(), middle,
                             levels.begin() + static_cast<std::ptrdiff_t>(count_));
            return *middle;
        };
        return {median([](const Rgb8& c) { return c.r; }),
                median([](const Rgb8& c) { return c.g; }),
                median([](const Rgb8& c) { return c.b; })};
    }

    [[nodiscard]] int tolerance() const {
        int largest = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            largest = std::max<int>(largest, members_[i]->tolerance);
        }
        return largest;
    }

 private:
    std::array<const Sight*, 8> members_{};
    std::size_t count_ = 0;
};

/// The surface that most agree upon, and of those the nearest.
Surface surface_of_most(const PixelSights& sights, float thickness) {
    Surface best(sights, -1.0F, 0.0F);  // None.
    for (const Sight& sight : sights) {
        const Surface surface(sights, sight.inverse_depth, thickness);
        if (surface.views() > best.views() ||
            (surface.views() == best.views() && surface.inverse_depth() > best.inverse_depth())) {
            best = surface;
        }
    }
    return best;
}

/// Whether two views agree upon a surface in this colour.
bool is_shown_by_two(const PixelSights& sights, const Rgb8& color, float thickness) {
    return std::any_of(sights.begin(), sights.end(), [&](const Sight& sight) {
        return Surface(sights, sight.inverse_depth, thickness).views_with(color) >= 2;
    });
}

/// Whether they show it alike, and the view something else, by more than so many tolerances.
bool is_in_another_color(const Surface& surface, const Rgb8& own, int tolerances) {
    constexpr int kLeastDifference = 12;  // 8-bit levels.
    const Rgb8 color = surface.color();
    if (4 * surface.views_with(color) < 3 * surface.views()) return false;
    return largest_difference(own, color) >
           tolerances * std::max(kLeastDifference, surface.tolerance());
}

/// Whether the view knows something nearer there, as two others confirm.
bool is_confirmed_before(const DepthMap& known, int x, int y, float inverse_depth) {
    return known.confidence(x, y) == kConfirmedBySeveral &&
           known.inverse_depth(x, y) > inverse_depth;
}

/// Whether most of the views that could see the surface do, in its colour. Those that have it in
/// their frame could, but where they know something before it.
bool is_seen_by_most(const std::vector<KnownView>& views, const std::vector<Witness>& witnesses,
                     int x, int y, const Surface& surface) {
    constexpr double kSameSurfacePx = 1.5;
    const Rgb8 color = surface.color();
    int could = 0;
    int do_see = 0;
    for (const Witness& witness : witnesses) {
        const KnownView& other = views[static_cast<std::size_t>(witness.view)];
        const auto place =
            place_in_view(other.known, witness.other_from_own, x, y, surface.inverse_depth());
        if (!place || other.disparity_px_per_inverse_depth <= 0) continue;
        const double same = kSameSurfacePx / other.disparity_px_per_inverse_depth;
        if (place->ahead < -same) continue;
        ++could;
        if (other.known.confidence(place->x, place->y) == 0 || place->ahead > same) continue;
        const Rgb8 there = witness.match.in_own_colors(other.picture(place->x, place->y));
        if (largest_difference(color, there) <= surface.tolerance()) ++do_see;
    }
    return 2 * do_see > could;
}

/// What the witnesses know, carried into the view.
Image<PixelSights> gathered_sights(const std::vector<KnownView>& views,
                                   const std::vector<Witness>& witnesses, int width, int height) {
    Image<PixelSights> sights(width, height);
    for (std::size_t k = 0; k < witnesses.size(); ++k) {
        const Witness& witness = witnesses[k];
        const KnownView& other = views[static_cast<std::size_t>(witness.view)];
        const auto tolerance = static_cast<std::uint8_t>(std::min(255, witness.match.tolerance));
        warp_rows(other.known, witness.own_from_other, {width, height, 0, 0}, 1,
                  [&](int y, const WarpedRow& warped) {
                      for (std::size_t i = 0; i < warped.rows.size(); ++i) {
                          if (warped.rows[i] < 0) continue;
                          const Rgb8& color = other.picture(static_cast<int>(i), y);
                          sights(warped.columns[i], warped.rows[i])
                              .add({warped.inverse_depths[i], witness.match.in_own_colors(color),
                                    static_cast<std::uint8_t>(k), tolerance});
                      }
                  });
    }
    return sights;
}

}  // namespace

OthersAgree others_agree(const std::vector<KnownView>& views, const std::vector<Witness>& witnesses,
                         int view_index) {
    constexpr int kLeastViews = 2;
    constexpr int kLeastViewsToBeCertain = 3;
    const KnownView& own = views[static_cast<std::size_t>(view_index)];
    const int width = own.picture.width();
    const int height = own.picture.height();
    OthersAgree result{{FloatImage(width, height), GrayImage(width, height)},
                       GrayImage(width, height)};
    if (witnesses.size() < kLeastViews) return result;
    const Image<PixelSights> sights = gathered_sights(views, witnesses, width, height);
    const auto thickness = static_cast<float>(2 / own.disparity_px_per_inverse_depth);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Surface surface = surface_of_most(sights(x, y), thickness);
            if (surface.views() < kLeastViews) continue;
            const float inverse_depth = surface.inverse_depth();
            result.agreed.inverse_depth(x, y) = inverse_depth;
            result.agreed.confidence(x, y) = kConfirmedBySeveral;
            const Rgb8& color = own.picture(x, y);
            if (!is_in_another_color(surface, color, 1)) continue;
            if (is_confirmed_before(own.known, x, y, inverse_depth + thickness)) continue;
            if (is_shown_by_two(sights(x, y), color, thickness)) continue;
            const bool is_certain = surface.views() >= kLeastViewsToBeCertain &&
                                    is_in_another_color(surface, color, 2) &&
                                    is_seen_by_most(views, witnesses, x, y, surface);
            result.is_unlike(x, y) =
                is_certain ? OthersAgree::kUnlike : OthersAgree::kPerhapsUnlike;
        }
    }
    return result;
}

}  // namespace lumi
