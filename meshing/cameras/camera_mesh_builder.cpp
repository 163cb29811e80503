#include "meshing/cameras/camera_mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "calib/work/error.h"
#include "calib/work/median.h"
#include "meshing/cameras/arrangement.h"
#include "meshing/cameras/camera_star.h"
#include "meshing/cameras/close_ups.h"
#include "meshing/cameras/construction.h"
#include "meshing/cameras/forward_motion.h"
#include "meshing/cameras/kernel.h"
#include "meshing/cameras/mesh_explanation.h"
#include "meshing/cameras/own_rays.h"
#include "meshing/cameras/preconditions.h"
#include "meshing/cameras/repair.h"
#include "meshing/cameras/scene_centre.h"
#include "meshing/cameras/scene_hull.h"
#include "meshing/cameras/stray_cameras.h"

namespace lumi {
namespace {

constexpr std::size_t kMaxScenePoints = 2000;
/// Cameras closer together than this share of their depth show no parallax in any photograph.
constexpr double kOneSpot = 1e-6;
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
    if (const auto demanded = mesh_construction_named(options.construction))
        return arrange_as(star, *demanded);
    // The paper's mesh is a hull in any case.
    if (options.shape != "convex")
        if (const auto forward = arrange_forward(axes)) return *forward;
    return arrange(star);
}

/// Without faces nothing is split off: what a walk comes close to is no close-up.
bool has_no_faces(const std::vector<OpticalAxis>& axes, const CameraMeshOptions& options) {
    return options.construction == "auto" ? forward_motion(axes).has_value()
                                          : options.construction == "nearest";
}

/// How far the centre may be moved: it stays within the scene, for it is also where the plane of a
/// scene without depth lies.
double reach_within(const std::vector<Eigen::Vector3d>& scene, const Eigen::Vector3d& centre) {
    if (scene.empty()) return 0.0;
    std::vector<double> distances;
    for (const Eigen::Vector3d& point : scene) distances.push_back((point - centre).norm());
    return 0.5 * quantile_of(std::move(distances), 0.5);
}

/// How the kernel of the mesh and the scene lie to each other.
void judge_kernel(const CameraMesh& mesh, const std::vector<Eigen::Vector3d>& scene,
                  const std::vector<Eigen::Vector3d>& hull, CameraMeshEvidence& evidence) {
    if (scene.empty() || mesh.faces.empty()) return;
    const Eigen::Vector3d& centre = mesh.scene_centre_in_world;
    const std::vector<FacePlane> planes = face_planes(mesh);
    double gauge = 0;
    for (const Eigen::Vector3d& corner : hull) {
        gauge = std::max(gauge, kernel_gauge(planes, corner - centre));
    }
    evidence.kernel_radius_over_scene_radius =
        gauge > 0 ? std::min(1 / gauge, kMostRoom) : kMostRoom;
    std::vector<Eigen::Vector3d> from_centre;
    for (const Eigen::Vector3d& corner : hull) from_centre.push_back(corner - centre);
    evidence.faces_with_scene_outside =
        static_cast<int>(std::count_if(planes.begin(), planes.end(), [&](const FacePlane& plane) {
            return face_clearance(plane, from_centre) < 0;
        }));
    // Planes that leave the whole hull inside need not be asked about each point again.
    std::vector<FacePlane> cutting;
    std::vector<Eigen::Vector3d> all;
    for (const Eigen::Vector3d& point : scene) all.push_back(point - centre);
    std::copy_if(planes.begin(), planes.end(), std::back_inserter(cutting),
                 [&](const FacePlane& plane) { return face_clearance(plane, all) < 0; });
    const auto inside = std::count_if(all.begin(), all.end(), [&](const Eigen::Vector3d& point) {
        return cutting.empty() || kernel_clearance(cutting, point) >= 0;
    });
    evidence.scene_share_in_kernel = static_cast<double>(inside) / static_cast<double>(all.size());
}

void note_repair(const RepairReport& repair, CameraMeshEvidence& evidence) {
    evidence.edges_flipped = repair.edges_flipped;
    evidence.cameras_slid = repair.slide.cameras_slid;
    evidence.largest_slide_share = repair.slide.largest_share;
    evidence.rms_slide_share = repair.slide.rms_share;
    evidence.worst_epipole_loss = repair.epipole_loss.worst;
    evidence.rms_epipole_loss = repair.epipole_loss.rms;
    evidence.epipole_loss_bound = repair.epipole_loss.worst_bound;
    evidence.epipole_loss_over_bound = repair.epipole_loss.worst_over_bound;
}

struct BuiltSurface {
    BuiltCameraMesh built;
    bool inside_out = false;
    std::optional<std::string> why_none;  ///< It does not lie between the cameras and the scene.
};

/// The mesh over the given cameras, with what speaks for it.
BuiltSurface build_surface(const Capture& capture, const std::vector<OpticalAxis>& axes,
                           const std::vector<Eigen::Vector3d>& points,
                           const CameraMeshOptions& options) {
    const auto centre_of_view = [&](int view) {
        return centre_in_world(capture.views[static_cast<std::size_t>(view)].cam_from_world);
    };
    BuiltCameraMesh built;
    CameraMeshEvidence& evidence = built.evidence;
    ConstructionRules rules;
    rules.convex = options.shape == "convex";
    std::vector<Eigen::Vector3d> scene;
    if (on_one_spot(axes)) {
        rules.arrangement.reason = axes.size() == 1
                                       ? "there is one camera"
                                       : "the camera turned on one spot and did not move";
        built.mesh = single_camera_mesh(axes.front());
    } else {
        const Eigen::Vector3d centre = estimate_scene_centre(axes);
        rules.arrangement = chosen_arrangement(axes, centre, options);
        if (!rules.arrangement.inside_out) {
            scene = foreground(points, centre, median_distance(axes, centre));
        }
        rules.scene_hull_in_world = scene_hull(scene, 1.0);
        built.mesh = construct_with_room(axes, centre, reach_within(scene, centre), rules);
        if (options.repair && !rules.convex) {
            note_repair(repair_kernel(built.mesh, {scene, centre_of_view}), evidence);
        }
    }
    evidence.cameras_total = static_cast<int>(axes.size());
    evidence.cameras_kept = distinct_views(built.mesh);
    judge_kernel(built.mesh, scene, rules.scene_hull_in_world, evidence);
    // Seen from within, a ray is blended from the cameras it leaves through: inside is outside.
    if (rules.arrangement.inside_out) {
        for (CameraMesh::Face& face : built.mesh.faces) std::swap(face[1], face[2]);
    }
    if (!built.mesh.faces.empty()) {
        evidence.own_ray_share =
            own_ray_share(capture, built.mesh, rules.arrangement.inside_out ? points : scene);
    }
    evidence.explanation = mesh_explanation(
        built.mesh, rules.arrangement, evidence,
        {.is_convex = rules.convex, .has_scene = !scene.empty() && !built.mesh.faces.empty()});
    BuiltSurface surface{std::move(built), rules.arrangement.inside_out, {}};
    if (!surface.built.mesh.faces.empty()) {
        SurfacePreconditions preconditions;
        if (!scene.empty())
            preconditions.scene_share_in_kernel = surface.built.evidence.scene_share_in_kernel;
        preconditions.share_that_faces_scene = share_that_faces(
            capture, axes, surface.built.mesh.scene_centre_in_world, surface.inside_out);
        surface.why_none = why_no_surface(preconditions);
    }
    return surface;
}

/// All cameras, in place of a surface that would not lie between them and what they show.
BuiltCameraMesh without_surface(const std::vector<OpticalAxis>& axes, const BuiltSurface& surface) {
    ConstructionRules rules;
    rules.arrangement = {.construction = MeshConstruction::kNearest, .reason = *surface.why_none};
    BuiltCameraMesh built;
    built.mesh = construct(axes, surface.built.mesh.scene_centre_in_world, rules);
    built.evidence.cameras_total = static_cast<int>(axes.size());
    built.evidence.cameras_kept = distinct_views(built.mesh);
    built.evidence.scene_share_in_kernel = surface.built.evidence.scene_share_in_kernel;
    built.evidence.kernel_radius_over_scene_radius =
        surface.built.evidence.kernel_radius_over_scene_radius;
    built.evidence.explanation = mesh_explanation(built.mesh, rules.arrangement, built.evidence);
    return built;
}

/// The axes of the views in no group.
std::vector<OpticalAxis> without_close_ups(const std::vector<OpticalAxis>& axes,
                                           const std::vector<CloseUpGroup>& groups) {
    std::vector<char> is_close_up(axes.size(), 0);
    for (const CloseUpGroup& group : groups) {
        for (const int axis : group.axes) is_close_up[static_cast<std::size_t>(axis)] = 1;
    }
    std::vector<OpticalAxis> others;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (!is_close_up[i]) others.push_back(axes[i]);
    }
    return others;
}

