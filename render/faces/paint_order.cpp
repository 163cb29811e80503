#include "render/faces/paint_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "render/transfer/polygon_clipping.h"
#include "render/transfer/polygon_extent.h"

namespace lumi {
namespace {

/// Overlaps narrower than this are the seams between neighbours, not overlaps.
constexpr double kSeam_px = 0.05;
/// Pieces reach less than that under what is painted after them, but enough to close every crack.
constexpr double kSeamsBeyond = 5.0;

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
    std::vector<std::vector<std::size_t>> overlapped;  ///< In either order.
};

/// What of a polygon remains beside one that is painted after it: each side of that one parts off a
/// piece. Pieces reach into it by a seam.
std::vector<FacePolygon> pieces_beside(const FacePolygon& polygon, const FacePolygon& later) {
    std::vector<FacePolygon> pieces;
    std::vector<Eigen::Vector2d> rest = polygon.corners_px;
    for (const Eigen::Vector3d& line : later.side_lines) {
        if (line.isZero(0)) continue;
        const Eigen::Vector3d seam(0, 0, kSeam_px * line.head<2>().norm());
        if (clipped(rest, -line - seam).size() < 3) continue;
        pieces.push_back(polygon);
        pieces.back().corners_px = clipped(rest, -line + seam / kSeamsBeyond);
        rest = clipped(rest, line);
        if (rest.size() < 3) break;
    }
    return pieces;
}

Constraints constraints_between(const std::vector<FacePolygon>& polygons) {
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const FacePolygon& polygon : polygons) boxes.push_back(bounding_box(polygon.corners_px));
    Constraints found{std::vector<std::vector<std::size_t>>(polygons.size()),
                      std::vector<int>(polygons.size(), 0),
                      std::vector<std::vector<std::size_t>>(polygons.size())};
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
            found.overlapped[i].push_back(j);
            found.overlapped[j].push_back(i);
        }
    }
    return found;
}

}  // namespace

std::vector<FacePolygon> without_overlaps(std::vector<FacePolygon> polygons) {
    Constraints constraints = constraints_between(polygons);
    std::vector<std::size_t> order;
    std::vector<bool> painted(polygons.size(), false);
    while (order.size() < polygons.size()) {
        std::optional<std::size_t> next;
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            if (painted[i]) continue;
            if (!next) next = i;  // Entered when all that is left waits for each other.
            if (constraints.waiting_for[i] > 0) continue;
            next = i;
            break;
        }
        painted[*next] = true;
        for (const std::size_t later : constraints.later[*next]) --constraints.waiting_for[later];
        order.push_back(*next);
    }
    std::vector<std::size_t> place(polygons.size());
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
    std::vector<FacePolygon> result;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        std::vector<FacePolygon> pieces{polygons[i]};
        for (const std::size_t other : constraints.overlapped[i]) {
            if (place[other] < place[i]) continue;
            std::vector<FacePolygon> kept;
            for (const FacePolygon& piece : pieces)
                for (FacePolygon& beside : pieces_beside(piece, polygons[other]))
                    kept.push_back(std::move(beside));
            pieces = std::move(kept);
        }
        std::move(pieces.begin(), pieces.end(), std::back_inserter(result));
    }
    return result;
}

}  // namespace lumi
