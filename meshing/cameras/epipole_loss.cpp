#include "meshing/cameras/epipole_loss.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "meshing/cameras/kernel.h"

namespace lumi {
namespace {

/// Slides below this share of the distance are rounding.
constexpr double kNotableSlide = 1e-9;

struct Place {
    std::vector<std::size_t> faces;
    std::vector<std::size_t> vertices;
};

/// Of the ray from the scene's corner to the view's centre, in one face; 0 when it does not cross
/// it.
double weight_of_view(const CameraMesh& mesh, std::size_t face_index, int view_index,
                      const Eigen::Vector3d& corner, const Eigen::Vector3d& centre) {
    const CameraMesh::Face& face = mesh.faces[face_index];
    const Eigen::Vector3d sides = side_products(mesh, face, corner, corner - centre);
    if (sides.minCoeff() < 0 || !(sides.sum() > 0)) return 0;
    double weight = 0;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const auto vertex = static_cast<std::size_t>(face[static_cast<std::size_t>(i)]);
        if (mesh.vertices[vertex].view_index == view_index) weight += sides[i] / sides.sum();
    }
    return weight;
}

std::map<int, Place> places_of_views(const CameraMesh& mesh) {
    std::map<int, Place> places;
    std::vector<char> seen(mesh.vertices.size(), 0);
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        for (const int corner : mesh.faces[face]) {
            const auto vertex = static_cast<std::size_t>(corner);
            Place& place = places[mesh.vertices[vertex].view_index];
            if (place.faces.empty() || place.faces.back() != face) place.faces.push_back(face);
            if (!seen[vertex]) place.vertices.push_back(vertex);
            seen[vertex] = 1;
        }
    }
    return places;
}

/// Whether the face has the vertex, and then its altitude there and its normal.
bool measure_face(const CameraMesh& mesh, const CameraMesh::Face& face, std::size_t vertex_index,
                  double& altitude, Eigen::Vector3d& normal) {
    const auto found = std::find(face.begin(), face.end(), static_cast<int>(vertex_index));
    if (found == face.end()) return false;
    const auto at = static_cast<std::size_t>(found - face.begin());
    const auto corner = [&](std::size_t step) -> const Eigen::Vector3d& {
        return mesh.vertices[static_cast<std::size_t>(face[(at + step) % 3])].position_in_world;
    };
    const Eigen::Vector3d side = (corner(2) - corner(1)).normalized();
    altitude = side.cross(corner(0) - corner(1)).norm();
    normal = face_plane(mesh, face).outward_normal;
    return true;
}

double radius_of(const CameraMesh& mesh, const std::vector<Eigen::Vector3d>& scene) {
    double radius = 0;
    for (const Eigen::Vector3d& corner : scene) {
        radius = std::max(radius, (corner - mesh.scene_centre_in_world).norm());
    }
    return radius;
}

}  // namespace

double epipole_loss_bound(const CameraMesh& mesh, std::size_t vertex_index,
                          const std::vector<std::size_t>& faces_at_vertex,
                          const Eigen::Vector3d& true_centre, double scene_radius) {
    const Eigen::Vector3d& centre = mesh.scene_centre_in_world;
    const Eigen::Vector3d& place = mesh.vertices[vertex_index].position_in_world;
    const double slide = (place - true_centre).norm();
    const double distance = std::min((place - centre).norm(), (true_centre - centre).norm());
    if (slide <= kNotableSlide * distance) return 0.0;
    if (scene_radius >= distance) return 1.0;
    const Eigen::Vector3d direction = (place - centre).normalized();
    const double alpha_rad = std::asin(scene_radius / distance);
    double bound = 0;
    for (const std::size_t face : faces_at_vertex) {
        double altitude = 0;
        Eigen::Vector3d normal;
        if (!measure_face(mesh, mesh.faces[face], vertex_index, altitude, normal)) continue;
        const double tilt_rad = std::acos(std::clamp(normal.dot(direction), -1.0, 1.0));
        const double cosine = std::cos(tilt_rad + alpha_rad);
        if (tilt_rad + alpha_rad >= std::numbers::pi / 2 || !(altitude * cosine > 0)) return 1.0;
        bound = std::max(bound, slide * scene_radius / (distance * altitude * cosine));
    }
    return std::min(bound, 1.0);
}

EpipoleLoss epipole_loss(const CameraMesh& mesh,
                         const std::function<Eigen::Vector3d(int view_index)>& centre_of_view,
                         const std::vector<Eigen::Vector3d>& scene_hull_in_world) {
    EpipoleLoss result;
    const double scene_radius = radius_of(mesh, scene_hull_in_world);
    const std::map<int, Place> places = places_of_views(mesh);
    double squares = 0;
    for (const auto& [view_index, place] : places) {
        const Eigen::Vector3d centre = centre_of_view(view_index);
        double loss = 0;
        for (const Eigen::Vector3d& corner : scene_hull_in_world) {
            double own = 0;
            for (const std::size_t face : place.faces) {
                own = std::max(own, weight_of_view(mesh, face, view_index, corner, centre));
            }
            loss = std::max(loss, 1.0 - own);
        }
        squares += loss * loss;
        result.worst = std::max(result.worst, loss);
        // A strip's pair of vertices stands beside its camera: no vertex is there to be bounded.
        double bound = is_surface(mesh) ? 0.0 : 1.0;
        for (const std::size_t vertex : place.vertices) {
            if (!is_surface(mesh) || mesh.vertices[vertex].is_virtual) continue;
            bound = epipole_loss_bound(mesh, vertex, place.faces, centre, scene_radius);
        }
        if (bound > 0) {
            result.worst_bound = std::max(result.worst_bound, bound);
            result.worst_over_bound = std::max(result.worst_over_bound, loss / bound);
        }
    }
    if (!places.empty()) result.rms = std::sqrt(squares / static_cast<double>(places.size()));
    return result;
}

}  // namespace lumi
