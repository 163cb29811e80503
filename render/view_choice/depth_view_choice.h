#pragma once

#include <array>
#include <vector>

#include "render/lumigraph/lumigraph.h"
#include "render/transfer/view_geometry.h"

namespace lumi {

/// Views to ask for depth, in the order of their use, and the share of the picture that they are
/// asked for.
struct DepthViewSet {
    std::vector<int> view_indices;
    double share = 1.0;
};

/// No more sets than this are made for an eye: with half as many, shares change in leaps where many
/// are nearly as good.
inline constexpr int kMaxDepthViewSets = 8;

/// The views, at most `max_views`, whose depth is most use to the eye: those that see what it sees
/// from nearly the same direction, and together as much of it as they can.
///
/// The eye's picture is sampled on a grid (view_sight.h). Views are taken one by one; each adds,
/// for every sample in its photograph, the more the smaller the angle between view and eye, and the
/// less the more views see it already. The first is the nearest. Views that see nothing of it are
/// left out, unless all are, and so are those without depth, unless none has any.
[[nodiscard]] std::vector<int> choose_depth_views(const Lumigraph& lumigraph, const Eye& eye,
                                                  int max_views);

/// The same for an eye that moves: where the next view would be nearly as much use, there is a set
/// with either. Their shares, whose sum is 1, change steadily with the eye, so that nothing has to
/// change all at once where one view is exchanged for another. In an order that does not depend on
/// the eye.
[[nodiscard]] std::vector<DepthViewSet> depth_view_sets(const Lumigraph& lumigraph, const Eye& eye,
                                                        int max_views);

/// One to three views, for what asks three always: where there are less the last is named again.
[[nodiscard]] std::array<int, 3> three_with_repeats(const std::vector<int>& view_indices);

/// agreeing_inverse_depth (view_geometry.h) of the sets' views: the mean by their shares.
[[nodiscard]] double agreeing_inverse_depth(const Lumigraph& lumigraph,
                                            const std::vector<ViewGeometry>& geometries,
                                            const std::vector<DepthViewSet>& sets,
                                            const Eigen::Vector3d& eye_in_world,
                                            double tolerance_px);

/// Each set is asked in a strip of the eye's picture, from the left to the right, as wide as its
/// share: where the strips end, in columns of a picture of this width (faces/strip_ends.h). Strips
/// move with the eye, so that it is a line that passes when one view is exchanged for another.
[[nodiscard]] std::vector<int> strip_ends(const std::vector<DepthViewSet>& sets, int width_px);

}  // namespace lumi
