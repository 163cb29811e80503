#pragma once

#include <map>
#include <utility>
#include <vector>

#include "meshing/selection/enclosing_views.h"
#include "meshing/surface/pictured_view.h"

namespace lumi {

/// A photograph at the size of thumbnails; `camera` is of the size of the whole photograph.
[[nodiscard]] ColorImage thumbnail_of(const ColorImage& photograph, const Camera& camera);

/// Predicts photographs from those of other views, all at the size of thumbnails: what leaving a
/// view out costs, at a small part of what drawing costs.
///
/// Each view is carried into the other's raster by its own depth, the nearest surface before the
/// rest. Predicted is the weighted mean of the views that see the surface that is nearest of all;
/// what none sees counts as the largest difference.
class ThumbnailPrediction {
 public:
    /// Photographs may be thumbnails already.
    explicit ThumbnailPrediction(const std::vector<PicturedView>& views);

    /// Mean squared difference in 8-bit steps between a view's thumbnail and its prediction, as
    /// 10 log10: what is lost of its PSNR, up to a constant. At most 80 steps count at a pixel.
    [[nodiscard]] double loss_db(int view, const EnclosingViews& from);

    /// Gives back what predictions from this view take.
    void forget(int view);

 private:
    struct Thumbnail {
        Camera camera;
        Rigid3 cam_from_world;
        ColorImage photograph;
        FloatImage inverse_depth;  ///< Of the same size; negative where it is unknown.
    };
    /// A thumbnail carried into another one's raster.
    struct Carried {
        FloatImage inverse_depth;  ///< There; negative where nothing was carried to.
        ColorImage color;
    };

    [[nodiscard]] static Thumbnail thumbnail_of(const PicturedView& view);
    [[nodiscard]] Carried carry(const Thumbnail& from, const Thumbnail& to) const;
    [[nodiscard]] const Carried& carried(int from, int to);

    std::vector<Thumbnail> thumbnails_;
    double same_surface_ = 0.0;  ///< Inverse depths that differ by less are of one surface.
    std::map<std::pair<int, int>, Carried> carried_;  ///< By (from, to).
};

}  // namespace lumi
