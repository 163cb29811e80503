#include "pipeline/bench/mesh_benchmark.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "calib/capture/all_views.h"
#include "calib/capture/rigid3.h"
#include "calib/work/stopwatch.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/cameras/camera_star.h"
#include "meshing/cameras/convex_mesh.h"
#include "meshing/cameras/scene_centre.h"
#include "meshing/cameras/slide.h"
#include "meshing/rivals/heigl_weights.h"
#include "meshing/rivals/unstructured_weights.h"
#include "meshing/rivals/view_dependent_weights.h"
#include "pipeline/bench/faces_entered.h"
#include "pipeline/bench/synthetic_captures.h"
#include "pipeline/synth/hand_held_path.h"

namespace lumi {
namespace {

constexpr int kLeastCameras = 20;
constexpr int kMostCameras = 200;
/// Each rival is measured on so many of the captures, with so many rays and steps of a path.
constexpr int kComparedCaptures = 20;
constexpr int kComparedRays = 500;
constexpr double kCameraSlid = 1e-9;
/// Of view-dependent texture: a polygon is what lies in a cube of this side over the scene's
/// radius.
constexpr double kPolygonShare = 0.1;

using Points = std::vector<Eigen::Vector3d>;

/// Somewhere on the ray that comes to the target from `away`: from within the scene to far beyond
/// all cameras. Every way of weighing is asked from such eyes.
Eigen::Vector3d eye_on_ray(const Eigen::Vector3d& target, const Eigen::Vector3d& away,
                           HashedRandom& random) {
    return target + (0.2 + 3 * random.uniform()) * away;
}

/// Of the cube of the lattice that the point lies in.
Eigen::Vector3d middle_of_polygon(const Eigen::Vector3d& point, double side) {
    return side * ((point / side).array().floor() + 0.5);
}

WayOfWeighing kernel_star_weights(const CameraMesh& mesh, std::size_t cameras) {
    return [&mesh, cameras](const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
        std::vector<double> weights(cameras, 0.0);
        const auto ray = weights_of_ray(mesh, eye, target - eye);
        for (std::size_t i = 0; ray && i < 3; ++i) {
            weights[static_cast<std::size_t>(ray->view_indices[i])] += ray->weights[i];
        }
        return weights;
    };
}

class Benchmark {
 public:
    Benchmark(const MeshBenchmarkOptions& options, Progress& progress)
        : options_(options),
          progress_(progress),
          ours_("kernel-star mesh"),
          heigl_("Heigl et al. 1999"),
          unstructured_("unstructured lumigraph"),
          view_dependent_("view-dependent texture") {}

    [[nodiscard]] MeshBenchmark run() {
        result_.least_kernel_over_scene = 1e9;
        progress_.begin("random captures", static_cast<std::size_t>(options_.captures));
        for (int i = 0; i < options_.captures; ++i) {
            progress_.throw_if_interrupted();
            measure_capture(i);
            progress_.advance();
        }
        result_.captures = options_.captures;
        const auto root_mean = [](double squares, long count) {
            return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0;
        };
        result_.rms_slide_share = root_mean(slide_squares_, result_.cameras);
        result_.rms_epipole_loss = root_mean(loss_squares_, result_.cameras);
        result_.convex_rms_push_share = root_mean(push_squares_, result_.cameras);
        result_.weights = {ours_.figures(), heigl_.figures(), unstructured_.figures(),
                           view_dependent_.figures()};
        time_growth();
        return result_;
    }

