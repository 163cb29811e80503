#include "render/modes/paint_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>

#include "render/modes/polygon_clipping.h"

namespace lumi {
namespace {

/// Overlaps narrower than this are the seams between neighbours, not overlaps.
constexpr double kSeam_px = 0.05;

using Box = Eigen::AlignedBox2d;

Box bounds(const FacePolygon& polygon) {
    Box box;
    for (const Eigen::Vector2d& corner : polygon.corners_px) box.extend(corner);
    return box;
}

/// True when one of the polygon's side lines has all corners of the other beyond it, but for a
/// seam: so it is for neighbours.
bool separates(const FacePolygon& polygon, const FacePolygon& other) {
    return std::any_of(polygon.side_lines.begin(), polygon.side_lines.end(),
                       [&](const Eigen::Vector3d& line) {
                           if (line.isZero(0)) return false;
                           const double seam = kSeam_px * line.head<2>().norm();
                           return std::all_of(other.corners_px.begin(), other.corners_px.end(),
                                              [&](const Eigen::Vector2d& corner) {
                                                  return line.dot(corner.homogeneous()) <= seam;
                                              });
                       });
}

/// A pixel well inside both polygons, if there is one. A polygon is the picture cut by its three
/// side lines, so it is enough to cut one by the lines of the other, moved inwards by the seam.
std::optional<Eigen::Vector2d> common_pixel(const FacePolygon& a, const FacePolygon& b) {
    std::vector<Eigen::Vector2d> corners = a.corners_px;
    for (const FacePolygon* polygon : {&a, &b}) {
        for (const Eigen::Vector3d& line : polygon->side_lines) {
            Eigen::Vector3d inner = line;
            inner.z() -= kSeam_px * line.head<2>().norm();
            corners = clipped(corners, inner);
        }
    }
    if (corners.size() < 3) return std::nullopt;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& corner : corners) centre += corner;
    return centre / static_cast<double>(corners.size());
}

double crossing_at(const FacePolygon& polygon, const Eigen::Vector2d& pixel) {
    double sum = 0;
    for (const Eigen::Vector3d& line : polygon.side_lines) sum += line.dot(pixel.homogeneous());
    return polygon.crossing_numerator / sum;
}

/// For each polygon, those that must be painted after it.
struct Constraints {
    std::vector<std::vector<std::size_t>> later;
    std::vector<int> waiting_for;
};

Constraints constraints_between(const std::vector<FacePolygon>& polygons) {
    std::vector<Box> boxes;
    for (const FacePolygon& polygon : polygons) boxes.push_back(bounds(polygon));
    Constraints found{std::vector<std::vector<std::size_t>>(polygons.size()),
                      std::vector<int>(polygons.size(), 0)};
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        for (std::size_t j = i + 1; j < polygons.size(); ++j) {
            if (!boxes[i].intersects(boxes[j]) || separates(polygons[i], polygons[j]) ||
                separates(polygons[j], polygons[i]))
                continue;
            const std::optional<Eigen::Vector2d> pixel = common_pixel(polygons[i], polygons[j]);
            if (!pixel) continue;
            const bool i_first =
                crossing_at(polygons[i], *pixel) < crossing_at(polygons[j], *pixel);
            found.later[i_first ? i : j].push_back(i_first ? j : i);
            ++found.waiting_for[i_first ? j : i];
        }
    }
    return found;
}

}  // namespace

std::vector<FacePolygon> in_paint_order(std::vector<FacePolygon> polygons) {
    Constraints constraints = constraints_between(polygons);
    std::vector<FacePolygon> sorted;
    std::vector<bool> painted(polygons.size(), false);
    while (sorted.size() < polygons.size()) {
        std::optional<std::size_t> next;
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            if (painted[i]) continue;
            if (!next) next = i;  // Entered when all that is left waits for each other.
            if (constraints.waiting_for[i] > 0) continue;
            next = i;
            break;
        }
        painted[*next] = true;
        for (const std::size_t later : constraints.later[*next]) {
            --constraints.waiting_for[later];
            polygons[later].overlaps_earlier = true;
        }
        sorted.push_back(std::move(polygons[*next]));
    }
    return sorted;
}

}  // namespace lumi
