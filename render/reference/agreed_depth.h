#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "render/depth_layers/depth_eye.h"
#include "render/depth_layers/depth_layer_views.h"
#include "render/frame/frame.h"
#include "render/reference/depth_consensus.h"
#include "render/transfer/past_sight.h"
#include "render/transfer/view_geometry.h"

namespace lumi {

/// What the views that an eye asks for depth agree on at a pixel, and the first of those that do.
struct AgreedPixelDepth {
    ConsensusDepth depth;    ///< Support 0 where nothing is known.
    int known_by = kNoView;  ///< Index of a view.
    /// What each of the views that were asked knows, by its index.
    std::map<int, EyeDepth> of_views;
};

/// The depth pre-pass of the mode `perpixel` in plain code: depth of the views that are most use to
/// the eye, each in its strips of the picture (depth_view_choice.h), drawn as finely as depth is
/// sampled (depth_eye.h).
class AgreedDepth {
 public:
    /// The Lumigraph must have depth; `geometries` are those of its views (view_geometry.h).
    AgreedDepth(const Lumigraph& lumigraph, const std::vector<ViewGeometry>& geometries,
                const Eye& eye, const RenderOptions& options);

    /// At the centre of a pixel of the eye's picture, or of a block of pixels. Where the texels of
    /// a pixel (kSmoothTexelsPerPixel) are of several surfaces, for each of them the mean of those
    /// that are of its surface; those behind tears count where there are no others.
    [[nodiscard]] std::vector<AgreedPixelDepth> samples_at(const Eigen::Vector2d& pixel) const;

    /// Whether none of the views sees what is at the place: it is stretched over tears, lies behind
    /// such, or nothing is known (holes/hole_cells.h).
    [[nodiscard]] bool is_hole(const Eigen::Vector2d& pixel) const;

 private:
    /// The views that are asked at a column of texels, kNoView among them.
    [[nodiscard]] const std::vector<int>& views_at(int column) const;
    /// What each of the views there knows of the texel that a pixel's place lies in, lone surfaces
    /// settled (depth_consensus.h).
    [[nodiscard]] std::vector<EyeDepth> depths_at(const Eigen::Vector2d& pixel) const;
    [[nodiscard]] int column_of(const Eigen::Vector2d& pixel) const;
    [[nodiscard]] AgreedPixelDepth agreed(const std::vector<EyeDepth>& depths,
                                          const std::vector<int>& views) const;

    DepthEye depth_eye_;
    std::vector<int> strip_ends_;
    DepthLayerViews layer_views_;
    double agreeing_inverse_depth_;
    std::map<int, Image<EyeDepth>> eye_depth_of_view_;
    std::map<int, PastSight> sights_;
};

}  // namespace lumi