 private:
    void measure_capture(int index) {
        HashedRandom random(options_.seed, static_cast<std::uint64_t>(index));
        const int count =
            kLeastCameras + static_cast<int>(random.below(kMostCameras - kLeastCameras + 1));
        const Points centres = hand_held_centres(count, options_.roughness, random);
        const Capture capture = capture_around(centres, options_.scene_share, random);
        const BuiltCameraMesh built =
            build_camera_mesh(capture, all_views(capture), {.construction = "closed"});
        add_evidence(built.evidence, count);
        add_epipole_losses(built, capture);
        add_convex(capture, built.mesh.scene_centre_in_world);

        const WayOfWeighing weigh = kernel_star_weights(built.mesh, centres.size());
        const int rays = options_.rays / options_.captures;
        for (int i = 0; i < rays; ++i) {
            const Eigen::Vector3d target = random_target(capture, random);
            const Eigen::Vector3d away = random_direction(random);
            ++result_.rays;
            if (faces_entered(built.mesh, target, -away) == 1) ++result_.rays_with_one_face;
            const Eigen::Vector3d eye = eye_on_ray(target, away, random);
            ours_.add_ray(weigh, eye, eye_on_ray(target, away, random), target);
        }
        ours_.add_path(weigh, random_direction(random), random_direction(random),
                       random_target(capture, random));
        if (index < kComparedCaptures) compare_rivals(capture, centres, random);
    }

    void add_evidence(const CameraMeshEvidence& evidence, int cameras) {
        result_.cameras += cameras;
        result_.cameras_kept += evidence.cameras_kept;
        result_.least_kernel_over_scene =
            std::min(result_.least_kernel_over_scene, evidence.kernel_radius_over_scene_radius);
        if (evidence.kernel_radius_over_scene_radius < 1) {
            ++result_.captures_not_repaired;
        } else if (evidence.cameras_slid > 0) {
            ++result_.captures_repaired_by_slides;
        } else if (evidence.edges_flipped > 0) {
            ++result_.captures_repaired_by_flips;
        }
        result_.cameras_slid += evidence.cameras_slid;
        slide_squares_ += evidence.rms_slide_share * evidence.rms_slide_share * cameras;
        result_.largest_slide_share =
            std::max(result_.largest_slide_share, evidence.largest_slide_share);
        result_.worst_epipole_loss =
            std::max(result_.worst_epipole_loss, evidence.worst_epipole_loss);
        loss_squares_ += evidence.rms_epipole_loss * evidence.rms_epipole_loss * cameras;
        result_.worst_epipole_loss_over_bound =
            std::max(result_.worst_epipole_loss_over_bound, evidence.epipole_loss_over_bound);
    }

    /// Of cameras that stand where they stood.
    void add_epipole_losses(const BuiltCameraMesh& built, const Capture& capture) {
        for (const CameraMesh::Vertex& vertex : built.mesh.vertices) {
            const Eigen::Vector3d centre = centre_in_world(
                capture.views[static_cast<std::size_t>(vertex.view_index)].cam_from_world);
            if ((vertex.position_in_world - centre).norm() > kCameraSlid) continue;
            for (std::size_t i = 0; i < capture.points.size(); i += 50) {
                const auto weights = weights_of_ray(built.mesh, centre,
                                                    capture.points[i].position_in_world - centre);
                double own = 0;
                for (std::size_t k = 0; weights && k < 3; ++k) {
                    if (weights->view_indices[k] == vertex.view_index) own += weights->weights[k];
                }
                result_.worst_unslid_epipole_loss =
                    std::max(result_.worst_unslid_epipole_loss, 1 - own);
            }
        }
    }

    void add_convex(const Capture& capture, const Eigen::Vector3d& centre) {
        const CameraStar star = camera_star(optical_axes(capture, all_views(capture)), centre);
        const ConvexShape shape = convex_shape(star, std::nullopt);
        result_.convex_cameras_kept +=
            std::count(shape.on_hull.begin(), shape.on_hull.end(), char{1});
        push_squares_ +=
            shape.rms_push_share * shape.rms_push_share * static_cast<double>(capture.views.size());
        result_.convex_largest_push_share =
            std::max(result_.convex_largest_push_share, shape.largest_push_share);
    }

