#pragma once

#include <memory>

#include "render/frame/frame.h"
#include "render/subdivision/edge_error.h"
#include "render/subdivision/outline_cells.h"
#include "render/subdivision/patch_sampler.h"

namespace lumi {

struct AdaptiveSubdivisionOptions {
    double max_error_px = 0.7;    ///< Of where the three photographs are looked up.
    EdgeErrorCounts counts = {};  ///< Where there is no depth, all is a guess, and is followed.
    double min_edge_px = 12.0;    ///< Shorter edges are not split, but cut at outlines.
    double max_edge_px = 96.0;    ///< Longer ones are, in any case.
    /// Where there would be more, all errors above are relaxed alike. 0: any number.
    std::size_t max_triangles = 5000;
};

/// The subdivision's options for a frame with these options.
[[nodiscard]] AdaptiveSubdivisionOptions subdivision_options(const Lumigraph& lumigraph,
                                                             const RenderOptions& options);

struct AdaptiveSubdivision {
    BlendTriangles triangles;
    /// The factor by which errors were relaxed to keep to the number of triangles; 1: not at all.
    double relaxation = 1.0;
};

/// Face polygons as triangles on which looking up the photographs at interpolated places is right
/// to within an error in pixels (methods: 1.D).
///
/// Whether an edge is split is decided at its midpoint, by how far the places where the photographs
/// are looked up lie from halfway between those of its ends, each photograph counting as its
/// weight. Both sides of an edge come to the same decision, also across faces, as the photograph
/// that they do not share has no weight there: no cracks, without a pass that removes T-vertices.
/// Long edges are split also where views know of an outline beside them (outline_cells.h), which
/// the midpoint may miss. Triangles that become too thin are split no more but where their
/// neighbours are. What is split no more is cut where its edges cross outlines
/// (outline_crossing.h), so that each lies on one surface. A plane is split only for the
/// perspective in it, and cameras that are close together ask for less.
///
/// Errors are relaxed until the triangles are few enough (relaxation_search.h). What was seen of
/// the scene for one subdivision serves the others, so that it is hardly looked at for more than is
/// drawn.
class AdaptiveSubdivider {
 public:
    AdaptiveSubdivider();
    ~AdaptiveSubdivider();
    AdaptiveSubdivider(AdaptiveSubdivider&&) noexcept;
    AdaptiveSubdivider& operator=(AdaptiveSubdivider&&) noexcept;

    /// `outlines` are of the eye that `search` is for; without them midpoints alone tell. The same
    /// for any number of threads, and whatever was subdivided before: nothing but memory is kept.
    [[nodiscard]] AdaptiveSubdivision subdivide(const std::vector<FacePolygon>& polygons,
                                                const DepthSearch& search,
                                                const Eigen::Vector3d& scene_plane,
                                                const PatchSampler::Options& sampling,
                                                const AdaptiveSubdivisionOptions& options,
                                                const OutlineCells& outlines = {});

 private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

/// One subdivision, by an AdaptiveSubdivider of its own.
[[nodiscard]] AdaptiveSubdivision adaptive_subdivision(
    const std::vector<FacePolygon>& polygons, const DepthSearch& search,
    const Eigen::Vector3d& scene_plane, const PatchSampler::Options& sampling,
    const AdaptiveSubdivisionOptions& options = {});

}  // namespace lumi
