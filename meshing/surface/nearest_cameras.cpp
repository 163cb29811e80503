#include "meshing/surface/nearest_cameras.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lumi {
namespace {

constexpr std::size_t kBlended = 3;
/// How far a camera is from its own eye, of the distance of the fourth: what it does not see, the
/// next ones show.
constexpr double kFromItself = 1e-3;
/// A camera that looks away sees nothing of what the eye does, but may be all there is.
constexpr double kLeastCosine = 0.01;

struct NearCamera {
    double distance = 0.0;  ///< As a share of that of the fourth nearest, whichever way it looks.
    const CameraMesh::Vertex* camera = nullptr;
};

/// The nearest first; those at one distance in their order in the mesh.
std::vector<NearCamera> by_distance(const CameraMesh& mesh, const Eigen::Vector3d& eye_in_world,
                                    const Eigen::Vector3d& line_of_sight) {
    std::vector<NearCamera> cameras;
    std::vector<double> distances;
    for (const CameraMesh::Vertex& vertex : mesh.vertices) {
        const double distance = (vertex.position_in_world - eye_in_world).norm();
        cameras.push_back({distance, &vertex});
        distances.push_back(distance);
    }
    const auto unit =
        distances.begin() + static_cast<std::ptrdiff_t>(std::min(kBlended, distances.size() - 1));
    std::nth_element(distances.begin(), unit, distances.end());
    for (NearCamera& near : cameras) {
        const Eigen::Vector3d& sight = near.camera->line_of_sight_in_world;
        const double cosine = sight.isZero() ? 1.0 : sight.dot(line_of_sight);
        // Four at the eye: whoever is elsewhere is infinitely farther.
        const double share = near.distance > 0 ? near.distance / *unit : 0.0;
        near.distance = (share + kFromItself) / std::clamp(cosine, kLeastCosine, 1.0);
        // Numbers that overflow are as far as can be.
        if (!std::isfinite(near.distance)) near.distance = std::numeric_limits<double>::max();
    }
    const std::size_t first = std::min(kBlended + 1, cameras.size());
    std::partial_sort(cameras.begin(), cameras.begin() + static_cast<std::ptrdiff_t>(first),
                      cameras.end(), [](const NearCamera& a, const NearCamera& b) {
                          if (a.distance != b.distance) return a.distance < b.distance;
                          return a.camera < b.camera;
                      });
    cameras.resize(first);
    return cameras;
}

}  // namespace

RayWeights weights_of_eye(const CameraMesh& mesh, const Eigen::Vector3d& eye_in_world,
                          const Eigen::Vector3d& line_of_sight) {
    const std::vector<NearCamera> cameras = by_distance(mesh, eye_in_world, line_of_sight);
    const double of_next = cameras.size() > kBlended ? 1.0 / cameras[kBlended].distance : 0.0;
    RayWeights weights;
    double sum = 0.0;
    for (std::size_t i = 0; i < kBlended; ++i) {
        const bool is_there = i < cameras.size();
        weights.view_indices[i] = cameras[is_there ? i : 0].camera->view_index;
        weights.weights[i] = is_there ? 1.0 / cameras[i].distance - of_next : 0.0;
        sum += weights.weights[i];
    }
    // All four are equally far.
    if (!(sum > 0)) {
        weights.weights.fill(1.0);
        sum = kBlended;
    }
    for (double& weight : weights.weights) weight /= sum;
    return weights;
}

std::vector<std::set<int>> nearest_views(const CameraMesh& mesh, std::size_t view_count) {
    std::vector<std::set<int>> neighbours(view_count);
    for (const CameraMesh::Vertex& vertex : mesh.vertices) {
        for (const NearCamera& near :
             by_distance(mesh, vertex.position_in_world, vertex.line_of_sight_in_world)) {
            const int other = near.camera->view_index;
            if (near.camera == &vertex || other == vertex.view_index) continue;
            neighbours[static_cast<std::size_t>(vertex.view_index)].insert(other);
            neighbours[static_cast<std::size_t>(other)].insert(vertex.view_index);
        }
    }
    return neighbours;
}

}  // namespace lumi
