#include "meshing/agreement/depth_of_others.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "meshing/agreement/gap_closing.h"
#include "meshing/agreement/seen_past.h"
#include "meshing/depth_scene/views_around.h"
#include "meshing/exposure/color_match.h"
#include "meshing/exposure/shared_colors.h"
#include "meshing/warp/warped_rows.h"

namespace lumi {
namespace {

using Claim = DepthOfOthers::Claim;

/// What several views say alike of one pixel.
struct Agreement {
    float inverse_depth = 0.0F;  ///< Mean.
    int views = 0;
    int first_asked = -1;  ///< One of them, by its place in the order of asking.
};

/// Inverse depths that other views claim for the unknown pixels of a view, at most one a view.
template <std::size_t kMost>
class PixelClaims {
 public:
    explicit PixelClaims(const GrayImage& confidence)
        : slot_of_pixel_(confidence.width(), confidence.height(), -1) {
        int slots = 0;
        for (std::size_t i = 0; i < slot_of_pixel_.pixels().size(); ++i) {
            if (confidence.pixels()[i] == 0) slot_of_pixel_.pixels()[i] = slots++;
        }
        slots_.resize(static_cast<std::size_t>(slots));
    }

    [[nodiscard]] bool is_wanted(int x, int y) const { return slot_of_pixel_(x, y) >= 0; }

    /// The first `kMost` views that have something to say count: they stand nearest.
    void add(int x, int y, std::uint8_t asked, float inverse_depth) {
        Slot& slot = slot_at(x, y);
        if (slot.count > 0 && slot.asked[slot.count - 1U] == asked) {
            // Of one view what is nearer hides the rest.
            float& last = slot.inverse_depths[slot.count - 1U];
            last = std::max(last, inverse_depth);
            return;
        }
        if (slot.count == kMost) return;
        slot.inverse_depths[slot.count] = inverse_depth;
        slot.asked[slot.count++] = asked;
    }

    /// What most views agree upon, each within `tolerance` of the middle; of that the nearest.
    [[nodiscard]] Agreement agreement(int x, int y, float tolerance) const {
        const Slot& slot = slots_[static_cast<std::size_t>(slot_of_pixel_(x, y))];
        Agreement best;
        for (std::size_t nearest = 0; nearest < slot.count; ++nearest) {
            const float near = slot.inverse_depths[nearest];
            float sum = 0;
            int views = 0;
            for (std::size_t i = 0; i < slot.count; ++i) {
                const float behind = near - slot.inverse_depths[i];
                if (behind < 0 || behind > 2 * tolerance) continue;
                sum += slot.inverse_depths[i];
                ++views;
            }
            const float mean = sum / static_cast<float>(views);
            if (views < best.views || (views == best.views && mean <= best.inverse_depth)) continue;
            best = {mean, views, slot.asked[nearest]};
        }
        return best;
    }

 private:
    struct Slot {
        std::array<float, kMost> inverse_depths{};
        std::array<std::uint8_t, kMost> asked{};
        std::uint8_t count = 0;
    };

    [[nodiscard]] Slot& slot_at(int x, int y) {
        return slots_[static_cast<std::size_t>(slot_of_pixel_(x, y))];
    }

