#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshing/surface/inverse_depth_range.h"
#include "render/depth_search/depth_search.h"
#include "render/faces/face_polygons.h"
#include "render/frame/frame.h"
#include "render/subdivision/blend_triangles.h"

namespace lumi {

struct PaperSubdivisionOptions {
    /// Depths that differ by more than this share of the scene's depth range are not the same.
    double depth_threshold_share = RenderOptions{}.depth_threshold_share;
    /// Triangles with a longest edge below this are not split.
    double min_size_px = RenderOptions{}.min_triangle_px;
    double max_size_px = RenderOptions{}.max_triangle_px;  ///< Longer ones are, in any case.
};

/// The paper's adaptive depth correction (section 4), to the letter: a triangle of a camera patch
/// is split in four while the depths at its corners and its centre differ, or some of these four
/// rays miss the scene, between a largest and a smallest size; triangles whose rays all miss are
/// left out. Edges that only a neighbour split, in the same patch or in the next, are split in turn
/// (T-vertex removal). Whether a view sees a vertex is yes or no: it does while depths differ by
/// less than twice DrawingChoices::occlusion_tolerance_px, where the ramp of other modes ends.
///
/// What the paper leaves open: a ray's depth is what two of the patch's three views agree on, their
/// mean, or else the nearest that one sees, or a guess (DepthSearch::first_hit); where the first
/// two agree the third is not asked. So it is at a camera's own vertex, too, where the paper looks
/// up that camera's depth map alone. Of smallest triangles of which rays miss the scene those are
/// drawn whose centre meets it, their other vertices on the scene plane. Depth comes from the
/// views' depth maps; where the paper casts rays into a mesh or a volume, these are seen through
/// depth maps made of them for each photograph, by a z-buffer or by rays (`[depth] model`).
[[nodiscard]] BlendTriangles paper_subdivision(const std::vector<FacePolygon>& polygons,
                                               const DepthSearch& search,
                                               const Eigen::Vector3d& scene_plane,
                                               const InverseDepthRange& scene,
                                               bool correct_occlusion,
                                               const PaperSubdivisionOptions& options = {});

/// What a frame of these polygons consists of: with the Lumigraph's scene plane and depth range,
/// and the options that a frame asks for.
[[nodiscard]] BlendTriangles paper_triangles(const std::vector<FacePolygon>& polygons,
                                             const Lumigraph& lumigraph,
                                             const SearchedViews& searched_views, const Eye& eye,
                                             const RenderOptions& options);

}  // namespace lumi
