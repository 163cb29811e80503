#include "meshing/rivals/heigl_weights.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lumi {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase>;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, Structure>;

/// Of the farthest camera's distance: so close to a camera the eye is there, and so close to its
/// plane the eye is no closer.
constexpr double kAtCamera = 1e-6;

}  // namespace

struct HeiglFrame::Implementation {
    Rigid3 eye_from_world;
    std::size_t cameras = 0;
    std::optional<std::size_t> at_eye;
    Triangulation triangulation;
};

HeiglFrame::HeiglFrame(const std::vector<Eigen::Vector3d>& centres_in_world,
                       const std::vector<Eigen::Vector3d>& axes_in_world,
                       const Rigid3& eye_from_world)
    : implementation_(std::make_unique<Implementation>()) {
    implementation_->eye_from_world = eye_from_world;
    implementation_->cameras = centres_in_world.size();
    double farthest = 0;
    for (const Eigen::Vector3d& centre : centres_in_world)
        farthest = std::max(farthest, (eye_from_world * centre).norm());
    const double closest = kAtCamera * farthest;
    for (std::size_t i = 0; i < centres_in_world.size(); ++i) {
        if ((eye_from_world.rotation * axes_in_world[i]).z() < kHeiglLeastCosine) continue;
        Eigen::Vector3d in_eye = eye_from_world * centres_in_world[i];
        if (in_eye.norm() <= closest) implementation_->at_eye = i;
        in_eye.z() = std::copysign(std::max(std::abs(in_eye.z()), closest), in_eye.z());
        const Eigen::Vector2d place = in_eye.hnormalized();
        implementation_->triangulation.insert({place.x(), place.y()})->info() = i;
    }
}
HeiglFrame::~HeiglFrame() = default;
HeiglFrame::HeiglFrame(HeiglFrame&& other) noexcept = default;
HeiglFrame& HeiglFrame::operator=(HeiglFrame&& other) noexcept = default;

std::vector<double> HeiglFrame::weights_towards(const Eigen::Vector3d& target_in_world) const {
    std::vector<double> weights(implementation_->cameras, 0.0);
    const Eigen::Vector3d in_eye = implementation_->eye_from_world * target_in_world;
    if (!(in_eye.z() > 1e-9 * in_eye.norm())) return weights;
    if (implementation_->at_eye) {
        weights[*implementation_->at_eye] = 1;
        return weights;
    }
    const Triangulation& triangulation = implementation_->triangulation;
    if (triangulation.dimension() < 2) return weights;
    const Eigen::Vector2d pixel = in_eye.hnormalized();
    const auto face = triangulation.locate({pixel.x(), pixel.y()});
    if (triangulation.is_infinite(face)) return weights;
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i) {
        const auto& place = face->vertex(i)->point();
        corners.col(i) = Eigen::Vector3d(place.x(), place.y(), 1);
    }
    const Eigen::Vector3d barycentric = corners.inverse() * pixel.homogeneous();
    for (int i = 0; i < 3; ++i) weights[face->vertex(i)->info()] = barycentric[i];
    return weights;
}

}  // namespace lumi
