#pragma once

#include <Eigen/Core>
#include <vector>

namespace lumi {

/// Those that a picture is drawn from, and how much of each.
struct EnclosingViews {
    std::vector<int> views;  ///< At most three.
    std::vector<double> weights;
};

/// What a camera mesh would draw a place from, without building one: of the triangles that the
/// candidates' directions form around the place's direction the one with the least circumscribed
/// circle on the sphere (Delaunay), with barycentric weights; where none encloses it, the edge that
/// comes nearest. Directions are of length one, from the scene's centre; `candidates` index
/// `directions` and should be few: all triples are tried. Empty when there are none.
[[nodiscard]] EnclosingViews enclosing_views(const Eigen::Vector3d& place,
                                             const std::vector<Eigen::Vector3d>& directions,
                                             const std::vector<int>& candidates);

}  // namespace lumi