    void compare_rivals(const Capture& capture, const Points& centres, HashedRandom& random) {
        Points axes;
        for (const View& view : capture.views) {
            axes.push_back(optical_axis_in_world(view.cam_from_world));
        }
        // The frame of an eye looks along the ray, as one that stands within the scene may have its
        // middle behind it.
        const WayOfWeighing heigl = [&](const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
            return HeiglFrame(centres, axes, looking_at(eye, target)).weights_towards(target);
        };
        const WayOfWeighing unstructured = [&](const Eigen::Vector3d& eye,
                                               const Eigen::Vector3d& target) {
            return unstructured_weights(centres, eye, target);
        };
        const WayOfWeighing view_dependent = [&](const Eigen::Vector3d& eye,
                                                 const Eigen::Vector3d& target) {
            return view_dependent_weights(
                centres, eye, middle_of_polygon(target, kPolygonShare * options_.scene_share));
        };
        for (int i = 0; i < kComparedRays; ++i) {
            const Eigen::Vector3d target = random_target(capture, random);
            const Eigen::Vector3d away = random_direction(random);
            const Eigen::Vector3d eye = eye_on_ray(target, away, random);
            const Eigen::Vector3d other = eye_on_ray(target, away, random);
            heigl_.add_ray(heigl, eye, other, target);
            unstructured_.add_ray(unstructured, eye, other, target);
            view_dependent_.add_ray(view_dependent, eye, other, target);
        }
        const Eigen::Vector3d from = random_direction(random);
        const Eigen::Vector3d to = random_direction(random);
        const Eigen::Vector3d target = random_target(capture, random);
        heigl_.add_path(heigl, from, to, target);
        unstructured_.add_path(unstructured, from, to, target);
        view_dependent_.add_path(view_dependent, from, to, target);
    }

    /// Time against number of cameras.
    void time_growth() {
        std::vector<int> counts;
        for (int count = 100; count <= options_.most_cameras_timed; count *= 10) {
            counts.push_back(count);
            if (3 * count <= options_.most_cameras_timed) counts.push_back(3 * count);
        }
        progress_.begin("growth with cameras", counts.size());
        for (const int count : counts) {
            progress_.throw_if_interrupted();
            HashedRandom random(options_.seed, 1'000'000 + static_cast<std::uint64_t>(count));
            // Distances vary by a fifth of the spacing: the shape of the faces is the same
            // throughout.
            const double roughness = 0.2 * std::sqrt(4 * std::numbers::pi / count);
            const Points centres = hand_held_centres(count, roughness, random);
            const Capture capture = capture_around(centres, options_.scene_share, random);
            const Stopwatch stopwatch;
            const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
            const double cpu_s = stopwatch.elapsed().cpu_s;
            result_.timings.push_back({count, cpu_s});
            progress_.advance();
        }
        result_.growth_exponent = growth_exponent(result_.timings);
    }

    const MeshBenchmarkOptions& options_;
    Progress& progress_;
    MeshBenchmark result_;
    double slide_squares_ = 0.0;
    double loss_squares_ = 0.0;
    double push_squares_ = 0.0;
    WeightsMeasurement ours_;
    WeightsMeasurement heigl_;
    WeightsMeasurement unstructured_;
    WeightsMeasurement view_dependent_;
};

}  // namespace

double growth_exponent(const std::vector<MeshTiming>& timings) {
    constexpr int kLeastCamerasFitted = 1000;
    std::vector<Eigen::Vector2d> points;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const MeshTiming& timing : timings) {
        if (timing.cameras < kLeastCamerasFitted || !(timing.cpu_s > 0)) continue;
        points.emplace_back(std::log(timing.cameras), std::log(timing.cpu_s));
        mean += points.back();
    }
    if (points.size() < 2) return 0.0;
    mean /= static_cast<double>(points.size());
    double across = 0;
    double along = 0;
    for (const Eigen::Vector2d& point : points) {
        across += (point.x() - mean.x()) * (point.y() - mean.y());
        along += std::pow(point.x() - mean.x(), 2);
    }
    return across / along;
}

MeshBenchmark benchmark_mesh(const MeshBenchmarkOptions& options, Progress& progress) {
    return Benchmark(options, progress).run();
}

}  // namespace lumi
