#include "meshing/cameras/camera_mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "calib/work/error.h"
#include "meshing/cameras/border.h"
#include "meshing/cameras/camera_directions.h"
#include "meshing/cameras/kernel.h"
#include "meshing/cameras/line_strip.h"
#include "meshing/cameras/scene_centre.h"
#include "meshing/cameras/spherical_triangulation.h"

namespace lumi {
namespace {

CameraMesh single_camera(const CameraDirection& camera, const Eigen::Vector3d& centre) {
    CameraMesh mesh;
    mesh.construction = MeshConstruction::kSingle;
    mesh.scene_centre_in_world = centre;
    mesh.vertices.push_back({centre + camera.radius * camera.direction, camera.view_index});
    return mesh;
}

std::vector<Eigen::Vector3d> directions_of(const std::vector<CameraDirection>& cameras) {
    std::vector<Eigen::Vector3d> directions;
    for (const CameraDirection& camera : cameras) directions.push_back(camera.direction);
    return directions;
}

/// The mesh over the sphere of directions; empty when they do not span a volume.
CameraMesh surface_mesh(const Capture& capture, const std::vector<CameraDirection>& cameras,
                        const Eigen::Vector3d& centre, bool keep_far_side) {
    CameraMesh mesh;
    mesh.scene_centre_in_world = centre;
    const std::vector<SphericalFace> hull = triangulate_sphere(directions_of(cameras));
    if (hull.empty()) return mesh;

    for (const CameraDirection& camera : cameras) {
        const View& view = capture.views[static_cast<std::size_t>(camera.view_index)];
        mesh.vertices.push_back({centre_in_world(view.cam_from_world), camera.view_index});
    }
    const std::vector<SphericalFace> kept =
        keep_far_side ? hull : without_far_side(hull, cameras.size());
    for (const SphericalFace& face : kept) mesh.faces.push_back(face.corners);
    mesh.construction =
        kept.size() == hull.size() ? MeshConstruction::kClosed : MeshConstruction::kOpen;
    if (mesh.construction == MeshConstruction::kOpen) add_skirt(mesh, cameras);
    return mesh;
}

CameraMesh row_mesh(const CameraRow& row, const std::vector<CameraDirection>& cameras,
                    const Eigen::Vector3d& centre) {
    CameraMesh mesh = strip_of_row(row, cameras, centre);
    if (cameras.size() == 2) mesh.construction = MeshConstruction::kPair;
    return mesh;
}

CameraMesh mesh_of(const Capture& capture, const std::vector<CameraDirection>& cameras,
                   const Eigen::Vector3d& centre, const std::string& construction) {
    if (cameras.size() == 1) return single_camera(cameras.front(), centre);
    const std::optional<CameraRow> row = find_row(cameras, construction == "line");
    if (row && (cameras.size() == 2 || construction == "auto" || construction == "line")) {
        return row_mesh(*row, cameras, centre);
    }
    CameraMesh mesh = surface_mesh(capture, cameras, centre, construction == "closed");
    if (mesh.faces.empty()) mesh = row_mesh(*find_row(cameras, true), cameras, centre);
    return mesh;
}

/// Seen from inside, the other side of each face is the outer one.
void turn_inside_out(CameraMesh& mesh) {
    for (CameraMesh::Face& face : mesh.faces) std::swap(face[1], face[2]);
}

std::string explain(const CameraMesh& mesh, std::size_t cameras, bool inside_out) {
    const std::string count = std::to_string(cameras) + " cameras ";
    std::string text;
    switch (mesh.construction) {
        case MeshConstruction::kClosed:
            text = count + "stand all around the scene: a closed mesh";
            break;
        case MeshConstruction::kOpen:
            text = count +
                   "cover a part of the directions: an open mesh, continued past its border "
                   "by the border's cameras";
            break;
        case MeshConstruction::kLine:
            text = count +
                   "stand in a row, their heights differ less than their spacing: a strip "
                   "along the row";
            break;
        case MeshConstruction::kPair:
            text = "two cameras: a strip between them";
            break;
        case MeshConstruction::kSingle:
            text = "one camera: every ray is taken from it";
            break;
    }
    if (inside_out) text += "; the cameras look outwards from their middle";
    return text;
}

int views_named_by(const CameraMesh& mesh) {
    std::set<int> views;
    for (const CameraMesh::Vertex& vertex : mesh.vertices) views.insert(vertex.view_index);
    return static_cast<int>(views.size());
}

CameraMeshEvidence evidence_of(const CameraMesh& mesh, const SceneExtent& scene,
                               std::size_t cameras) {
    constexpr double kToleratedShare = 0.01;
    CameraMeshEvidence evidence;
    evidence.cameras_total = static_cast<int>(cameras);
    evidence.cameras_kept = views_named_by(mesh);
    if (scene.radius > 0) {
        evidence.kernel_radius_over_scene_radius = kernel_radius(mesh) / scene.radius;
    }
    evidence.faces_with_scene_outside =
        faces_with_scene_outside(mesh, scene.points_in_world, kToleratedShare);
    evidence.explanation = explain(mesh, cameras, scene.inside_out);
    return evidence;
}

}  // namespace

void validate(const CameraMeshOptions& options) {
    for (const char* known : {"auto", "closed", "open", "line"}) {
        if (options.construction == known) return;
    }
    throw Error(ErrorKind::kUsage, "E-CONFIG-VALUE",
                "[mesh] construction = \"" + options.construction + "\"",
                "use \"auto\", \"closed\", \"open\" or \"line\"");
}

CameraMeshOptions read_camera_mesh_options(const ConfigSection& section) {
    CameraMeshOptions options;
    options.construction = section.text("construction", options.construction);
    validate(options);
    return options;
}

BuiltCameraMesh build_camera_mesh(const Capture& capture, const std::vector<int>& view_indices,
                                  const CameraMeshOptions& options) {
    validate(options);
    if (view_indices.empty()) {
        throw Error(ErrorKind::kDegenerateCapture, "E-MESH-NOVIEW",
                    "there is no camera to make a mesh of", "hold out fewer photographs");
    }
    const SceneExtent scene = find_scene(capture, view_indices);
    const std::vector<CameraDirection> cameras =
        camera_directions(capture, view_indices, scene.centre_in_world);
    BuiltCameraMesh built;
    built.mesh = mesh_of(capture, cameras, scene.centre_in_world, options.construction);
    built.evidence = evidence_of(built.mesh, scene, cameras.size());
    if (scene.inside_out) turn_inside_out(built.mesh);
    return built;
}

}  // namespace lumi
