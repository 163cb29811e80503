#include "pipeline/bench/arrangement_benchmark.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "calib/capture/all_views.h"
#include "calib/capture/rigid3.h"
#include "calib/work/stopwatch.h"
#include "calib/work/whole_file.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/cameras/kernel.h"
#include "meshing/cameras/mesh_picture.h"
#include "pipeline/bench/faces_entered.h"
#include "pipeline/bench/largest_jump.h"
#include "pipeline/bench/synthetic_captures.h"

namespace lumi {
namespace {

constexpr std::array<int, 4> kCameraCounts{1, 10, 100, 1000};
constexpr int kRays = 1000;
constexpr int kPaths = 4;
constexpr int kPathSteps = 200;
constexpr JumpSearch kJumpSearch{.halvings = 40, .negligible = 1e-9};
constexpr double kSlid = 1e-9;
constexpr std::size_t kEpipoleCameras = 60;

using Weights = std::map<int, double>;

Weights weights_by_view(const CameraMesh& mesh, const Eigen::Vector3d& eye,
                        const Eigen::Vector3d& direction) {
    Weights weights;
    const auto ray = weights_of_ray(mesh, eye, direction);
    for (std::size_t i = 0; ray && i < 3; ++i) {
        if (ray->weights[i] > 0) weights[ray->view_indices[i]] += ray->weights[i];
    }
    return weights;
}

double difference(const Weights& a, const Weights& b) {
    double sum = 0;
    for (const auto& [view, weight] : a) {
        const auto other = b.find(view);
        sum += std::abs(weight - (other == b.end() ? 0.0 : other->second));
    }
    for (const auto& [view, weight] : b) sum += a.contains(view) ? 0.0 : weight;
    return sum;
}

class ArrangementMeasurement {
 public:
    ArrangementMeasurement(const ArrangedCapture& arranged, std::uint64_t seed)
        : arranged_(arranged), random_(seed, 8'000'000) {}

    [[nodiscard]] ArrangementFigures run() {
        const Stopwatch stopwatch;
        const BuiltCameraMesh built =
            build_camera_mesh(arranged_.capture, all_views(arranged_.capture), {});
        figures_.cpu_s = stopwatch.elapsed().cpu_s;
        mesh_ = &built.mesh;
        planes_ = face_planes(built.mesh);
        figures_.name = arranged_.name;
        figures_.cameras = static_cast<int>(arranged_.capture.views.size());
        figures_.construction = name_of(built.mesh.construction);
        figures_.cameras_kept = built.evidence.cameras_kept;
        figures_.shells = built.evidence.shells;
        for (int i = 0; i < kRays; ++i) add_ray();
        for (int i = 0; i < kPaths; ++i) add_path();
        add_epipoles();
        return figures_;
    }

 private:
    /// A point of the scene that lies in the kernel; of a room, one that it shows.
    Eigen::Vector3d target() {
        Eigen::Vector3d point = Eigen::Vector3d::Zero();
        for (int tries = 0; tries < 100; ++tries) {
            point = arranged_.inside_out
                        ? arranged_.capture.points[random_.below(arranged_.capture.points.size())]
                              .position_in_world
                        : random_target(arranged_.capture, random_);
            if (arranged_.inside_out || mesh_->faces.empty() ||
                kernel_clearance(planes_, point - mesh_->scene_centre_in_world) >= 0) {
                return point;
            }
        }
        return mesh_->scene_centre_in_world;
    }
    /// From the target to where it is looked at from.
    Eigen::Vector3d away_from(const Eigen::Vector3d& point) {
        if (arranged_.inside_out) return (0.3 * random_direction(random_) - point).normalized();
        for (;;) {
            const Eigen::Vector3d away = random_direction(random_);
            const double limit = std::cos(arranged_.spread_deg * std::numbers::pi / 180);
            if (away.dot(arranged_.side) >= limit) return away;
        }
    }

    void add_ray() {
        const Eigen::Vector3d point = target();
        const Eigen::Vector3d away = away_from(point);
        const Weights one =
            weights_by_view(*mesh_, point + (0.1 + 4 * random_.uniform()) * away, -away);
        const Weights other =
            weights_by_view(*mesh_, point + (0.1 + 4 * random_.uniform()) * away, -away);
        ++figures_.rays;
        figures_.rays_answered += one.empty() ? 0 : 1;
        figures_.rays_with_one_face +=
            mesh_->faces.empty() || faces_entered(*mesh_, point, -away) == 1 ? 1 : 0;
        figures_.most_cameras_a_ray =
            std::max(figures_.most_cameras_a_ray, static_cast<int>(one.size()));
        figures_.worst_inconsistency =
            std::max(figures_.worst_inconsistency, 0.5 * difference(one, other));
        if (one.empty()) return;
        double sum = 0;
        for (const auto& [view, weight] : one) sum += weight;
        figures_.worst_sum_error = std::max(figures_.worst_sum_error, std::abs(sum - 1));
    }

