#include "render/faces/asked_views.h"

#include <algorithm>

namespace lumi {
namespace {

bool is_among(int view, const std::vector<int>& views) {
    return std::find(views.begin(), views.end(), view) != views.end();
}

}  // namespace

std::size_t unasked_views(const std::array<int, 3>& views, const std::vector<int>& asked) {
    return static_cast<std::size_t>(std::count_if(
        views.begin(), views.end(), [&](int view) { return !is_among(view, asked); }));
}

std::vector<FacePolygon> asked_first(const std::vector<FacePolygon>& polygons,
                                     const std::vector<int>& asked) {
    std::vector<FacePolygon> ordered = polygons;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        std::array<std::size_t, 3> order{0, 1, 2};
        std::stable_partition(order.begin(), order.end(), [&](std::size_t corner) {
            return is_among(polygons[i].view_indices[corner], asked);
        });
        for (std::size_t corner = 0; corner < 3; ++corner) {
            ordered[i].view_indices[corner] = polygons[i].view_indices[order[corner]];
            ordered[i].side_lines[corner] = polygons[i].side_lines[order[corner]];
            ordered[i].beyond_border[corner] = polygons[i].beyond_border[order[corner]];
        }
    }
    return ordered;
}

}  // namespace lumi
