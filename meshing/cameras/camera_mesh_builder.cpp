#include "meshing/cameras/camera_mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "calib/work/error.h"
#include "meshing/cameras/arrangement.h"
#include "meshing/cameras/border.h"
#include "meshing/cameras/camera_star.h"
#include "meshing/cameras/kernel.h"
#include "meshing/cameras/line_strip.h"
#include "meshing/cameras/scene_centre.h"
#include "meshing/cameras/spherical_triangulation.h"

namespace lumi {
namespace {

/// How far skirts and strips reach, in largest camera distances from the scene centre: a ray to the
/// scene misses them only within atan(1/8), 7 degrees, of their direction.
constexpr double kReach = 8.0;
/// Outliers of the sparse points must not decide.
constexpr double kSceneShare = 0.95;
constexpr std::size_t kMaxScenePoints = 2000;
/// Cameras closer together than this share of their depth show no parallax in any photograph.
constexpr double kOneSpot = 1e-6;
/// Clearance of the scene in the kernel, as a share of the camera distance, that needs no search.
constexpr double kEnoughClearance = 0.25;
constexpr double kLeastGain = 1e-3;
/// Open meshes may leave the scene all the room there is; reports want a finite figure.
constexpr double kMostRoom = 100.0;

/// The points nearer to the centre than the usual camera: what the cameras stand around. What lies
/// beyond is background, which no camera mesh can contain.
std::vector<Eigen::Vector3d> foreground(const std::vector<Eigen::Vector3d>& points,
                                        const Eigen::Vector3d& centre, double camera_distance) {
    std::vector<Eigen::Vector3d> nearer;
    std::copy_if(
        points.begin(), points.end(), std::back_inserter(nearer),
        [&](const Eigen::Vector3d& point) { return (point - centre).norm() < camera_distance; });
    return nearer;
}

bool on_one_spot(const std::vector<OpticalAxis>& axes) {
    double extent = 0;
    double depth = 0;
    for (const OpticalAxis& axis : axes) {
        extent = std::max(extent, (axis.centre_in_world - axes.front().centre_in_world).norm());
        depth = std::max(depth, axis.depth);
    }
    return extent <= kOneSpot * depth || extent == 0;
}

CameraMesh surface_mesh(const CameraStar& star, const Arrangement& arrangement) {
    CameraMesh mesh;
    mesh.scene_centre_in_world = star.centre_in_world;
    for (const OpticalAxis& axis : star.axes) {
        mesh.vertices.push_back({axis.centre_in_world, axis.view_index});
    }
    if (arrangement.construction == MeshConstruction::kClosed) {
        mesh.faces = spherical_triangulation(star.directions);
    } else if (arrangement.construction == MeshConstruction::kOpen) {
        mesh.faces = open_triangulation(star.directions, arrangement.gap_direction);
        append_skirt(star, arrangement.gap_direction, kReach * largest_distance(star), mesh);
    }
    return mesh;
}

/// The mesh of the stated construction over the cameras, star-shaped about `centre`.
CameraMesh construct(const std::vector<OpticalAxis>& axes, const Eigen::Vector3d& centre,
                     const Arrangement& arrangement) {
    const CameraStar star = camera_star(axes, centre);
    const bool strip = arrangement.construction == MeshConstruction::kLine ||
                       arrangement.construction == MeshConstruction::kPair;
    CameraMesh mesh =
        strip
            ? build_line_strip(star, arrangement.strip_normal, kReach * largest_distance(star)).mesh
            : surface_mesh(star, arrangement);
    mesh.construction = arrangement.construction;
    return mesh;
}

/// The clearance that all but the outermost points have in the kernel, as a share of the usual
/// camera distance; enough is enough.
double scene_clearance(const CameraMesh& mesh, const std::vector<Eigen::Vector3d>& points,
                       double camera_distance) {
    const std::vector<FacePlane> planes = face_planes(mesh);
    std::vector<double> clearances;
    for (const Eigen::Vector3d& point : points) {
        clearances.push_back(kernel_clearance(planes, point - mesh.scene_centre_in_world));
    }
    const double trimmed = percentile(std::move(clearances), 1 - kSceneShare);
    return std::min(trimmed / camera_distance, kEnoughClearance);
}

int distinct_views(const CameraMesh& mesh) {
    std::set<int> views;
    for (const CameraMesh::Vertex& vertex : mesh.vertices) views.insert(vertex.view_index);
    return static_cast<int>(views.size());
}

/// The mesh about the centre near `start` that gives the scene the most room in its kernel without
/// losing a camera.
CameraMesh construct_with_room(const std::vector<OpticalAxis>& axes, const Eigen::Vector3d& start,
                               const Arrangement& arrangement,
                               const std::vector<Eigen::Vector3d>& scene) {
    const CameraMesh first = construct(axes, start, arrangement);
    const double camera_distance = median_distance(axes, start);
    if (scene.empty() || scene_clearance(first, scene, camera_distance) >= kEnoughClearance) {
        return first;
    }
    const int views = distinct_views(first);
    const auto room = [&](const Eigen::Vector3d& centre) {
        const CameraMesh mesh = construct(axes, centre, arrangement);
        return distinct_views(mesh) < views ? -std::numeric_limits<double>::infinity()
                                            : scene_clearance(mesh, scene, camera_distance);
    };
    // The centre stays within the scene: it is also where the plane of a scene without depth lies.
    std::vector<double> distances;
    for (const Eigen::Vector3d& point : scene) distances.push_back((point - start).norm());
    const double reach = 0.5 * percentile(std::move(distances), 0.5);
    return construct(axes, improve_scene_centre(start, reach, kLeastGain, room), arrangement);
}

/// One camera for all, when none can be told from another by where it stands.
CameraMesh single_camera_mesh(const OpticalAxis& axis) {
    CameraMesh mesh;
    mesh.construction = MeshConstruction::kSingle;
    mesh.scene_centre_in_world =
        axis.centre_in_world + (axis.depth > 0 ? axis.depth : 1.0) * axis.direction_in_world;
    mesh.vertices.push_back({axis.centre_in_world, axis.view_index});
    return mesh;
}

Arrangement chosen_arrangement(const std::vector<OpticalAxis>& axes, const Eigen::Vector3d& centre,
                               const CameraMeshOptions& options) {
    const CameraStar star = camera_star(axes, centre);
    const auto demanded = mesh_construction_named(options.construction);
    return demanded ? arrange_as(star, *demanded) : arrange(star);
}

/// How the kernel of the mesh and the scene lie to each other.
struct KernelJudgement {
    double scale = 0.0;  ///< The kernel over the trimmed scene; 0 when not known.
    double share = 0.0;  ///< Of the scene's points that lie in the kernel.
    int faces_with_scene_outside = 0;
};

KernelJudgement judge_kernel(const CameraMesh& mesh, const std::vector<Eigen::Vector3d>& scene) {
    KernelJudgement judgement;
    if (scene.empty() || mesh.faces.empty()) return judgement;
    const std::vector<FacePlane> planes = face_planes(mesh);
    std::vector<double> gauges;
    for (const Eigen::Vector3d& point : scene) {
        gauges.push_back(kernel_gauge(planes, point - mesh.scene_centre_in_world));
    }
    const auto count = static_cast<double>(scene.size());
    const auto inside =
        std::count_if(gauges.begin(), gauges.end(), [](double gauge) { return gauge <= 1; });
    judgement.share = static_cast<double>(inside) / count;
    judgement.scale = std::min(1 / percentile(std::move(gauges), kSceneShare), kMostRoom);
    for (const FacePlane& plane : planes) {
        const auto outside =
            std::count_if(scene.begin(), scene.end(), [&](const Eigen::Vector3d& point) {
                return plane.outward_normal.dot(point - mesh.scene_centre_in_world) >
                       plane.distance;
            });
        if (static_cast<double>(outside) > (1 - kSceneShare) * count) {
            ++judgement.faces_with_scene_outside;
        }
    }
    return judgement;
}

/// "closed: the cameras surround the scene ...; 48 of 48 cameras are vertices of the mesh; ..."
std::string explain(const CameraMesh& mesh, const Arrangement& arrangement,
                    const CameraMeshEvidence& evidence, const KernelJudgement& kernel) {
    std::string text = name_of(mesh.construction);
    if (arrangement.inside_out) text += ", inside out (the cameras look away from their middle)";
    text += ": " + arrangement.reason + "; " + std::to_string(evidence.cameras_kept) + " of " +
            std::to_string(evidence.cameras_total) + " cameras are vertices of the mesh";
    if (evidence.cameras_kept < evidence.cameras_total) {
        text += ", the others stand behind or before one of them as seen from the scene";
    }
    if (kernel.scale > 0) {
        text += "; " + std::to_string(std::lround(std::floor(100 * kernel.share))) +
                " % of the scene's points lie in its kernel, where no ray crosses two faces";
    }
    return text + ".";
}

}  // namespace

BuiltCameraMesh build_camera_mesh(const Capture& capture, const std::vector<int>& view_indices,
                                  const CameraMeshOptions& options) {
    validate(options);
    if (view_indices.empty()) {
        throw Error(ErrorKind::kDegenerateCapture, "E-MESH-NOVIEW",
                    "no view is left to build the camera mesh from",
                    "register more photographs, or hold fewer of them out");
    }
    const std::vector<OpticalAxis> axes = optical_axes(capture, view_indices);
    BuiltCameraMesh built;
    Arrangement arrangement;
    std::vector<Eigen::Vector3d> scene;
    if (on_one_spot(axes)) {
        arrangement.reason = axes.size() == 1 ? "there is one camera"
                                              : "the camera turned on one spot and did not move";
        built.mesh = single_camera_mesh(axes.front());
    } else {
        const Eigen::Vector3d centre = estimate_scene_centre(axes);
        arrangement = chosen_arrangement(axes, centre, options);
        if (!arrangement.inside_out) {
            scene = foreground(visible_points(capture, view_indices, kMaxScenePoints), centre,
                               median_distance(axes, centre));
        }
        built.mesh = construct_with_room(axes, centre, arrangement, scene);
    }
    built.evidence.cameras_total = static_cast<int>(view_indices.size());
    built.evidence.cameras_kept = distinct_views(built.mesh);
    const KernelJudgement kernel = judge_kernel(built.mesh, scene);
    built.evidence.kernel_radius_over_scene_radius = kernel.scale;
    built.evidence.faces_with_scene_outside = kernel.faces_with_scene_outside;
    built.evidence.explanation = explain(built.mesh, arrangement, built.evidence, kernel);
    // Seen from within, a ray is blended from the cameras it leaves through: inside is outside.
    if (arrangement.inside_out) {
        for (CameraMesh::Face& face : built.mesh.faces) std::swap(face[1], face[2]);
    }
    return built;
}

}  // namespace lumi
