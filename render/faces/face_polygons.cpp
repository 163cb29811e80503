#include "render/faces/face_polygons.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "calib/capture/calibration_matrix.h"
#include "render/faces/blend_strips.h"
#include "render/faces/paint_order.h"
#include "render/transfer/polygon_clipping.h"

namespace lumi {
namespace {

/// Side products below this share of the face's extent vanish: the eye stands on the edge.
constexpr double kVanishingShare = 1e-10;

using Corners = std::vector<Eigen::Vector2d>;

double value_at(const Eigen::Vector3d& line, const Eigen::Vector2d& pixel) {
    return line.dot(pixel.homogeneous());
}

double largest_on(const Corners& corners, const Eigen::Vector3d& line) {
    double largest = 0;
    for (const Eigen::Vector2d& corner : corners)
        largest = std::max(largest, std::abs(value_at(line, corner)));
    return largest;
}

/// What is needed of the eye: where it is, which way it looks, and the direction of each pixel's
/// ray.
struct EyeRays {
    Eigen::Vector3d eye_in_world;
    Eigen::Vector3d line_of_sight;
    Eigen::Matrix3d direction_from_pixel;  ///< World direction, of unit depth, from (x, y, 1).
    Corners picture;
    double longest_direction = 0.0;
};

EyeRays eye_rays(const Eye& eye) {
    EyeRays rays;
    rays.eye_in_world = centre_in_world(eye.cam_from_world);
    rays.line_of_sight = optical_axis_in_world(eye.cam_from_world);
    rays.direction_from_pixel = eye.cam_from_world.rotation.conjugate().toRotationMatrix() *
                                calibration_matrix(eye.camera).inverse();
    rays.picture = picture_corners_px(eye.camera);
    for (const Eigen::Vector2d& corner : rays.picture)
        rays.longest_direction = std::max(
            rays.longest_direction, (rays.direction_from_pixel * corner.homogeneous()).norm());
    return rays;
}

/// Lines of the side products, exactly zero where they vanish on the whole picture: at a camera's
/// centre two of them do, and rounding errors must not cut the picture into pieces.
std::array<Eigen::Vector3d, 3> side_lines(const std::array<Eigen::Vector3d, 3>& from_eye,
                                          const EyeRays& rays) {
    const double extent = std::max({from_eye[0].norm(), from_eye[1].norm(), from_eye[2].norm()});
    const double vanishing = kVanishingShare * extent * extent * rays.longest_direction;
    std::array<Eigen::Vector3d, 3> lines;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d normal = from_eye[(i + 1) % 3].cross(from_eye[(i + 2) % 3]);
        lines[i] = -(rays.direction_from_pixel.transpose() * normal);
        if (largest_on(rays.picture, lines[i]) <= vanishing) lines[i].setZero();
    }
    return lines;
}

/// The line moved outwards by the overlap.
Eigen::Vector3d widened(const Eigen::Vector3d& line, double overlap_px) {
    return line + Eigen::Vector3d(0, 0, overlap_px * line.head<2>().norm());
}

FacePolygon polygon_of(const CameraMesh& mesh, int face_index, const EyeRays& rays,
                       double overlap_px) {
    const CameraMesh::Face& face = mesh.faces[static_cast<std::size_t>(face_index)];
    FacePolygon polygon;
    polygon.face_index = face_index;
    std::array<Eigen::Vector3d, 3> from_eye;
    for (std::size_t i = 0; i < 3; ++i) {
        const CameraMesh::Vertex& vertex = mesh.vertices[static_cast<std::size_t>(face[i])];
        polygon.view_indices[i] = vertex.view_index;
        polygon.beyond_border[i] = vertex.is_virtual ? 1.0F : 0.0F;
        from_eye[i] = vertex.position_in_world - rays.eye_in_world;
    }
    polygon.side_lines = side_lines(from_eye, rays);
    polygon.crossing_numerator = -from_eye[0].dot(from_eye[1].cross(from_eye[2]));
    polygon.corners_px = rays.picture;
    for (const Eigen::Vector3d& line : polygon.side_lines)
        polygon.corners_px = clipped(polygon.corners_px, widened(line, overlap_px));
    return polygon;
}

/// Scales the side products so that single precision holds them; empty polygons stay empty.
void normalise(FacePolygon& polygon) {
    double largest = 0;
    for (const Eigen::Vector3d& line : polygon.side_lines)
        largest = std::max(largest, largest_on(polygon.corners_px, line));
    if (!(largest > 0)) {
        polygon.corners_px.clear();
        return;
    }
    for (Eigen::Vector3d& line : polygon.side_lines) line /= largest;
    polygon.crossing_numerator /= largest;
}

/// The whole picture, in a strip for each of the eye's blends.
std::vector<FacePolygon> polygons_without_faces(const CameraMesh& mesh, const EyeRays& rays) {
    const std::vector<EyeBlend> blends = blends_of_eye(mesh, rays.eye_in_world, rays.line_of_sight);
    const double width = rays.picture[2].x();
    const double height = rays.picture[2].y();
    const std::vector<int> ends = blend_strip_ends(blends, static_cast<int>(width));
    std::vector<FacePolygon> polygons;
    double begin = 0;
    for (std::size_t strip = 0; strip < blends.size(); ++strip) {
        const double end = ends[strip];
        if (!(end > begin)) continue;
        FacePolygon polygon;
        polygon.view_indices = blends[strip].weights.view_indices;
        for (std::size_t i = 0; i < 3; ++i)
            polygon.side_lines[i] = blends[strip].weights.weights[i] * Eigen::Vector3d::UnitZ();
        polygon.corners_px = {{begin, 0}, {end, 0}, {end, height}, {begin, height}};
        polygons.push_back(std::move(polygon));
        begin = end;
    }
    return polygons;
}

}  // namespace

std::vector<FacePolygon> face_polygons(const CameraMesh& mesh, const Eye& eye, double overlap_px) {
    const EyeRays rays = eye_rays(eye);
    if (mesh.faces.empty() && !mesh.vertices.empty()) return polygons_without_faces(mesh, rays);
    std::vector<FacePolygon> polygons;
    for (std::size_t index = 0; index < mesh.faces.size(); ++index) {
        FacePolygon polygon = polygon_of(mesh, static_cast<int>(index), rays, overlap_px);
        normalise(polygon);
        if (polygon.corners_px.size() >= 3) polygons.push_back(std::move(polygon));
    }
    return without_overlaps(std::move(polygons));
}

std::array<double, 3> weights_at(const FacePolygon& polygon, const Eigen::Vector2d& pixel) {
    std::array<double, 3> products{};
    for (std::size_t i = 0; i < 3; ++i) products[i] = value_at(polygon.side_lines[i], pixel);
    std::array<double, 3> weights{};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += weights[i] = std::max(0.0, products[i]);
    if (sum > 0) {
        for (double& weight : weights) weight /= sum;
    } else {
        const auto largest = std::max_element(products.begin(), products.end());
        weights[static_cast<std::size_t>(largest - products.begin())] = 1;
    }
    return weights;
}

}  // namespace lumi