    void add_path() {
        const Eigen::Vector3d point = target();
        const Eigen::Vector3d from = away_from(point);
        const Eigen::Quaterniond turn = turn_between(from, away_from(point));
        const auto weights_at = [&](double t) {
            const Eigen::Vector3d away = Eigen::Quaterniond::Identity().slerp(t, turn) * from;
            return weights_by_view(*mesh_, point + (0.6 + 2 * t) * away, -away);
        };
        for (int step = 0; step < kPathSteps; ++step) {
            const double jump =
                largest_jump_between(weights_at, difference, static_cast<double>(step) / kPathSteps,
                                     static_cast<double>(step + 1) / kPathSteps, kJumpSearch);
            figures_.largest_jump = std::max(figures_.largest_jump, jump);
        }
    }

    /// Cameras of the mesh or of a shell, where they were not slid: their own rays.
    void add_epipoles() {
        add_epipoles_of(*mesh_);
        for (const CameraMesh& shell : mesh_->shells) add_epipoles_of(shell);
    }
    void add_epipoles_of(const CameraMesh& mesh) {
        const std::size_t step = 1 + mesh.vertices.size() / kEpipoleCameras;
        for (std::size_t i = 0; i < mesh.vertices.size(); i += step) {
            const CameraMesh::Vertex& vertex = mesh.vertices[i];
            const Eigen::Vector3d centre =
                centre_in_world(arranged_.capture.views[static_cast<std::size_t>(vertex.view_index)]
                                    .cam_from_world);
            if ((vertex.position_in_world - centre).norm() > kSlid) continue;
            for (int ray = 0; ray < 5; ++ray) {
                const Eigen::Vector3d point = target();
                if (arranged_.inside_out && (point - centre).dot(centre) <= 0) continue;
                const Weights own = weights_by_view(mesh, centre, point - centre);
                const auto found = own.find(vertex.view_index);
                const double weight = found == own.end() ? 0.0 : found->second;
                figures_.worst_unslid_epipole_loss =
                    std::max(figures_.worst_unslid_epipole_loss, 1 - weight);
            }
        }
    }

    const ArrangedCapture& arranged_;
    HashedRandom random_;
    const CameraMesh* mesh_ = nullptr;
    std::vector<FacePlane> planes_;
    ArrangementFigures figures_;
};

}  // namespace

std::vector<ArrangementFigures> benchmark_arrangements(std::uint64_t seed, Progress& progress) {
    std::vector<ArrangementFigures> all;
    progress.begin("arrangements", kCameraCounts.size());
    for (const int cameras : kCameraCounts) {
        for (const ArrangedCapture& arranged : arranged_captures(cameras, seed)) {
            progress.throw_if_interrupted();
            all.push_back(ArrangementMeasurement(arranged, seed).run());
        }
        progress.advance();
    }
    return all;
}

std::vector<ArrangementGrowth> time_arrangements(int most_cameras, std::uint64_t seed,
                                                 Progress& progress) {
    constexpr int kLeastCameras = 1000;
    std::vector<ArrangementGrowth> all;
    std::vector<int> counts;
    for (int count = kLeastCameras; count <= most_cameras; count *= 10) counts.push_back(count);
    progress.begin("growth of each arrangement", counts.size());
    for (const int count : counts) {
        // Places are off by the same share of the spacing: the shape of the faces is the same.
        const double unsteady = 0.02 * std::sqrt(static_cast<double>(kLeastCameras) / count);
        std::size_t row = 0;
        for (const ArrangedCapture& arranged : arranged_captures(count, seed, unsteady)) {
            progress.throw_if_interrupted();
            if (static_cast<int>(arranged.capture.views.size()) < count / 2) continue;
            const Stopwatch stopwatch;
            const BuiltCameraMesh built =
                build_camera_mesh(arranged.capture, all_views(arranged.capture), {});
            if (row == all.size()) all.push_back({arranged.name, {}, 0.0});
            all[row++].timings.push_back({count, stopwatch.elapsed().cpu_s});
        }
        progress.advance();
    }
    for (ArrangementGrowth& growth : all) {
        growth.growth_exponent = growth_exponent(growth.timings);
    }
    return all;
}

void draw_arrangements(const std::filesystem::path& folder, std::uint64_t seed) {
    constexpr int kCameras = 40;
    for (const ArrangedCapture& arranged : arranged_captures(kCameras, seed)) {
        const std::vector<int> views = all_views(arranged.capture);
        const CameraMesh mesh = build_camera_mesh(arranged.capture, views, {}).mesh;
        std::string name = arranged.name;
        std::replace(name.begin(), name.end(), ' ', '-');
        write_whole_text(folder / (name + ".svg"), camera_mesh_svg(arranged.capture, views, mesh));
    }
}

}  // namespace lumi
