#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "render/depth_search/occlusion.h"
#include "render/faces/face_polygons.h"
#include "render/lumigraph/lumigraph.h"
#include "render/subdivision/blend_triangles.h"
#include "render/surroundings/picture_cells.h"

namespace lumi {

/// Whether a triangle may have pixels that none of its photographs shows: unless one of them has a
/// weight all over it and shows all three corners, inside by its unsure border.
/// `views` are those that the vertices name.
[[nodiscard]] bool may_show_none(const std::array<const BlendVertex*, 3>& corners,
                                 const std::vector<LumigraphView>& views,
                                 double border_px = kFinestBorder_px);

/// Marks the cells that such triangles touch.
void mark_where_none_may_be_shown(const BlendTriangles& triangles,
                                  const std::vector<LumigraphView>& views, PictureCells& cells,
                                  double border_px = kFinestBorder_px);

/// Marks the cells in which a face's cameras may all look past the place where the ray meets
/// `plane` (a line as from scene_plane_inverse_depth): unless one of them has a weight all over the
/// cell and shows its four corners, inside by its unsure border.
void mark_where_none_may_be_shown(const std::vector<FacePolygon>& polygons,
                                  const std::vector<LumigraphView>& views, const Eye& eye,
                                  const Eigen::Vector3d& plane, PictureCells& cells,
                                  double border_px = kFinestBorder_px);

/// Marks the cells that reach beyond the camera mesh as the eye sees it: there is no face to look
/// through, as far behind the cameras or past the mesh's border.
void mark_beyond_mesh(const CameraMesh& mesh, const Eye& eye, PictureCells& cells);

}  // namespace lumi
