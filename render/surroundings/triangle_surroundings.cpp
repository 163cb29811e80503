#include "render/surroundings/triangle_surroundings.h"

#include "render/surroundings/empty_cells.h"

namespace lumi {

void set_surroundings(const Lumigraph& lumigraph, const SmallPhotographs& small, const Eye& eye,
                      BlendTriangles& triangles, double border_px) {
    PictureCells cells(eye.camera);
    mark_where_none_may_be_shown(triangles, lumigraph.views, cells, border_px);
    if (!cells.is_any_marked()) return;
    const ColorGrid colors = surrounding_colors(lumigraph, small, eye, cells);
    for (BlendVertex& vertex : triangles.vertices) {
        const Eigen::Vector3f color = colors.at(vector_of(vertex.pixel));
        vertex.surroundings = {color.x(), color.y(), color.z()};
    }
}

}  // namespace lumi