    Image<int> slot_of_pixel_;
    std::vector<Slot> slots_;
};

/// In the colour that the view shows.
using Claims = PixelClaims<6>;
/// In another; two are enough.
using Denials = PixelClaims<4>;

/// Another view, asked about the pixels of a view.
struct Witness {
    const DepthView* view;
    const DepthMap* map;
    InverseDepthWarp own_from_other;
    ColorImage picture;  ///< Averaged.
    ColorMatch match;
};

/// Empty where the views share too little to compare colours.
std::optional<Witness> witness(const DepthScene& scene, const std::vector<DepthMap>& maps,
                               int view_index, const ColorImage& own_picture, int other_index) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    const DepthView& other = scene.views[static_cast<std::size_t>(other_index)];
    const DepthMap& map = maps[static_cast<std::size_t>(other_index)];
    const InverseDepthWarp own_from_other = warp_from(other).to(view);
    ColorImage picture = averaged(other.photograph);
    constexpr int kStep = 8;
    const auto match = color_match(shared_colors(
        {maps[static_cast<std::size_t>(view_index)], own_picture}, {map, picture}, own_from_other,
        static_cast<float>(1 / view.disparity_px_per_inverse_depth), kStep));
    if (!match) return std::nullopt;
    return Witness{&other, &map, own_from_other, std::move(picture), *match};
}

/// What the witness knows in the colour that the view shows, and what in another.
void add_claims(const Witness& witness, std::uint8_t asked, const ColorImage& own_picture,
                Claims& claims, Denials& denials) {
    const WarpRaster raster{own_picture.width(), own_picture.height(), 0, 0};
    warp_rows(*witness.map, witness.own_from_other, raster, 1, [&](int y, const WarpedRow& warped) {
        for (std::size_t i = 0; i < warped.rows.size(); ++i) {
            if (warped.rows[i] < 0) continue;
            const int column = warped.columns[i];
            const int row = warped.rows[i];
            if (!claims.is_wanted(column, row)) continue;
            const Rgb8& color = witness.picture(static_cast<int>(i), y);
            const bool is_same = witness.match.is_same(own_picture(column, row), color);
            if (is_same) {
                claims.add(column, row, asked, warped.inverse_depths[i]);
            } else {
                denials.add(column, row, asked, warped.inverse_depths[i]);
            }
        }
    });
}

DepthMap empty_map(int width, int height) {
    return {FloatImage(width, height), GrayImage(width, height)};
}

void set_known(DepthMap& map, int x, int y, float inverse_depth) {
    map.inverse_depth(x, y) = inverse_depth;
    map.confidence(x, y) = kKnown;
}

/// Closing gaps reaches over what the view knows, and what is agreed upon.
void forget_hidden_where_known(const Claims& claims, DepthOfOthers& others) {
    for (int y = 0; y < others.hidden.confidence.height(); ++y) {
        for (int x = 0; x < others.hidden.confidence.width(); ++x) {
            if (claims.is_wanted(x, y) && others.agreed.confidence(x, y) == 0) continue;
            others.hidden.confidence(x, y) = 0;
        }
    }
}

/// Claims of enough views; of the other pixels what is claimed, if anything is, and what is denied.
DepthOfOthers told_apart(const Claims& claims, const Denials& denials,
                         const std::vector<int>& asked, int width, int height, float one_pixel) {
    constexpr int kLeastViews = 3;
    constexpr int kLeastDenying = 2;
    DepthOfOthers result{empty_map(width, height), {}, empty_map(width, height)};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (!claims.is_wanted(x, y)) continue;
            const Agreement found = claims.agreement(x, y, one_pixel);
            if (found.views >= kLeastViews) {
                set_known(result.agreed, x, y, found.inverse_depth);
                continue;
            }
            if (found.views > 0) {
                const int view = asked[static_cast<std::size_t>(found.first_asked)];
                result.doubtful.push_back({x, y, view, found.inverse_depth});
            }
            const Agreement denied = denials.agreement(x, y, one_pixel);
            if (denied.views >= kLeastDenying && denied.views > found.views) {
                set_known(result.hidden, x, y, denied.inverse_depth);
            }
        }
    }
    result.hidden = with_gaps_closed(result.hidden);
    result.agreed = with_gaps_closed(result.agreed);
    std::erase_if(result.doubtful, [&](const Claim& claim) {
        return result.agreed.confidence(claim.x, claim.y) != 0;
    });
    forget_hidden_where_known(claims, result);
    return result;
}

/// Whether the view sees past a surface at this place of another, or another colour there.
bool refutes(const Witness& witness, const InverseDepthWarp& other_from_own, const Claim& claim,
             float continued, const Rgb8& color) {
    const std::optional<PlaceInView> there =
        place_in_view(*witness.map, other_from_own, claim.x, claim.y, continued);
    if (!there) return false;
    const double clearly = kClearlyApartPx / witness.view->disparity_px_per_inverse_depth;
    if (there->ahead > clearly) return true;
    if (there->ahead < -clearly) return false;  // Hidden from there.
    return !witness.match.is_same(color, witness.picture(there->x, there->y));
}

}  // namespace

DepthOfOthers depth_of_others(const DepthScene& scene, const std::vector<DepthMap>& maps,
                              int view_index) {
    constexpr std::size_t kMostAsked = 255;
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    const GrayImage& confidence = maps[static_cast<std::size_t>(view_index)].confidence;
    const int width = confidence.width();
    const int height = confidence.height();
    if (view.disparity_px_per_inverse_depth <= 0) {
        return {empty_map(width, height), {}, empty_map(width, height)};
    }
    const ColorImage own_picture = averaged(view.photograph);
    std::vector<int> asked = views_around(scene, view_index);
    asked.resize(std::min(asked.size(), kMostAsked));
    Claims claims(confidence);
    Denials denials(confidence);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto other = witness(scene, maps, view_index, own_picture, asked[i]);
        if (other) add_claims(*other, static_cast<std::uint8_t>(i), own_picture, claims, denials);
    }
    const auto one_pixel = static_cast<float>(1 / view.disparity_px_per_inverse_depth);
    return told_apart(claims, denials, asked, width, height, one_pixel);
}

void take_claims_against(const DepthScene& scene, const std::vector<DepthMap>& maps, int view_index,
                         std::vector<Claim> claims, DepthMap& map, FloatImage& distance_px) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    const ColorImage own_picture = averaged(view.photograph);
    std::sort(claims.begin(), claims.end(),
              [](const Claim& a, const Claim& b) { return a.view < b.view; });
    for (auto first = claims.begin(); first != claims.end();) {
        const int asked = first->view;
        const auto last = std::find_if(first, claims.end(),
                                       [&](const Claim& claim) { return claim.view != asked; });
        if (const auto other = witness(scene, maps, view_index, own_picture, asked)) {
            const InverseDepthWarp other_from_own = warp_from(view).to(*other->view);
            std::for_each(first, last, [&](const Claim& claim) {
                float& continued = map.inverse_depth(claim.x, claim.y);
                const Rgb8& color = own_picture(claim.x, claim.y);
                if (!refutes(*other, other_from_own, claim, continued, color)) return;
                continued = claim.inverse_depth;
                distance_px(claim.x, claim.y) = 0;
            });
        }
        first = last;
    }
}

}  // namespace lumi
