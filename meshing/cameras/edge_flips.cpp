#include "meshing/cameras/edge_flips.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <unordered_map>

#include "meshing/cameras/kernel.h"

namespace lumi {
namespace {

/// Rounding must not flip an edge to and fro: a flip gains this share of the mesh's size.
constexpr double kLeastFlipGain = 1e-9;

/// The two faces at an edge: left is (from, to, above), right is (to, from, below).
struct Quadrilateral {
    std::size_t left_face = 0;
    std::size_t right_face = 0;
    int from = 0;
    int to = 0;
    int above = 0;
    int below = 0;
};

/// A triangle mesh whose edges can be flipped.
class Flipper {
 public:
    /// What a face is worth; a flip must raise the lesser of two.
    using Worth = std::function<double(const CameraMesh::Face&)>;

    Flipper(CameraMesh& mesh, Worth worth, double least_gain)
        : mesh_(mesh), worth_(std::move(worth)), least_gain_(least_gain) {
        for (std::size_t face = 0; face < mesh.faces.size(); ++face) enter(face);
        for (const CameraMesh::Face& face : mesh.faces) worths_.push_back(worth_(face));
    }

    /// Flips until no edge of a face that is worth less than `enough` gains.
    int run(double enough) {
        std::deque<std::size_t> waiting;
        for (std::size_t face = 0; face < worths_.size(); ++face) {
            if (worths_[face] < enough) waiting.push_back(face);
        }
        int flips = 0;
        // Far more than any mesh needs; rounding cannot hold the loop.
        const std::size_t most_visits = 200 * (mesh_.faces.size() + 10);
        for (std::size_t visits = 0; !waiting.empty() && visits < most_visits; ++visits) {
            const std::size_t face = waiting.front();
            waiting.pop_front();
            if (worths_[face] >= enough) continue;
            const std::optional<Quadrilateral> best = best_flip(face);
            if (!best) continue;
            flip(*best);
            ++flips;
            for (const std::size_t changed : {best->left_face, best->right_face}) {
                waiting.push_back(changed);
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    const auto neighbour = face_at(mesh_.faces[changed][(corner + 1) % 3],
                                                   mesh_.faces[changed][corner]);
                    if (neighbour) waiting.push_back(*neighbour);
                }
            }
        }
        return flips;
    }

 private:
    static std::uint64_t key(int from, int to) {
        return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32) |
               static_cast<std::uint32_t>(to);
    }
    void enter(std::size_t face) {
        const CameraMesh::Face& corners = mesh_.faces[face];
        for (std::size_t i = 0; i < 3; ++i) face_of_[key(corners[i], corners[(i + 1) % 3])] = face;
    }
    [[nodiscard]] std::optional<std::size_t> face_at(int from, int to) const {
        const auto found = face_of_.find(key(from, to));
        if (found == face_of_.end()) return std::nullopt;
        return found->second;
    }
    [[nodiscard]] const CameraMesh::Vertex& vertex(int index) const {
        return mesh_.vertices[static_cast<std::size_t>(index)];
    }
    [[nodiscard]] bool faces_outward(const CameraMesh::Face& face) const {
        std::array<Eigen::Vector3d, 3> d;
        for (std::size_t i = 0; i < 3; ++i) {
            d[i] = (vertex(face[i]).position_in_world - mesh_.scene_centre_in_world).normalized();
        }
        return d[0].dot(d[1].cross(d[2])) > 1e-12;
    }

    static int third_corner(const CameraMesh::Face& face, int a, int b) {
        return *std::find_if(face.begin(), face.end(),
                             [&](int corner) { return corner != a && corner != b; });
    }

    /// Two cameras and two virtual vertices may change partners across a skirt; an edge between
    /// cameras that skirts begin at is the border, which stays.
    [[nodiscard]] bool may_flip(const Quadrilateral& q) const {
        const int on_edge = vertex(q.from).is_virtual + vertex(q.to).is_virtual;
        const int opposite = vertex(q.above).is_virtual + vertex(q.below).is_virtual;
        return (on_edge == 0 && opposite == 0) || (on_edge == 1 && opposite == 1);
    }

    [[nodiscard]] std::optional<Quadrilateral> quadrilateral(std::size_t face, int from,
                                                             int to) const {
        const auto right = face_at(to, from);
        if (!right) return std::nullopt;
        const Quadrilateral q{face,
                              *right,
                              from,
                              to,
                              third_corner(mesh_.faces[face], from, to),
                              third_corner(mesh_.faces[*right], from, to)};
        // The other diagonal may already be an edge: a tetrahedron's four faces.
        if (q.above == q.below || face_at(q.above, q.below) || face_at(q.below, q.above)) {
            return std::nullopt;
        }
        if (!may_flip(q)) return std::nullopt;
        return q;
    }

    static std::array<CameraMesh::Face, 2> flipped(const Quadrilateral& q) {
        return {CameraMesh::Face{q.above, q.from, q.below},
                CameraMesh::Face{q.below, q.to, q.above}};
    }

    [[nodiscard]] std::optional<Quadrilateral> best_flip(std::size_t face) const {
        std::optional<Quadrilateral> best;
        double most_gain = least_gain_;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto q =
                quadrilateral(face, mesh_.faces[face][i], mesh_.faces[face][(i + 1) % 3]);
            if (!q) continue;
            const auto [one, other] = flipped(*q);
            if (!faces_outward(one) || !faces_outward(other)) continue;
            const double before = std::min(worths_[q->left_face], worths_[q->right_face]);
            const double gain = std::min(worth_(one), worth_(other)) - before;
            if (!(gain > most_gain)) continue;
            most_gain = gain;
            best = q;
        }
        return best;
    }

    void flip(const Quadrilateral& q) {
        const auto [one, other] = flipped(q);
        face_of_.erase(key(q.from, q.to));
        face_of_.erase(key(q.to, q.from));
        mesh_.faces[q.left_face] = one;
        mesh_.faces[q.right_face] = other;
        for (const std::size_t changed : {q.left_face, q.right_face}) {
            enter(changed);
            worths_[changed] = worth_(mesh_.faces[changed]);
        }
    }

    CameraMesh& mesh_;
    Worth worth_;
    double least_gain_;
    std::unordered_map<std::uint64_t, std::size_t> face_of_;
    std::vector<double> worths_;
};

double size_of(const CameraMesh& mesh) {
    double size = 0;
    for (const CameraMesh::Vertex& vertex : mesh.vertices) {
        if (vertex.is_virtual) continue;
        size = std::max(size, (vertex.position_in_world - mesh.scene_centre_in_world).norm());
    }
    return size;
}

}  // namespace

int flip_edges_for_room(CameraMesh& mesh, const std::vector<Eigen::Vector3d>& scene_hull_in_world,
                        double enough) {
    std::vector<Eigen::Vector3d> from_centre;
    for (const Eigen::Vector3d& point : scene_hull_in_world) {
        from_centre.push_back(point - mesh.scene_centre_in_world);
    }
    const auto room = [&](const CameraMesh::Face& face) {
        return face_clearance(face_plane(mesh, face), from_centre);
    };
    return Flipper(mesh, room, kLeastFlipGain * size_of(mesh)).run(enough);
}

}  // namespace lumi
