#include "meshing/cameras/construction.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>

#include "meshing/cameras/border.h"
#include "meshing/cameras/camera_star.h"
#include "meshing/cameras/convex_mesh.h"
#include "meshing/cameras/kernel.h"
#include "meshing/cameras/line_strip.h"
#include "meshing/cameras/spherical_triangulation.h"
#include "meshing/cameras/thin_border.h"

namespace lumi {
namespace {

/// How far skirts and strips reach, in largest camera distances from the scene centre: a ray to the
/// scene misses them only within atan(1/8), 7 degrees, of their direction.
constexpr double kReach = 8.0;
/// Clearance of the scene in the kernel, as a share of the camera distance, that needs no search.
constexpr double kEnoughClearance = 0.25;
constexpr double kLeastGain = 1e-3;
/// Cameras times constructions that the search for a centre may take.
constexpr int kSearchWork = 20'000;
constexpr int kLeastConstructions = 8;
constexpr int kMostConstructions = 120;

CameraMesh cameras_alone(const CameraStar& star) {
    CameraMesh mesh;
    mesh.scene_centre_in_world = star.centre_in_world;
    for (const OpticalAxis& axis : star.axes) {
        mesh.vertices.push_back({axis.centre_in_world, axis.view_index});
    }
    return mesh;
}

/// The faces over a star, which loses its cameras within the hull when the mesh is to be convex.
std::vector<CameraMesh::Face> faces_over(CameraStar& star, const ConstructionRules& rules) {
    const bool is_open = rules.arrangement.construction == MeshConstruction::kOpen;
    const Eigen::Vector3d& gap = rules.arrangement.gap_direction;
    if (!rules.convex) {
        return is_open ? open_triangulation(star.directions, gap)
                       : spherical_triangulation(star.directions);
    }
    ConvexShape shape =
        convex_shape(star, is_open ? std::optional<Eigen::Vector3d>(gap) : std::nullopt);
    std::vector<int> new_index;
    int kept = 0;
    for (const char on_hull : shape.on_hull) new_index.push_back(on_hull ? kept++ : -1);
    star = kept_cameras(star, shape.on_hull);
    for (CameraMesh::Face& face : shape.faces) {
        for (int& corner : face) corner = new_index[static_cast<std::size_t>(corner)];
    }
    return shape.faces;
}

/// How much room the scene has in the kernel, in world units: negative where it reaches out, and
/// least where the mesh is not even star-shaped. Without a scene that of the centre counts.
double room_in(const CameraMesh& mesh, const std::vector<Eigen::Vector3d>& scene_hull_in_world) {
    const double radius = kernel_radius(face_planes(mesh));
    if (!(radius > 0)) return -std::numeric_limits<double>::infinity();
    return scene_hull_in_world.empty() ? radius : scene_clearance(mesh, scene_hull_in_world);
}

/// The open mesh with its skirt. A jagged border is peeled of its thin triangles where the scene
/// has room then: their planes may point anywhere. But dents in the border fold the skirt, so that
/// less is peeled where that serves the scene better.
CameraMesh open_mesh(const CameraStar& star, const std::vector<CameraMesh::Face>& faces,
                     const ConstructionRules& rules) {
    constexpr std::array<double, 3> kThinAltitudes{0.3, 0.1, 0.0};
    CameraMesh best;
    double most_room = -std::numeric_limits<double>::infinity();
    for (const double thin_altitude : kThinAltitudes) {
        CameraMesh mesh = cameras_alone(star);
        mesh.faces = faces;
        peel_thin_border(star.directions, thin_altitude, mesh.faces);
        append_skirt(star, rules.arrangement.gap_direction, kReach * largest_distance(star),
                     rules.scene_hull_in_world, mesh);
        const double room = room_in(mesh, rules.scene_hull_in_world);
        if (!best.faces.empty() && room <= most_room) continue;
        most_room = room;
        best = std::move(mesh);
        if (most_room > 0) break;
    }
    return best;
}

CameraMesh surface_mesh(CameraStar star, const ConstructionRules& rules) {
    const std::vector<CameraMesh::Face> faces = faces_over(star, rules);
    if (rules.arrangement.construction == MeshConstruction::kOpen) {
        return open_mesh(star, faces, rules);
    }
    CameraMesh mesh = cameras_alone(star);
    mesh.faces = faces;
    return mesh;
}

CameraMesh mesh_without_faces(const std::vector<OpticalAxis>& axes, const Eigen::Vector3d& centre) {
    CameraMesh mesh;
    mesh.scene_centre_in_world = centre;
    for (const OpticalAxis& axis : axes)
        mesh.vertices.push_back(
            {axis.centre_in_world, axis.view_index, false, axis.direction_in_world});
    return mesh;
}

CameraMesh strip_mesh(const CameraStar& star, const ConstructionRules& rules) {
    const Eigen::Vector3d& normal = rules.arrangement.strip_normal;
    const double length = kReach * largest_distance(star);
    LineStrip strip = build_line_strip(star, normal, length);
    if (!rules.convex) return strip.mesh;
    const CameraStar kept = kept_cameras(star, on_convex_chain(star, normal, strip.closed_ring));
    return kept.axes.size() < 2 ? strip.mesh : build_line_strip(kept, normal, length).mesh;
}

}  // namespace

CameraMesh construct(const std::vector<OpticalAxis>& axes, const Eigen::Vector3d& centre,
                     const ConstructionRules& rules) {
    const CameraStar star = camera_star(axes, centre);
    CameraMesh mesh;
    switch (rules.arrangement.construction) {
        case MeshConstruction::kLine:
        case MeshConstruction::kPair:
            mesh = strip_mesh(star, rules);
            break;
        case MeshConstruction::kClosed:
        case MeshConstruction::kOpen:
            mesh = surface_mesh(star, rules);
            break;
        case MeshConstruction::kNearest:
            mesh = mesh_without_faces(axes, centre);
            break;
        case MeshConstruction::kSingle:
            mesh = cameras_alone(star);
            break;
    }
    mesh.construction = rules.arrangement.construction;
    return mesh;
}

CameraMesh construct_with_room(const std::vector<OpticalAxis>& axes, const Eigen::Vector3d& start,
                               double reach, const ConstructionRules& rules) {
    CameraMesh first = construct(axes, start, rules);
    const double camera_distance = median_distance(axes, start);
    const auto enough_room_in = [&](const CameraMesh& mesh) {
        return std::min(scene_clearance(mesh, rules.scene_hull_in_world) / camera_distance,
                        kEnoughClearance);
    };
    const int affordable = kSearchWork / static_cast<int>(axes.size());
    // Where one construction takes long, a scene that is inside is inside enough.
    const double enough = affordable < kLeastConstructions ? 0.0 : kEnoughClearance;
    if (enough_room_in(first) >= enough) return first;
    const int views = distinct_views(first);
    const auto room_about = [&](const Eigen::Vector3d& centre) {
        const CameraMesh mesh = construct(axes, centre, rules);
        return distinct_views(mesh) < views ? -std::numeric_limits<double>::infinity()
                                            : enough_room_in(mesh);
    };
    const int constructions = std::clamp(affordable, kLeastConstructions, kMostConstructions);
    return construct(
        axes, improve_scene_centre(start, reach, kLeastGain, constructions, room_about), rules);
}

double scene_clearance(const CameraMesh& mesh,
                       const std::vector<Eigen::Vector3d>& scene_hull_in_world) {
    std::vector<Eigen::Vector3d> from_centre;
    for (const Eigen::Vector3d& point : scene_hull_in_world) {
        from_centre.push_back(point - mesh.scene_centre_in_world);
    }
    double clearance = std::numeric_limits<double>::infinity();
    for (const FacePlane& plane : face_planes(mesh)) {
        clearance = std::min(clearance, face_clearance(plane, from_centre));
    }
    return clearance;
}

int distinct_views(const CameraMesh& mesh) {
    std::set<int> views;
    for (const CameraMesh::Face& face : mesh.faces) {
        for (const int corner : face) {
            views.insert(mesh.vertices[static_cast<std::size_t>(corner)].view_index);
        }
    }
    if (mesh.faces.empty())
        for (const CameraMesh::Vertex& camera : mesh.vertices) views.insert(camera.view_index);
    return static_cast<int>(views.size());
}

}  // namespace lumi