void add_shells(const Capture& capture, const std::vector<OpticalAxis>& axes,
                const std::vector<CloseUpGroup>& groups, const std::vector<Eigen::Vector3d>& points,
                BuiltCameraMesh& built) {
    CameraMeshEvidence& evidence = built.evidence;
    for (const CloseUpGroup& group : groups) {
        std::vector<OpticalAxis> group_axes;
        for (const int axis : group.axes) {
            group_axes.push_back(axes[static_cast<std::size_t>(axis)]);
        }
        built.mesh.shells.push_back(
            close_up_shell(group_axes, points_in_view(capture, group_axes, points)));
        evidence.close_ups += distinct_views(built.mesh.shells.back());
    }
    if (groups.empty()) return;
    evidence.cameras_total = static_cast<int>(axes.size());
    evidence.cameras_kept += evidence.close_ups;
    evidence.shells = static_cast<int>(groups.size());
    evidence.explanation.pop_back();
    evidence.explanation += "; " + std::to_string(evidence.close_ups) +
                            (evidence.close_ups == 1 ? " close-up refines" : " close-ups refine") +
                            " what they see, in " + std::to_string(evidence.shells) +
                            (evidence.shells == 1 ? " shell." : " shells.");
}

/// The mesh over these cameras, of close-ups in shells.
BuiltCameraMesh build_over(const Capture& capture, const std::vector<OpticalAxis>& axes,
                           const std::vector<Eigen::Vector3d>& points,
                           const CameraMeshOptions& options) {
    std::vector<CloseUpGroup> groups;
    if (options.shells && options.shape != "convex" && !has_no_faces(axes, options))
        groups = find_close_ups(capture, axes, points);
    BuiltSurface surface = build_surface(capture, without_close_ups(axes, groups), points, options);
    // From the middle of a room every camera sees a part of it only: near walls are no close-ups.
    if (surface.inside_out && !groups.empty()) {
        groups.clear();
        surface = build_surface(capture, axes, points, options);
    }
    if (surface.why_none && options.construction == "auto" && options.shape != "convex")
        return without_surface(axes, surface);
    add_shells(capture, axes, groups, points, surface.built);
    return std::move(surface.built);
}

void note_left_out(std::size_t strays, CameraMeshEvidence& evidence) {
    evidence.cameras_total += static_cast<int>(strays);
    evidence.explanation.pop_back();
    evidence.explanation += "; left out: " + std::to_string(strays) +
                            " at less than half or more than twice the usual distance, for no "
                            "surface would hold all.";
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
    const std::vector<Eigen::Vector3d> points =
        visible_points(capture, view_indices, kMaxScenePoints);
    BuiltCameraMesh built = build_over(capture, axes, points, options);
    if (built.mesh.construction != MeshConstruction::kNearest || options.construction != "auto")
        return built;
    const std::vector<OpticalAxis> others = without_strays(axes);
    if (others.size() == axes.size()) return built;
    BuiltCameraMesh without = build_over(capture, others, points, options);
    if (without.mesh.faces.empty()) return built;
    note_left_out(axes.size() - others.size(), without.evidence);
    return without;
}

}  // namespace lumi
