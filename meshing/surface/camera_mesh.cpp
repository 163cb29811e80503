#include "meshing/surface/camera_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "calib/work/error.h"
#include "meshing/surface/nearest_cameras.h"

namespace lumi {
namespace {

constexpr std::array<std::pair<MeshConstruction, const char*>, 6> kConstructionNames{{
    {MeshConstruction::kClosed, "closed"},
    {MeshConstruction::kOpen, "open"},
    {MeshConstruction::kLine, "line"},
    {MeshConstruction::kPair, "pair"},
    {MeshConstruction::kNearest, "nearest"},
    {MeshConstruction::kSingle, "single"},
}};

const CameraMesh::Vertex& vertex(const CameraMesh& mesh, int index) {
    return mesh.vertices[static_cast<std::size_t>(index)];
}

/// Side products smaller than this share of their terms are rounding errors: the line passes
/// through a vertex or along an edge.
constexpr double kRoundingShare = 1e-12;

double determinant(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double value = a.dot(b.cross(c));
    const double scale = a.norm() * b.norm() * c.norm();
    return std::abs(value) <= kRoundingShare * scale ? 0.0 : value;
}

/// Where along the line the face is crossed, in units of `direction`.
double crossing_of(const CameraMesh& mesh, const CameraMesh::Face& face,
                   const Eigen::Vector3d& weights, const Eigen::Vector3d& point,
                   const Eigen::Vector3d& direction) {
    Eigen::Vector3d crossing = Eigen::Vector3d::Zero();
    for (int corner = 0; corner < 3; ++corner) {
        crossing += weights[corner] *
                    vertex(mesh, face[static_cast<std::size_t>(corner)]).position_in_world;
    }
    return (crossing - point).dot(direction) / direction.squaredNorm();
}

RayWeights ray_weights(const CameraMesh& mesh, int face_index, const Eigen::Vector3d& weights) {
    RayWeights result;
    result.face_index = face_index;
    const CameraMesh::Face& face = mesh.faces[static_cast<std::size_t>(face_index)];
    for (std::size_t corner = 0; corner < 3; ++corner) {
        result.view_indices[corner] = vertex(mesh, face[corner]).view_index;
        result.weights[corner] = weights[static_cast<Eigen::Index>(corner)];
        if (vertex(mesh, face[corner]).is_virtual) result.beyond_border += result.weights[corner];
    }
    return result;
}

}  // namespace

std::string name_of(MeshConstruction construction) {
    for (const auto& [value, name] : kConstructionNames) {
        if (value == construction) return name;
    }
    return {};
}

std::optional<MeshConstruction> mesh_construction_named(const std::string& name) {
    for (const auto& [value, known] : kConstructionNames) {
        if (name == known) return value;
    }
    return std::nullopt;
}

bool is_surface(const CameraMesh& mesh) {
    return mesh.construction == MeshConstruction::kClosed ||
           mesh.construction == MeshConstruction::kOpen;
}

bool is_strip(const CameraMesh& mesh) {
    return mesh.construction == MeshConstruction::kLine ||
           mesh.construction == MeshConstruction::kPair;
}

Eigen::Vector3d side_products(const CameraMesh& mesh, const CameraMesh::Face& face,
                              const Eigen::Vector3d& point_in_world,
                              const Eigen::Vector3d& direction) {
    const Eigen::Vector3d p0 = vertex(mesh, face[0]).position_in_world - point_in_world;
    const Eigen::Vector3d p1 = vertex(mesh, face[1]).position_in_world - point_in_world;
    const Eigen::Vector3d p2 = vertex(mesh, face[2]).position_in_world - point_in_world;
    const Eigen::Vector3d back = -direction;
    return {determinant(back, p1, p2), determinant(back, p2, p0), determinant(back, p0, p1)};
}

std::optional<RayWeights> weights_of_ray(const CameraMesh& mesh,
                                         const Eigen::Vector3d& eye_in_world,
                                         const Eigen::Vector3d& direction) {
    if (mesh.faces.empty() && !mesh.vertices.empty())
        return weights_of_eye(mesh, eye_in_world, direction.normalized());
    std::optional<RayWeights> best;
    double best_crossing = 0;
    for (std::size_t index = 0; index < mesh.faces.size(); ++index) {
        const Eigen::Vector3d sides =
            side_products(mesh, mesh.faces[index], eye_in_world, direction);
        const double sum = sides.sum();
        if (sides.minCoeff() < 0 || !(sum > 0)) continue;
        const Eigen::Vector3d weights = sides / sum;
        const double crossing =
            crossing_of(mesh, mesh.faces[index], weights, eye_in_world, direction);
        if (best && crossing <= best_crossing) continue;
        best = ray_weights(mesh, static_cast<int>(index), weights);
        best_crossing = crossing;
    }
    return best;
}

std::vector<std::set<int>> neighbouring_views(const CameraMesh& mesh, std::size_t view_count) {
    if (mesh.faces.empty()) return nearest_views(mesh, view_count);
    std::vector<std::set<int>> neighbours(view_count);
    const auto link = [&](int a, int b) {
        const int view_a = vertex(mesh, a).view_index;
        const int view_b = vertex(mesh, b).view_index;
        if (view_a == view_b) return;
        neighbours[static_cast<std::size_t>(view_a)].insert(view_b);
        neighbours[static_cast<std::size_t>(view_b)].insert(view_a);
    };
    for (const CameraMesh::Face& face : mesh.faces)
        for (std::size_t corner = 0; corner < 3; ++corner)
            link(face[corner], face[(corner + 1) % 3]);
    return neighbours;
}

double capture_fade(const RayWeights& weights, double faded_share) {
    const double share = std::clamp(weights.beyond_border / faded_share, 0.0, 1.0);
    return 1.0 - share * share * (3.0 - 2.0 * share);
}

void renumber_views(CameraMesh& mesh, const std::vector<int>& new_index) {
    for (CameraMesh::Vertex& vertex : mesh.vertices) {
        vertex.view_index = new_index[static_cast<std::size_t>(vertex.view_index)];
    }
    for (CameraMesh& shell : mesh.shells) renumber_views(shell, new_index);
}

void validate(const CameraMesh& mesh, int view_count, const std::string& where) {
    const auto refuse = [&](const std::string& what) {
        throw Error(ErrorKind::kBadInput, "E-MESH-INVALID", where + ": " + what,
                    "make the camera mesh again with `lumi mesh`");
    };
    if (mesh.vertices.empty()) refuse("expected at least one vertex");
    if (!mesh.scene_centre_in_world.allFinite()) refuse("the scene centre is not finite");
    if (mesh.construction == MeshConstruction::kNearest && !mesh.faces.empty())
        refuse("cameras without a surface have no faces");
    for (const CameraMesh::Vertex& corner : mesh.vertices) {
        if (!corner.position_in_world.allFinite()) refuse("a vertex is not finite");
        const double sight = corner.line_of_sight_in_world.norm();
        if (sight != 0 && !(std::abs(sight - 1) < 1e-6))
            refuse("a line of sight is not of length one");
        if (corner.view_index < 0 || corner.view_index >= view_count) {
            refuse("a vertex names view " + std::to_string(corner.view_index) + " of " +
                   std::to_string(view_count));
        }
    }
    const auto count = static_cast<int>(mesh.vertices.size());
    for (const CameraMesh::Face& face : mesh.faces) {
        for (const int index : face) {
            if (index < 0 || index >= count) refuse("a face names a vertex that does not exist");
        }
    }
    for (const CameraMesh& shell : mesh.shells) {
        if (!shell.shells.empty()) refuse("a shell has shells of its own");
        validate(shell, view_count, where);
    }
}

}  // namespace lumi
