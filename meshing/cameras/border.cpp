#include "meshing/cameras/border.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>

#include "meshing/cameras/kernel.h"
#include "meshing/cameras/spherical_triangulation.h"

namespace lumi {
namespace {

/// Stereographic picture of the unit sphere from `pole`, which goes to infinity. Conformal, and
/// circles through the pole become straight lines.
class StereographicPicture {
 public:
    explicit StereographicPicture(const Eigen::Vector3d& pole)
        : pole_(pole), first_(pole.unitOrthogonal()), second_(pole.cross(first_)) {}

    [[nodiscard]] Eigen::Vector2d of(const Eigen::Vector3d& direction) const {
        return Eigen::Vector2d(direction.dot(first_), direction.dot(second_)) /
               (1.0 - direction.dot(pole_));
    }

    /// The tangent of the sphere, of length one, that a step in the picture stands for.
    [[nodiscard]] Eigen::Vector3d tangent(const Eigen::Vector2d& at,
                                          const Eigen::Vector2d& step) const {
        const double q = 1.0 + at.squaredNorm();
        const double q_step = 2.0 * at.dot(step);
        const Eigen::Vector3d place = 2.0 * in_space(at) + (q - 2.0) * pole_;
        const Eigen::Vector3d place_step = 2.0 * in_space(step) + q_step * pole_;
        return (place_step * q - place * q_step).normalized();
    }

 private:
    [[nodiscard]] Eigen::Vector3d in_space(const Eigen::Vector2d& p) const {
        return p.x() * first_ + p.y() * second_;
    }

    Eigen::Vector3d pole_;
    Eigen::Vector3d first_;
    Eigen::Vector3d second_;
};

/// The mesh is to the left of a border edge seen from outside the sphere, and also in the picture,
/// which looks at the sphere's outside from beyond the pole's antipode: outward is to the right.
Eigen::Vector2d outward_normal(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                               double handedness) {
    const Eigen::Vector2d along = (to - from).normalized();
    return handedness * Eigen::Vector2d(along.y(), -along.x());
}

/// Twice the signed area of the border polygon; its sign is the picture's handedness.
double signed_area(const std::vector<std::array<int, 2>>& edges,
                   const std::vector<Eigen::Vector2d>& picture) {
    double area = 0;
    for (const auto& [from, to] : edges) {
        const Eigen::Vector2d& p = picture[static_cast<std::size_t>(from)];
        const Eigen::Vector2d& q = picture[static_cast<std::size_t>(to)];
        area += p.x() * q.y() - p.y() * q.x();
    }
    return area;
}

/// Where the skirt goes from a camera: a tangent of the sphere between the one towards the gap
/// (share 0) and the border's bisector (share 1), but never towards the axis of the gap, where the
/// skirts of opposite cameras would meet.
Eigen::Vector3d skirt_direction(const Eigen::Vector3d& camera_direction,
                                const Eigen::Vector3d& bisector, double bisector_share,
                                const Eigen::Vector3d& gap) {
    const double towards_gap = camera_direction.dot(gap);
    const Eigen::Vector3d meridian = (gap - towards_gap * camera_direction).normalized();
    const Eigen::Vector3d from_axis = (camera_direction - towards_gap * gap).normalized();
    const Eigen::Vector3d tangent = bisector_share * bisector + (1.0 - bisector_share) * meridian;
    const double approach = std::min(0.0, tangent.dot(from_axis));
    return (tangent - approach * from_axis).normalized();
}

/// The bisector of the outward normals at each border camera, as a tangent of the sphere.
std::map<int, Eigen::Vector3d> border_bisectors(const CameraStar& star,
                                                const std::vector<std::array<int, 2>>& edges,
                                                const Eigen::Vector3d& gap_direction) {
    const StereographicPicture stereographic(gap_direction);
    std::vector<Eigen::Vector2d> picture;
    for (const Eigen::Vector3d& direction : star.directions) {
        picture.push_back(stereographic.of(direction));
    }
    const double handedness = signed_area(edges, picture) > 0 ? 1.0 : -1.0;
    std::map<int, Eigen::Vector2d> normals;
    for (const auto& [from, to] : edges) {
        const Eigen::Vector2d normal =
            outward_normal(picture[static_cast<std::size_t>(from)],
                           picture[static_cast<std::size_t>(to)], handedness);
        for (const int end : {from, to}) {
            normals.try_emplace(end, Eigen::Vector2d::Zero()).first->second += normal;
        }
    }
    std::map<int, Eigen::Vector3d> bisectors;
    for (const auto& [camera, normal] : normals) {
        bisectors[camera] =
            stereographic.tangent(picture[static_cast<std::size_t>(camera)], normal);
    }
    return bisectors;
}

}  // namespace

std::vector<std::array<int, 3>> open_triangulation(const std::vector<Eigen::Vector3d>& directions,
                                                   const Eigen::Vector3d& gap_direction) {
    std::vector<Eigen::Vector3d> with_gap = directions;
    with_gap.push_back(gap_direction);
    auto faces = spherical_triangulation(with_gap);
    const auto gap = static_cast<int>(directions.size());
    std::erase_if(faces, [gap](const std::array<int, 3>& face) {
        return std::find(face.begin(), face.end(), gap) != face.end();
    });
    return faces;
}

std::vector<std::array<int, 2>> border_edges(const std::vector<std::array<int, 3>>& faces) {
    // Both directions of an edge come to stand side by side: (lesser end, greater end, from).
    std::vector<std::array<int, 3>> edges;
    edges.reserve(3 * faces.size());
    for (const auto& face : faces) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const int from = face[corner];
            const int to = face[(corner + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), from});
        }
    }
    std::sort(edges.begin(), edges.end());
    std::vector<std::array<int, 2>> border;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto& [lesser, greater, from] = edges[i];
        const bool has_opposite =
            i + 1 < edges.size() && edges[i + 1][0] == lesser && edges[i + 1][1] == greater;
        if (has_opposite) {
            ++i;
        } else {
            border.push_back({from, from == lesser ? greater : lesser});
        }
    }
    std::sort(border.begin(), border.end());
    return border;
}

