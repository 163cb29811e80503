#include "meshing/geometry/triangle_mesh_writing.h"

#include <string>

#include "meshing/surface/ply_places.h"

namespace lumi {
namespace {

/// By the triangles' sides, on average.
PlyPlaces places_of(const TriangleMesh& mesh) {
    double distances = 0;
    double lengths = 0;
    for (const auto& face : mesh.faces) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector3d& a = mesh.vertices[face[corner]];
            const Eigen::Vector3d& b = mesh.vertices[face[(corner + 1) % 3]];
            distances += a.norm();
            lengths += (b - a).norm();
        }
    }
    return {distances, lengths};
}

}  // namespace

void write_triangle_mesh_ply(const std::filesystem::path& path, const TriangleMesh& mesh) {
    const bool has_normals = mesh.normals.size() == mesh.vertices.size();
    const bool has_colors = mesh.colors.size() == mesh.vertices.size();
    const PlyPlaces places = places_of(mesh);
    std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                         std::to_string(mesh.vertices.size()) + "\n" + places.properties();
    if (has_normals) header += "property float nx\nproperty float ny\nproperty float nz\n";
    if (has_colors) header += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    header += "element face " + std::to_string(mesh.faces.size()) +
              "\nproperty list uchar uint vertex_indices\nend_header\n";
    Bytes bytes(header.begin(), header.end());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        places.append(mesh.vertices[i], bytes);
        if (has_normals) append_to_ply(mesh.normals[i], bytes);
        if (has_colors) append_to_ply(mesh.colors[i], bytes);
    }
    for (const auto& face : mesh.faces) {
        bytes.push_back(3);
        append_to_ply(face, bytes);
    }
    write_whole_file(path, bytes);
}

}  // namespace lumi
