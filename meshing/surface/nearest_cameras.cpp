#include "meshing/surface/nearest_cameras.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "meshing/surface/gradual_choice.h"

namespace lumi {
namespace {

constexpr std::size_t kBlended = 3;
/// How far a camera is from its own eye, of the distance of the fourth: what it does not see, the
/// next ones show.
constexpr double kFromItself = 1e-3;
/// A camera that looks away sees nothing of what the eye does, but may be all there is.
constexpr double kLeastCosine = 0.01;
/// Of its closeness: what a camera that is about to be exchanged counts where no other sees.
constexpr double kLeastWeight = 1e-3;

/// How far each camera is from the eye, as a share of the distance of the fourth nearest, and the
/// farther the more it looks another way.
std::vector<double> distances_from(const CameraMesh& mesh, const Eigen::Vector3d& eye_in_world,
                                   const Eigen::Vector3d& line_of_sight) {
    std::vector<double> distances;
    for (const CameraMesh::Vertex& vertex : mesh.vertices)
        distances.push_back((vertex.position_in_world - eye_in_world).norm());
    std::vector<double> in_order = distances;
    const auto unit =
        in_order.begin() + static_cast<std::ptrdiff_t>(std::min(kBlended, in_order.size() - 1));
    std::nth_element(in_order.begin(), unit, in_order.end());
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const Eigen::Vector3d& sight = mesh.vertices[i].line_of_sight_in_world;
        const double cosine = sight.isZero() ? 1.0 : sight.dot(line_of_sight);
        // Four at the eye: whoever is elsewhere is infinitely farther.
        const double share = distances[i] > 0 ? distances[i] / *unit : 0.0;
        distances[i] = (share + kFromItself) / std::clamp(cosine, kLeastCosine, 1.0);
        // Numbers that overflow are as far as can be.
        if (!std::isfinite(distances[i])) distances[i] = std::numeric_limits<double>::max();
    }
    return distances;
}

/// The nearest first, no more than four; those at one distance in their order in the mesh.
std::vector<std::size_t> four_nearest(const std::vector<double>& distances) {
    std::vector<std::size_t> cameras(distances.size());
    std::iota(cameras.begin(), cameras.end(), std::size_t{0});
    const std::size_t first = std::min(kBlended + 1, cameras.size());
    std::partial_sort(cameras.begin(), cameras.begin() + static_cast<std::ptrdiff_t>(first),
                      cameras.end(), [&](std::size_t a, std::size_t b) {
                          return distances[a] != distances[b] ? distances[a] < distances[b] : a < b;
                      });
    cameras.resize(first);
    return cameras;
}

/// One over the distance of the fourth nearest, which is not blended.
double closeness_of_next(const std::vector<double>& distances) {
    const std::vector<std::size_t> nearest = four_nearest(distances);
    return nearest.size() > kBlended ? 1.0 / distances[nearest.back()] : 0.0;
}

RayWeights weights_of(const std::vector<std::size_t>& cameras, const CameraMesh& mesh,
                      const std::vector<double>& distances, double of_next) {
    RayWeights weights;
    double sum = 0.0;
    for (std::size_t i = 0; i < kBlended; ++i) {
        const bool is_there = i < cameras.size();
        const std::size_t camera = cameras[is_there ? i : 0];
        const double closeness = 1.0 / distances[camera];
        weights.view_indices[i] = mesh.vertices[camera].view_index;
        weights.weights[i] =
            is_there ? std::max(0.0, closeness - of_next) + kLeastWeight * closeness : 0.0;
        sum += weights.weights[i];
    }
    for (double& weight : weights.weights) weight /= sum;
    return weights;
}

}  // namespace

std::vector<EyeBlend> blends_of_eye(const CameraMesh& mesh, const Eigen::Vector3d& eye_in_world,
                                    const Eigen::Vector3d& line_of_sight) {
    const std::vector<double> distances = distances_from(mesh, eye_in_world, line_of_sight);
    const double of_next = closeness_of_next(distances);
    std::vector<EyeBlend> blends;
    for (const GradualChoice& choice : gradual_choices(distances, kBlended))
        blends.push_back({weights_of(choice.chosen, mesh, distances, of_next), choice.share});
    return blends;
}

RayWeights weights_of_eye(const CameraMesh& mesh, const Eigen::Vector3d& eye_in_world,
                          const Eigen::Vector3d& line_of_sight) {
    const std::vector<EyeBlend> blends = blends_of_eye(mesh, eye_in_world, line_of_sight);
    return std::max_element(blends.begin(), blends.end(),
                            [](const EyeBlend& a, const EyeBlend& b) { return a.share < b.share; })
        ->weights;
}

std::vector<std::set<int>> nearest_views(const CameraMesh& mesh, std::size_t view_count) {
    std::vector<std::set<int>> neighbours(view_count);
    for (const CameraMesh::Vertex& vertex : mesh.vertices) {
        for (const std::size_t near : four_nearest(
                 distances_from(mesh, vertex.position_in_world, vertex.line_of_sight_in_world))) {
            const int other = mesh.vertices[near].view_index;
            if (other == vertex.view_index) continue;
            neighbours[static_cast<std::size_t>(vertex.view_index)].insert(other);
            neighbours[static_cast<std::size_t>(other)].insert(vertex.view_index);
        }
    }
    return neighbours;
}

}  // namespace lumi