void append_skirt(const CameraStar& star, const Eigen::Vector3d& gap_direction, double length,
                  const std::vector<Eigen::Vector3d>& scene_hull_in_world, CameraMesh& mesh) {
    const auto edges = border_edges(mesh.faces);
    const auto bisectors = border_bisectors(star, edges, gap_direction);
    std::map<int, int> virtual_of;
    for (const auto& [camera, bisector] : bisectors) {
        virtual_of[camera] = static_cast<int>(mesh.vertices.size());
        mesh.vertices.push_back(mesh.vertices[static_cast<std::size_t>(camera)]);
        mesh.vertices.back().is_virtual = true;
    }
    const std::size_t first_skirt_face = mesh.faces.size();
    for (const auto& [from, to] : edges) {
        mesh.faces.push_back({to, from, virtual_of.at(from)});
        mesh.faces.push_back({to, virtual_of.at(from), virtual_of.at(to)});
    }
    const auto place = [&](double bisector_share) {
        for (const auto& [camera, bisector] : bisectors) {
            const Eigen::Vector3d direction =
                skirt_direction(star.directions[static_cast<std::size_t>(camera)], bisector,
                                bisector_share, gap_direction);
            mesh.vertices[static_cast<std::size_t>(virtual_of.at(camera))].position_in_world =
                mesh.vertices[static_cast<std::size_t>(camera)].position_in_world +
                length * direction;
        }
    };
    std::vector<Eigen::Vector3d> scene;
    for (const Eigen::Vector3d& point : scene_hull_in_world) {
        scene.push_back(point - mesh.scene_centre_in_world);
    }
    const auto room_within = [&](const std::vector<FacePlane>& planes) {
        const double radius = kernel_radius(planes);
        if (scene.empty()) return radius;
        if (!(radius > 0)) return -std::numeric_limits<double>::infinity();
        double room = std::numeric_limits<double>::infinity();
        for (const FacePlane& plane : planes) room = std::min(room, face_clearance(plane, scene));
        return room;
    };
    double best_share = 0.0;
    double most_room = -std::numeric_limits<double>::infinity();
    for (const double share : {1.0, 0.75, 0.5, 0.25, 0.0}) {
        place(share);
        std::vector<FacePlane> planes;
        for (std::size_t face = first_skirt_face; face < mesh.faces.size(); ++face) {
            planes.push_back(face_plane(mesh, mesh.faces[face]));
        }
        const double room = room_within(planes);
        if (room <= most_room) continue;
        most_room = room;
        best_share = share;
    }
    place(best_share);
}

}  // namespace lumi
