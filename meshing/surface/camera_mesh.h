#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace lumi {

/// How the camera mesh was made; each arrangement of cameras has its own construction.
enum class MeshConstruction {
    kClosed,  ///< All around: the spherical hull of the directions from the scene centre.
    kOpen,    ///< A patch (hemisphere, wall): the hull without its far side, with a skirt.
    kLine,    ///< A row, arc or ring: a strip of quadrilaterals stretched along its normal.
    kPair,    ///< Two cameras: a strip.
    /// No surface lies between the cameras and the scene: they stand behind each other along their
    /// line of sight, or amid what they show. Drawn from the three that are nearest to the eye.
    kNearest,
    kSingle,  ///< One camera: it alone is drawn from.
};

[[nodiscard]] std::string name_of(MeshConstruction construction);
[[nodiscard]] std::optional<MeshConstruction> mesh_construction_named(const std::string& name);

/// The static surface that says which cameras a ray is blended from (the paper, section 3).
///
/// A vertex names a view; several vertices may name the same one, which is how strips and skirts
/// stay one structure with the rest. Faces wind counter-clockwise seen from outside, that is, from
/// the side that the eye looks in from.
struct CameraMesh {
    struct Vertex {
        Eigen::Vector3d position_in_world = Eigen::Vector3d::Zero();
        int view_index = 0;
        /// Stands beyond the border, where no camera stands: part of a skirt or of a strip's end.
        bool is_virtual = false;
        /// Of length one, for kNearest; zero where it does not matter.
        Eigen::Vector3d line_of_sight_in_world = Eigen::Vector3d::Zero();
    };
    using Face = std::array<int, 3>;  ///< Indices into `vertices`.

    MeshConstruction construction = MeshConstruction::kSingle;
    Eigen::Vector3d scene_centre_in_world = Eigen::Vector3d::Zero();
    std::vector<Vertex> vertices;
    std::vector<Face> faces;  ///< None of kNearest and kSingle.
    /// Meshes over close-ups, coarse before fine: each refines what its cameras see, as far as
    /// their weights say (see `capture_fade`), and its own cameras are vertices of it alone.
    std::vector<CameraMesh> shells;
};

/// Of triangles between cameras: closed or open.
[[nodiscard]] bool is_surface(const CameraMesh& mesh);
/// Of quadrilaterals between pairs of vertices, one above and one below each camera: line or pair.
[[nodiscard]] bool is_strip(const CameraMesh& mesh);

/// Which views a ray is blended from, and how much of each; the weights sum to 1.
struct RayWeights {
    int face_index = -1;
    std::array<int, 3> view_indices{};
    std::array<double, 3> weights{};
    /// Share of the weights that virtual vertices have: 0 within the capture, 1 far beyond it.
    double beyond_border = 0.0;
};

/// The side products of the line through `point` along `direction` with the edges of a face: the
/// numerators of its barycentric coordinates, and the same for every point on the line
/// (lambda_i = det[-direction, p_j, p_k] with p = vertex - point). For a line that crosses the face
/// from outside to inside all three are >= 0.
[[nodiscard]] Eigen::Vector3d side_products(const CameraMesh& mesh, const CameraMesh::Face& face,
                                            const Eigen::Vector3d& point_in_world,
                                            const Eigen::Vector3d& direction);

/// Weights of the line through `eye_in_world` along `direction` (from the eye to the scene): of the
/// faces it enters through, those behind the eye included, the last one, which is nearest to the
/// scene. With faces, the same for any eye on the
/// line, empty when none is crossed from outside, and 1 for a vertex that the line passes through.
/// Without faces those of an eye that looks along it (nearest_cameras.h), where frames are drawn
/// with those of the eye's optical axis.
[[nodiscard]] std::optional<RayWeights> weights_of_ray(const CameraMesh& mesh,
                                                       const Eigen::Vector3d& eye_in_world,
                                                       const Eigen::Vector3d& direction);

/// Of each view those that it is blended with somewhere: they share a face of the mesh; without
/// faces, those nearest to it (nearest_views). Shells are not asked.
[[nodiscard]] std::vector<std::set<int>> neighbouring_views(const CameraMesh& mesh,
                                                            std::size_t view_count);

/// Shares of virtual vertices at which what lies beyond the border has faded out, about 35 degrees
/// beyond it: skirts and the ends of strips reach eight camera distances out, shells end there.
inline constexpr double kSkirtFadedShare = 0.7 / 8;
inline constexpr double kShellFadedShare = 1.0;

/// How much a ray counts when what lies beyond the capture is to fade out: 1 - smoothstep of
/// `beyond_border` over `faded_share`. Continuous, like the weights.
[[nodiscard]] double capture_fade(const RayWeights& weights, double faded_share = kSkirtFadedShare);

/// Gives every vertex of the mesh and of its shells the view that `new_index` has for its old one.
void renumber_views(CameraMesh& mesh, const std::vector<int>& new_index);

/// Throws Error (E-MESH-INVALID) unless indices are in range, every number is finite and lines of
/// sight are of length one or zero, in the shells as well.
void validate(const CameraMesh& mesh, int view_count, const std::string& where);

}  // namespace lumi
